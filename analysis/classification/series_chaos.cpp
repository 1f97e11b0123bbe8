#include "analysis/classification/classify_series.hpp"
#include "analysis/special_values.hpp"
#include "analysis/spectrum/fft.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace swirl::analysis {

namespace {

constexpr std::size_t most_for_exponent = 4000;
constexpr std::size_t most_for_surrogates = 1000;

std::span<const double> last(std::span<const double> series, std::size_t most) {
    return series.size() > most ? series.last(most) : series;
}

/// The first lag at which the autocorrelation falls below 1/e, at most n/20.
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

double distance_squared(std::span<const double> x, std::size_t i, std::size_t j, int dimension, std::size_t delay) {
    double sum = 0;
    for (int m = 0; m < dimension; ++m) {
        const std::size_t shift = static_cast<std::size_t>(m) * delay;
        sum += (x[i + shift] - x[j + shift]) * (x[i + shift] - x[j + shift]);
    }
    return sum;
}

/// ⟨ln |x − x'|⟩ of neighbours, t = 0 … horizon samples after they were nearest.
std::vector<double> divergence(std::span<const double> x, int dimension, std::size_t delay, std::size_t horizon) {
    const std::size_t reach = static_cast<std::size_t>(dimension - 1) * delay;
    const std::size_t points = x.size() - reach - horizon;
    const std::size_t window = static_cast<std::size_t>(dimension) * delay;
    std::vector<double> sums(horizon + 1, 0), counts(horizon + 1, 0);
    for (std::size_t i = 0; i < points; ++i) {
        double nearest = infinity;
        std::size_t neighbour = i;
        for (std::size_t j = 0; j < points; ++j) {
            if ((i > j ? i - j : j - i) <= window) continue;
            const double d = distance_squared(x, i, j, dimension, delay);
            if (d > 0 && d < nearest) nearest = d, neighbour = j;
        }
        if (neighbour == i) continue;
        for (std::size_t t = 0; t <= horizon; ++t) {
            const double d = std::abs(x[i + reach + t] - x[neighbour + reach + t]);
            if (d > 0) sums[t] += std::log(d), counts[t] += 1;
        }
    }
    for (std::size_t t = 0; t <= horizon; ++t) sums[t] = counts[t] > 0 ? sums[t] / counts[t] : nan;
    return sums;
}

/// Mean over the last quarter of a divergence.
double plateau_of(const std::vector<double>& curve) {
    const auto quarter = static_cast<std::ptrdiff_t>(curve.size() / 4);
    return std::accumulate(curve.end() - quarter, curve.end(), 0.0) / static_cast<double>(quarter);
}

/// Slope of the straight rise between the first sample and 70 % of the way to the plateau; NaN if there is none.
double rise_of(const std::vector<double>& curve) {
    constexpr double least_rise = 1.5;  // a factor 4.5 in distance
    constexpr std::size_t fewest_points = 4;
    constexpr double largest_bend = 0.06;  // scatter about the line, over the rise
    const double rise = plateau_of(curve) - curve[1];
    if (!(rise >= least_rise)) return nan;
    std::size_t end = 1;
    while (end < curve.size() && curve[end] < curve[1] + 0.7 * rise) ++end;
    if (end - 1 < fewest_points) return nan;
    std::vector<double> times(end - 1);
    std::iota(times.begin(), times.end(), 1.0);
    double c0, slope, c00, c01, c11, squares;
    gsl_fit_linear(times.data(), 1, curve.data() + 1, 1, times.size(), &c0, &slope, &c00, &c01, &c11, &squares);
    const double scatter = std::sqrt(squares / static_cast<double>(times.size()));
    return scatter <= largest_bend * rise ? slope : nan;
}

std::vector<std::size_t> ranks_of(std::span<const double> x) {
    std::vector<std::size_t> order(x.size()), ranks(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
    for (std::size_t r = 0; r < order.size(); ++r) ranks[order[r]] = r;
    return ranks;
}

/// Amplitude-adjusted Fourier surrogate: Gaussian values in the order of x, phases drawn anew, then x's own values in
/// the order of those.
std::vector<double> surrogate(std::span<const double> x, std::mt19937_64& random) {
    const std::size_t n = x.size();
    std::vector<double> sorted(x.begin(), x.end());
    std::sort(sorted.begin(), sorted.end());
    const auto ranks = ranks_of(x);
    ComplexFft fft(n);
    for (std::size_t i = 0; i < n; ++i)
        fft.input()[i] = gsl_cdf_ugaussian_Pinv((static_cast<double>(ranks[i]) + 0.5) / static_cast<double>(n));
    const auto image = fft.transform();
    std::vector<std::complex<double>> turned(image.begin(), image.end());
    for (std::size_t k = 1; 2 * k < n; ++k) {
        const double phase = 2 * std::numbers::pi * static_cast<double>(random() >> 11) * 0x1p-53;
        turned[k] *= std::polar(1.0, phase);
        turned[n - k] = std::conj(turned[k]);
    }
    std::copy(turned.begin(), turned.end(), fft.input().begin());
    std::vector<double> result(n);
    const auto back = fft.transform();  // forward again: the series backwards, which is a surrogate too
    for (std::size_t i = 0; i < n; ++i) result[i] = back[i].real();
    const auto order = ranks_of(result);
    for (std::size_t i = 0; i < n; ++i) result[i] = sorted[order[i]];
    return result;
}

/// Root mean square error of predicting x one delay ahead by the mean of the four nearest delay vectors of dimension 3.
double prediction_error(std::span<const double> x, std::size_t delay) {
    constexpr int dimension = 3;
    constexpr std::size_t neighbours = 4;
    const std::size_t ahead = 3 * delay;
    const std::size_t points = x.size() - ahead;
    double squares = 0;
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < points; ++i) {
        near.clear();
        for (std::size_t j = 0; j < points; ++j)
            if ((i > j ? i - j : j - i) > ahead) near.emplace_back(distance_squared(x, i, j, dimension, delay), j);
        std::partial_sort(near.begin(), near.begin() + neighbours, near.end());
        double prediction = 0;
        for (std::size_t k = 0; k < neighbours; ++k) prediction += x[near[k].second + ahead] / neighbours;
        squares += (x[i + ahead] - prediction) * (x[i + ahead] - prediction);
    }
    return std::sqrt(squares / static_cast<double>(points));
}

}  // namespace

SeriesExponent exponent_of_series(std::span<const double> series) {
    const auto x = last(series, most_for_exponent);
    const std::size_t delay = std::min(decorrelation(x), x.size() / 16);
    const std::size_t horizon = std::min(x.size() / 4, 30 * delay);
    std::vector<double> slopes;
    for (const int dimension : {2, 3, 4}) {
        const double slope = rise_of(divergence(x, dimension, delay, horizon));
        if (!std::isnan(slope)) slopes.push_back(slope);
    }
    SeriesExponent result;
    result.dimensions = static_cast<int>(slopes.size());
    result.exponent = result.spread = nan;
    if (slopes.empty()) return result;
    std::sort(slopes.begin(), slopes.end());
    result.exponent = slopes[slopes.size() / 2];
    result.spread = (slopes.back() - slopes.front()) / result.exponent;
    result.trusted = slopes.size() == 3 && result.exponent > 0 && result.spread <= largest_spread;
    return result;
}

double separation_of_neighbours(std::span<const double> series) {
    const auto x = last(series, most_for_exponent);
    const auto curve = divergence(x, 3, std::min(decorrelation(x), x.size() / 16), x.size() / 4);
    return plateau_of(curve) - curve[1];
}

SurrogateTest test_surrogates(std::span<const double> series) {
    const auto x = last(series, most_for_surrogates);
    const std::size_t delay = std::min(decorrelation(x), x.size() / 16);
    SurrogateTest test;
    test.error = prediction_error(x, delay);
    test.smallest_of_surrogates = infinity;
    std::mt19937_64 random(1);
    for (int i = 0; i < test.surrogates; ++i)
        test.smallest_of_surrogates =
            std::min(test.smallest_of_surrogates, prediction_error(surrogate(x, random), delay));
    return test;
}

}  // namespace swirl::analysis
