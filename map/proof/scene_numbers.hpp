// A scene's exact numbers as enclosed numbers of another sort, and each by its parameter's name.
#pragma once

#include "map/model/parameter.hpp"
#include "map/proof/ball_scene.hpp"

#include <stdexcept>

namespace swirl::proof {

/// Each number by `number`, which takes a ball.
template <class S, class Number>
SceneIn<S> scene_as(const BallScene& exact, const Number& number) {
    SceneIn<S> scene;
    scene.sides = exact.sides;
    scene.law = exact.law;
    scene.frictionless = exact.frictionless;
    scene.alpha = number(exact.alpha);
    scene.beta = number(exact.beta);
    scene.mu = number(exact.mu);
    scene.restitution = number(exact.restitution);
    scene.kappa = number(exact.kappa);
    scene.inertia = number(exact.inertia);
    scene.inverse_inertia = number(exact.inverse_inertia);
    scene.spacing = number(exact.spacing);
    return scene;
}

/// The scene with another value of one of its numbers; set_inertia is to follow.
template <class S>
void set_parameter(SceneIn<S>& scene, Parameter parameter, const S& value) {
    switch (parameter) {
        case Parameter::alpha:
            scene.alpha = value;
            break;
        case Parameter::beta:
            scene.beta = value;
            break;
        case Parameter::mu:
            scene.mu = value;
            break;
        case Parameter::restitution:
            scene.restitution = value;
            break;
        case Parameter::inertia_factor:
            scene.kappa = value;
            break;
        case Parameter::drag:
            throw std::invalid_argument(
                "proofs are not extended to a floor that drags: drag is no parameter of theirs");
        case Parameter::tangential_restitution:
            throw std::invalid_argument(
                "proofs are not extended to tangential restitution: tangential-restitution is no parameter of theirs");
        case Parameter::corner:
            throw std::invalid_argument("proofs are not extended to rounded corners: corner is no parameter of theirs");
    }
}

/// I = κα².
template <class S>
void set_inertia(SceneIn<S>& scene) {
    scene.inertia = scene.kappa * intervals::square(scene.alpha);
    scene.inverse_inertia = S(1) / scene.inertia;
}

}  // namespace swirl::proof
