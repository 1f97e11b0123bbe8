#include "analysis/orbits/known_cycles.hpp"

#include <algorithm>

namespace swirl::analysis {

bool KnownCycles::contains(const CyclePoints& points) const {
    return std::any_of(cycles_.begin(), cycles_.end(), [&](const Cycle& other) {
        return distance_between(map_, other.points, points) <= same_;
    });
}

bool KnownCycles::contains_family_of(const CyclePoints& points, Eigen::Index dimension) const {
    for (std::size_t i = 0; i < cycles_.size(); ++i) {
        const Cycle& other = cycles_[i];
        if (!other.is_family() || other.period() != points.size()) continue;
        if (!curves_[i].members.empty() && belongs_to(map_, curves_[i], points)) return true;
        if (other.tangents.cols() > 1 && other.tangents.cols() == dimension &&
            (is_reachable(map_, p_, other.points, points) || is_reachable(map_, p_, points, other.points)))
            return true;
    }
    return false;
}

bool KnownCycles::add(const CyclePoints& points, double residual) {
    if (contains(points)) return false;
    const Closing closing = close_cycle(map_, points, p_);
    if (!closing.alive) return false;
    const Eigen::MatrixXd tangents = family_directions(closing, map_.dimension);
    if (one_per_family_ && tangents.cols() > 0 && contains_family_of(points, tangents.cols())) return false;
    Cycle cycle;
    cycle.points = points;
    cycle.residual = residual;
    if (!complete_cycle(map_, p_, cycle)) return false;
    const bool curve = one_per_family_ && cycle.tangents.cols() == 1;
    curves_.push_back(curve ? walk_family(map_, p_, cycle) : FamilyCurve{});
    cycles_.push_back(std::move(cycle));
    return true;
}

}  // namespace swirl::analysis
