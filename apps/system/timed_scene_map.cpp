#include "apps/system/scene_map.hpp"
#include "apps/system/section_system.hpp"
#include "map/derivative/timed_collision.hpp"

#include <cmath>
#include <limits>

namespace swirl::apps {

namespace {

/// (z, τ) ↦ (z after the impact at τ, g).
template <Shape shape, ImpactRule rule>
struct TimedSystem {
    using System = SectionSystem<shape, rule>;
    static constexpr int dimension = System::dimension;

    Scene<double> scene;

    analysis::ShootingStep operator()(const Eigen::VectorXd& y, double) const {
        analysis::ShootingStep step;
        const double time = y[dimension];
        if (!(time > 0)) return step;
        const SectionPoint<double> z = System::point_of(y.head<dimension>());
        const auto timed = collide_at<double, shape, rule>(scene, z, time);
        if (!timed.possible) return step;
        step.state.resize(dimension + 1);
        step.state << System::state_of(section_point(timed.collision.after)), timed.gap;
        step.by_state = timed.derivative;
        step.duration = time;
        step.integral = z.spin * time;
        step.letter = 6 * timed.collision.vertex_step + static_cast<int>(timed.collision.impulse.mode);
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
    using System = SectionSystem<shape, rule>;
    const Flight<double> flight = flight_from(map.body(), post_impact_state(System::point_of(z)));
    double best = std::numeric_limits<double>::infinity(), time = longest / samples;
    for (int i = 1; i <= samples; ++i) {
        const Instant<double> at = instant_at<shape>(flight, longest * i / samples);
        const auto nearest = detail::nearest_to_wall<shape>(map.body(), flight, at);
        if (!(nearest.gap.rate > 0)) continue;
        Collision<double> collision;
        map.strike(flight, at, nearest.arm, collision);
        const Eigen::VectorXd after = System::state_of(section_point(collision.after));
        const double away = plain.difference(after, next).norm() + std::abs(nearest.gap.value);
        if (!(away < best)) continue;
        best = away;
        time = at.time;
    }
    return time;
}

}  // namespace

analysis::TimedMap timed_scene_map(const Scene<double>& scene) {
    return with_collision_map(scene, [](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        analysis::TimedMap timed;
        analysis::ShootingMap plain = analysis::shooting_map(SectionSystem(map));
        plain.step = nullptr;  // its coordinates alone are wanted: the system does not outlive this call
        timed.map = plain;
        ++timed.map.dimension;
        timed.map.constraints = 1;
        timed.map.angle_periods.push_back(0);
        timed.map.step = TimedSystem<Map::shape, Map::rule>{map.scene()};
        timed.time_between = [map, plain](const Eigen::VectorXd& z, const Eigen::VectorXd& next) {
            return time_between(map, plain, z, next);
        };
        return timed;
    });
}

}  // namespace swirl::apps
