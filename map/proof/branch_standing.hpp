// What a branch of solutions is over a cell of two parameters: a fixed point of the map with a stability that does not
// change, or none.
#pragma once

#include "map/cells/cell_equations.hpp"
#include "map/proof/steady_cells.hpp"

namespace swirl::proof {

/// Over the cell, where the branch encloses τ and φ. Cost: some tenths of a millisecond.
cells::BranchStanding standing_of(const PlaneScene& plane, const cells::ParameterCell& cell,
                                  const cells::SolutionBranch& branch);

}  // namespace swirl::proof
