// The drag of the floor, from a film's arcs, and whether that moves with the dish.
#pragma once

#include "analysis/fits/floor_drag.hpp"
#include "apps/studies/fits/dish_motion.hpp"
#include "map/model/scene.hpp"

#include <optional>
#include <span>

namespace swirl::studies {

using swirl::Floor;  ///< on what the body moves

struct FilmDrag {
    Floor floor = Floor::dish;
    double worse_by = analysis::nan;  ///< cost of the other floor's arcs less that of these; NaN: not looked for
    bool floor_told = false;          ///< the other floor is worse by `sure_floor`
    analysis::DraggedArcs with;       ///< on that floor
    analysis::DragFit on_the_other;   ///< NaN where it was not looked for
};

/// Cost of arcs (analysis::cost_of), in which floors surely differ: that of one more line, which noise alone does not
/// reach. The likelihoods then differ by e^12.
inline constexpr double sure_floor = analysis::cost_of_arc;

/// γ of the floor (analysis::settled_drag), over arcs between two impacts that meet the wall nowhere else. Without a
/// `given` floor both are tried: that of the lesser cost, the dish's own where no drag is sure.
///   arcs  of those frames, straight
FilmDrag film_drag(std::span<const analysis::FilmFrame> frames, double period, const analysis::FilmArcs& arcs,
                   const FilmedScene& scene, const DishMotion& dish, std::optional<Floor> given);

}  // namespace swirl::studies
