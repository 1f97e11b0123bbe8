#include "analysis/rotation/rotation_number.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/enum_name.hpp"
#include "analysis/rotation/weighted_birkhoff.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

namespace swirl::analysis {

namespace {

constexpr double rounding_turns = 1e-15;

void require_finite(std::span<const double> samples, const char* what) {
    for (std::size_t j = 0; j < samples.size(); ++j) {
        if (!std::isfinite(samples[j])) refuse(std::string(what) + "[" + std::to_string(j) + "]", samples[j], "finite");
    }
}

double fraction_of_turn(double turns) {
    const double part = turns - std::floor(turns);
    return part < 1 ? part : 0;
}

double to_digits(double difference) {
    return std::clamp(-std::log10(difference), 0.0, 16.0);
}

struct Branch {
    double cut = 0;  ///< turns: advances are taken in [cut, cut + 1)
    double gap = 0;  ///< turns: width of the free arc round the cut
};

/// The middle of the widest arc of the circle that holds none of `advances` (in [0, 1)).
Branch widest_free_arc(std::vector<double> advances) {
    std::sort(advances.begin(), advances.end());
    Branch best{(advances.back() + advances.front() + 1) / 2, advances.front() + 1 - advances.back()};
    for (std::size_t j = 1; j < advances.size(); ++j) {
        const double gap = advances[j] - advances[j - 1];
        if (gap > best.gap) best = {(advances[j] + advances[j - 1]) / 2, gap};
    }
    return best;
}

void judge(RotationNumber& result, bool converged, const RotationOptions& options) {
    if (!converged) {
        result.outcome = RotationOutcome::not_converged;
        return;
    }
    const double tolerance = std::max(options.rational_tolerance, 10 * result.half_difference);
    result.denominator = simplest_fraction(result.rotation, tolerance, options.max_denominator).denominator;
    result.outcome = result.denominator > 0 ? RotationOutcome::periodic : RotationOutcome::quasi_periodic;
}

/// The order p of the halves' difference, ∝ n^(−p), between n/4 and n samples.
double convergence_order(std::span<const double> advances, double half_difference) {
    const double early = weighted_birkhoff_average(advances.first(advances.size() / 4)).half_difference;
    if (early < rounding_turns) return 0;
    return std::log(early / std::max(half_difference, rounding_turns)) / std::log(4.0);
}

RotationNumber rotation_of_turns(const std::vector<double>& turns, const RotationOptions& options) {
    RotationNumber result;
    result.method = "angle";
    if (turns.size() < std::max<std::size_t>(options.min_samples, 8)) return result;
    std::vector<double> advances(turns.size() - 1);
    for (std::size_t j = 0; j < advances.size(); ++j) advances[j] = fraction_of_turn(turns[j + 1] - turns[j]);
    const Branch branch = widest_free_arc(advances);
    if (branch.gap < options.min_angular_gap) {
        result.outcome = RotationOutcome::not_a_rotation;
        return result;
    }
    for (double& advance : advances) advance = fraction_of_turn(advance - branch.cut);
    const WeightedAverage mean = weighted_birkhoff_average(advances);
    result.rotation = fraction_of_turn(mean.average + branch.cut);
    if (1 - result.rotation < rounding_turns) result.rotation = 0;
    result.half_difference = mean.half_difference;
    result.digits = to_digits(mean.half_difference);
    result.order = convergence_order(advances, mean.half_difference);
    judge(result, result.digits >= options.min_digits, options);
    return result;
}

bool is_constant(std::span<const double> samples) {
    const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
    const double scale = std::max(std::abs(*low), std::abs(*high));
    return *high - *low <= 64 * std::numeric_limits<double>::epsilon() * scale;
}

}  // namespace

std::string_view name_of(RotationOutcome outcome) {
    using enum RotationOutcome;
    return name_in<RotationOutcome>({{quasi_periodic, "quasi-periodic"},
                                     {periodic, "periodic"},
                                     {not_converged, "not-converged"},
                                     {not_a_rotation, "not-a-rotation"},
                                     {constant, "constant"},
                                     {too_short, "too-short"}},
                                    outcome);
}

Fraction simplest_fraction(double x, double tolerance, std::int64_t max_denominator) {
    // Walk down the Stern–Brocot tree: mediants come in order of growing denominator, so the first one within the
    // tolerance is the simplest. At most max_denominator steps.
    const double whole = std::floor(x);
    const double part = x - whole;
    Fraction low{0, 1};
    Fraction high{1, 1};
    const auto shifted = [&](Fraction f) {
        return Fraction{f.numerator + static_cast<std::int64_t>(whole) * f.denominator, f.denominator};
    };
    if (part <= tolerance) return shifted(low);
    if (1 - part <= tolerance) return shifted(high);
    while (low.denominator + high.denominator <= max_denominator) {
        const Fraction mediant{low.numerator + high.numerator, low.denominator + high.denominator};
        const double value = static_cast<double>(mediant.numerator) / static_cast<double>(mediant.denominator);
        if (std::abs(value - part) <= tolerance) return shifted(mediant);
        (value < part ? low : high) = mediant;
    }
    return {0, 0};
}

RotationNumber rotation_number_of_angle(std::span<const double> angles, double period, const RotationOptions& options) {
    if (!(period > 0) || !std::isfinite(period)) refuse("period", period, "positive and finite");
    require_finite(angles, "angles");
    std::vector<double> turns(angles.size());
    for (std::size_t j = 0; j < turns.size(); ++j) turns[j] = fraction_of_turn(angles[j] / period);
    return rotation_of_turns(turns, options);
}

RotationNumber rotation_number_by_delay(std::span<const double> samples, const RotationOptions& options) {
    require_finite(samples, "samples");
    RotationNumber result;
    result.method = "delay angle";
    if (samples.size() < options.min_samples + 1) return result;
    if (is_constant(samples)) {
        result.outcome = RotationOutcome::constant;
        return result;
    }
    const double centre = weighted_birkhoff_average(samples).average;
    std::vector<double> turns(samples.size() - 1);
    double least = infinity;
    double sum = 0;
    for (std::size_t j = 0; j < turns.size(); ++j) {
        const double x = samples[j] - centre;
        const double y = samples[j + 1] - centre;
        turns[j] = fraction_of_turn(std::atan2(y, x) / (2 * std::numbers::pi));
        least = std::min(least, std::hypot(x, y));
        sum += std::hypot(x, y);
    }
    if (least < options.min_radius * sum / static_cast<double>(turns.size())) {
        result.outcome = RotationOutcome::not_a_rotation;
        return result;
    }
    result = rotation_of_turns(turns, options);
    result.method = "delay angle";
    result.rotation = std::min(result.rotation, 1 - result.rotation);
    return result;
}

RotationNumber rotation_of_observable(std::span<const double> samples, const RotationOptions& options) {
    require_finite(samples, "samples");
    RotationNumber result;
    result.method = "frequency";
    result.order = nan;
    if (samples.size() < options.min_samples) return result;
    if (is_constant(samples)) {
        result.outcome = RotationOutcome::constant;
        return result;
    }
    const auto holds = [&](const FrequencyLine& line) {
        return to_digits(line.half_difference) >= options.min_digits &&
               line.half_difference * static_cast<double>(samples.size()) <= options.max_line_error;
    };
    // Where the strongest line does not hold, as in chaos, no other is asked.
    bool strongest = true;
    const std::vector<FrequencyLine> lines = fundamental_frequencies(
        samples, options, [&](const FrequencyLine& line) { return !std::exchange(strongest, false) || holds(line); });
    result.residual = 1;
    for (const FrequencyLine& line : lines) result.residual -= line.share;
    result.residual = std::max(0.0, result.residual);
    result.outcome = RotationOutcome::not_converged;
    std::int64_t period = 1;
    for (const FrequencyLine& line : lines) {
        result.rotation = line.frequency;
        result.half_difference = line.half_difference;
        result.digits = to_digits(line.half_difference);
        judge(result, holds(line) && result.residual <= options.max_residual, options);
        if (result.outcome != RotationOutcome::periodic) break;
        period = std::lcm(period, result.denominator);
    }
    if (result.outcome == RotationOutcome::periodic) result.denominator = period;
    if (result.outcome != RotationOutcome::not_converged) return result;
    const RotationNumber delayed = rotation_number_by_delay(samples, options);
    return delayed.outcome == RotationOutcome::quasi_periodic ? delayed : result;
}

}  // namespace swirl::analysis
