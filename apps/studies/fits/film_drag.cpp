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

analysis::DraggedArcs drag_on(Floor floor, Frames frames, double period, const FilmArcs& arcs, const FilmedScene& scene,
                              const DishMotion& dish) {
    const auto parts_of = [&](const FilmArcs& film) {
        std::vector<ArcPart> parts = analysis::parts_between(film, meeting_kinks(film));
        std::erase_if(parts, [&](const ArcPart& part) { return comes_near(film, part, scene, dish); });
        return parts;
    };
    const double radius = floor == Floor::dish ? scene.beta : 0;
    return analysis::settled_drag(frames, period, arcs, {radius, dish.rate, dish.phase}, parts_of);
}

}  // namespace

FilmDrag film_drag(Frames frames, double period, const FilmArcs& arcs, const FilmedScene& scene, const DishMotion& dish,
                   std::optional<Floor> given) {
    FilmDrag found;
    found.floor = given.value_or(Floor::dish);
    found.with = drag_on(found.floor, frames, period, arcs, scene, dish);
    if (given || scene.beta == 0) return found;
    analysis::DraggedArcs table = drag_on(Floor::table, frames, period, arcs, scene, dish);
    const bool any = found.with.drag.surely_drags() || table.drag.surely_drags();
    if (!any) return found;
    found.on_the_other = table.drag;
    if (std::isnan(found.with.drag.value) || std::isnan(table.drag.value)) return found;  // straight arcs cost more
    const double place_noise = std::min(found.with.arcs.place_noise, table.arcs.place_noise);
    const double angle_noise = std::min(found.with.arcs.angle_noise, table.arcs.angle_noise);
    const double worse = analysis::cost_of(found.with.arcs, place_noise, angle_noise) -
                         analysis::cost_of(table.arcs, place_noise, angle_noise);
    found.worse_by = -worse;
    found.floor_told = std::abs(worse) > sure_floor;
    if (!(worse > sure_floor)) return found;
    found.floor = Floor::table;
    found.worse_by = worse;
    found.on_the_other = found.with.drag;
    found.with = std::move(table);
    return found;
}

}  // namespace swirl::studies
