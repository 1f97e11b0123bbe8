#include "analysis/classification/classify_series.hpp"

#include "analysis/spectrum/lines.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace swirl::analysis {

namespace {

constexpr std::size_t fewest = 64;
constexpr double largest_change = 0.5;  // between the halves
constexpr double rounding = 1e-9;  // of the largest value: as the closure of an orbit that has settled

struct Repetition {
    int period = 0;           ///< 0: none
    double residual = 0;      ///< standard deviation about the phase means
    double correlation = 0;   ///< largest autocorrelation of the residual
};

double deviation_of(std::span<const double> x) { return gsl_stats_sd(x.data(), 1, x.size()); }

/// The residual about the k phase means.
std::vector<double> residual_of(std::span<const double> x, std::size_t k) {
    std::vector<double> means(k, 0), rest(x.begin(), x.end());
    for (std::size_t p = 0; p < k; ++p) {
        std::size_t count = 0;
        for (std::size_t i = p; i < x.size(); i += k) means[p] += x[i], ++count;
        means[p] /= static_cast<double>(count);
    }
    for (std::size_t i = 0; i < x.size(); ++i) rest[i] -= means[i % k];
    return rest;
}

double largest_autocorrelation(const std::vector<double>& r, std::size_t lags) {
    double variance = 0, largest = 0;
    for (const double v : r) variance += v * v;
    for (std::size_t lag = 1; lag <= lags && lag < r.size() / 4; ++lag) {
        double sum = 0;
        for (std::size_t i = 0; i + lag < r.size(); ++i) sum += r[i] * r[i + lag];
        largest = std::max(largest, std::abs(sum / variance));
    }
    return largest;
}

/// The smallest period whose residual is noise. A period whose residual is small but not white ends the search: the
/// multiples of it would hide the structure in more means.
Repetition repetition_of(std::span<const double> x, double limit, double exact, int max_period) {
    const std::size_t n = x.size();
    const std::size_t most = std::min(static_cast<std::size_t>(max_period), n / 8);
    for (std::size_t k = 1; k <= most; ++k) {
        const auto rest = residual_of(x, k);
        double squares = 0;
        for (const double v : rest) squares += v * v;
        const double residual = std::sqrt(squares / static_cast<double>(n - k));
        if (residual > limit) continue;
        if (residual <= exact) return {static_cast<int>(k), residual, 0};
        const double correlation = largest_autocorrelation(rest, 2 * k + 8);
        const bool white = correlation <= 4 / std::sqrt(static_cast<double>(n));
        return {white ? static_cast<int>(k) : 0, residual, correlation};
    }
    return {};
}

void describe_repetition(const Repetition& repetition, double limit, double white, Classification& result) {
    const bool repeats = repetition.period > 0, found = repeats || repetition.residual > 0;
    result.evidence.push_back({"residual about the phase means", repetition.residual, limit,
                               repeats ? "repeats within the noise"
                               : found ? "small at one period, but structured: no noise"
                                       : "repeats at no period looked for",
                               repeats
                                   ? "above " + in_words(limit) + ": another period, or lines and predictability decide"
                               : found ? "nothing alone: its structure decides"
                                       : "at most " + in_words(limit) + " and white at one period: that cycle"});
    if (!(repetition.residual > 0)) return;
    const bool is_white = repetition.correlation <= white;
    result.evidence.push_back(
        {"autocorrelation of the residual", repetition.correlation, white, is_white ? "white" : "structured",
         is_white ? "above " + in_words(white) + ": no noise; lines and predictability would decide"
                  : "at most " + in_words(white) + ": noise about a cycle"});
}

/// Largest shift between the halves: of their means over the standard deviation, of their variances over their sum.
bool lasts(std::span<const double> x, double deviation, Classification& result) {
    const auto first = x.first(x.size() / 2), second = x.last(x.size() / 2);
    const double shift = std::abs(gsl_stats_mean(first.data(), 1, first.size()) -
                                  gsl_stats_mean(second.data(), 1, second.size())) / deviation;
    const double a = gsl_stats_variance(first.data(), 1, first.size());
    const double b = gsl_stats_variance(second.data(), 1, second.size());
    const double change = std::abs(a - b) / (a + b);
    const auto add = [&](const char* name, double value) {
        const bool lasting = value <= largest_change;
        result.evidence.push_back({name, value, largest_change, lasting ? "it lasts" : "still settling",
                                   lasting ? "above " + in_words(largest_change) + ": undecided, still settling"
                                           : "at most " + in_words(largest_change) +
                                                 ": its repetitions, lines and predictability would decide"});
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
    result.evidence.push_back({"share of the variance in spectral lines", share.line_fraction, all,
                               std::string(name(share.verdict)) +
                                   (share.steadiness_tested ? "" : " (too few segments to tell a line from a band)"),
                               lines ? "below " + in_words(all) + ": not all lines, predictability would decide"
                                     : "at or above " + in_words(all) +
                                           ": all lines, quasi-steady if neighbours stay neighbours"});
    return share;
}

void name_lines(std::span<const double> x, bool sampled_flow, Classification& result) {
    const double separation = separation_of_neighbours(x);
    const bool kept = separation <= std::log(2);
    result.evidence.push_back({"logarithmic separation of neighbours", separation, std::log(2),
                               !kept          ? "neighbours part: chaos on narrow bands, or noise"
                               : sampled_flow ? "neighbours stay: periodic or quasi-periodic in time"
                                              : "neighbours stay: a torus",
                               (kept ? "above " : "at most ") + in_words(std::log(2)) +
                                   (kept ? ": undecided" : ": quasi-steady")});
    if (!kept) return;
    result.mode = Mode::quasi_steady;
    result.kind = sampled_flow ? Kind::none : Kind::quasi_periodic;
}

void name_irregular(std::span<const double> x, Classification& result) {
    const SurrogateTest surrogates = test_surrogates(x);
    const bool deterministic = surrogates.error < surrogates.smallest_of_surrogates;
    result.evidence.push_back({"prediction error", surrogates.error, surrogates.smallest_of_surrogates,
                               deterministic
                                   ? "smaller than that of each of 39 surrogates: deterministic, not linear noise"
                                   : "not smaller than that of linear noise (the smallest of 39 surrogates)",
                               deterministic ? "at or above " + in_words(surrogates.smallest_of_surrogates) +
                                                   ": as linear noise, undecided"
                                             : "below " + in_words(surrogates.smallest_of_surrogates) +
                                                   ": deterministic, chaotic if neighbours part at one rate"});
    const SeriesExponent exponent = exponent_of_series(x);
    result.evidence.push_back(
        {"divergence of neighbours per sample", exponent.exponent, exponent.spread,
         exponent.trusted ? "a straight rise, the same in dimensions 2, 3 and 4 (threshold: their spread)"
                          : "no straight rise that embedding dimensions 2, 3 and 4 agree on",
         exponent.trusted ? "at or below 0, or a spread above " + in_words(largest_spread) + ": undecided"
                          : "positive with a spread of at most " + in_words(largest_spread) +
                                (deterministic ? ": chaotic" : ": still undecided, as it is not predictable")});
    if (!exponent.trusted) return;
    result.largest_exponent = exponent.exponent;
    result.largest_exponent_error = exponent.spread * exponent.exponent / 2;
    if (!deterministic) return;
    result.mode = Mode::chaotic;
    result.kind = Kind::chaotic;
}

}  // namespace

Classification classify_series(std::span<const double> x, const ClassifySeriesOptions& options) {
    if (x.size() < fewest)
        throw std::invalid_argument("series of " + std::to_string(x.size()) + " samples: must be " +
                                    std::to_string(fewest) + " or more without a gap");
    if (!(options.noise >= 0 && std::isfinite(options.noise)))
        throw std::invalid_argument("noise = " + std::to_string(options.noise) + ": must be >= 0, finite");
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
    const double exact = rounding * largest;
    const bool constant = deviation <= std::max(exact, 1.5 * options.noise);
    if (!constant && !lasts(x, deviation, result)) {
        result.kind = Kind::transient;
        return result;
    }
    const double limit = options.noise > 0 ? 1.5 * options.noise : constant ? exact : options.largest_noise * deviation;
    const Repetition repetition = repetition_of(x, std::max(limit, exact), exact, options.max_period);
    const double white = 4 / std::sqrt(static_cast<double>(x.size()));
    describe_repetition(repetition, std::max(limit, exact), white, result);
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
