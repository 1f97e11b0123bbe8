#include "analysis/spectrum/resample.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/special_values.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr std::size_t most_samples = std::size_t{1} << 28;
/// In units of the spacing: a grid point that misses a sample by rounding only is taken to be on it.
constexpr double sample_slack = 1e-9;

struct Samples {
    std::vector<double> times;
    std::vector<double> values;
};

Samples checked(std::span<const double> times, std::span<const double> values) {
    if (times.size() != values.size()) {
        throw std::invalid_argument("number of times = " + std::to_string(times.size()) +
                                    ": must be the number of values, " + std::to_string(values.size()));
    }
    Samples kept;
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

double median_distance(const std::vector<double>& times) {
    std::vector<double> distances(times.size() - 1);
    for (std::size_t i = 0; i < distances.size(); ++i) distances[i] = times[i + 1] - times[i];
    std::sort(distances.begin(), distances.end());
    return gsl_stats_median_from_sorted_data(distances.data(), 1, distances.size());
}

/// The value at t, which lies between samples i and i + 1.
double value_at(const Samples& in, std::size_t i, double t, Interpolation interpolation, double longest, double slack) {
    const double from = in.times[i];
    const double to = in.times[i + 1];
    if (std::abs(t - from) <= slack) return in.values[i];
    if (std::abs(t - to) <= slack) return in.values[i + 1];
    if (to - from > longest) return nan;
    if (interpolation == Interpolation::hold) return in.values[i];
    return in.values[i] + (t - from) / (to - from) * (in.values[i + 1] - in.values[i]);
}

}  // namespace

std::string_view name_of(Interpolation interpolation) {
    return interpolation == Interpolation::linear ? "linear" : "hold";
}

Interpolation interpolation_from_name(std::string_view word) {
    if (word == "linear") return Interpolation::linear;
    if (word == "hold") return Interpolation::hold;
    throw std::invalid_argument("interpolation = " + std::string(word) + ": must be linear or hold");
}

Resampled resample(std::span<const double> times, std::span<const double> values, const ResampleOptions& options) {
    const Samples in = checked(times, values);
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
    for (std::size_t i = 0; i + 1 < in.times.size(); ++i) {
        const double distance = in.times[i + 1] - in.times[i];
        if (distance <= longest) continue;
        ++result.gaps;
        result.missing_fraction += distance / span;
    }
    const double slack = sample_slack * spacing;
    const auto count = static_cast<std::size_t>(std::floor((span + slack) / spacing)) + 1;
    std::size_t i = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double t = std::min(in.times.front() + static_cast<double>(k) * spacing, in.times.back());
        while (i + 2 < in.times.size() && in.times[i + 1] <= t + slack) ++i;
        result.series.values.push_back(value_at(in, i, t, options.interpolation, longest, slack));
    }
    return result;
}

}  // namespace swirl::analysis
