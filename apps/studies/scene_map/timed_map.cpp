#include "apps/studies/scene_map/itinerary_map.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/derivative/timed_collision.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

namespace swirl::studies {

namespace {

/// (z, τ) ↦ (z after the impact at τ, g).
template <Shape shape, ImpactRule rule>
struct TimedStep {
    static constexpr int dimension = section_dimension<shape>;

    CollisionMap<double, shape, rule> map;

    analysis::ShootingStep operator()(const Eigen::VectorXd& y, double) const {
        analysis::ShootingStep step;
        const double time = y[dimension];
        if (!(time > 0)) return step;
        const SectionPoint<double> z = section_point_of(y.head<dimension>());
        const auto timed = collide_at(map, z, time);
        if (!timed.possible) return step;
        step.state.resize(dimension + 1);
        step.state << coordinates_of<dimension>(section_point(timed.collision.after)), timed.gap;
        step.by_state = timed.derivative;
        step.duration = time;
        step.integral = z.spin * time;
        step.letter = number_of(Letter{timed.collision.vertex_step, timed.collision.impulse.mode, false});
        step.alive = step.state.allFinite() && step.by_state.allFinite();
        return step;
    }
};

/// The impact at a sampled time that leads nearest to `next`; the first guess of Newton's method.
template <Shape shape, ImpactRule rule>
double time_between(const CollisionMap<double, shape, rule>& map, const analysis::ShootingMap& plain,
                    const Eigen::VectorXd& z, const Eigen::VectorXd& next) {
    constexpr int samples = 400;
    const double longest = 4 * pi<double>();  // flights longer than two turns of the swirl are rare
    const Flight<double> flight = flight_from(map.body(), post_impact_state(section_point_of(z)));
    double best = std::numeric_limits<double>::infinity(), time = longest / samples;
    Instant<double> at = instant_at_start(flight);
    for (int i = 1; i <= samples; ++i) {
        advance<shape>(flight, at, longest / samples);
        // No vertex is outside the circumscribed circle.
        if (!(-centre_gap(map.body(), flight, at).value < best)) continue;
        const auto nearest = detail::nearest_to_wall<shape>(map.body(), flight, at);
        if (!(nearest.gap.rate > 0 && std::abs(nearest.gap.value) < best)) continue;
        Collision<double> collision;
        map.strike(flight, at, nearest.arm, nearest.vertex, collision);
        const Eigen::VectorXd after = coordinates_of<section_dimension<shape>>(section_point(collision.after));
        const double away = plain.difference(after, next).norm() + std::abs(nearest.gap.value);
        if (!(away < best)) continue;
        best = away;
        time = at.time;
    }
    return time;
}

}  // namespace

analysis::TimedMap timed_map_of(const Scene<double>& scene) {
    analysis::ShootingMap plain = shooting_map_of(scene);
    plain.step = nullptr;  // its coordinates alone are wanted
    return with_collision_map(scene, [&](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        analysis::TimedMap timed;
        timed.map = plain;
        ++timed.map.dimension;
        timed.map.constraints = 1;
        timed.map.angle_periods.push_back(0);
        timed.map.step = TimedStep<Map::shape, Map::rule>{map};
        timed.time_between = [map, plain](const Eigen::VectorXd& z, const Eigen::VectorXd& next) {
            return time_between(map, plain, z, next);
        };
        return timed;
    });
}

}  // namespace swirl::studies
