// The cells of a grid: one to five parameters of the scene or numbers of its starts, each with its points; or points
// that fill their box.
#pragma once

#include "map/model/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace swirl::studies::grids {

/// One parameter and its points. A law is its enumerator's number, a disk `disk_sides`.
struct GridAxis {
    std::string name = {};  ///< one of scene_axes, law, speed (of random starts), or one of start_numbers
    std::string text = {};  ///< as a user gave it, for who writes it down
    std::vector<double> points = {};
    bool sampled = false;   ///< point i is cell i's, and so it is of the other axes
    bool in_words = false;  ///< laws, and sides with a disk: categories, between which there is nothing

    bool has_words() const { return in_words; }
};

/// Parameters of the scene that are numbers.
inline constexpr std::array<const char*, 12> scene_axes = {"alpha",       "beta",           "mu",
                                                           "restitution", "inertia-factor", "sides",
                                                           "drag",        "spin-drag",      "tangential-restitution",
                                                           "corner",      "floor-friction", "gravity-ratio"};

/// Of a start in the laboratory, in R_c, R_c ω_s, radians and ω_s.
inline constexpr std::array<const char*, 6> start_numbers = {"x", "y", "vx", "vy", "angle", "spin"};

/// True if the parameter is one of the grid's axes.
bool has_axis(const std::vector<GridAxis>& grid, const std::string& name);

std::size_t cell_count(const std::vector<GridAxis>& grid);

/// The axes' points of a cell; the last axis runs fastest.
std::vector<double> cell_point(const std::vector<GridAxis>& grid, std::size_t cell);

// Points that fill a box of parameters, in place of a grid.

/// Which points, and how many.
struct Sample {
    enum class Kind { sobol, latin } kind = Kind::sobol;
    std::size_t count = 0;
};

/// Coordinate `axis` of the points in the unit cube of `axes` dimensions: [axis][point], each in [0, 1).
///   sobol  the first COUNT points of Sobol's sequence (GSL), whatever the seed
///   latin  a Latin hypercube: one point in each of COUNT slices along every axis, the slices in random order and a
///          random place within. Philox keyed by the seed.
/// Sources: Sobol, USSR Comput. Math. Math. Phys. 7 (1967) 86; McKay, Beckman, Conover, Technometrics 21 (1979) 239.
std::vector<std::vector<double>> unit_points(const Sample& sample, std::size_t axes, std::uint64_t seed);

}  // namespace swirl::studies::grids
