// Scenes drawn over the parameters, frictionless and elastic ones among them.
#pragma once

#include "map/model/scene.hpp"

#include <random>

namespace swirl::studies {

inline Scene<double> random_scene(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    constexpr int sides[] = {disk_sides, 3, 4, 5, 6, 8, 12};
    Scene<double> scene;
    scene.sides = sides[random() % 7];
    scene.alpha = 0.1 + 0.8 * unit(random);
    scene.beta = 0.02 + 1.2 * unit(random);
    scene.mu = unit(random) < 0.2 ? 0 : 1.5 * unit(random);
    scene.restitution = unit(random) < 0.3 ? 1 : unit(random);
    scene.inertia_factor = uniform_inertia_factor<double>(scene.sides);
    return scene;
}

}  // namespace swirl::studies
