// Where the runs of a cell start: at random, or where the cell says.
#pragma once

#include "apps/command_line/start_options.hpp"
#include "apps/sweep/grid.hpp"

#include <string>
#include <vector>

namespace swirl::apps::sweep {

/// True if an axis is a number of a start in the laboratory (x, y, vx, vy, angle, spin): each cell has one start then,
/// and the grid is a plane of starts, of whose basins of attraction it makes a map.
bool starts_are_placed(const std::vector<GridAxis>& grid);

/// True if all axes are: every cell has the same scene.
bool are_all_of_the_start(const std::vector<GridAxis>& grid);

/// The start of run `run` of a cell. Placed, it is that of the start's flags (x = β and else 0 without them) with the
/// cell's numbers; otherwise that of `swirl classify --seed (seed + run)`, with the grid's speed if it has one.
LabStart<double> cell_start(const StartOptions& options, const Scene<double>& scene, const std::vector<GridAxis>& grid,
                            std::size_t cell, std::uint64_t run);

/// The start whose numbers along the grid's axes are those of a point, in a cell or between; its other numbers are the
/// flags'.
LabStart<double> placed_start(const StartOptions& options, const Scene<double>& scene,
                              const std::vector<GridAxis>& grid, const std::vector<double>& point);

/// What the flags of the starts say, as settings by name, without those that are gridded.
std::vector<std::pair<std::string, double>> start_settings(const StartOptions& options, const Scene<double>& scene,
                                                           const std::vector<GridAxis>& grid);

/// @throws BadInput if the grid, the start's flags and the number of runs do not go together
void require_starts(const StartOptions& options, const std::vector<GridAxis>& grid, std::int64_t runs);

/// --grid in R_c = ω_s = m = 1: x, y, vx, vy, spin and speed are given in the user's units, if there are any.
std::vector<std::string> grid_without_units(std::vector<std::string> texts, const std::optional<Units>& units);

/// Of an axis: "R_c" for x, "1" for a parameter of the scene …
std::string units_of_axis(const std::string& name);

}  // namespace swirl::apps::sweep
