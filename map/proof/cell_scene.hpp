// A scene with two of its numbers over a cell.
#pragma once

#include "map/proof/solution_equations.hpp"
#include "map/proof/steady_cells.hpp"

#include <cstddef>
#include <stdexcept>

namespace swirl::proof {

/// The scene with its two parameters over the cell as the variables number `first` and the next of S.
///   at_middle  the parameters are those of the cell's middle, without width
template <class S>
SceneIn<S> scene_over(const PlaneScene& plane, const cells::ParameterCell& cell, std::size_t first,
                      bool at_middle = false) {
    const BallScene exact = ball_scene(plane.base);
    SceneIn<S> scene;
    scene.sides = exact.sides;
    scene.law = exact.law;
    scene.alpha = S(exact.alpha);
    scene.beta = S(exact.beta);
    scene.mu = S(exact.mu);
    scene.restitution = S(exact.restitution);
    scene.kappa = S(exact.kappa);
    scene.spacing = S(exact.spacing);
    for (std::size_t i = 0; i < 2; ++i) {
        const S value = at_middle ? S(cell.middle(i)) : S::variable(cell.low[i], cell.high[i], first + i);
        switch (plane.parameters[i]) {
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
                throw std::invalid_argument("proven cells are not extended to a floor that drags: drag is no axis");
        }
    }
    scene.inertia = scene.kappa * square(scene.alpha);
    scene.inverse_inertia = S(1) / scene.inertia;
    return scene;
}

}  // namespace swirl::proof
