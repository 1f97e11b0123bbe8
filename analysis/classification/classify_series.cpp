#include "analysis/classification/classify_series.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/classification/repetition.hpp"
#include "analysis/spectrum/lines.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
    result.evidence.push_back({"residual about the phase means", repetition.residual, limit, words_of(repetition),
                               repeats
                                   ? "above " + in_words(limit) + ": another period, or lines and predictability decide"
                               : found ? "at most half of it and white at a multiple of that period: that cycle"
                                       : "at most " + in_words(limit) + " and white at one period: that cycle"});
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
    const auto add = [&](const char* name, double value) {
        const bool lasting = value <= largest_change;
        result.evidence.push_back(
            {name, value, largest_change, lasting ? "the halves agree" : "the series still settles",
             lasting ? "above " + in_words(largest_change) + ": undecided, since the series still settles"
                     : "at most " + in_words(largest_change) + ": its repetitions, lines and predictability decide"});
        return lasting;
    };
    const bool mean_lasts = add("shift of the mean between the halves", shift);
    return add("change of the variance between the halves", change) && mean_lasts;
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
         lines ? "below " + in_words(all) + ": not all are lines, and predictability decides"
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

void name_irregular(std::span<const double> x, Classification& result) {
    const SurrogateTest surrogates = test_surrogates(x);
    const bool deterministic = surrogates.error < surrogates.smallest_of_surrogates;
    result.evidence.push_back({"prediction error", surrogates.error, surrogates.smallest_of_surrogates,
                               deterministic
                                   ? "each of 39 surrogates errs more: the series is deterministic, not linear noise"
                                   : "linear noise is predicted as well (the best of 39 surrogates)",
                               deterministic ? "at or above " + in_words(surrogates.smallest_of_surrogates) +
                                                   ": undecided, since linear noise does as well"
                                             : "below " + in_words(surrogates.smallest_of_surrogates) +
                                                   ": deterministic, chaotic if neighbours part at one rate"});
    const SeriesExponent exponent = exponent_of_series(x);
    result.evidence.push_back(
        {"divergence of neighbours per sample", exponent.exponent, exponent.spread,
         exponent.trusted ? "neighbours part at one rate in dimensions 2, 3 and 4 (threshold: their spread)"
                          : "embedding dimensions 2, 3 and 4 agree on no straight rise",
         exponent.trusted ? "at or below 0, or a spread above " + in_words(largest_spread) + ": undecided"
                          : "positive with a spread of at most " + in_words(largest_spread) +
                                (deterministic ? ": chaotic" : ": still undecided, since it is not predictable")});
    if (!exponent.trusted) return;
    result.largest_exponent = exponent.exponent;
    result.largest_exponent_error = exponent.spread * exponent.exponent / 2;
    if (!deterministic) return;
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
    name_irregular(x, result);
    return result;
}

}  // namespace swirl::analysis
