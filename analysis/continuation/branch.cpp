#include "analysis/continuation/branch.hpp"

#include "analysis/continuation/multipliers.hpp"

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
    const std::size_t count = back.points.size();  // its first is the other's first
    std::reverse(back.points.begin(), back.points.end());
    for (auto& point : back.points) point.at.tangent *= -1;
    std::reverse(back.special.begin(), back.special.end());
    for (auto& special : back.special) {
        special.cycle.at.tangent *= -1;
        std::swap(special.word_before, special.word_after);
        special.after = count < 2 ? 0 : count - 2 - std::min(special.after, count - 2);
    }
    for (auto& special : forth.special) special.after += count - 1;
    back.points.insert(back.points.end(), forth.points.begin() + 1, forth.points.end());
    back.special.insert(back.special.end(), forth.special.begin(), forth.special.end());
    back.begin = back.end;
    back.end = forth.end;
    forth = std::move(back);
}

}  // namespace swirl::analysis
