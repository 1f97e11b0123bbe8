#include "apps/system/shooting_map.hpp"

#include "apps/system/scene_map.hpp"
#include "map/derivative/timed_collision.hpp"

#include <cmath>

namespace swirl::apps {

namespace {

/// As u_n → 0 every state of a body at rest on the wall solves F(z) = z: an impact that is no faster ends the map.
constexpr double least_impact_speed = detail::least_impact_speed;

/// Solvers ask for cycles of impacts: contact that lasts longer than a few swings has none.
constexpr double solver_horizon = 50;

/// u_n before the impact, from the state after it: C = −u_n changes by B₂p + B₃q.
double impact_speed(const Body<double>& body, const Collision<double>& collision) {
    const ContactKinematics<double> after = contact_kinematics(body, collision.after);
    return after.un + after.b2() * collision.impulse.normal + after.b3() * collision.impulse.tangential;
}

/// All of a step but its derivatives. False where the map ends.
template <int D>
bool fill_step(const SceneMap<D>& map, const ReturnStep<double>& known, analysis::ShootingStep& step) {
    if (!map.goes_on(known)) return false;
    step.state = map.coordinates(known.collision.after);
    step.duration = known.collision.flight_time;
    step.letter = number_of(letter_of(known));
    step.integral = known.turned;
    step.margin = impact_speed(map.body(), known.collision);
    return step.margin > least_impact_speed;
}

template <int D>
analysis::ShootingStep step_of(const SceneMap<D>& map, const Eigen::VectorXd& z) {
    analysis::ShootingStep step;
    const auto state = map.state_at(z);
    const ReturnStep<double> known = map.return_step(state);
    if (!fill_step(map, known, step)) return step;
    step.by_state =
        known.contacts.empty() ? map.through_flight(state, known) : map.through_contact(section_point_of(z), known);
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

/// F along a parameter. `typical` has the shape and the impact rule.
template <int D>
struct MapAlongParameter {
    SceneMap<D> typical;
    Scene<double> scene;
    Parameter parameter;

    SceneMap<D> at(double p) const { return typical.with(with_parameter(scene, parameter, p)); }

    analysis::ShootingStep operator()(const Eigen::VectorXd& z, double p) const {
        analysis::ShootingStep step;
        if (!is_allowed(parameter, p)) return step;
        const SceneMap<D> map = at(p);
        const auto state = map.state_at(z);
        const ReturnStep<double> known = map.return_step(state);
        if (!fill_step(map, known, step)) return step;
        if (known.contacts.empty()) {
            const auto d = map.through_flight(state, known, parameter);
            step.by_state = d.first;
            step.by_parameter = d.second;
        } else {
            step.by_state = map.through_contact(section_point_of(z), known);
            step.by_parameter = quotient_along(state, p);
        }
        step.alive = step.by_state.allFinite() && step.by_parameter.allFinite();
        return step;
    }

    /// Through contact: a central difference, one-sided at the end of the parameter's range.
    Eigen::VectorXd quotient_along(const PostImpactState<double>& state, double p) const {
        constexpr double h = 1e-5;
        const double high = is_allowed(parameter, p + h) ? p + h : p;
        const double low = is_allowed(parameter, p - h) ? p - h : p;
        const auto above = at(high).advance(state), below = at(low).advance(state);
        if (!above.alive || !below.alive) return Eigen::VectorXd::Constant(D, std::nan(""));
        Eigen::VectorXd change = typical.coordinates(above.state) - typical.coordinates(below.state);
        for (int i = 0; i < D; ++i)
            if (typical.angle_period(i) > 0) change[i] = std::remainder(change[i], typical.angle_period(i));
        return change / (high - low);
    }
};

/// All of a scene's map for solvers but its step.
template <int D>
analysis::ShootingMap without_step(const SceneMap<D>& map) {
    analysis::ShootingMap result;
    result.dimension = D;
    for (int i = 0; i < D; ++i) result.angle_periods.push_back(map.angle_period(i));
    result.least_margin = least_impact_speed;
    return result;
}

}  // namespace

analysis::ShootingMap shooting_map_of(const Scene<double>& scene) {
    return with_scene_map(
        scene,
        [](const auto& map) {
            analysis::ShootingMap result = without_step(map);
            result.step = [map](const Eigen::VectorXd& z, double) { return step_of(map, z); };
            return result;
        },
        solver_horizon);
}

analysis::ShootingMap shooting_map_of(const Scene<double>& scene, Parameter parameter) {
    // Along μ there is friction, whatever this scene's own μ.
    const Scene<double> typical = parameter == Parameter::mu ? with_parameter(scene, parameter, 1.0) : scene;
    return with_scene_map(
        typical,
        [&]<int D>(const SceneMap<D>& map) {
            analysis::ShootingMap result = without_step(map);
            result.has_parameter = true;
            result.step = MapAlongParameter<D>{map, typical, parameter};
            return result;
        },
        solver_horizon);
}

}  // namespace swirl::apps
