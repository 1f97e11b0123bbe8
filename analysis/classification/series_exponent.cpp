#include "analysis/classification/series_exponent.hpp"

#include "analysis/random_draws.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

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

namespace {

constexpr std::size_t most_for_exponent = 10'000;
constexpr std::size_t most_for_separation = 4000;
constexpr std::size_t segments = 20;
constexpr std::uint64_t replicates = 200;
constexpr double rise = 0.7;  // of the stretch that is fitted, a factor 2 in distance
constexpr double smallest_rise = 0.5;
constexpr double below_size = 2.3;  // a tenth of the attractor's size
constexpr double largest_jump = 0.15;
constexpr double near_size = 1.2;  // a third, at which neighbours still part, but ever more slowly

std::span<const double> last(std::span<const double> series, std::size_t most) {
    return series.size() > most ? series.last(most) : series;
}

/// Mean number of samples from maximum to maximum of the series, smoothed over half its memory.
std::size_t mean_period(std::span<const double> x, std::size_t delay) {
    const std::size_t width = std::max<std::size_t>(1, delay / 2);
    std::vector<double> smooth(x.size() - width + 1);
    double sum = std::accumulate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(width), 0.0);
    for (std::size_t i = 0;; ++i) {
        smooth[i] = sum;
        if (i + 1 == smooth.size()) break;
        sum += x[i + width] - x[i];
    }
    std::size_t maxima = 0;
    for (std::size_t i = 1; i + 1 < smooth.size(); ++i)
        maxima += smooth[i] > smooth[i - 1] && smooth[i] >= smooth[i + 1] ? 1 : 0;
    return std::max<std::size_t>(1, (smooth.size() + maxima / 2) / std::max<std::size_t>(1, maxima));
}

/// Mean ln of the distances of delay vectors that have nothing to do with each other.
double logarithm_of_size(const DelayVectors& vectors) {
    const std::size_t n = vectors.count();
    double sum = 0;
    std::size_t pairs = 0;
    for (std::size_t part = 3; part <= 7; ++part)  // of each with that a third, a fifth, … of the series later
        for (std::size_t i = 0; i < n; i += n / 1000 + 1) {
            const double d = vectors.distance_squared(i, (i + n / part) % n);
            if (d > 0) sum += std::log(d) / 2, ++pairs;
        }
    return pairs > 0 ? sum / static_cast<double>(pairs) : nan;
}

/// Sums over references of one segment of the series each.
struct SegmentSums {
    std::vector<double> sums, counts;  // segments × (horizon + 1)
    std::size_t width;

    explicit SegmentSums(const Divergence& divergence)
        : sums(segments * (divergence.horizon + 1), 0), counts(sums), width(divergence.horizon + 1) {
        for (std::size_t r = 0; r < divergence.references; ++r) {
            const std::size_t at = r * segments / divergence.references * width;
            const auto logarithms = divergence.of(r);
            for (std::size_t t = 0; t < width; ++t)
                if (!std::isnan(logarithms[t])) sums[at + t] += logarithms[t], counts[at + t] += 1;
        }
    }

    /// S(t), each segment so often.
    std::vector<double> mean(const std::array<double, segments>& times) const {
        std::vector<double> sum(width, 0), count(width, 0);
        for (std::size_t k = 0; k < segments; ++k)
            for (std::size_t t = 0; t < width; ++t)
                sum[t] += times[k] * sums[k * width + t], count[t] += times[k] * counts[k * width + t];
        for (std::size_t t = 0; t < width; ++t) sum[t] = count[t] > 0 ? sum[t] / count[t] : nan;
        return sum;
    }
};

/// Each value the mean of `period` from there on.
std::vector<double> over_period(std::span<const double> curve, std::size_t period) {
    std::vector<double> means;
    for (std::size_t t = 0; t + period <= curve.size(); ++t)
        means.push_back(std::accumulate(curve.begin() + static_cast<std::ptrdiff_t>(t),
                                        curve.begin() + static_cast<std::ptrdiff_t>(t + period), 0.0) /
                        static_cast<double>(period));
    return means;
}

/// The stretch of a curve from `begin` to `end` that a line is fitted to.
struct Stretch {
    std::size_t begin, end;  // both included
};

double slope_of(std::span<const double> curve, Stretch stretch) {
    const double middle = static_cast<double>(stretch.begin + stretch.end) / 2;
    double tt = 0, ts = 0;
    for (std::size_t t = stretch.begin; t <= stretch.end; ++t) {
        const double from_middle = static_cast<double>(t) - middle;
        tt += from_middle * from_middle, ts += from_middle * curve[t];
    }
    return ts / tt;
}

/// The slope of a curve's means over a period, as a sum over the curve.
class Slope {
public:
    Slope(Stretch stretch, std::size_t period) : begin_(stretch.begin), weights_(stretch.end - stretch.begin + period) {
        std::vector<double> one(weights_.size() + 1);
        const Stretch from_zero{0, stretch.end - stretch.begin};
        for (std::size_t t = from_zero.begin; t <= from_zero.end; ++t) {
            one[t] = 1 / static_cast<double>(period);
            const double weight = slope_of(one, from_zero);
            one[t] = 0;
            for (std::size_t k = t; k < t + period; ++k) weights_[k] += weight;
        }
    }
    double operator()(std::span<const double> curve) const {
        return std::inner_product(weights_.begin(), weights_.end(), curve.begin() + static_cast<std::ptrdiff_t>(begin_),
                                  0.0);
    }

private:
    std::size_t begin_;
    std::vector<double> weights_;
};

/// Below `limit`.
std::optional<Stretch> stretch_of(std::span<const double> curve, std::size_t begin, double limit) {
    std::size_t end = begin;
    while (end + 1 < curve.size() && curve[end + 1] <= limit && (curve[end] - curve[begin] < rise || end < begin + 2))
        ++end;
    if (end < begin + 2 || !(curve[end] - curve[begin] >= smallest_rise)) return std::nullopt;
    return Stretch{begin, end};
}

/// Half the difference between the first and the second half of the stretch.
double curvature_of(std::span<const double> curve, Stretch stretch) {
    const std::size_t half = std::max<std::size_t>(1, (stretch.end - stretch.begin) / 2);
    return std::abs(slope_of(curve, {stretch.begin, stretch.begin + half}) -
                    slope_of(curve, {stretch.end - half, stretch.end})) /
           2;
}

/// Standard deviation of the slope over resampled segments.
double bootstrap(const SegmentSums& sums, const Slope& slope_of_curve) {
    double sum = 0, squares = 0;
    for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
        std::array<double, segments> times{};
        for (std::uint64_t k = 0; k < segments; k += 4)
            for (const std::uint64_t bits : random_bits({replicate, k, 0, 0}, {1, 0x736567}))
                times[(bits >> 32) * segments >> 32] += 1;
        const double slope = slope_of_curve(sums.mean(times));
        sum += slope, squares += slope * slope;
    }
    const double n = static_cast<double>(replicates), mean = sum / n;
    return std::sqrt(std::max(0.0, squares / n - mean * mean) * n / (n - 1));
}

/// The median of the references' own slopes.
double typical_slope(const Divergence& divergence, const Slope& slope_of_curve) {
    std::vector<double> slopes;
    for (std::size_t r = 0; r < divergence.references; ++r) {
        const double slope = slope_of_curve(divergence.of(r));
        if (!std::isnan(slope)) slopes.push_back(slope);
    }
    if (slopes.empty()) return nan;
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle;
}

/// Noise makes nearest neighbours of those whose noise agrees; one step later it does not. By so much more do the
/// distances of a smooth flow grow in the first step than in the second.
double jump_of(std::span<const double> curve) {
    return std::max(0.0, 2 * curve[1] - curve[0] - curve[2]);
}

struct Rate {
    double slope, scatter, curvature, noise, typical;
    bool clear;  // the stretch stays well below the attractor's size, and above the noise
};

std::optional<Rate> rate_in(std::span<const double> x, std::size_t dimension, bool flow) {
    const std::size_t delay = flow ? std::min(decorrelation(x), x.size() / 16) : 1;
    const std::size_t period = flow ? std::min(mean_period(x, delay), x.size() / 16) : 1;
    DivergenceOptions options;
    options.across_flow = flow;
    options.horizon = flow ? std::min(x.size() / 4, 5 * period) : std::min<std::size_t>(x.size() / 8, 60);
    options.window = std::max(flow ? period : 1, dimension * delay);
    const DelayVectors vectors{x, dimension, delay};
    const Divergence divergence = divergence_of(vectors, options);
    if (divergence.references < 2 * segments) return std::nullopt;
    const SegmentSums sums(divergence);
    std::array<double, segments> once;
    once.fill(1);
    const auto raw = sums.mean(once), curve = over_period(raw, period);
    const double size = logarithm_of_size(vectors);
    const std::size_t begin = flow ? period / 2 : dimension - 1;
    const auto well_below = stretch_of(curve, begin, size - below_size);
    const auto stretch = well_below ? well_below : stretch_of(curve, begin, size - near_size);
    if (!stretch) return std::nullopt;
    const Slope slope_of_curve(*stretch, period);
    const double slope = slope_of(curve, *stretch);
    const double jump = flow ? jump_of(raw) : 0;
    return Rate{slope,
                bootstrap(sums, slope_of_curve),
                curvature_of(curve, *stretch),
                2 * slope * jump,
                typical_slope(divergence, slope_of_curve) / slope,
                well_below && jump <= largest_jump};
}

double median_of(const std::vector<Rate>& rates, double Rate::*member) {
    std::vector<double> values;
    for (const Rate& rate : rates) values.push_back(rate.*member);
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

}  // namespace

bool SeriesExponent::is_positive() const {
    return dimensions >= 2 && exponent > 2 * error && typical >= smallest_typical;
}

SeriesExponent exponent_of_series(std::span<const double> series, bool sampled_flow) {
    const auto x = last(series, most_for_exponent);
    std::vector<Rate> rates;
    const std::size_t first = sampled_flow ? 3 : 2;
    for (std::size_t dimension = first; dimension < first + 3; ++dimension)
        if (const auto rate = rate_in(x, dimension, sampled_flow)) rates.push_back(*rate);
    SeriesExponent result;
    result.resolved = std::count_if(rates.begin(), rates.end(), [](const Rate& rate) { return rate.clear; }) >= 2;
    if (result.resolved) std::erase_if(rates, [](const Rate& rate) { return !rate.clear; });
    result.dimensions = static_cast<int>(rates.size());
    if (result.dimensions < 2) return result;
    const auto [least, most] =
        std::minmax_element(rates.begin(), rates.end(), [](const Rate& a, const Rate& b) { return a.slope < b.slope; });
    const double scatter = median_of(rates, &Rate::scatter);
    result.exponent = median_of(rates, &Rate::slope);
    result.curvature = median_of(rates, &Rate::curvature);
    result.spread = (most->slope - least->slope) / 2;
    result.typical = median_of(rates, &Rate::typical);
    result.noise = median_of(rates, &Rate::noise);
    result.error = std::sqrt(2 * scatter * scatter + result.curvature * result.curvature +
                             result.spread * result.spread + result.noise * result.noise);
    return result;
}

double separation_of_neighbours(std::span<const double> series) {
    const auto x = last(series, most_for_separation);
    const std::size_t delay = std::min(decorrelation(x), x.size() / 16);
    DivergenceOptions options;
    options.horizon = x.size() / 4;
    options.window = 3 * delay;
    const Divergence divergence = divergence_of({x, 3, delay}, options);
    if (divergence.references == 0) return nan;
    std::array<double, segments> once;
    once.fill(1);
    const auto curve = SegmentSums(divergence).mean(once);
    const auto quarter = static_cast<std::ptrdiff_t>(curve.size() / 4);
    return std::accumulate(curve.end() - quarter, curve.end(), 0.0) / static_cast<double>(quarter) - curve[1];
}

}  // namespace swirl::analysis
