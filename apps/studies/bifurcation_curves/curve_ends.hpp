// Where a curve leads to others.
#pragma once

#include "apps/studies/bifurcation_curves/curves_of_kind.hpp"
#include "apps/studies/bifurcation_curves/search_equations.hpp"

#include <cstddef>
#include <vector>

namespace swirl::studies::bifurcation_curves {

struct CurveEnds {
    std::vector<StartingPoint> starting_points;
    std::size_t not_found = 0;  ///< special points of a border where none was found
};

/// In how many parts they can be sought, of a curve that was found: of a smooth one its two ends are one, and each of
/// its special points, about which branches may have to be followed; of one on a border all is one.
std::size_t parts_of_ends(const Followed& followed);

/// Borders that a smooth curve ends on, curves that it crosses or that end on it at its points of codimension 2, and
/// those that are born on a border.
CurveEnds ends_of(const SearchEquations& equations, const Followed& followed, std::size_t part);

}  // namespace swirl::studies::bifurcation_curves
