#include "analysis/continuation/branch.hpp"

#include "analysis/continuation/multipliers.hpp"
#include "analysis/continuation/put_before.hpp"

#include <algorithm>
#include <utility>

namespace swirl::analysis {

std::string_view name_of(SpecialKind kind) {
    switch (kind) {
        case SpecialKind::fold:
            return "fold";
        case SpecialKind::flip:
            return "flip";
        case SpecialKind::neimark_sacker:
            return "neimark-sacker";
        case SpecialKind::branch_point:
            return "branch-point";
        case SpecialKind::border:
            return "border";
    }
    return "?";
}

std::string_view name_of(BranchEnd end) {
    switch (end) {
        case BranchEnd::range:
            return "range";
        case BranchEnd::closed:
            return "closed";
        case BranchEnd::border:
            return "border";
        case BranchEnd::not_converged:
            return "not-converged";
        case BranchEnd::most_points:
            return "most-points";
        case BranchEnd::halved:
            return "halved";
        case BranchEnd::switched:
            return "switched";
        case BranchEnd::family:
            return "family";
        case BranchEnd::stopped:
            return "stopped";
    }
    return "?";
}

BranchPoint branch_point_at(const CurvePoint& at) {
    BranchPoint point;
    point.at = at;
    point.multipliers = multipliers_at(at);
    point.index = index_of(point.multipliers);
    point.stability = stability_of(point.multipliers);
    point.mean = at.shooting.integral / at.shooting.duration;
    return point;
}

void put_before(Branch back, Branch& forth) {
    put_before(
        std::move(back), forth, [](BranchPoint& point) { point.at.tangent *= -1; },
        [](SpecialPoint& special) {
            special.cycle.at.tangent *= -1;
            std::swap(special.word_before, special.word_after);
        });
}

}  // namespace swirl::analysis
