#include "analysis/classification/classify_series.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/classification/returns.hpp"
#include "analysis/classification/series_exponent.hpp"
#include "analysis/classification/surrogates.hpp"
#include "analysis/special_values.hpp"
#include "analysis/spectrum/lines.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>

namespace swirl::analysis {

namespace {

constexpr double largest_change = 0.5;  // between the halves
// Of the largest value, some 5000 ε: what rounding leaves of a computed series, and far below a measured signal on a
// large offset.
constexpr double series_rounding = 1e-12;

double deviation_of(std::span<const double> x) {
    return gsl_stats_sd(x.data(), 1, x.size());
}

/// With the structured period, if multiples of one were looked for.
std::string words_of(const Repetition& repetition) {
    const std::string structured = "structured at period " + std::to_string(repetition.structured);
    if (repetition.period > 0)
        return "the series repeats within the noise" + (repetition.structured > 0 ? " (" + structured + ")" : "");
    return repetition.structured > 0 ? "the residual is small, but " + structured + ", so it is no noise"
                                     : "the series repeats at no period that was tried";
}

void describe_repetition(const Repetition& repetition, double limit, std::size_t samples, Classification& result) {
    const bool repeats = repetition.period > 0, found = repeats || repetition.structured > 0;
    result.evidence.push_back(
        {"residual about the phase means", repetition.residual, limit, words_of(repetition),
         repeats ? "above " + in_words(limit) + ": another period, or lines and predictability decide"
         : found ? "at most half of it and white at a multiple of that period: quasi-steady, that cycle"
                 : "at most " + in_words(limit) + " and white at one period: steady (period 1) or quasi-steady"});
    if (!(repetition.residual > 0)) return;
    const auto add = [&](const char* name, double value, double threshold, bool is_white, const std::string& within,
                         const std::string& beyond) {
        result.evidence.push_back(
            {name, value, threshold, is_white ? "the residual is white, as noise is" : "the residual has structure",
             is_white ? beyond + ": no noise; lines and predictability decide" : within + ": noise about a cycle"});
    };
    const double white = white_autocorrelation(samples);
    add("autocorrelation of the residual", repetition.correlation, white, repetition.correlation <= white,
        "at most " + in_words(white) + ", and white phase by phase", "above " + in_words(white));
    add("chance of the residual's correlations phase by phase", repetition.chance, smallest_chance,
        repetition.chance >= smallest_chance, "at least " + in_words(smallest_chance) + ", and no autocorrelation",
        "below " + in_words(smallest_chance));
}

/// Largest shift between the halves: of their means over the standard deviation, of their variances over their sum.
bool lasts(std::span<const double> x, double deviation, Classification& result) {
    const auto first = x.first(x.size() / 2), second = x.last(x.size() / 2);
    const double shift =
        std::abs(gsl_stats_mean(first.data(), 1, first.size()) - gsl_stats_mean(second.data(), 1, second.size())) /
        deviation;
    const double a = gsl_stats_variance(first.data(), 1, first.size());
    const double b = gsl_stats_variance(second.data(), 1, second.size());
    const double change = std::abs(a - b) / (a + b);
    const auto add = [&](const char* name, double value, bool lasting) {
        result.evidence.push_back(
            {name, value, largest_change, lasting ? "the halves agree" : "the series still settles",
             lasting ? "above " + in_words(largest_change) + ": undecided, since the series still settles"
                     : "at most " + in_words(largest_change) + ": its repetitions, lines and predictability decide"});
    };
    const bool mean_lasts = shift <= largest_change, variance_lasts = change <= largest_change;
    const auto add_mean = [&] { add("shift of the mean between the halves", shift, mean_lasts); };
    if (mean_lasts) add_mean();
    add("change of the variance between the halves", change, variance_lasts);
    if (!mean_lasts) add_mean();  // what speaks against is said last
    return mean_lasts && variance_lasts;
}

LineShare lines_of(std::span<const double> x, Classification& result) {
    SpectrumOptions options;
    options.cycle_time = 1;
    const LineShare share = line_share(power_spectrum(x, 1, options));
    const double all = LineOptions{}.all_lines;
    const bool lines = share.verdict == SpectrumVerdict::lines;
    result.evidence.push_back(
        {"share of the variance in spectral lines", share.line_fraction, all,
         std::string(name_of(share.verdict)) +
             (share.steadiness_tested ? "" : " (too few segments to tell a line from a band)"),
         lines && !share.steadiness_tested
             ? "a longer series, whose segments show that lines stay: quasi-steady if neighbours stay neighbours"
         : lines ? "below " + in_words(all) + ": not all are lines, and predictability decides"
                 : "at or above " + in_words(all) + ": all lines, quasi-steady if neighbours stay neighbours"});
    return share;
}

void name_lines(std::span<const double> x, bool sampled_flow, Classification& result) {
    const double separation = separation_of_neighbours(x);
    const bool kept = separation <= std::log(2);
    result.evidence.push_back(
        {"logarithmic separation of neighbours", separation, std::log(2),
         !kept          ? "neighbours part, as in chaos on narrow bands or in noise"
         : sampled_flow ? "neighbours stay: the series is periodic or quasi-periodic in time"
                        : "neighbours stay, as on a torus",
         (kept ? "above " : "at most ") + in_words(std::log(2)) + (kept ? ": undecided" : ": quasi-steady")});
    if (!kept) return;
    result.mode = Mode::quasi_steady;
    result.kind = sampled_flow ? Kind::none : Kind::quasi_periodic;
}

Evidence divergence_evidence(const SeriesExponent& found, const std::string& otherwise) {
    const bool above = found.exponent > 2 * found.error;
    return {"divergence of neighbours per sample", found.exponent, 2 * found.error,
            found.dimensions < 2 ? "neighbours part along no straight stretch in two embedding dimensions"
            : !above             ? "the rate at which neighbours part is not told from 0"
            : found.resolved     ? "neighbours part at one rate (threshold: two of its errors)"
                                 : "neighbours part, but are too far apart from the first for an exponent",
            found.dimensions < 2 ? "a longer series, in which they part along such a stretch: " + otherwise
            : above              ? "at or below " + in_words(2 * found.error) + " (two of its errors): undecided"
                                 : "above " + in_words(2 * found.error) + " (two of its errors): " + otherwise};
}

Evidence typical_evidence(const SeriesExponent& found, const std::string& otherwise) {
    const bool typical = found.typical >= smallest_typical;
    return {"rate of the median pair of neighbours over the mean one", found.typical, smallest_typical,
            typical ? "most pairs part, not a few" : "a few pairs jump apart while most stay, as in a random telegraph",
            (typical ? "below " : "at or above ") + in_words(smallest_typical) +
                (typical ? ": undecided" : ": " + otherwise)};
}

Evidence prediction_evidence(const SurrogateTest& surrogates, bool deterministic) {
    const std::string least = in_words(surrogates.limit());
    return {"prediction error", surrogates.error, surrogates.limit(),
            deterministic ? "every surrogate errs more by a twentieth (39 a kind): the series is no such noise"
                          : surrogates.kind + " is predicted as well (the best of 39 surrogates)",
            deterministic ? "at or above " + least + ": undecided, since " + surrogates.kind + " does as well"
                          : "below " + least + ": deterministic, chaotic if neighbours part at one rate"};
}

/// How the mean frequency of a smooth series goes from part to part of it.
struct FrequencyDrift {
    double ratio = 2;   ///< von Neumann's: Σ (ω_{k+1} − ω_k)²/Σ (ω_k − mean)², 2 where parts are independent
    double change = 1;  ///< the largest ω_k over the smallest
    bool is_slow() const { return ratio < slow_drift && change > 1.3; }
    static constexpr double slow_drift = 0.3;  // of 16 independent parts five times in a million
};

/// ω_k by 2(1 − cos ω) = Σ(Δx)²/Σ(x − mean)², exact of a tone. Of a series with less than six samples a cycle, or four
/// cycles a part, it tells nothing.
FrequencyDrift frequency_drift(std::span<const double> x) {
    constexpr std::size_t parts = 16;
    constexpr double fewest_cycles = 4, least_samples = 6;
    const auto frequency_of = [](std::span<const double> part) {
        const double mean = gsl_stats_mean(part.data(), 1, part.size());
        double steps = 0, squares = 0;
        for (std::size_t i = 0; i < part.size(); ++i) {
            squares += (part[i] - mean) * (part[i] - mean);
            if (i > 0) steps += (part[i] - part[i - 1]) * (part[i] - part[i - 1]);
        }
        return squares > 0 ? std::acos(std::clamp(1 - 0.5 * steps / squares, -1.0, 1.0)) : 0.0;
    };
    const std::size_t length = x.size() / parts;
    const double turn = 2 * std::numbers::pi, whole = frequency_of(x);
    if (whole > turn / least_samples || whole * static_cast<double>(length) < fewest_cycles * turn) return {};
    std::array<double, parts> frequencies{};
    for (std::size_t k = 0; k < parts; ++k) frequencies[k] = frequency_of(x.subspan(k * length, length));
    const auto [low, high] = std::minmax_element(frequencies.begin(), frequencies.end());
    double differences = 0;
    for (std::size_t k = 1; k < parts; ++k) differences += std::pow(frequencies[k] - frequencies[k - 1], 2);
    const double squares = gsl_stats_tss(frequencies.data(), 1, parts);
    if (!(*low > 0) || !(squares > 0)) return {};
    return {differences / squares, *high / *low};
}

/// What speaks against chaos is said last.
void name_irregular(std::span<const double> x, bool sampled_flow, Classification& result) {
    const SurrogateTest surrogates = test_surrogates(x);
    const bool deterministic = surrogates.error < surrogates.limit();
    const SeriesExponent found = exponent_of_series(x, sampled_flow);
    const std::string otherwise = deterministic ? "chaotic" : "still undecided, since noise is predicted as well";
    const auto add = [&](bool wanted) {
        if (deterministic == wanted) result.evidence.push_back(prediction_evidence(surrogates, deterministic));
        if (found.dimensions >= 2 && (found.typical >= smallest_typical) == wanted)
            result.evidence.push_back(typical_evidence(found, otherwise));
        if ((found.exponent > 2 * found.error) == wanted)
            result.evidence.push_back(divergence_evidence(found, otherwise));
    };
    add(true);
    add(false);
    if (!found.is_positive()) return;
    if (found.resolved) {
        result.largest_exponent = found.exponent;
        result.largest_exponent_error = found.error;
    }
    if (!deterministic) return;
    if (const FrequencyDrift drift = frequency_drift(x); drift.is_slow()) {
        result.evidence.push_back({"steps of the mean frequency from part to part, over its scatter", drift.ratio,
                                   FrequencyDrift::slow_drift,
                                   "the frequency changes slowly all along, as that of a tone which is swept",
                                   "at or above " + in_words(FrequencyDrift::slow_drift) + ": chaotic"});
        result.largest_exponent = result.largest_exponent_error = nan;
        return;
    }
    result.mode = Mode::chaotic;
    result.kind = Kind::chaotic;
}

}  // namespace

Classification classify_series(std::span<const double> x, const ClassifySeriesOptions& options) {
    if (x.size() < fewest_samples)
        throw std::invalid_argument("series of " + std::to_string(x.size()) + " samples: must be " +
                                    std::to_string(fewest_samples) + " or more without a gap");
    if (!(options.noise >= 0 && std::isfinite(options.noise))) refuse("noise", options.noise, ">= 0, finite");
    Classification result;
    result.mode = Mode::undecided;
    result.steps = static_cast<std::int64_t>(x.size());
    const auto points = recurrence::embed_series(x);  // throws for a value that is not finite
    const auto rate = recurrence::recurrence_rate(points, options.recurrence_threshold);
    result.recurrence_rate = rate.with_diagonal();
    result.recurrence_rate_without_diagonal = rate.without_diagonal();
    result.mean = result.mean_per_step = gsl_stats_mean(x.data(), 1, x.size());

    double largest = 0;
    for (const double v : x) largest = std::max(largest, std::abs(v));
    const double deviation = deviation_of(x);
    const double exact = series_rounding * largest;
    const bool constant = deviation <= std::max(exact, 1.5 * options.noise);
    if (!constant && !lasts(x, deviation, result)) {
        result.kind = Kind::transient;
        return result;
    }
    const double limit = options.noise > 0 ? 1.5 * options.noise : constant ? exact : options.largest_noise * deviation;
    const RepetitionLimits limits{std::max(limit, exact), exact, options.max_period};
    const Repetition repetition = repetition_of(x, limits);
    describe_repetition(repetition, limits.residual, x.size(), result);
    if (repetition.period > 0) {
        result.period = options.sampled_flow && repetition.period > 1 ? 0 : repetition.period;
        result.mode = repetition.period == 1 ? Mode::steady : Mode::quasi_steady;
        result.kind = repetition.period == 1 ? Kind::fixed_point : Kind::cycle;
        return result;
    }
    if (constant) return result;
    const LineShare share = lines_of(x, result);
    if (share.verdict == SpectrumVerdict::lines) {
        if (share.steadiness_tested) name_lines(x, options.sampled_flow, result);
        return result;
    }
    name_irregular(x, options.sampled_flow, result);
    return result;
}

}  // namespace swirl::analysis
