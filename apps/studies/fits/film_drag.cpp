#include "apps/studies/fits/film_drag.hpp"

#include "apps/studies/fits/film_impacts.hpp"
#include "map/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies {

namespace {

using analysis::ArcPart;
using analysis::FilmArcs;
using Frames = std::span<const analysis::FilmFrame>;

/// Between its ends the arc comes to the wall so nearly that it may have met it unseen.
bool comes_near(const FilmArcs& film, const ArcPart& part, const FilmedScene& scene, const DishMotion& dish) {
    constexpr double near = 8;  // standard errors of three frames' mean
    const double turned = scene.sides == disk_sides ? 0 : scene.alpha * film.angle_noise;
    const double error = std::hypot(film.place_noise, turned) / std::sqrt(3.0);
    const Frames frames = film.kept;
    const auto gap_at = [&](std::size_t i) {
        const Eigen::Vector3d mean = (frames[i - 1].place + frames[i].place + frames[i + 1].place) / 3;
        return contact_at(scene, dish, frames[i].time, mean).gap;
    };
    double before = gap_at(part.first + 1), here = before;
    for (std::size_t i = part.first + 1; i + 1 < part.last; ++i) {
        const double after = gap_at(i + 1);
        if (here >= before && here >= after && here > -near * error) return true;
        before = here, here = after;
    }
    return false;
}

std::vector<ArcPart> parts_of(const FilmArcs& film, const FilmedScene& scene, const DishMotion& dish) {
    std::vector<ArcPart> parts = analysis::parts_between(film, meeting_kinks(film));
    std::erase_if(parts, [&](const ArcPart& part) { return comes_near(film, part, scene, dish); });
    return parts;
}

analysis::FloorMotion motion_of(Floor floor, const FilmedScene& scene, const DishMotion& dish) {
    return {floor == Floor::dish ? scene.beta : 0, dish.rate, dish.phase};
}

Floor other_than(Floor floor) {
    return floor == Floor::dish ? Floor::table : Floor::dish;
}

/// By how much the division of the film on the other floor costs more, with the noise of the worse one.
double other_costs_more(const FilmArcs& here, const FilmArcs& there) {
    const double place = std::max(here.place_noise, there.place_noise),
                 angle = std::max(here.angle_noise, there.angle_noise);
    return analysis::cost_of_division(there, place, angle) - analysis::cost_of_division(here, place, angle);
}

/// By how much the other floor is worse, by the arcs that speak most for it; NaN where these or those tell no drag.
/// Where on the other one no drag can be told at all, its arcs are pieces, and their number speaks.
double other_worse_by(Floor floor, const analysis::DraggedArcs& here, const analysis::DraggedArcs& there,
                      const FilmedScene& scene, const DishMotion& dish) {
    const auto by_arcs = [&](const FilmArcs& film) {
        return analysis::floor_worse_by(film.kept, parts_of(film, scene, dish),
                                        motion_of(other_than(floor), scene, dish), motion_of(floor, scene, dish),
                                        film.place_noise);
    };
    const double on_here = by_arcs(here.arcs);
    const double on_there = std::isnan(there.drag.value) && here.drag.surely_drags()
                                ? other_costs_more(here.arcs, there.arcs)
                                : by_arcs(there.arcs);
    return std::isnan(on_here) || std::isnan(on_there) ? analysis::nan : std::min(on_here, on_there);
}

}  // namespace

bool FilmDrag::floor_told() const {
    return worse_by > sure_floor;
}

bool FilmDrag::floor_contradicted() const {
    return worse_by < -sure_floor;
}

FilmDrag film_drag(Frames frames, double period, const FilmArcs& arcs, const FilmedScene& scene, const DishMotion& dish,
                   const KnownFloor& known) {
    const auto on = [&](Floor floor) {
        return analysis::settled_drag(frames, period, arcs, motion_of(floor, scene, dish),
                                      [&](const FilmArcs& film) { return parts_of(film, scene, dish); });
    };
    FilmDrag found;
    found.floor = known.floor.value_or(Floor::dish);
    found.with = on(found.floor);
    if (!known.compared || scene.beta == 0) return found;
    const Floor other = other_than(found.floor);
    analysis::DraggedArcs there = on(other);
    if (!found.with.drag.surely_drags() && !there.drag.surely_drags()) return found;
    found.on_the_other = there.drag;
    const double worse = other_worse_by(found.floor, found.with, there, scene, dish),
                 better = other_worse_by(other, there, found.with, scene, dish);
    found.worse_by = better > sure_floor ? -better : worse;
    // Where its own arcs tell no drag at all, this floor is no answer to arcs that bend.
    const bool is_none = std::isnan(found.with.drag.value) && there.drag.surely_drags() &&
                         other_costs_more(there.arcs, found.with.arcs) > sure_floor;
    if (known.floor || !(found.floor_contradicted() || is_none)) return found;
    found.floor = other;
    found.worse_by = better;
    found.on_the_other = found.with.drag;
    found.with = std::move(there);
    return found;
}

}  // namespace swirl::studies
