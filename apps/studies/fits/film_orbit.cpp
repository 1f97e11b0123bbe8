#include "apps/studies/fits/film_orbit.hpp"

#include "apps/studies/scene_map/scene_orbit.hpp"
#include "apps/studies/scene_map/start.hpp"

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>

namespace swirl::studies {

namespace {

/// An arc with a used impact at either end.
std::optional<analysis::FreeArc> first_whole_arc(const FilmFit& film) {
    for (std::size_t i = 0; i + 1 < film.impacts.size(); ++i) {
        const FilmImpact &start = film.impacts[i], &end = film.impacts[i + 1];
        const bool follows = end.kink.before == start.kink.before + 1;
        if (follows && start.use == KinkUse::used && end.use == KinkUse::used) return film.arcs.arcs[end.kink.before];
    }
    return std::nullopt;
}

/// The laboratory turned so that the dish's centre is at (β, 0), in units of the swirl's own rate.
LabStart<double> start_on(const analysis::FreeArc& arc, const DishMotion& dish) {
    const Eigen::Rotation2Dd back(-(dish.rate * arc.mean_time + dish.phase));
    const Eigen::Vector2d place = back * (arc.middle.head<2>() - dish.origin);
    const Eigen::Vector2d velocity = back * arc.velocity.head<2>() / dish.rate;
    return {place[0],
            place[1],
            velocity[0],
            velocity[1],
            arc.middle[2] + dish.mark + back.angle(),
            arc.velocity[2] / dish.rate};
}

}  // namespace

std::vector<SpinStep> simulated_spin(const Scene<double>& found, const FilmFit& film) {
    const std::optional<analysis::FreeArc> arc = first_whole_arc(film);
    if (!arc) return {};
    const double end = (film.arcs.arcs.back().end - arc->mean_time) * film.dish.rate;
    SceneOrbit<double> orbit(found, start_on(*arc, film.dish));
    std::vector<SpinStep> steps = {{arc->mean_time, arc->velocity[2]}};
    double now = 0;
    while (orbit.impacts() < most_steps && orbit.advance(end - now)) {
        now = orbit.frame().time.unwound();
        if (now > end) break;
        steps.push_back({arc->mean_time + now / film.dish.rate, orbit.post_impact().spin * film.dish.rate});
    }
    return steps;
}

}  // namespace swirl::studies
