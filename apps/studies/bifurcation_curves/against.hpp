// The curves of a plane and a mode map over it, checked against each other.
#pragma once

#include "analysis/section_map.hpp"
#include "apps/studies/bifurcation_curves/curves.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::studies::bifurcation_curves {

/// The runs of a sweep over the plane's two parameters.
struct MappedPlane {
    struct Run {
        bool periodic = false;   ///< it came to a fixed point or cycle of impacts
        bool undecided = false;  ///< it has no verdict
        bool in_family = false;  ///< it came to a member of a family
        std::int64_t period = 0;
        double mean_spin = 0;
    };
    std::array<std::vector<double>, 2> values;  ///< of the parameters, in the plane's order
    std::size_t runs = 0;                       ///< in each cell
    MapStarts starts;                           ///< of the runs
    std::vector<Run> all;                       ///< by cell (first parameter slowest), then by run

    std::size_t cells() const { return values[0].size() * values[1].size(); }
    Eigen::Vector2d place(std::size_t cell) const {
        return {values[0][cell / values[1].size()], values[1][cell % values[1].size()]};
    }
};

/// In one cell: an attracting cycle that only the curves or only the map know.
struct Disagreement {
    Eigen::Vector2d parameters{0, 0};
    std::int64_t period = 0;
    double mean_spin = 0;
    std::size_t run = 0;  ///< of curve-missing: the run
    /// curve-missing: a run came to it, and no curve leads there. too-few-starts: it attracts, no run came to it.
    /// transient: nor did any, but one of the cell's runs has no verdict.
    std::string why;
};

struct Agreement {
    std::size_t cells = 0;          ///< of the map within the plane
    std::size_t outside_cells = 0;  ///< its others, which are compared with nothing
    std::size_t with_cycle = 0;     ///< cells with an attracting cycle by the curves
    std::size_t unseen_cells = 0;   ///< cells with an attracting cycle that no run came to
    std::size_t missing_cells = 0;  ///< cells where a run came to a cycle that no curve leads to
    std::size_t led_by_runs = 0;    ///< cells that were missing before curves were sought from the map's own runs
    std::size_t family_cells = 0;   ///< cells where a run came to a member of a family: it is compared with nothing
    std::vector<Disagreement> list;
};

/// Attracting cycles by the curves: those that lose their stability on one of them, carried from its points to the
/// cells beside it and on from cell to cell by Newton's method, as long as they attract (by more than
/// `analysis::neutral_margin`: what attracts by less, as a family does along itself, is not compared). A run agrees
/// with one of the same period whose mean S is the same to 10⁻⁶. Cycles of periods above `longest` are not
/// compared. Cost: some 0.1 ms a cycle and cell.
/// Once stopped, of the cells so far.
Agreement compare(const Scene<double>& scene, const Plane& plane, const std::vector<Curve>& curves,
                  const MappedPlane& map, std::int64_t longest, const analysis::Stop& stop = {});

/// The runs that came to cycles that no curve leads to, one of a cell and period.
std::vector<MapRun> missing_runs(const Agreement& agreement);

}  // namespace swirl::studies::bifurcation_curves
