// The boundaries of the basins over a plane of starts, and the saddles that they lead to.
//
// Between two neighbouring starts that came to different attractors the boundary is bisected to 10⁻¹² of a step; the
// orbit between two starts on its two sides, drawn together again and again (straddling), stays on the boundary and
// leads to the unstable cycle or torus whose stable set it is. Source: H. E. Nusse and J. A. Yorke, Physica D 36 (1989)
// 137 (analysis/classification/basin_boundary.hpp).
#pragma once

#include "apps/studies/basins/basins.hpp"
#include "apps/studies/basins/saddles.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace swirl::studies::grids {

/// Follows so many places on the boundaries, evenly spread. Nothing if it was stopped.
///   study    over numbers of the start alone
///   results  of its runs, one a cell
///   visited  1 of the cells that were run themselves; empty: all
/// Cost: of a place some 50 runs, and about one for each impact until its orbit is at the saddle.
std::optional<Boundaries> find_saddles(const GridStudy& study, std::span<const RunResult> results,
                                       std::span<const char> visited, const Basins& basins, std::size_t places,
                                       const RunControl& control = {});

}  // namespace swirl::studies::grids
