#include "analysis/classification/classify.hpp"

namespace swirl::analysis::classification_detail {

namespace {

void describe_cycle(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    auto& evidence = result.evidence;
    if (!findings.has_cycle) {
        evidence.push_back({"period", 0, static_cast<double>(options.period.max_period),
                            "no attracting cycle of this period or a shorter one is near the orbit's end"});
        return;
    }
    evidence.push_back({"closure", findings.closure, options.period.closure,
                        findings.closure <= options.period.closure
                            ? "the orbit itself returns in all section coordinates"
                            : "the orbit is still approaching the cycle that Newton's method found"});
    evidence.push_back({"cycle residual", findings.residual, options.period.residual,
                        "how well the polished cycle closes"});
    evidence.push_back({"distance to cycle", findings.distance, options.period.vicinity,
                        "from the orbit's last state"});
    evidence.push_back({"slowest multiplier", findings.slowest_multiplier, 1,
                        findings.is_family ? "a multiplier is 1: a member of a family; the others attract"
                                           : "all multipliers attract"});
}

void describe_exponent(const Findings& findings, Classification& result) {
    const SignEvidence& e = findings.exponent;
    if (findings.exponent_outcome != LyapunovOutcome::completed) {
        result.evidence.push_back({"largest exponent", Classification::unknown, 0,
                                   std::string(name(findings.exponent_outcome))});
        return;
    }
    result.evidence.push_back({"largest exponent", e.exponent, e.standard_error,
                               std::string(name(e.sign)) + " (threshold: its standard error)"});
}

/// The paper's rule reads RC alone; it stands here as evidence, not as a judge.
void describe_recurrence(Classification& result) {
    result.evidence.push_back({"recurrence rate without diagonal", result.recurrence_rate_without_diagonal, 1e-4,
                               result.recurrence_rate_without_diagonal < 1e-4 ? "as the paper's chaotic mode"
                                                                              : "values of the observable recur"});
}

void describe_rotation(const Findings& findings, Classification& result) {
    result.evidence.push_back({"rotation number", findings.rotation.rotation, findings.rotation.half_difference,
                               std::string(name(findings.rotation.outcome)) +
                                   " (threshold: difference of its halves)"});
}

}  // namespace

void decide(const Findings& findings, const ClassifyOptions& options, Classification& result) {
    describe_cycle(findings, options, result);
    describe_exponent(findings, result);
    describe_recurrence(result);
    const bool chaotic = findings.exponent.sign == ExponentSign::positive;
    result.mode = Mode::undecided;
    result.kind = Kind::transient;
    if (findings.has_cycle && !chaotic) {
        result.mode = result.period == 1 ? Mode::steady : Mode::quasi_steady;
        result.kind = result.period > 1 ? Kind::cycle : findings.is_family ? Kind::family : Kind::fixed_point;
        return;
    }
    if (chaotic && !findings.has_cycle) {
        result.mode = Mode::chaotic;
        result.kind = Kind::chaotic;
        return;
    }
    if (findings.has_cycle) return;  // settles on an attracting cycle and yet grows: a transient
    describe_rotation(findings, result);
    const bool settled = std::abs(std::log(findings.spread_change)) <= std::log(options.settled_spread);
    result.evidence.push_back({"change of spread along the tail", findings.spread_change, options.settled_spread,
                               settled ? "the orbit keeps its size" : "the orbit is still settling"});
    if (settled && findings.rotation.outcome == RotationOutcome::quasi_periodic) {
        result.mode = Mode::quasi_steady;
        result.kind = Kind::quasi_periodic;
        result.rotation = findings.rotation.rotation;
    }
}

}  // namespace swirl::analysis::classification_detail
