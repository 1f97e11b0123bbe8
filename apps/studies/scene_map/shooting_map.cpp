#include "apps/studies/scene_map/shooting_map.hpp"

#include "apps/studies/scene_map/chatter_once.hpp"
#include "apps/studies/scene_map/on_the_wall.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "map/derivative/timed_collision.hpp"

#include <cmath>
#include <cstddef>

namespace swirl::studies {

namespace {

/// As u_n → 0 every state of a body at rest on the wall solves F(z) = z: an impact that is no faster ends the map.
constexpr double least_impact_speed = detail::least_impact_speed;

/// u_n before the impact, from the state after it: C = −u_n changes by B₂p + B₃q.
double impact_speed(const Body<double>& body, const Collision<double>& collision) {
    const ContactKinematics<double> after = kinematics_of(body, collision.after);
    return after.un + after.b2() * collision.impulse.normal + after.b3() * collision.impulse.tangential;
}

/// DF of one step of the return map.
template <int D>
analysis::Matrix<D> derivative_at(const SceneMap<D>& map, const PostImpactState<double>& z,
                                  const ReturnStep<double>& known) {
    return known.contacts.empty() ? map.through_flight(z, known) : map.through_contact(section_point(z), known);
}

/// Where a step begins: at z itself, or on the surfaces near it that impacts without restitution leave.
template <int D>
WallState<D> begin_of(const SceneMap<D>& map, const Eigen::VectorXd& z, bool on_surface) {
    if (on_surface) return on_the_wall<D>(map.body(), z);
    WallState<D> begin;
    begin.z = z;
    return begin;
}

/// One step from there on, rebounds that end in contact counted once, with its derivative by z: all but ∂F/∂p.
///   derive  DF of one step of the return map
template <int D, class Derive>
analysis::ShootingStep step_of(const SceneMap<D>& map, const WallState<D>& begin, const Derive& derive) {
    analysis::ShootingStep step;
    PostImpactState<double> state = map.state_at(begin.z);
    const auto steps = steps_as_one(map, state);
    analysis::Matrix<D> by_state = begin.by_state;
    Letter letter;
    step.duration = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const ReturnStep<double>& known = steps[i];
        if (!map.goes_on(known)) return step;
        if (i + 1 == steps.size()) step.margin = impact_speed(map.body(), known.collision);
        if (!(step.margin > least_impact_speed)) return step;
        by_state = derive(state, known) * by_state;
        step.duration += known.collision.flight_time;
        step.integral += known.turned;
        letter = i == 0 ? letter_of(known) : joined(letter, letter_of(known), map.body().sides);
        state = known.collision.after;
    }
    step.state = map.coordinates(state);
    step.letter = number_of(letter);
    step.by_state = by_state;
    step.alive = step.by_state.allFinite();
    return step;
}

/// F along a parameter. `typical` has the shape and the impact rule.
template <int D>
struct MapAlongParameter {
    SceneMap<D> typical;
    Scene<double> scene;
    Parameter parameter;
    bool on_surface = false;

    SceneMap<D> at(double p) const { return typical.with(with_parameter(scene, parameter, p)); }
    bool has(double p) const {
        const Scene<double> there = with_parameter(scene, parameter, p);
        return is_allowed(parameter, p) && (!there.is_rounded() || there.corner < there.alpha);
    }

    analysis::ShootingStep operator()(const Eigen::VectorXd& z, double p) const {
        analysis::ShootingStep step;
        if (!has(p)) return step;
        const SceneMap<D> map = at(p);
        const WallState<D> begin = begin_of(map, z, on_surface);
        analysis::Vector<D> along = begin.along(parameter);
        step = step_of(map, begin, [&](const PostImpactState<double>& from, const ReturnStep<double>& known) {
            const analysis::Matrix<D> d = derivative_at(map, from, known);
            along = d * along + map.along(from, known, parameter);
            return d;
        });
        step.by_parameter = along;
        step.alive = step.alive && along.allFinite();
        return step;
    }
};

/// F over two parameters. `typical` has the shape and the impact rule.
template <int D>
struct PlaneStepOf {
    SceneMap<D> typical;
    Scene<double> scene;
    Parameter first, second;

    analysis::ShootingStep operator()(const Eigen::VectorXd& z, const Eigen::Vector2d& p) const {
        analysis::ShootingStep step;
        if (!is_allowed(first, p[0]) || !is_allowed(second, p[1])) return step;
        const SceneMap<D> map = typical.with(with_parameter(with_parameter(scene, first, p[0]), second, p[1]));
        Eigen::Matrix<double, D, 2> along = Eigen::Matrix<double, D, 2>::Zero();
        step = step_of(map, begin_of(map, z, false),
                       [&](const PostImpactState<double>& from, const ReturnStep<double>& known) {
                           const analysis::Matrix<D> d = derivative_at(map, from, known);
                           along = (d * along).eval();
                           along.col(0) += map.along(from, known, first);
                           along.col(1) += map.along(from, known, second);
                           return d;
                       });
        step.by_parameter = along;
        step.alive = step.alive && along.allFinite();
        return step;
    }
};

/// The coordinates of a scene's map for solvers.
template <int D>
analysis::MapCoordinates coordinates_for(const SceneMap<D>& map) {
    analysis::MapCoordinates result;
    result.dimension = D;
    for (int i = 0; i < D; ++i) result.angle_periods.push_back(map.angle_period(i));
    result.least_margin = least_impact_speed;
    return result;
}

}  // namespace

analysis::ShootingMap shooting_map_of(const Scene<double>& scene, Accuracy accuracy) {
    return with_scene_map(
        scene,
        [&scene](const auto& map) {
            analysis::ShootingMap result{coordinates_for(map)};
            const auto step = [map](bool on_surface) {
                return [map, on_surface](const Eigen::VectorXd& z, double) {
                    return step_of(map, begin_of(map, z, on_surface), [&map](const auto& from, const auto& known) {
                        return derivative_at(map, from, known);
                    });
                };
            };
            result.step = step(false);
            if (scene.restitution == 0) result.step_from_surface = step(true);
            return result;
        },
        solver_horizon, accuracy);
}

analysis::ShootingMap shooting_map_of(const Scene<double>& scene, Parameter parameter, Accuracy accuracy) {
    // Along μ there is friction, whatever this scene's own μ, and so with drag, tangential restitution and r.
    const bool may_vanish =
        parameter == Parameter::mu || parameter == Parameter::drag || parameter == Parameter::tangential_restitution;
    const Scene<double> typical = may_vanish                       ? with_parameter(scene, parameter, 1.0)
                                  : parameter == Parameter::corner ? with_parameter(scene, parameter, scene.alpha / 2)
                                                                   : scene;
    return with_scene_map(
        typical,
        [&]<int D>(const SceneMap<D>& map) {
            analysis::ShootingMap result{coordinates_for(map)};
            result.has_parameter = true;
            result.step = MapAlongParameter<D>{map, typical, parameter};
            if (scene.restitution == 0 && parameter != Parameter::restitution && !typical.is_rounded())
                result.step_from_surface = MapAlongParameter<D>{map, typical, parameter, true};
            return result;
        },
        solver_horizon, accuracy);
}

bool is_allowed(Parameter parameter, double value) {
    switch (parameter) {
        case Parameter::alpha:
            return value > 0 && value < 1;
        case Parameter::restitution:
        case Parameter::tangential_restitution:
            return value >= 0 && value <= 1;
        case Parameter::inertia_factor:
            return value > 0 && detail::is_holdable(value);
        case Parameter::drag:
            return value >= 0 && value <= largest_drag && detail::is_holdable(value);
        case Parameter::corner:  // below α, which the map's own range says
        case Parameter::beta:
        case Parameter::mu:
            break;
    }
    return value >= 0 && detail::is_holdable(value);
}

analysis::PlaneMap plane_map_of(const Scene<double>& scene, Parameter first, Parameter second) {
    Scene<double> typical = scene;
    for (const Parameter parameter : {first, second})
        if (parameter == Parameter::mu) typical = with_parameter(typical, parameter, 1.0);
    return with_scene_map(
        typical,
        [&]<int D>(const SceneMap<D>& map) {
            return analysis::PlaneMap{coordinates_for(map), PlaneStepOf<D>{map, typical, first, second}};
        },
        solver_horizon);
}

}  // namespace swirl::studies
