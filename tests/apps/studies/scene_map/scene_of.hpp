// Scenes of uniform bodies in a line each.
#pragma once

#include "map/model/scene.hpp"

namespace swirl::tests {

inline Scene<double> scene_of(int sides, double alpha, double beta, double mu, double restitution,
                              Law law = Law::poisson) {
    return {sides, alpha, beta, mu, restitution, law, uniform_inertia_factor<double>(sides)};
}

}  // namespace swirl::tests
