// The drag of the dish's floor, from a film's arcs.
#pragma once

#include "analysis/fits/floor_drag.hpp"
#include "apps/studies/fits/dish_motion.hpp"

#include <span>

namespace swirl::studies {

/// γ of the floor, which moves with the dish (analysis::settled_drag), over arcs between two impacts that meet the wall
/// nowhere else.
///   arcs  of those frames, straight
analysis::DragFit film_drag(std::span<const analysis::FilmFrame> frames, double period, const analysis::FilmArcs& arcs,
                            const FilmedScene& scene, const DishMotion& dish);

}  // namespace swirl::studies
