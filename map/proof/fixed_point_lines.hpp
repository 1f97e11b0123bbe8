// The sets on which fixed points lie, as problems of the plane.
#pragma once

#include "map/proof/plane_cells.hpp"
#include "map/proof/steady_in_balls.hpp"

#include <string>
#include <vector>

namespace swirl::proof {

/// Fixed points of one kind: those whose contact sticks, at e = 1 those with χ = 0, those that slip throughout.
struct FixedPointSet {
    enum class Kind { sticking, straight, sliding } kind = Kind::sticking;
    PlaneProblem problem;
    std::vector<Cell> start;
    Ball sine, width;    ///< sin χ and w where they are fixed
    std::string open{};  ///< why nothing is known of it; empty: it is examined
};

/// All of them, for 0 < τ ≤ max_time. The scene outlives it.
std::vector<FixedPointSet> fixed_point_sets(const BallScene& scene, double max_time);

/// The section point of a solution, of vertex step j.
BallPoint<Ball> fixed_point_of(const BallScene& scene, const FixedPointSet& set, const PlaneSolution& solution);

/// Of a set that slides: u_t after the impact in the direction that its friction is for, which an orbit needs > 0.
Ball slip_along(const BallScene& scene, const FixedPointSet& set, const BallPoint<Ball>& z);

/// φ = ψ + χ on a line.
Ball phi_on_line(const FixedPointSet& line);

/// The contact mode there: slip of a sticking contact stops early or late; both where that is not certain.
std::vector<ContactMode> modes_of(const BallScene& scene, const FixedPointSet& set, const PlaneSolution& solution);

}  // namespace swirl::proof
