#include "analysis/continuation/branch.hpp"

#include "analysis/continuation/multipliers.hpp"

#include <array>
#include <utility>

namespace swirl::analysis {

std::string_view name_of(SpecialKind kind) {
    static constexpr std::array<std::string_view, 5> names{"fold", "flip", "neimark-sacker", "branch-point", "border"};
    return names[static_cast<std::size_t>(kind)];
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

void turn(BranchPoint& point) {
    turn(point.at);
}

void turn(SpecialPoint& special) {
    turn(special.cycle);
    std::swap(special.word_before, special.word_after);
}

}  // namespace swirl::analysis
