#include "analysis/continuation/branch.hpp"

#include "analysis/continuation/normal_form.hpp"
#include "analysis/cycles/family.hpp"

#include <array>
#include <cstddef>
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
    std::swap(special.itinerary_before, special.itinerary_after);
}

std::vector<BranchPoint> cycles_at(const ShootingMap& map, const Branch& branch, double p) {
    std::vector<BranchPoint> found;
    const CurveProblem problem = cycle_problem(map, branch.period(), p);
    const auto gap = [p](const CurvePoint& point) { return point.p() - p; };
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
        const CurvePoint& a = branch.points[i].at;
        const CurvePoint& b = branch.points[i + 1].at;
        if (a.p() == p) found.push_back(branch.points[i]);
        if (!(gap(a) * gap(b) < 0)) continue;
        const double h = problem.product(a.tangent, across(map, a, b.points(), b.p()));
        CurvePoint at;
        if (locate(problem, a, h, gap(a), gap(b), gap, at)) found.push_back(branch_point_at(at));
    }
    if (!branch.points.empty() && branch.points.back().at.p() == p) found.push_back(branch.points.back());
    return found;
}

std::optional<BranchPoint> find_on_branch(const ShootingMap& map, const Branch& branch, double p,
                                          const CyclePoints& points) {
    if (branch.period() != points.size()) return std::nullopt;
    for (const auto& cycle : cycles_at(map, branch, p))
        if (distance_between(map, cycle.at.points(), points) < same_cycle) return cycle;
    return std::nullopt;
}

}  // namespace swirl::analysis
