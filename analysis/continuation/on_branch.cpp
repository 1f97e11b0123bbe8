#include "analysis/continuation/on_branch.hpp"

#include "analysis/continuation/locate.hpp"

namespace swirl::analysis {

std::vector<BranchPoint> cycles_at(const ShootingMap& map, const Branch& branch, double p) {
    std::vector<BranchPoint> found;
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
        const auto& a = branch.points[i].at;
        const auto& b = branch.points[i + 1].at;
        if (a.p == p) found.push_back(branch.points[i]);
        if (!((a.p - p) * (b.p - p) < 0)) continue;
        Eigen::VectorXd across(a.tangent.size());
        for (std::size_t j = 0; j < a.points.size(); ++j)
            across.segment(static_cast<Eigen::Index>(j) * map.dimension, map.dimension) =
                map.difference(b.points[j], a.points[j]);
        across[across.size() - 1] = b.p - a.p;
        const double h = curve_product(a.tangent, across, true, a.points.size());
        CurvePoint at;
        const auto gap = [&](const CurvePoint& point) { return point.p - p; };
        if (locate(map, a, h, a.p - p, b.p - p, gap, at)) found.push_back(branch_point_at(at));
    }
    if (!branch.points.empty() && branch.points.back().at.p == p) found.push_back(branch.points.back());
    return found;
}

std::optional<BranchPoint> find_on_branch(const ShootingMap& map, const Branch& branch, double p,
                                          const CyclePoints& points) {
    if (branch.period() != points.size()) return std::nullopt;
    for (const auto& cycle : cycles_at(map, branch, p))
        if (distance_between(map, cycle.at.points, points) < same_cycle) return cycle;
    return std::nullopt;
}

}  // namespace swirl::analysis
