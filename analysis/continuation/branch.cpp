#include "analysis/continuation/branch.hpp"

#include "analysis/continuation/multipliers.hpp"

namespace swirl::analysis {

std::string_view name(SpecialKind kind) {
    switch (kind) {
        case SpecialKind::fold: return "fold";
        case SpecialKind::flip: return "flip";
        case SpecialKind::neimark_sacker: return "neimark-sacker";
        case SpecialKind::branch_point: return "branch-point";
        case SpecialKind::border: return "border";
    }
    return "?";
}

std::string_view name(BranchEnd end) {
    switch (end) {
        case BranchEnd::range: return "range";
        case BranchEnd::closed: return "closed";
        case BranchEnd::border: return "border";
        case BranchEnd::not_converged: return "not-converged";
        case BranchEnd::most_points: return "most-points";
        case BranchEnd::halved: return "halved";
        case BranchEnd::switched: return "switched";
        case BranchEnd::stopped: return "stopped";
    }
    return "?";
}

BranchPoint branch_point_at(const CurvePoint& at) {
    Cycle cycle;
    cycle.multipliers = multipliers_at(at);
    judge_stability(cycle);
    BranchPoint point;
    point.at = at;
    point.multipliers = cycle.multipliers;
    point.index = cycle.index;
    point.stability = cycle.stability;
    point.mean = at.closing.integral / at.closing.duration;
    return point;
}

}  // namespace swirl::analysis
