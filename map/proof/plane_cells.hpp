// Subdivision of a plane until every part of it is excluded, or holds one solution for certain.
#pragma once

#include "map/intervals/dual.hpp"
#include "map/intervals/krawczyk.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace swirl::proof {

using intervals::Ball;

/// Of (τ, φ), or of τ alone (then the second side is without content).
struct Cell {
    double low[2], high[2];
    double width(int i) const { return high[i] - low[i]; }
};

/// What is asked: f = 0 (of two unknowns) and j whole, of τ and φ.
struct PlaneProblem {
    int unknowns = 2;
    /// f (not read for one unknown) and j with their derivatives by τ and φ.
    struct Values {
        intervals::Dual<2> f, j;
    };
    std::function<Values(const Ball& tau, const Ball& phi)> evaluate;
    /// True if the cell holds no solution for reasons of its own (R ≤ 0, |tan χ| > μ, τ near 0 …).
    std::function<bool(const Ball& tau, const Ball& phi)> excluded;
};

/// A solution: exactly one in `cell`, and it lies in tau, phi.
struct PlaneSolution {
    long j = 0;
    Cell cell;
    Ball tau, phi;
};

struct PlaneResult {
    std::vector<PlaneSolution> solutions;
    std::vector<Cell> open;
    std::size_t cells = 0;
};

/// Cost: some ten microseconds a cell.
void solve(const PlaneProblem& problem, const Cell& start, const std::function<bool()>& stop, PlaneResult& result);

}  // namespace swirl::proof
