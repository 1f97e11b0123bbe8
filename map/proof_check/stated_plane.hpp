// Cells of a plane of two parameters as a certificate states them, and their check by other equations.
#pragma once

#include "map/cells/plane_piece.hpp"
#include "map/proof_check/stated_cycle.hpp"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace swirl::proof_check {

struct StatedPlane {
    StatedCycle scene;                   ///< its numbers alone; those of the plane are not read
    std::array<std::string, 2> names{};  ///< of the parameters: alpha, beta, mu, restitution, inertia-factor
    cells::ParameterCell plane;
    double max_time = 0;
    std::vector<cells::PlaneCell> proven;  ///< the cells that are stated as proven, as halves of halves of the plane
};

/// Proves the counts of all cells again; empty if they hold, else which does not. The search is that of the proof
/// (map/cells/); the equations, the inequalities of flight and impact, the derivative and the count of multipliers are
/// this folder's: map/proof/README.md, "Checking".
///   stop  true: end, with words that say so
std::string what_fails(const StatedPlane& plane, const std::function<bool()>& stop);

}  // namespace swirl::proof_check
