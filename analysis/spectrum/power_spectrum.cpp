#include "analysis/spectrum/power_spectrum.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/enum_name.hpp"
#include "analysis/spectrum/fft.hpp"
#include "analysis/spectrum/segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t least_samples = 8;
constexpr std::size_t least_segments_for_spread = 4;

template <class Sample>
void require_valid(std::span<const Sample> series, double spacing, const SpectrumOptions& options) {
    if (!(spacing > 0) || !std::isfinite(spacing)) refuse("spacing", spacing, "positive and finite");
    if (!(options.overlap >= 0 && options.overlap < 1)) refuse("overlap", options.overlap, "in [0, 1)");
    if (!(options.cycle_time > 0) || !std::isfinite(options.cycle_time)) {
        refuse("cycle_time", options.cycle_time, "positive and finite");
    }
    if (options.segment_length != 0 && options.segment_length < least_samples) {
        refuse("segment_length", static_cast<double>(options.segment_length), "0 (automatic) or at least 8");
    }
    for (const Sample& x : series) {
        if (!is_missing(x) && !std::isfinite(std::abs(x)))
            refuse("series", std::abs(x), "finite, or NaN where missing");
    }
}

/// Subtracts mean or least-squares line over the samples that are there; returns the scale of the series, max |x|.
template <class Sample>
double subtract_trend(std::vector<Sample>& series, Detrend detrend) {
    double scale = 0;
    double count = 0;
    double index_mean = 0;
    Sample mean{};
    for (std::size_t j = 0; j < series.size(); ++j) {
        if (is_missing(series[j])) continue;
        count += 1;
        mean += series[j];
        index_mean += static_cast<double>(j);
        scale = std::max(scale, std::abs(series[j]));
    }
    if (detrend == Detrend::none || count == 0) return scale;
    mean /= count;
    index_mean /= count;
    Sample slope{};
    Sample correction{};  // of the mean's own rounding, which grows with the length of the series
    double moment = 0;
    for (std::size_t j = 0; j < series.size(); ++j) {
        if (is_missing(series[j])) continue;
        const double offset = static_cast<double>(j) - index_mean;
        correction += series[j] - mean;
        slope += offset * (series[j] - mean);
        moment += offset * offset;
    }
    mean += correction / count;
    slope = detrend == Detrend::linear && moment > 0 ? slope / moment : Sample{};
    for (std::size_t j = 0; j < series.size(); ++j) series[j] -= mean + slope * (static_cast<double>(j) - index_mean);
    return scale;
}

template <class Sample>
double mean_square(std::span<const Sample> series) {
    double sum = 0;
    double count = 0;
    for (const Sample& x : series) {
        if (is_missing(x)) continue;
        sum += std::norm(x);
        count += 1;
    }
    return count > 0 ? sum / count : 0;
}

/// Variance of estimates from overlapping segments: K/(1 + 2 Σ_s (1 − s/K) ρ_s), ρ_s = (Σ w_j w_{j+sD})²/(Σ w²)².
double independent_segments(const std::vector<double>& window, std::size_t hop, std::size_t segments) {
    double own = 0;
    for (const double w : window) own += w * w;
    double inflation = 1;
    for (std::size_t s = 1; s < segments && s * hop < window.size(); ++s) {
        double overlap = 0;
        for (std::size_t j = 0; j + s * hop < window.size(); ++j) overlap += window[j] * window[j + s * hop];
        const double correlation = (overlap / own) * (overlap / own);
        inflation += 2 * (1 - static_cast<double>(s) / static_cast<double>(segments)) * correlation;
    }
    return static_cast<double>(segments) / inflation;
}

struct Periodograms {
    std::vector<double> mean;    ///< ⟨|X_k|²⟩
    std::vector<double> spread;  ///< standard deviation over mean
    std::size_t used = 0;
};

template <class Sample>
Periodograms average_segments(std::span<const Sample> series, const std::vector<double>& window,
                              const std::vector<std::size_t>& starts) {
    const std::size_t length = window.size();
    Fft<Sample> fft(length);
    Periodograms result;
    std::vector<double> scatter;  // running sum of squared deviations (Welford)
    for (const std::size_t start : starts) {
        const std::span<const Sample> segment = series.subspan(start, length);
        for (std::size_t j = 0; j < length; ++j) fft.input()[j] = window[j] * segment[j];
        const std::span<const Complex> bins = fft.transform();
        result.mean.resize(bins.size());
        scatter.resize(bins.size());
        const double count = static_cast<double>(++result.used);
        for (std::size_t k = 0; k < bins.size(); ++k) {
            const double deviation = std::norm(bins[k]) - result.mean[k];
            result.mean[k] += deviation / count;
            scatter[k] += deviation * (std::norm(bins[k]) - result.mean[k]);
        }
    }
    if (result.used < least_segments_for_spread) return result;
    for (std::size_t k = 0; k < scatter.size(); ++k) {
        const double deviation = std::sqrt(scatter[k] / (static_cast<double>(result.used) - 1));
        result.spread.push_back(result.mean[k] > 0 ? deviation / result.mean[k] : 0);
    }
    return result;
}

/// Puts the negative frequencies of a complex transform before the others.
void order_two_sided(std::vector<double>& values) {
    const auto negative = static_cast<std::ptrdiff_t>(values.size() / 2);
    std::rotate(values.begin(), values.end() - negative, values.end());
}

/// Frequencies, one- or two-sided ordering, the integral, and the bins' attenuation.
void finish(PowerSpectrum& result, Periodograms& periodograms, double window_power) {
    const std::size_t length = result.segment_length;
    const double samples = static_cast<double>(length);
    result.frequency_step = result.settings.cycle_time / (result.spacing * samples);
    result.power = std::move(periodograms.mean);
    result.spread = std::move(periodograms.spread);
    std::ptrdiff_t first = 0;
    if (result.two_sided) {
        order_two_sided(result.power);
        if (!result.spread.empty()) order_two_sided(result.spread);
        first = -static_cast<std::ptrdiff_t>(length / 2);
    } else {
        const std::size_t last = length % 2 == 0 ? result.power.size() - 1 : result.power.size();
        for (std::size_t k = 1; k < last; ++k) result.power[k] *= 2;
    }
    double sum = 0;
    for (const double p : result.power) sum += p;
    // Welch's own normalisation integrates to Σ|X|²/(L Σw²); the scale is what brings it to the variance.
    if (sum > 0 && result.variance > 0) result.variance_scale = result.variance / (sum / (samples * window_power));
    const double to_density = sum > 0 ? result.variance / (sum * result.frequency_step) : 0;
    for (std::size_t k = 0; k < result.power.size(); ++k) {
        const double bin = static_cast<double>(first + static_cast<std::ptrdiff_t>(k));
        result.frequency.push_back(bin * result.frequency_step);
        result.power[k] *= to_density;
        if (result.settings.compensate_bin_average) result.power[k] /= bin_average_gain(bin / samples);
    }
}

/// Variances of the detrended series and of its halves; true if it is constant to rounding.
template <class Sample>
bool measure_variance(PowerSpectrum& result, std::span<const Sample> series, double scale) {
    result.variance = mean_square(series);
    const double first = mean_square(series.first(series.size() / 2));
    const double second = mean_square(series.last(series.size() / 2));
    if (std::sqrt(result.variance) <= 64 * std::numeric_limits<double>::epsilon() * scale) {
        result.variance = 0;
        return true;
    }
    result.nonstationarity = std::abs(first - second) / (first + second);
    return false;
}

template <class Sample>
PowerSpectrum estimate(std::span<const Sample> given, double spacing, const SpectrumOptions& options) {
    require_valid(given, spacing, options);
    PowerSpectrum result;
    result.two_sided = std::is_same_v<Sample, Complex>;
    result.samples = given.size();
    result.spacing = spacing;
    result.settings = options;
    result.segment_length = options.segment_length;
    const std::vector<Stretch> stretches = stretches_of(given);
    if (result.segment_length == 0) result.segment_length = automatic_segment_length(stretches, options.overlap);
    result.settings.segment_length = result.segment_length;
    if (given.size() < std::max(least_samples, result.segment_length)) return result;
    result.outcome = SpectrumOutcome::no_complete_segment;
    if (result.segment_length < least_samples) return result;

    std::vector<Sample> series(given.begin(), given.end());
    const double scale = subtract_trend(series, options.detrend);
    const std::span<const Sample> all(series);
    const bool constant = measure_variance(result, all, scale);

    const std::vector<double> window = window_values(options.window, result.segment_length);
    const double length = static_cast<double>(result.segment_length);
    const auto hop = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(length * (1 - options.overlap))));
    const std::vector<std::size_t> starts =
        segment_starts(stretches, result.segment_length, options.overlap, options.segments);
    Periodograms periodograms = average_segments(all, window, starts);
    result.segments = periodograms.used;
    if (result.segments == 0) return result;
    const Stretch whole{stretches.front().begin, stretches.back().end};
    const std::size_t without_gaps = segments_within({&whole, 1}, result.segment_length, options.overlap);
    result.segments_skipped = stretches.size() > 1 ? without_gaps - std::min(without_gaps, result.segments) : 0;
    result.outcome = constant ? SpectrumOutcome::constant : SpectrumOutcome::completed;
    result.effective_segments = independent_segments(window, hop, result.segments);
    finish(result, periodograms, std::inner_product(window.begin(), window.end(), window.begin(), 0.0));
    return result;
}

}  // namespace

std::string_view name_of(Detrend detrend) {
    using enum Detrend;
    return name_in<Detrend>({{none, "none"}, {mean, "mean"}, {linear, "linear"}}, detrend);
}

Detrend detrend_from_name(std::string_view word) {
    for (const Detrend detrend : {Detrend::none, Detrend::mean, Detrend::linear}) {
        if (name_of(detrend) == word) return detrend;
    }
    throw std::invalid_argument("detrend = " + std::string(word) + ": must be none, mean or linear");
}

std::string_view name_of(SpectrumOutcome outcome) {
    using enum SpectrumOutcome;
    return name_in<SpectrumOutcome>({{completed, "completed"},
                                     {constant, "constant"},
                                     {too_short, "too-short"},
                                     {no_complete_segment, "no-complete-segment"}},
                                    outcome);
}

double bin_average_gain(double frequency) {
    const double x = std::numbers::pi * frequency;
    return x == 0 ? 1 : std::pow(std::sin(x) / x, 2);
}

PowerSpectrum power_spectrum(std::span<const double> series, double spacing, const SpectrumOptions& options) {
    return estimate(series, spacing, options);
}

PowerSpectrum power_spectrum(std::span<const Complex> series, double spacing, const SpectrumOptions& options) {
    return estimate(series, spacing, options);
}

}  // namespace swirl::analysis
