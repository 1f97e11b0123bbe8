#include "analysis/classification/delay_vectors.hpp"

#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace swirl::analysis {

double DelayVectors::distance_squared(std::size_t i, std::size_t j) const {
    double sum = 0;
    for (std::size_t m = 0; m < dimension; ++m) {
        const double d = x[i + m * delay] - x[j + m * delay];
        sum += d * d;
    }
    return sum;
}

double DelayVectors::distance_squared_to_segment(std::size_t i, std::size_t j) const {
    double ww = 0, wu = 0, uu = 0;
    for (std::size_t m = 0; m < dimension; ++m) {
        const double begin = x[j + m * delay], u = x[j + 1 + m * delay] - begin, w = x[i + m * delay] - begin;
        ww += w * w, wu += w * u, uu += u * u;
    }
    const double s = uu > 0 ? std::clamp(wu / uu, 0.0, 1.0) : 0;
    return std::max(0.0, ww - 2 * s * wu + s * s * uu);
}

std::size_t decorrelation(std::span<const double> x) {
    const std::size_t n = x.size();
    const double mean = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(n);
    double variance = 0;
    for (const double v : x) variance += (v - mean) * (v - mean);
    const std::size_t most = std::max<std::size_t>(1, n / 20);
    for (std::size_t lag = 1; lag < most; ++lag) {
        double sum = 0;
        for (std::size_t i = 0; i + lag < n; ++i) sum += (x[i] - mean) * (x[i + lag] - mean);
        if (sum < variance / std::numbers::e) return lag;
    }
    return most;
}

NeighbourSearch::NeighbourSearch(const DelayVectors& vectors, std::size_t count, Equal equal)
    : vectors_(vectors), equal_(equal), order_(count), place_(count) {
    const auto x = vectors.x;
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return x[a] < x[b] || (x[a] == x[b] && a < b); });
    for (std::size_t r = 0; r < count; ++r) place_[order_[r]] = r;
}

std::span<const NeighbourSearch::Neighbour> NeighbourSearch::nearest(std::size_t i, std::size_t k, std::size_t window) {
    found_.clear();
    const double x = vectors_.x[i];
    std::size_t below = place_[i], above = place_[i] + 1;  // order_[below − 1] and order_[above] are next
    while (below > 0 || above < order_.size()) {
        const double down = below > 0 ? x - vectors_.x[order_[below - 1]] : infinity;
        const double up = above < order_.size() ? vectors_.x[order_[above]] - x : infinity;
        const double first = std::min(down, up);
        if (found_.size() == k && first * first >= found_.back().first) break;
        const std::size_t j = down <= up ? order_[--below] : order_[above++];
        if ((i > j ? i - j : j - i) <= window) continue;
        const Neighbour candidate(vectors_.distance_squared(i, j), j);
        if ((equal_ == Equal::left_out && !(candidate.first > 0)) || (found_.size() == k && candidate >= found_.back()))
            continue;
        if (found_.size() == k) found_.pop_back();
        found_.insert(std::upper_bound(found_.begin(), found_.end(), candidate), candidate);
    }
    return found_;
}

namespace {

/// ln of the distances of y_{i + t} from y_{j + t}.
void follow(const DelayVectors& vectors, std::size_t i, std::size_t j, std::span<double> logarithms) {
    for (std::size_t t = 0; t < logarithms.size(); ++t) {
        const double d = vectors.distance_squared(i + t, j + t);
        if (d > 0) logarithms[t] = std::log(d) / 2;
    }
}

/// ln of the distances of y_{i + t} from the path that begins at y_j. Ends where that comes to i's own path.
void follow_across(const DelayVectors& vectors, std::size_t i, std::size_t j, std::size_t window,
                   std::span<double> logarithms) {
    constexpr std::size_t slip = 3;  // steps by which the nearest point may lag or lead from one step to the next
    for (std::size_t t = 0; t < logarithms.size(); ++t) {
        double least = infinity;
        std::size_t nearest = j;
        const std::size_t end = std::min(j + slip, vectors.count() - 1);
        for (std::size_t s = j - std::min(j, slip); s < end; ++s) {
            const double d = vectors.distance_squared_to_segment(i + t, s);
            if (d < least) least = d, nearest = s;
        }
        if ((nearest > i + t ? nearest - (i + t) : i + t - nearest) <= window / 2) return;
        if (nearest + 2 >= vectors.count()) return;
        if (least > 0) logarithms[t] = std::log(least) / 2;
        j = nearest + 1;
    }
}

}  // namespace

Divergence divergence_of(const DelayVectors& vectors, const DivergenceOptions& options) {
    // A neighbour that leads needs some steps more than the horizon.
    const std::size_t reserve = options.horizon + (options.across_flow ? options.horizon / 4 + 2 : 0);
    Divergence result;
    result.horizon = options.horizon;
    if (vectors.x.size() < (vectors.dimension - 1) * vectors.delay + reserve + 2 * options.window + 2) return result;
    const std::size_t count = vectors.count() - reserve;
    const std::size_t stride = (count - 1) / options.most_references + 1;
    result.references = (count - 1) / stride + 1;
    result.logarithms.assign(result.references * (options.horizon + 1), nan);
    NeighbourSearch search(vectors, count);
    for (std::size_t r = 0; r < result.references; ++r) {
        const auto found = search.nearest(r * stride, 1, options.window);
        if (found.empty()) continue;
        const auto logarithms = std::span(result.logarithms).subspan(r * (options.horizon + 1), options.horizon + 1);
        if (options.across_flow)
            follow_across(vectors, r * stride, found[0].second, options.window, logarithms);
        else
            follow(vectors, r * stride, found[0].second, logarithms);
    }
    return result;
}

}  // namespace swirl::analysis
