// Where a curve leads to others.
#pragma once

#include "apps/studies/bifurcation_curves/curves_of_kind.hpp"
#include "apps/studies/bifurcation_curves/search_equations.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace swirl::studies::bifurcation_curves {

struct CurveEnds {
    std::vector<StartingPoint> starting_points;
    std::size_t not_found = 0;  ///< special points of a border where none was found
};

/// A part of the work, by itself: the two ends of a smooth curve, one of its special points, or of one about which
/// branches are followed one of the four; all of a curve on a border.
struct EndPart {
    std::optional<std::size_t> special;  ///< none: the ends, or the curve on a border
    std::optional<std::size_t> beside;   ///< of branches: the point of the curve that they go through, and along …
    int axis = 0;                        ///< … which axis
};
std::vector<EndPart> parts_of_ends(const Followed& followed);

/// Borders that a smooth curve ends on, curves that it crosses or that end on it at its points of codimension 2, and
/// those that are born on a border. Of a curve that was found.
CurveEnds ends_of(const SearchEquations& equations, const Followed& followed, const EndPart& part);

}  // namespace swirl::studies::bifurcation_curves
