#include "apps/system/scene_map.hpp"

#include "apps/system/section_system.hpp"
#include "map/derivative/timed_collision.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

namespace swirl::apps {

namespace {

/// As u_n → 0 every state of a body at rest on the wall solves F(z) = z: an impact that is no faster ends the map.
constexpr double least_impact_speed = detail::least_impact_speed;

/// Solvers ask for cycles of impacts: contact that lasts longer than a few swings has none.
constexpr double solver_horizon = 50;

/// A map and its system, which refers to it.
template <Shape shape, ImpactRule rule>
struct OwnedSystem {
    explicit OwnedSystem(const CollisionMap<double, shape, rule>& m) : map(m), system(map, solver_horizon) {}
    CollisionMap<double, shape, rule> map;
    SectionSystem<shape, rule> system;
};

/// u_n before the impact, from the state after it: C = −u_n changes by B₂p + B₃q.
double impact_speed(const Body<double>& body, const Collision<double>& collision) {
    const ContactKinematics<double> after = contact_kinematics(body, collision.after);
    return after.un + after.b2() * collision.impulse.normal + after.b3() * collision.impulse.tangential;
}

/// All of a step but its derivatives. False where the map ends.
template <class System>
bool fill_step(const System& system, const ReturnStep<double>& return_step, analysis::ShootingStep& step) {
    analysis::Advance<System::dimension> plain;
    system.fill(plain, return_step);
    if (!plain.alive || !plain.state.allFinite()) return false;
    step.state = plain.state;
    step.duration = plain.duration;
    step.letter = plain.letter;
    step.integral = plain.integral;
    step.margin = impact_speed(system.map().body(), return_step.collision);
    return step.margin > least_impact_speed;
}

template <Shape shape, ImpactRule rule>
analysis::ShootingStep step_of(const OwnedSystem<shape, rule>& owned, const Eigen::VectorXd& z) {
    analysis::ShootingStep step;
    const SectionPoint<double> point = SectionSystem<shape, rule>::point_of(z);
    const ReturnStep<double> return_step = owned.system.return_map().advance(post_impact_state(point), solver_horizon);
    if (!fill_step(owned.system, return_step, step)) return step;
    step.by_state = owned.system.derivative_of(point, return_step);
    step.alive = step.by_state.allFinite();
    return step;
}

/// True if the parameter is within its range there.
bool is_allowed(Parameter parameter, double value) {
    switch (parameter) {
        case Parameter::alpha:
            return value > 0 && value < 1;
        case Parameter::restitution:
            return value >= 0 && value <= 1;
        case Parameter::inertia_factor:
            return value > 0 && detail::is_holdable(value);
        case Parameter::beta:
        case Parameter::mu:
            break;
    }
    return value >= 0 && detail::is_holdable(value);
}

/// F along a parameter for one shape and rule.
template <Shape shape, ImpactRule rule>
struct MapAlongParameter {
    using System = SectionSystem<shape, rule>;
    static constexpr int dimension = System::dimension;

    Scene<double> scene;
    Parameter parameter;

    analysis::ShootingStep operator()(const Eigen::VectorXd& z, double p) const {
        analysis::ShootingStep step;
        if (!is_allowed(parameter, p)) return step;
        const Scene<double> here = with_parameter(scene, parameter, p);
        const CollisionMap<double, shape, rule> map(here);
        const System system(map, solver_horizon);
        const SectionPoint<double> point = System::point_of(z);
        const ReturnStep<double> return_step = system.return_map().advance(post_impact_state(point), solver_horizon);
        if (!fill_step(system, return_step, step)) return step;
        if (return_step.contacts.empty()) {
            const auto d =
                derivative_with_parameter<double, shape, rule>(here, parameter, point, return_step.collision);
            step.by_state = d.first;
            step.by_parameter = d.second;
        } else {
            step.by_state = system.derivative_of(point, return_step);
            step.by_parameter = quotient_along(z, p);
        }
        step.alive = step.by_state.allFinite() && step.by_parameter.allFinite();
        return step;
    }

    /// Through contact: a central difference, one-sided at the end of the parameter's range.
    Eigen::VectorXd quotient_along(const Eigen::VectorXd& z, double p) const {
        constexpr double h = 1e-5;
        const double high = is_allowed(parameter, p + h) ? p + h : p;
        const double low = is_allowed(parameter, p - h) ? p - h : p;
        const auto advance = [&](double value) {
            const CollisionMap<double, shape, rule> map(with_parameter(scene, parameter, value));
            return System(map, solver_horizon).advance(typename System::State(z));
        };
        const auto above = advance(high), below = advance(low);
        Eigen::VectorXd change = above.state - below.state;
        for (int i = 0; i < dimension; ++i)
            if (System::angle_period(i) > 0) change[i] = std::remainder(change[i], System::angle_period(i));
        if (!above.alive || !below.alive) return Eigen::VectorXd::Constant(dimension, std::nan(""));
        return change / (high - low);
    }
};

template <Shape shape, ImpactRule rule>
MapAlongParameter<shape, rule> along_parameter(const CollisionMap<double, shape, rule>& map, Parameter parameter) {
    return {map.scene(), parameter};
}

}  // namespace

analysis::ShootingMap scene_map(const Scene<double>& scene) {
    return with_collision_map(scene, [](const auto& map) {
        auto owned =
            std::make_shared<OwnedSystem<std::decay_t<decltype(map)>::shape, std::decay_t<decltype(map)>::rule>>(map);
        analysis::ShootingMap result = analysis::shooting_map(owned->system);
        result.least_margin = least_impact_speed;
        // The system must live as long as the step that refers to it.
        result.step = [owned](const Eigen::VectorXd& z, double) { return step_of(*owned, z); };
        return result;
    });
}

analysis::ShootingMap scene_map(const Scene<double>& scene, Parameter parameter) {
    // Along μ there is friction, whatever this scene's own μ.
    const Scene<double> typical = parameter == Parameter::mu ? with_parameter(scene, parameter, 1.0) : scene;
    return with_collision_map(typical, [&](const auto& map) {
        const SectionSystem system(map);
        analysis::ShootingMap result = analysis::shooting_map(system);
        result.has_parameter = true;
        result.least_margin = least_impact_speed;
        result.step = along_parameter(map, parameter);
        return result;
    });
}

SectionPoint<double> section_point_of(const Eigen::VectorXd& z) {
    if (z.size() == section_dimension<Shape::disk>) return {z[0], 0, z[1], z[2], z[3]};
    return {z[0], z[1], z[2], z[3], z[4]};
}

Eigen::VectorXd state_of(const SectionPoint<double>& z, bool disk) {
    if (disk) return Eigen::Vector4d(z.psi, z.vn, z.vt, z.spin);
    Eigen::VectorXd state(5);
    state << z.psi, z.chi, z.vn, z.vt, z.spin;
    return state;
}

Letter letter_from(std::int64_t letter) {
    const bool through_contact = letter < 0;
    if (through_contact) letter = -1 - letter;
    return {static_cast<int>(letter / 6), static_cast<ContactMode>(letter % 6), through_contact};
}

}  // namespace swirl::apps
