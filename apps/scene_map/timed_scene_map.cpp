#include "apps/scene_map/scene_map.hpp"
#include "apps/section_system.hpp"
#include "map/timed_collision.hpp"

#include <cmath>

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
        const auto timed = collide_at<double, shape, rule>(scene, std::nullopt, z, time);
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

template <Shape shape, ImpactRule rule>
TimedSystem<shape, rule> timed_system(const CollisionMap<double, shape, rule>& map) {
    return {map.scene()};
}

}  // namespace

analysis::ShootingMap timed_scene_map(const Scene<double>& scene) {
    return with_collision_map(scene, [&](const auto& map) {
        analysis::ShootingMap result = analysis::shooting_map(SectionSystem(map));
        ++result.dimension;
        result.constraints = 1;
        result.angle_periods.push_back(0);
        result.step = timed_system(map);
        return result;
    });
}

}  // namespace swirl::apps
