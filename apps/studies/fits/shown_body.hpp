// The size and the number of sides of a body that falls on a plate, as its film shows them.
#pragma once

#include "analysis/fits/free_arcs.hpp"
#include "apps/studies/fits/dish_motion.hpp"
#include "apps/studies/fits/plate.hpp"

#include <optional>
#include <vector>

namespace swirl::studies {

/// Kinks that meet between arcs that fall: what tells the plate and the body on it.
std::vector<analysis::Kink> free_meetings(const analysis::FilmArcs& arcs);

/// The body's size by kinks that meet between arcs that fall (body_on_plate), those that count being the clear impacts
/// of one vertex as the fit before has it. Nothing of a disk, or where no size settles.
std::optional<BodyOnPlate> shown_body(const analysis::FilmArcs& arcs, const FilmedScene& scene);

/// The more kinks, the nearer to the plate, the better the division of the film into arcs is; −1 of none.
double worth_of(const std::optional<BodyOnPlate>& body);

/// Another number of sides, 3 to 12 or a disk, with which vertices are surely nearer to the plate. Looked for where
/// those of the given ones are off it by 1.5 times their errors; sure where the robust scale of n kinks is smaller by a
/// factor e^(12/(n − 4)): a chance of some e^(−12). Some tenths of a second where they are looked for.
std::optional<BodyOnPlate> nearer_shape(const analysis::FilmArcs& arcs, const FilmedScene& scene);

}  // namespace swirl::studies
