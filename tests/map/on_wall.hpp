// A body on the wall over a floor with dry friction, for the tests.
#pragma once

#include "map/dry/wall_contact.hpp"
#include "tests/map/dry_scene.hpp"

#include <memory>
#include <random>

namespace swirl::tests {

/// Numbers drawn evenly.
struct Draw {
    std::mt19937_64 generator;
    double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
};

/// A scene in which contact is frequent.
inline Scene<double> drawn_over_dry_floor(Draw& draw, int sides) {
    Scene<double> scene = scene_over_dry_floor(0, sides, Floor::dish);
    scene.alpha = draw(0.1, 0.8);
    scene.beta = draw(0.1, 1.2);
    scene.mu = draw(0, 1) < 0.15 ? 0 : draw(0.02, 0.8);
    scene.restitution = draw(0, 0.8);
    scene.floor_friction = draw(0.02, 1.0) * scene.beta;
    scene.floor = draw(0, 1) < 0.3 ? Floor::table : Floor::dish;
    return scene;
}

/// What contact needs of a scene, and what it refers to.
struct OnWall {
    std::shared_ptr<const UniformPressure> pressure;
    DryWall<double> wall;

    explicit OnWall(const Scene<double>& scene)
        : pressure(std::make_shared<const UniformPressure>(scene.sides)),
          wall{contact_scene(make_body(scene), scene.mu, scene.restitution, ImpactRule::poisson), pressure.get(),
               scene.floor_deceleration(), scene.floor == Floor::dish} {}

    /// Contact from a state in it.
    ContactPhase<double> followed(Support support, const ContactState<double>& z, double horizon,
                                  const ContactSink& sink = {}) const {
        return follow_dry_contact(wall, {true, support, z, 0, 0, 0}, horizon, sink);
    }
};

}  // namespace swirl::tests
