// Fixed points over a rectangle of two parameters, as an abstract problem: two equations in a flight time τ and an
// angle x, one of which is whole numbers j, and what is to be known of a solution. map/proof states it by one set of
// equations, map/proof_check by another; the search is the same. map/proof/README.md, "Cells".
#pragma once

#include "map/cells/plane_piece.hpp"
#include "map/intervals/curved.hpp"
#include "map/intervals/sloped.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace swirl::cells {

using intervals::Sloped;

/// The unknowns' and the parameters' ranges: what τ and x are off by, then both parameters.
using Ranged = Sloped<4>;

/// A part of the plane of the unknowns. `set`: which of the problem's systems; contacts that stick, that slip …
struct UnknownBox {
    int set = 0;
    std::array<double, 2> low{}, high{};  ///< of τ, x
};

/// Exactly one solution (τ, x) for each p of a cell with |(τ, x) − x₀ − X(p − p₀)| ≤ domain, component by component. It
/// lies within `near` of x₀ + X(p − p₀).
struct SolutionBranch {
    int set = 0;
    long j = 0;
    std::array<double, 2> parameters{}, middle{};   ///< p₀, x₀
    std::array<std::array<double, 2>, 2> slopes{};  ///< X: ∂x_i/∂p_k, roughly
    std::array<double, 2> near{}, domain{};

    /// On the cell on which it was found, with its sides as e_k: x₀ + X(p − p₀) + Σ curves e_k e_l, within `close`.
    std::array<std::array<double, 3>, 2> curves{};
    std::array<double, 2> close{};
};

/// x₀ + X(p − p₀) and what it is off by, over a number with the cell's parameters as variables `first` and the next.
///   width  of what it is off by: branch.near, or nothing
template <class S>
S on_branch(const ParameterCell& cell, const SolutionBranch& branch, std::size_t i, std::size_t first, double width) {
    S x(branch.middle[i]);
    for (std::size_t k = 0; k < 2; ++k)
        x += S(branch.slopes[i][k]) * (S::variable(cell.low[k], cell.high[k], first + k) - S(branch.parameters[k]));
    x.rest = intervals::detail::at_least(x.rest + width);
    return x;
}

/// Both parameters to second order.
using Curving = intervals::Curved<2>;

/// The same to second order, on the cell on which the branch was found.
///   width  of what it is off by: branch.close, or nothing
inline Curving on_curved_branch(const ParameterCell& cell, const SolutionBranch& branch, std::size_t i, double width) {
    auto x = on_branch<Curving>(cell, branch, i, 0, width);
    for (std::size_t k = 0; k < branch.curves[i].size(); ++k) x.two[k] += branch.curves[i][k];  // from 0: no rounding
    return x;
}

/// What a branch is over a cell: a fixed point for every p, with as many multipliers on either side of the unit circle;
/// or none for any; or it is not decided.
struct BranchStanding {
    bool decided = false;
    Doubt doubt = Doubt::equations;  ///< of one that is not decided
    bool exists = false;
    int outside = 0, inside = 0;  ///< multipliers

    static BranchStanding doubtful(Doubt doubt) { return {false, doubt, false, 0, 0}; }
    static BranchStanding no_fixed_point() { return {true, Doubt::none, false, 0, 0}; }
    static BranchStanding fixed_point(int outside, int inside) { return {true, Doubt::none, true, outside, inside}; }
};

/// The equations' left sides, f = 0 and j whole.
struct Equations {
    Ranged f, j;
};
struct CurvedEquations {
    Curving f, j;
};
/// The same, with their derivatives by τ and x: rows f and j.
struct LinearEquations {
    Ranged f, j;
    std::array<std::array<Ranged, 2>, 2> by;
};

/// The problem over one cell.
class CellEquations {
public:
    explicit CellEquations(const ParameterCell& cell) : cell_(cell) {}
    CellEquations(const CellEquations&) = delete;
    CellEquations& operator=(const CellEquations&) = delete;
    virtual ~CellEquations() = default;

    const ParameterCell& cell() const { return cell_; }

    virtual Equations values(int set, const Ranged& tau, const Ranged& x) const = 0;
    virtual CurvedEquations curved(int set, const Curving& tau, const Curving& x) const = 0;
    ///   at_middle  of the cell, p without width
    virtual LinearEquations linear(int set, const Ranged& tau, const Ranged& x, bool at_middle) const = 0;
    /// No solution that is a fixed point lies there, for reasons of its own (a wall that pulls, χ too large, τ near 0).
    virtual bool is_excluded(int set, const Ranged& tau, const Ranged& x) const = 0;
    /// At some moment of the flight from there to the vertex j on, the same for all, a vertex is outside.
    virtual bool is_met_earlier(int set, long j, const Ranged& tau, const Ranged& x) const = 0;
    /// Of a branch that was found on this cell.
    virtual BranchStanding standing_of(const SolutionBranch& branch) const = 0;

private:
    ParameterCell cell_;
};

/// What is known of a box over a cell.
struct BoxSight {
    bool excluded = false;      ///< it holds no solution
    std::optional<long> whole;  ///< the one whole number that j can be
    Ranged f, j;                ///< by the box's sides, then by the cell's
};
BoxSight look_at(const CellEquations& equations, const UnknownBox& box);
Ranged side(const UnknownBox& box, std::size_t i);

/// The branch near (τ, x) over the cell; nothing where Newton's method or Krawczyk's operator fails.
std::optional<SolutionBranch> branch_near(const CellEquations& equations, int set, long j,
                                          const std::array<double, 2>& start);

/// Are two branches of the cell the same? `found` was found on the cell, `known` on one that holds it. They are one if
/// they are one at its middle, where the solution is alone in the domain of `known`, and two if they differ there: they
/// are continuous, and where they are one, they are so around it.
enum class Relation { same, different, unclear };
Relation relation_of(const CellEquations& equations, const SolutionBranch& known, const SolutionBranch& found);

/// Every solution of the box, which has the branch's j alone, is the branch's, whatever p of the cell.
bool covers(const CellEquations& equations, const SolutionBranch& branch, const UnknownBox& box);

}  // namespace swirl::cells
