// --grid and --sample: the cells of a sweep as users give them.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/studies/grids/grid.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

using namespace studies::grids;

/// How the cells lie: on the grid; on one that has 2^levels steps for each; or as a sample.
struct GridForm {
    std::optional<Sample> sample = {};
    std::uint64_t seed = 1;  ///< of the sample
    int levels = 0;
    std::size_t scenes = 0;  ///< rows of a table of scenes, of which each text is a column; 0: there is none
};

/// The levels of --refine go so far.
inline constexpr int most_levels = 10;

/// NAME=A:B:COUNT: point i is A + (B − A) i/(COUNT − 1), the double nearest to it (points_between). NAME=A:B:COUNT:log:
/// A (B/A)^{i/(COUNT − 1)} (points_between_logarithms). NAME=V,V,…: these, numbers in rising order; laws by their
/// numbers, in the order in which they are given, as sides are that have a disk among them (`disk_sides`). Of a sample
/// NAME=A:B, NAME=A:B:log or a list, of a table of scenes a list in the order of its rows: point i is cell i's.
/// @throws BadInput naming the axis, its value and what is allowed: an unknown or repeated name, more than five axes,
/// COUNT < 1, COUNT = 1 with A ≠ B, numbers that are not finite, sides that are not whole, COUNT of a sample,
/// logarithms of what is not > 0, a value of a list that is none or is given twice, a list to be refined, more than 10⁸
/// cells
std::vector<GridAxis> grid_from(const std::vector<std::string>& texts, const GridForm& form = {});

/// A value of an axis as its text has it: of laws and sides a number that stands for it. @throws BadInput
double axis_value(const std::string& name, const std::string& text);

/// A point of an axis as people and flags say it: a law's name, disk, or the shortest number that reads back to the
/// same double.
std::string word_at(const GridAxis& axis, double point);

/// True of what can be an axis.
bool is_axis_name(const std::string& name);
/// "alpha, beta, …", for messages.
std::string axis_names();

/// "alpha=", ...: with what an axis begins.
std::vector<std::string> axes_to_offer();

/// sobol:COUNT | latin:COUNT. @throws BadInput naming the text and what is allowed: another name, COUNT outside 1 to
/// 10⁶
Sample sample_from(const std::string& text);

/// The scene of a cell. @throws BadInput, std::invalid_argument if the scene is not complete or out of range
Scene<double> scene_of_cell(SceneOptions scene, const std::vector<GridAxis>& grid, std::size_t cell);

}  // namespace swirl::apps::sweep
