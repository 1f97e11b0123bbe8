// The two equations over one cell of a plane: which parts of the plane of unknowns hold solutions, and what they are.
#pragma once

#include "map/cells/plane_search.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace swirl::cells {

struct Tracked {
    SolutionBranch branch;
    BranchStanding standing;
};

/// What a cell inherits: parts of the plane of unknowns that may hold solutions, and the solutions that were enclosed.
struct Node {
    ParameterCell cell;
    int depth = 0;
    std::vector<UnknownBox> boxes;
    std::vector<Tracked> branches;

    /// The lower or upper half of it in a side.
    Node half(std::size_t side, bool upper) const {
        Node result = *this;
        (upper ? result.cell.low : result.cell.high)[side] = cell.middle(side);
        ++result.depth;
        return result;
    }
};

/// Solves the equations over a node's cell: `boxes` are then those that may hold solutions besides those of `branches`.
class CellSolver {
public:
    CellSolver(const PlaneProblem& problem, Node& node) : equations_(problem.over(node.cell)), node_(node) {}
    void run();

private:
    void follow(Tracked& tracked);
    void take(const UnknownBox& box, std::vector<UnknownBox>& waiting);
    bool is_covered(const UnknownBox& box, long j) const;
    bool is_closed(const UnknownBox& box, const BoxSight& sight);

    /// Where no branch was found from.
    struct Failure {
        int set;
        long j;
        std::array<double, 2> at, reach;
    };
    std::unique_ptr<CellEquations> equations_;
    Node& node_;
    std::vector<Failure> failures_;
};

/// What is proven of a node's cell after that.
PlaneCell judged(const Node& node);

}  // namespace swirl::cells
