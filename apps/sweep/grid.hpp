// The cells of a sweep: one to five parameters of the scene or numbers of its starts, each from A to B in COUNT steps,
// by logarithms, or as a list; points that fill that box; or the rows of a table of scenes.
#pragma once

#include "apps/command_line/scene_options.hpp"
#include "apps/sweep/sample.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

/// NAME=A:B:COUNT: point i is A + (B − A) i/(COUNT − 1), the double nearest to it (points_between). NAME=A:B:COUNT:log:
/// A (B/A)^{i/(COUNT − 1)} (points_between_logarithms). NAME=V,V,…: these, numbers in rising order; laws by their
/// numbers, in the order in which they are given, as sides are that have a disk among them (`disk_sides`). Of a sample
/// NAME=A:B, NAME=A:B:log or a list, of a table of scenes a list in the order of its rows: point i is cell i's.
struct GridAxis {
    std::string name;  ///< as the flag
    std::string text;  ///< as it was given
    std::vector<double> points;
    bool sampled = false;
    bool in_words = false;  ///< laws, and sides with a disk: categories, between which there is nothing

    bool has_words() const { return in_words; }
    /// A point as people and flags say it: a law's name, disk, or the shortest number that reads back to the same
    /// double.
    std::string word_at(double point) const;
};

/// How the cells lie: on the grid; on one that has 2^levels steps for each; or as a sample.
struct GridForm {
    std::optional<Sample> sample = {};
    std::uint64_t seed = 1;  ///< of the sample
    int levels = 0;
    std::size_t scenes = 0;  ///< rows of a table of scenes, of which each text is a column; 0: there is none
};

/// Of a start in the laboratory, in R_c, R_c ω_s, radians and ω_s.
inline constexpr std::array<const char*, 6> start_numbers = {"x", "y", "vx", "vy", "angle", "spin"};

/// The levels of --refine go so far.
inline constexpr int most_levels = 10;

/// @throws BadInput naming the axis, its value and what is allowed: an unknown or repeated name, more than five axes,
/// COUNT < 1, COUNT = 1 with A ≠ B, numbers that are not finite, sides that are not whole, COUNT of a sample,
/// logarithms of what is not > 0, a value of a list that is none or is given twice, a list to be refined, more than 10⁸
/// cells
std::vector<GridAxis> grid_from(const std::vector<std::string>& texts, const GridForm& form = {});

/// A value of an axis as its text has it: of laws and sides a number that stands for it. @throws BadInput
double axis_value(const std::string& name, const std::string& text);

/// True of what can be an axis.
bool is_axis_name(const std::string& name);
/// "alpha, beta, …", for messages.
extern const char* const axis_names;

/// True if the parameter is one of the grid's axes.
bool has_axis(const std::vector<GridAxis>& grid, const std::string& name);

/// "alpha=", ...: with what an axis begins.
std::vector<std::string> axes_to_offer();

std::size_t cell_count(const std::vector<GridAxis>& grid);

/// The axes' points of a cell; the last axis runs fastest.
std::vector<double> cell_point(const std::vector<GridAxis>& grid, std::size_t cell);

/// The scene of a cell. @throws BadInput, std::invalid_argument if the scene is not complete or out of range
Scene<double> cell_scene(SceneOptions scene, const std::vector<GridAxis>& grid, std::size_t cell);

}  // namespace swirl::apps::sweep
