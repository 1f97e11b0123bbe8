// The dish's physics as other solvers take it: in axes that stand still and move with the container's centre. There the
// wall is the unit circle at rest and the swirl a uniform force, O(t) = β cis t being the centre's place:
//
//     X = P − O     X″ = −O″ = β cis t     S constant
//
// Written out here by itself, not taken from map/, so that agreement of the first impacts means something.
#pragma once

#include "peer.hpp"

#include <cmath>

namespace swirl::peers {

/// A body at t = 0 in the container's frame. The vertex that has just struck is in the direction of `angle`.
struct ContainerState {
    Vec2<double> centre;    ///< X
    Vec2<double> velocity;  ///< X′
    double angle = 0, spin = 0;
};

/// arg n = ψ at t = 0; V = n (v_n + i v_t); X′ = V − O′, O′(0) = iβ.
inline ContainerState container_state(const Scene<double>& scene, const State& start) {
    const Vec2<double> normal = start.psi;
    const Vec2<double> arm = scene.alpha * times(normal, start.chi);
    const Vec2<double> lab = times(normal, Vec2<double>{start.vn, start.vt});
    return {normal - arm, {lab.x, lab.y - scene.beta}, std::atan2(arm.y, arm.x), start.spin};
}

/// The section's coordinates at time t; `arm` leads from the centre to the point that touches.
inline State section_state(const Scene<double>& scene, double t, const Vec2<double>& centre,
                           const Vec2<double>& velocity, const Vec2<double>& arm, double spin) {
    const Vec2<double> swirl{std::cos(t), std::sin(t)};
    const Vec2<double> x = centre + arm;
    const Vec2<double> normal = (1 / std::hypot(x.x, x.y)) * x;
    const Vec2<double> lab = velocity + scene.beta * quarter_turned(swirl);
    const Vec2<double> seen = seen_from(normal, lab);
    return {seen_from(swirl, normal), (1 / std::hypot(arm.x, arm.y)) * seen_from(normal, arm), seen.x, seen.y, spin};
}

/// The impact by Poisson's law: Δv_n = −p, Δv_t = q, ΔS = (r_n q + r_t p)/I. The slip is used up by p = p_k; from there
/// on q changes by r with p: what holds the contact point, or, if that takes more than μ, slip the other way.
inline State after_impact(const Scene<double>& scene, State state) {
    const double inertia = scene.inertia_factor * scene.alpha * scene.alpha, mu = scene.mu;
    const double rn = scene.alpha * state.chi.x, rt = scene.alpha * state.chi.y;
    const double un = state.vn - state.spin * rt - scene.beta * state.psi.y;
    const double ut = state.vt + state.spin * rn - scene.beta * state.psi.x;
    const double b1 = 1 + rn * rn / inertia, b2 = 1 + rt * rt / inertia, b3 = rn * rt / inertia;
    const double s = std::copysign(1.0, ut), c = b2 - s * mu * b3, d = mu * b1 - s * b3;
    const double kink = d > 0 ? std::fabs(ut) / d : HUGE_VAL;
    const double r = std::fabs(b3) <= mu * b1 ? -b3 / b1 : s * mu;
    const double compression = c * kink >= un ? un / c : kink + (un - c * kink) / (b2 + r * b3);
    const double p = (1 + scene.restitution) * compression;
    const double q = -s * mu * std::fmin(p, kink) + r * std::fmax(0, p - kink);
    state.vn -= p;
    state.vt += q;
    state.spin += (rn * q + rt * p) / inertia;
    return state;
}

/// From the centre to vertex k, counted from the one at `angle`; to the disk's point that is nearest to the wall.
inline Vec2<double> arm_of(const Scene<double>& scene, const Vec2<double>& centre, double angle, int k) {
    if (scene.is_disk()) return (scene.alpha / std::hypot(centre.x, centre.y)) * centre;
    const double direction = angle + 2 * M_PI * k / scene.sides;
    return {scene.alpha * std::cos(direction), scene.alpha * std::sin(direction)};
}

}  // namespace swirl::peers
