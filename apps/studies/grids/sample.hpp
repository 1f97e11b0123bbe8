// Points that fill a box of parameters, in place of a grid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::studies::grids {

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
