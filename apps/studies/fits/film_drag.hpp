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
    double worse_by = analysis::nan;  ///< of the other floor, see film_drag(); NaN: not looked for, or not told
    analysis::DraggedArcs with;       ///< on that floor
    analysis::DragFit on_the_other;   ///< NaN where it was not looked for

    bool floor_told() const;          ///< the arcs tell it
    bool floor_contradicted() const;  ///< the arcs tell the other one, where this was given
};

/// Of analysis::floor_worse_by(): the likelihoods then differ by e^6, and the wrong floor is told with a chance of at
/// most 3 in 10,000 by noise.
inline constexpr double sure_floor = 12;

/// What is known of the floor beforehand.
struct KnownFloor {
    std::optional<Floor> floor;
    bool compared = true;  ///< with the other one
};

/// γ of the floor and γ_r of the spin (analysis::settled_drag), over arcs between two impacts that meet the wall
/// nowhere else. Both floors are tried, and compared by the places alone (analysis::floor_worse_by) on the arcs that
/// each of them makes of the film: one is told where the other is worse by `sure_floor` on both. Without a floor that
/// is given it is the one that is told, the dish's own where none is, or no drag is sure on either. Where on one of
/// them no γ can be told, its arcs being cut to pieces, what the division of the film costs more there counts in place
/// of its arcs.
///   arcs  of those frames, straight or analysis::bent_arcs()
FilmDrag film_drag(std::span<const analysis::FilmFrame> frames, double period, const analysis::FilmArcs& arcs,
                   const FilmedScene& scene, const DishMotion& dish, const KnownFloor& known);

}  // namespace swirl::studies
