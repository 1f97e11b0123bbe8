#include "analysis/spectrum/resample.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/special_values.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr std::size_t most_samples = std::size_t{1} << 28;
/// In units of the spacing: a grid point that misses a sample by rounding only is taken to be on it.
constexpr double sample_slack = 1e-9;

/// The value at t, which lies between samples i and i + 1.
double value_at(const TimedSamples& in, std::size_t i, double t, Interpolation interpolation, double longest,
                double slack) {
    const double from = in.times[i];
    const double to = in.times[i + 1];
    if (std::abs(t - from) <= slack) return in.values[i];
    if (std::abs(t - to) <= slack) return in.values[i + 1];
    if (to - from > longest) return nan;
    if (interpolation == Interpolation::hold) return in.values[i];
    return in.values[i] + (t - from) / (to - from) * (in.values[i + 1] - in.values[i]);
}

struct EvenGrid {
    double spacing;
    Interpolation interpolation;
    double longest;  ///< distance of samples that is no gap
};

/// The values at times.front() + k spacing.
std::vector<double> on_even_times(const TimedSamples& in, const EvenGrid& grid) {
    const double slack = sample_slack * grid.spacing;
    const double span = in.times.back() - in.times.front();
    const auto count = static_cast<std::size_t>(std::floor((span + slack) / grid.spacing)) + 1;
    std::vector<double> values;
    values.reserve(count);
    std::size_t i = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double t = std::min(in.times.front() + static_cast<double>(k) * grid.spacing, in.times.back());
        while (i + 2 < in.times.size() && in.times[i + 1] <= t + slack) ++i;
        values.push_back(value_at(in, i, t, grid.interpolation, grid.longest, slack));
    }
    return values;
}

/// The Nyquist frequency that is lower, of the new grid or of the samples; 0: they have the same.
double low_pass_for(double spacing, double own) {
    constexpr double same = 0.01;  // the mean distance is not that of the grid to the last digit
    return std::abs(spacing / own - 1) <= same ? 0 : 0.5 / std::max(spacing, own);
}

/// Every `every`-th value after a low-pass that leaves nothing from `nyquist` on, in cycles per value. NaN stay where
/// they are. O(n half periods).
std::vector<double> smoothed(const std::vector<double>& values, std::size_t every, double nyquist) {
    constexpr double half_periods = 32, share = 43.0 / 47.0;
    const double cutoff = share * nyquist;
    const auto reach = static_cast<std::ptrdiff_t>(half_periods / (2 * nyquist));
    std::vector<double> weights;  // from the middle on
    for (std::ptrdiff_t j = 0; j <= reach; ++j) {
        const double x = std::numbers::pi * static_cast<double>(j) / (static_cast<double>(reach) + 1);
        const double blackman = 0.42 + 0.5 * std::cos(x) + 0.08 * std::cos(2 * x);
        const double turn = 2 * std::numbers::pi * cutoff * static_cast<double>(j);
        weights.push_back(blackman * (j == 0 ? 1 : std::sin(turn) / turn));
    }
    const auto n = static_cast<std::ptrdiff_t>(values.size());
    std::vector<double> result;
    for (std::ptrdiff_t k = 0; k < n; k += static_cast<std::ptrdiff_t>(every)) {
        double sum = 0, weight = 0;
        for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, k - reach); i <= std::min(n - 1, k + reach); ++i) {
            if (std::isnan(values[static_cast<std::size_t>(i)])) continue;
            const double w = weights[static_cast<std::size_t>(std::abs(i - k))];
            sum += w * values[static_cast<std::size_t>(i)];
            weight += w;
        }
        result.push_back(std::isnan(values[static_cast<std::size_t>(k)]) ? nan : sum / weight);
    }
    return result;
}

}  // namespace

TimedSamples samples_there(std::span<const double> times, std::span<const double> values) {
    if (times.size() != values.size()) {
        throw std::invalid_argument("number of times = " + std::to_string(times.size()) +
                                    ": must be the number of values, " + std::to_string(values.size()));
    }
    TimedSamples kept;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!std::isfinite(times[i]) || (i > 0 && !(times[i] > times[i - 1]))) {
            refuse("times[" + std::to_string(i) + "]", times[i], "finite and later than the one before");
        }
        if (std::isnan(values[i])) continue;
        kept.times.push_back(times[i]);
        kept.values.push_back(values[i]);
    }
    if (kept.times.size() < 2) {
        throw std::invalid_argument("number of samples = " + std::to_string(kept.times.size()) +
                                    ": must be at least 2 that are not NaN");
    }
    return kept;
}

double median_distance(std::span<const double> times) {
    std::vector<double> distances(times.size() - 1);
    for (std::size_t i = 0; i < distances.size(); ++i) distances[i] = times[i + 1] - times[i];
    std::sort(distances.begin(), distances.end());
    return gsl_stats_median_from_sorted_data(distances.data(), 1, distances.size());
}

std::string_view name_of(Interpolation interpolation) {
    return interpolation == Interpolation::linear ? "linear" : "hold";
}

Interpolation interpolation_from_name(std::string_view word) {
    if (word == "linear") return Interpolation::linear;
    if (word == "hold") return Interpolation::hold;
    throw std::invalid_argument("interpolation = " + std::string(word) + ": must be linear or hold");
}

Resampled resample(std::span<const double> times, std::span<const double> values, const ResampleOptions& options) {
    const TimedSamples in = samples_there(times, values);
    const double median = median_distance(in.times);
    if (!(options.gap_factor > 1)) refuse("gap_factor", options.gap_factor, "above 1");
    const double spacing = options.spacing == 0 ? median : options.spacing;
    const double span = in.times.back() - in.times.front();
    if (!(spacing > 0)) refuse("spacing", spacing, "positive");
    if (span / spacing > static_cast<double>(most_samples)) {
        refuse(
            "spacing", spacing,
            "at least " + digits_of(span / static_cast<double>(most_samples)) + ", the length of the series over 2^28");
    }
    Resampled result;
    result.series.start = in.times.front();
    result.series.spacing = spacing;
    const double longest = options.gap_factor * median;
    double own = 0, count = 0;
    for (std::size_t i = 0; i + 1 < in.times.size(); ++i) {
        const double distance = in.times[i + 1] - in.times[i];
        if (distance <= longest) {
            own += distance;
            ++count;
            continue;
        }
        ++result.gaps;
        result.missing_fraction += distance / span;
    }
    own /= count;
    result.own_nyquist = 1 / (2 * own);
    if (options.low_pass) result.low_pass = low_pass_for(spacing, own);
    if (result.low_pass == 0) {
        result.series.values = on_even_times(in, {spacing, options.interpolation, longest});
        return result;
    }
    const auto finer = static_cast<std::size_t>(std::ceil(2 * spacing / own));
    const double step = spacing / static_cast<double>(finer);
    if (span / step > static_cast<double>(most_samples))
        refuse("spacing", spacing,
               "at least " + digits_of(span * static_cast<double>(finer) / static_cast<double>(most_samples)));
    result.series.values =
        smoothed(on_even_times(in, {step, options.interpolation, longest}), finer, result.low_pass * step);
    return result;
}

}  // namespace swirl::analysis
