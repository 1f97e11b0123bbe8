#include "analysis/classification/classify.hpp"

#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::analysis::classification_detail {

namespace {

constexpr const char* then_others_decide = "the largest exponent and the rotation number then decide";

void describe_period(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    const double longest = static_cast<double>(options.period.max_period);
    const std::string range = "2 to " + std::to_string(options.period.max_period);
    if (!findings.has_cycle) {
        result.evidence.push_back({"period", 0, longest,
                                   "no attracting cycle of this period or a shorter one is near the orbit's end",
                                   "a cycle of period 1 is found: steady; of period " + range + ": quasi-steady"});
        return;
    }
    result.evidence.push_back(
        {"period", static_cast<double>(result.period), longest,
         "the smallest number of impacts after which all section coordinates return",
         (result.period == 1 ? "period " + range + ": quasi-steady" : std::string("period 1: steady")) +
             "; no period up to " + std::to_string(options.period.max_period) + ": " + then_others_decide});
}

void describe_cycle(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    auto& evidence = result.evidence;
    const PeriodOptions& limits = options.period;
    const bool closed = findings.closure <= limits.closure;
    evidence.push_back(
        {"closure", findings.closure, limits.closure,
         closed ? "the orbit itself returns in all section coordinates"
                : "the orbit is still approaching the cycle that Newton's method found",
         closed ? "above " + in_words(limits.closure) + ": no cycle, unless Newton's method finds an attracting one"
                : "above " + in_words(limits.vicinity) + ": no cycle, " + then_others_decide});
    const double residual = findings.has_multipliers ? limits.residual : limits.closure;
    evidence.push_back({"cycle residual", findings.residual, residual, "how well the cycle closes",
                        "above " + in_words(residual) +
                            (closed && findings.has_multipliers ? ": the orbit's own closure would be the evidence"
                                                                : std::string(": no cycle, ") + then_others_decide)});
    if (findings.farthest > 0)
        evidence.push_back(
            {"distance to cycle", findings.distance, findings.farthest,
             "the cycle lies as near to the orbit's last state as its return allows",
             "above " + in_words(findings.farthest) + ": another cycle than the orbit's, " + then_others_decide});
    if (findings.has_multipliers)
        evidence.push_back({"slowest multiplier", findings.slowest_multiplier, 1 - neutral_margin,
                            !findings.attracting ? "the cycle does not attract, but the orbit has stayed on it"
                            : findings.is_family ? "one multiplier is 1, as of a member of a family; the others attract"
                                                 : "all multipliers attract",
                            findings.attracting
                                ? "at or above 1 - " + in_words(neutral_margin) + ": no attracting cycle; " +
                                      then_others_decide + ", unless the orbit itself stays on it"
                                : "nothing: the verdict rests on the orbit's own return"});
    if (findings.superstable)
        evidence.push_back({"rank of the derivative along the cycle", 0, 0,
                            "superstable: the cycle annihilates every direction, so that one exact return repeats",
                            "a rank of 1 or more: the orbit itself must stay on the cycle"});
    else if (!findings.attracting)
        evidence.push_back({"closure throughout", findings.closure_persists ? 1.0 : 0.0, 1,
                            "the orbit returns after every impact of the tail's last quarter",
                            "it does not return: it passes an unstable cycle; " + std::string(then_others_decide)});
}

/// What suffices to be positive: beyond its errors and beyond what a bounded sum may leave.
void describe_exponent(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    const SignEvidence& e = findings.exponent;
    if (findings.exponent_outcome != LyapunovOutcome::completed) {
        result.evidence.push_back(
            {"largest exponent", nan, 0, std::string(name_of(findings.exponent_outcome)), "positive: chaotic"});
        return;
    }
    if (e.exponent == -infinity) {
        result.evidence.push_back({"largest exponent", e.exponent, 0,
                                   "a step on the way, such as a rest, or several landings annihilate every direction: "
                                   "neighbouring orbits become one",
                                   "a finite exponent: its sign decides"});
        return;
    }
    const double sigmas = options.sigmas;
    const double errors = std::isnan(e.standard_error) ? 0 : sigmas * e.standard_error;
    const std::string cycle = findings.has_cycle ? "undecided, as it contradicts the cycle" : "chaotic";
    const bool positive = e.sign == ExponentSign::positive;
    const std::string sign =
        "exponent is " + std::string(name_of(e.sign)) + " (threshold: " + in_words(sigmas) + " standard errors)";
    result.evidence.push_back(
        {"largest exponent", e.exponent, errors,
         positive && findings.has_cycle ? "the orbit nears a cycle, and yet its " + sign : "the " + sign,
         positive ? "at or below " + in_words(errors) + ": not positive, " +
                        (findings.has_cycle ? "so the cycle stands" : "and the rotation number decides")
                  : "above " + in_words(std::max(errors, e.shrinking_bound)) + " (" + in_words(sigmas) +
                        " standard errors, and the bound of a neutral direction): " + cycle});
}

/// The rule of Sun 2019 (docs/references.md) reads RC alone; it is evidence, and does not decide.
void describe_recurrence(Classification& result) {
    constexpr double sun_2019 = 1e-4;
    const bool few = result.recurrence_rate_without_diagonal < sun_2019;
    result.evidence.push_back(
        {"recurrence rate without diagonal", result.recurrence_rate_without_diagonal, sun_2019,
         few ? "values of the observable do not recur" : "values of the observable recur",
         "nothing: this does not decide (the rule of Sun 2019 alone would call it " +
             std::string(few ? "chaotic, and regular at or above " : "regular, and chaotic below ") +
             in_words(sun_2019) + ")"});
}

void describe_rounding(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    const double limit = options.period.rounding;
    result.evidence.push_back(
        {"growth of rounding along the period", findings.rounding, limit,
         "the orbit returns, but its period is decided by rounding, whose errors grow to this along it: "
         "chaos between superstable landings",
         "at most " + in_words(limit) + ": quasi-steady, that cycle"});
}

std::string rotation_in_words(const RotationNumber& rotation) {
    switch (rotation.outcome) {
        case RotationOutcome::quasi_periodic:
            return "the orbit winds round a torus: both halves give one number, and it is no fraction";
        case RotationOutcome::periodic:
            return "the number is a fraction of denominator " + std::to_string(rotation.denominator) +
                   ", but no cycle of that period was found";
        case RotationOutcome::not_converged:
            return "no rotation number: the halves of the orbit give two that differ by " +
                   in_words(rotation.half_difference) + " turns";
        case RotationOutcome::not_a_rotation:
            return "no rotation number: the orbit does not wind round a closed curve";
        case RotationOutcome::constant:
            return "no rotation number: the observable is constant to rounding";
        case RotationOutcome::too_short:
            return "no rotation number: " + std::to_string(RotationOptions{}.min_samples) + " impacts are needed";
    }
    return "";
}

/// What would make a torus of the orbit, or none.
std::string other_rotation_in_words(RotationOutcome outcome) {
    const RotationOptions limits;
    const std::string close = in_words(std::pow(10, -limits.min_digits)) + " turns";
    const std::string fraction = "fraction of denominator up to " + std::to_string(limits.max_denominator);
    const std::string torus = ": quasi-steady, if the orbit keeps its size";
    switch (outcome) {
        case RotationOutcome::quasi_periodic:
            return "halves that differ by more than " + close + ", or a " + fraction + ": undecided";
        case RotationOutcome::periodic:
            return "a cycle of that period is found: quasi-steady; or more impacts show a number that is no " +
                   fraction + torus;
        case RotationOutcome::not_a_rotation:
            return "the orbit winds round a closed curve, and both halves of it give one number" + torus;
        case RotationOutcome::constant:
            return "the observable varies: a rotation number is then looked for";
        case RotationOutcome::too_short:
            return std::to_string(limits.min_samples) + " impacts or more: a rotation number is then looked for";
        case RotationOutcome::not_converged:
            break;
    }
    return "both halves give one number to " + close + " (more impacts tell), no " + fraction + torus;
}

void describe_rotation(const Findings& findings, Classification& result) {
    const RotationNumber& rotation = findings.rotation;
    result.evidence.push_back({"rotation number", rotation.rotation, rotation.half_difference,
                               rotation_in_words(rotation), other_rotation_in_words(rotation.outcome)});
}

bool describe_size(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    const bool settled = std::abs(std::log(findings.spread_change)) <= std::log(options.settled_spread);
    const std::string range = in_words(1 / options.settled_spread) + " to " + in_words(options.settled_spread);
    const bool torus = findings.rotation.outcome == RotationOutcome::quasi_periodic;
    const std::string changing =
        options.conserves ? "the tail is too short for the orbit's slow beats" : "the orbit's size still changes";
    result.evidence.push_back(
        {"change of spread along the tail", findings.spread_change, options.settled_spread,
         settled ? "the orbit keeps its size" : changing,
         settled ? "outside " + range + ": undecided, since " + changing
         : torus ? "within " + range + ": quasi-steady, a torus"
                 : "within " + range + ": the orbit keeps its size; a rotation number is needed, too"});
    return settled;
}

/// What one orbit in chaos can't exclude: none of n steps led out of it, so that the rate is below 3/n at 95 %.
void describe_stay(Classification& result) {
    const auto steps = static_cast<double>(result.steps);
    const double half_life = std::log(2) * steps / 3;
    result.evidence.push_back({"steps without leaving chaos", steps, half_life,
                               "a transient whose half-life is above " + in_words(half_life) +
                                   " steps is not excluded (95 %); more starts, or steps, tell",
                               "nothing: this does not decide"});
}

/// An attracting cycle's exponent is ln of its largest |multiplier| over its period, and no statistics.
void describe_settled(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    const auto limit = static_cast<double>(options.transient + options.collisions);
    result.evidence.push_back({"steps until it was settled", static_cast<double>(result.steps), limit,
                               findings.is_family
                                   ? "on a member of a family that attracts: no continuation leads away"
                                   : "within the ball about an attracting cycle in which the linear part rules: no "
                                     "continuation leads away",
                               "none up to " + in_words(limit) + ": all of these steps would be judged"});
    result.evidence.push_back({"largest exponent", result.largest_exponent, 0,
                               "ln of the cycle's largest |multiplier| over its period",
                               "above 0: the cycle would not attract"});
}

}  // namespace

void decide_settled(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    describe_period(findings, options, result);
    describe_cycle(findings, options, result);
    describe_settled(findings, options, result);
    describe_recurrence(result);
    result.mode = result.period == 1 ? Mode::steady : Mode::quasi_steady;
    result.kind = result.period > 1 ? Kind::cycle : findings.is_family ? Kind::family : Kind::fixed_point;
}

void decide(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    describe_period(findings, options, result);
    if (findings.has_cycle) describe_cycle(findings, options, result);
    describe_exponent(findings, options, result);
    describe_recurrence(result);
    const bool chaotic = findings.exponent.sign == ExponentSign::positive;
    result.mode = Mode::undecided;
    result.kind = findings.has_cycle && chaotic && !options.conserves ? Kind::transient : Kind::none;
    if (findings.has_cycle && !chaotic) {
        result.mode = result.period == 1 ? Mode::steady : Mode::quasi_steady;
        result.kind = result.period > 1 ? Kind::cycle : findings.is_family ? Kind::family : Kind::fixed_point;
        return;
    }
    if (chaotic && !findings.has_cycle) {
        result.mode = Mode::chaotic;
        result.kind = Kind::chaotic;
        describe_stay(result);
        return;
    }
    if (findings.rounding > 0) {
        describe_rounding(findings, options, result);
        return;
    }
    if (findings.has_cycle) return;  // settles on an attracting cycle and yet grows: a transient
    describe_rotation(findings, result);
    if (!describe_size(findings, options, result)) {
        if (!options.conserves) result.kind = Kind::transient;
        return;
    }
    if (findings.rotation.outcome != RotationOutcome::quasi_periodic) return;
    result.mode = Mode::quasi_steady;
    result.kind = Kind::quasi_periodic;
    result.rotation = findings.rotation.rotation;
}

}  // namespace swirl::analysis::classification_detail
