#include "analysis/lyapunov/exponent_sign.hpp"

#include "analysis/enum_name.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr std::size_t least_blocks = 32;

void require_index(const LyapunovSpectrum& spectrum, std::size_t index) {
    if (index < spectrum.exponents.size()) return;
    throw std::invalid_argument("exponent index = " + std::to_string(index) + ": must be below " +
                                std::to_string(spectrum.exponents.size()));
}

double mean_of(const std::vector<double>& values, std::size_t first, std::size_t last) {
    return std::accumulate(values.begin() + first, values.begin() + last, 0.0) / static_cast<double>(last - first);
}

void measure_octaves(SignEvidence& evidence, const std::vector<double>& sums) {
    evidence.last_octave = nan;
    evidence.octave_before = nan;
    evidence.least_quarter = nan;
    if (sums.size() < least_blocks) return;
    const auto middle = sums.begin() + static_cast<std::ptrdiff_t>(sums.size() / 2);
    const auto quarter = sums.begin() + static_cast<std::ptrdiff_t>(sums.size() / 4);
    evidence.last_octave = std::accumulate(middle, sums.end(), 0.0);
    evidence.octave_before = std::accumulate(quarter, middle, 0.0);
    const auto last = sums.end() - static_cast<std::ptrdiff_t>(sums.size() / 4);
    evidence.least_quarter =
        std::min({evidence.octave_before, std::accumulate(middle, last, 0.0), std::accumulate(last, sums.end(), 0.0)});
}

/// True if Σ ln growth drifts in one direction.
bool drifts(const SignEvidence& evidence, double total, const SignOptions& options) {
    return std::abs(total) > options.drift && evidence.last_octave * total > options.drift_share * total * total;
}

double change_over_last_doubling(const LyapunovSpectrum& spectrum, std::size_t index) {
    for (auto point = spectrum.record.rbegin(); point != spectrum.record.rend(); ++point) {
        if (2 * point->step <= spectrum.steps) {
            return std::abs(spectrum.exponents[index] - point->exponents[index]);
        }
    }
    return nan;
}

}  // namespace

std::string_view name_of(ExponentSign sign) {
    using enum ExponentSign;
    return name_in<ExponentSign>(
        {{positive, "positive"}, {negative, "negative"}, {neutral, "neutral"}, {undecided, "undecided"}}, sign);
}

SignEvidence judge_sign(const LyapunovSpectrum& spectrum, std::size_t index, const SignOptions& options) {
    require_index(spectrum, index);
    const double steps = static_cast<double>(std::max<std::int64_t>(spectrum.steps, 1));
    SignEvidence evidence;
    evidence.exponent = spectrum.exponents[index];
    evidence.standard_error = spectrum.standard_errors[index];
    evidence.growth_order = spectrum.growth_orders[index];
    evidence.shrinking_bound = options.neutral_scale * (1 + std::log(steps)) / steps;
    evidence.weighted_exponent = spectrum.weighted_exponents[index];
    evidence.weighted_half_difference = spectrum.weighted_half_difference[index];
    if (std::isnan(evidence.exponent)) return evidence;
    if (std::isinf(evidence.exponent)) {
        evidence.sign = ExponentSign::negative;
        return evidence;
    }
    const double size = std::abs(evidence.exponent);
    const bool weighted_zero = std::abs(evidence.weighted_exponent) <= options.neutral_weighted &&
                               evidence.weighted_half_difference <= options.neutral_weighted;
    measure_octaves(evidence, spectrum.block_sums[index]);
    const bool bounded = evidence.growth_order <= options.neutral_growth;
    const bool sheared = std::abs(evidence.last_octave) <= options.shear_octave &&
                         std::abs(evidence.last_octave) <= options.shear_ratio * std::abs(evidence.octave_before);
    const bool drifting = drifts(evidence, evidence.exponent * steps, options);
    if (evidence.least_quarter > options.neutral_scale * (1 + std::log(steps)) &&
        evidence.exponent > options.burst_sigmas * evidence.standard_error) {
        evidence.sign = ExponentSign::positive;
    } else if (weighted_zero || (size <= evidence.shrinking_bound && (bounded || sheared) && !drifting)) {
        evidence.sign = ExponentSign::neutral;
    } else if (size > options.sigmas * evidence.standard_error) {
        evidence.sign = evidence.exponent > 0 ? ExponentSign::positive : ExponentSign::negative;
    }
    return evidence;
}

bool is_clearly_positive(const SignEvidence& evidence) {
    return evidence.sign == ExponentSign::positive && evidence.exponent > evidence.shrinking_bound;
}

std::int64_t steps_until_positive(const SignEvidence& evidence, std::int64_t steps, const SignOptions& options) {
    constexpr double spare = 1.5;  // the exponent itself is known to some of its errors only
    constexpr double most = 1e15;  // more steps than any orbit has
    if (!(evidence.exponent > 0) || !std::isfinite(evidence.standard_error)) return 0;
    const double errors = options.sigmas * evidence.standard_error / evidence.exponent;
    double needed = static_cast<double>(steps) * errors * errors;
    double bounded = static_cast<double>(steps);
    for (int i = 0; i < 10; ++i)  // n = neutral_scale (1 + ln n)/λ, by iteration, which contracts like 1/ln n
        bounded = options.neutral_scale * (1 + std::log(std::max(bounded, 1.0))) / evidence.exponent;
    needed = std::max(needed, bounded);
    return static_cast<std::int64_t>(std::min(spare * needed, most));
}

Settling judge_settling(const LyapunovSpectrum& spectrum, std::size_t index, double tolerance, double sigmas) {
    require_index(spectrum, index);
    Settling result{false, nan, nan, nan, nan};
    const double exponent = spectrum.exponents[index];
    if (std::isinf(exponent)) return {true, exponent, exponent, 0, 0};
    const std::vector<double>& sums = spectrum.block_sums[index];
    if (sums.size() < least_blocks) return result;
    const double length = static_cast<double>(spectrum.block_length);
    const std::size_t quarter = sums.size() / 4;
    const std::size_t half = sums.size() / 2;
    result.early = mean_of(sums, 0, quarter) / length;
    result.late = mean_of(sums, half, sums.size()) / length;
    const BlockError late = block_error({sums.begin() + half, sums.end()});
    // The early mean scatters, too: the same variance per block, but fewer blocks.
    const double inflation = 1 + static_cast<double>(sums.size() - half) / static_cast<double>(quarter);
    result.error = late.standard_error / length * std::sqrt(inflation);
    result.last_change = change_over_last_doubling(spectrum, index);
    result.settled = std::abs(result.late - result.early) <= std::max(sigmas * result.error, tolerance);
    return result;
}

}  // namespace swirl::analysis
