// A scene over a floor with dry friction, for the tests.
#pragma once

#include "map/model/scene.hpp"

namespace swirl::tests {

/// a_f = `friction`, as G = 1.
inline Scene<double> scene_over_dry_floor(double friction, int sides, Floor floor) {
    Scene<double> scene;
    scene.sides = sides;
    scene.alpha = 0.4;
    scene.beta = 0.5;
    scene.mu = 0.5;
    scene.restitution = 0.9;
    scene.inertia_factor = uniform_inertia_factor<double>(sides);
    scene.floor_friction = friction;
    scene.gravity_ratio = 1;
    scene.floor = floor;
    return scene;
}

}  // namespace swirl::tests
