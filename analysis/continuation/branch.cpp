#include "analysis/continuation/branch.hpp"

#include "analysis/continuation/normal_form.hpp"
#include "analysis/cycles/family.hpp"

#include <array>
#include <cmath>
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

namespace {

/// The branch's cycles at p, each corrected to rounding, of the steps along which there may be a wanted one.
///   may_hold  (its first point, its length)
template <class MayHold>
std::vector<BranchPoint> cycles_of_steps(const ShootingMap& map, const Branch& branch, double p,
                                         const MayHold& may_hold) {
    std::vector<BranchPoint> found;
    const CurveProblem problem = cycle_problem(map, branch.period(), p);
    const auto gap = [p](const CurvePoint& point) { return point.p() - p; };
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
        const CurvePoint& a = branch.points[i].at;
        const CurvePoint& b = branch.points[i + 1].at;
        if (a.p() == p) found.push_back(branch.points[i]);
        if (!(gap(a) * gap(b) < 0)) continue;
        const Eigen::VectorXd step = across(map, a, b.points(), b.p());
        if (!may_hold(a, problem.length(step))) continue;
        const double h = problem.product(a.tangent, step);
        CurvePoint at;
        if (locate(problem, a, h, gap(a), gap(b), gap, at)) found.push_back(branch_point_at(at));
    }
    if (!branch.points.empty() && branch.points.back().at.p() == p) found.push_back(branch.points.back());
    return found;
}

}  // namespace

std::optional<BranchPoint> find_on_branch(const ShootingMap& map, const Branch& branch, double p,
                                          const CyclePoints& points) {
    if (branch.period() != points.size()) return std::nullopt;
    // What lies on a step is no farther from its beginning than a bent step is long; of one point of k, √k times that.
    constexpr double bend = 2;
    const double most = bend * std::sqrt(static_cast<double>(points.size()));
    const auto is_near = [&](const CurvePoint& from, double length) {
        return distance_between(map, from.points(), points) <= most * length + same_cycle;
    };
    for (const auto& cycle : cycles_of_steps(map, branch, p, is_near))
        if (distance_between(map, cycle.at.points(), points) < same_cycle) return cycle;
    return std::nullopt;
}

}  // namespace swirl::analysis
