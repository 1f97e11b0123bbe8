// The starts of a sweep as users give them, beside its grid.
#pragma once

#include "apps/command_line/start_options.hpp"
#include "apps/sweep/grid_options.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::sweep {

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
