// Halving of a plane of two parameters until its parts are proven: map/proof/README.md, "Cells".
#pragma once

#include "map/cells/cell_equations.hpp"
#include "map/cells/plane_piece.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace swirl::cells {

/// The problem over any cell of a plane, and all of the plane of its unknowns.
struct PlaneProblem {
    std::function<std::unique_ptr<CellEquations>(const ParameterCell&)> over;
    std::vector<UnknownBox> unknowns;
};

/// Halves a cell until its parts are proven or at the limits. What a part inherits: parts of the plane of unknowns that
/// may hold solutions, and the branches that were enclosed.
///   stop  true: end; what is left is not looked at
PlanePiece prove_piece(const PlaneProblem& problem, const ParameterCell& piece, const PlaneLimits& limits,
                       const std::function<bool()>& stop);

/// Proves again what is stated of cells of the plane, which are halves of halves of it, each by further halves if need
/// be. Empty if all of it holds, else what does not.
std::string what_fails(const PlaneProblem& problem, const ParameterCell& plane, const std::vector<PlaneCell>& stated,
                       const std::function<bool()>& stop);

}  // namespace swirl::cells
