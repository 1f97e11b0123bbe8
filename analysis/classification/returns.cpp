#include "analysis/classification/returns.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace swirl::analysis {

namespace {

// Eight equal repetitions are no accident; of noise, eight a phase can hide any dependence.
constexpr std::size_t fewest_exact = 8, fewest_noisy = 16;
constexpr double finer_residual = 0.5;  // of that of the structured period

/// The residual about the k phase means. A phase's mean is taken from its first sample on: what repeats exactly leaves
/// exactly nothing.
std::vector<double> residual_of(std::span<const double> x, std::size_t k) {
    std::vector<double> rest(x.begin(), x.end());
    for (std::size_t p = 0; p < k; ++p) {
        double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = p; i < x.size(); i += k) sum += rest[i] -= x[p], ++count;
        const double mean = sum / static_cast<double>(count);
        for (std::size_t i = p; i < x.size(); i += k) rest[i] -= mean;
    }
    return rest;
}

double deviation_of_residual(const std::vector<double>& rest, std::size_t k) {
    double squares = 0;
    for (const double v : rest) squares += v * v;
    return std::sqrt(squares / static_cast<double>(rest.size() - k));
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

/// McLeod's portmanteau test for periodic series (J. Time Series Anal. 15 (1994) 221): of white noise the squared
/// correlations of phase p with the next two phases, times their numbers, are a χ² of as many degrees of freedom as
/// there are phases that are more than rounding.
double chance_by_phase(const std::vector<double>& rest, std::size_t k, double rounding) {
    std::vector<double> deviations(k, 0), counts(k, 0);
    for (std::size_t i = 0; i < rest.size(); ++i) deviations[i % k] += rest[i] * rest[i], counts[i % k] += 1;
    for (std::size_t p = 0; p < k; ++p) deviations[p] = std::sqrt(deviations[p] / counts[p]);
    double sum = 0, freedom = 0;
    for (const std::size_t lag : {std::size_t{1}, std::size_t{2}})
        for (std::size_t p = 0; p < k; ++p) {
            const double one = deviations[p], other = deviations[(p + lag) % k];
            if (!(std::min(one, other) > rounding)) continue;
            double products = 0, pairs = 0;
            for (std::size_t i = p; i + lag < rest.size(); i += k)
                products += rest[i] / one * (rest[i + lag] / other), ++pairs;
            sum += (pairs + 2) * (products / pairs) * (products / pairs);
            ++freedom;
        }
    return freedom > 0 ? gsl_cdf_chisq_Q(sum, freedom) : 1;
}

}  // namespace

double white_autocorrelation(std::size_t n) {
    return 4 / std::sqrt(static_cast<double>(n));
}

Repetition repetition_of(std::span<const double> x, const RepetitionLimits& limits) {
    const std::size_t n = x.size();
    const std::size_t most = std::min(static_cast<std::size_t>(limits.max_period), n / fewest_exact);
    Repetition first;
    for (std::size_t k = 1; k <= most; ++k) {
        const int period = static_cast<int>(k);
        if (first.structured > 0 && period % first.structured != 0) continue;
        const auto rest = residual_of(x, k);
        const double residual = deviation_of_residual(rest, k);
        if (residual <= limits.exact) return {period, residual, 0, 1, first.structured};
        if (residual > limits.residual || k > n / fewest_noisy) continue;
        if (first.structured > 0 && residual > finer_residual * first.residual) continue;
        const double correlation = largest_autocorrelation(rest, 2 * k + 8);
        const double chance = chance_by_phase(rest, k, limits.exact);
        const bool white = correlation <= white_autocorrelation(n) && chance >= smallest_chance;
        if (white) return {period, residual, correlation, chance, first.structured};
        if (first.structured == 0) first = {0, residual, correlation, chance, period};
    }
    return first;
}

}  // namespace swirl::analysis
