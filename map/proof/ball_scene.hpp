// A scene as exact numbers: the decimals that a user wrote, not the doubles next to them.
#pragma once

#include "map/intervals/ball.hpp"
#include "map/model/scene.hpp"

namespace swirl::proof {

using intervals::Ball;

/// α = 0.4 is the ball about 4/10. κ is the decimal, too, unless its double is that of the uniform lamina: then
/// (2 + cos(2π/N))/6 itself.
template <class S>
struct SceneIn {
    int sides = 6;
    Law law = Law::poisson;
    bool frictionless = false;
    S alpha, beta, mu, restitution, kappa;
    S inertia, inverse_inertia;  ///< I = κα², 1/I
    S spacing;                   ///< 2π/N; 0 of the disk

    bool is_disk() const { return sides == disk_sides; }
};
using BallScene = SceneIn<Ball>;

/// Every number is the shortest decimal that reads back to the scene's double.
inline BallScene ball_scene(const Scene<double>& scene) {
    using intervals::decimal;
    without_floor(scene, "a proof");
    without_tangential_restitution(scene, "a proof");
    without_rod(scene, "a proof");
    without_rounding(scene, "a proof");
    BallScene balls;
    balls.sides = scene.sides;
    balls.law = scene.law;
    balls.frictionless = scene.mu == 0;
    balls.alpha = decimal(scene.alpha);
    balls.beta = decimal(scene.beta);
    balls.mu = decimal(scene.mu);
    balls.restitution = decimal(scene.restitution);
    if (!scene.is_disk()) balls.spacing = Ball(2) * intervals::pi_ball() / Ball(scene.sides);
    balls.kappa = decimal(scene.inertia_factor);
    if (scene.inertia_factor == uniform_inertia_factor<double>(scene.sides) && !scene.is_disk())
        balls.kappa = (Ball(2) + intervals::sine_cosine(balls.spacing).cosine) / Ball(6);
    balls.inertia = balls.kappa * intervals::square(balls.alpha);
    balls.inverse_inertia = Ball(1) / balls.inertia;
    return balls;
}

}  // namespace swirl::proof
