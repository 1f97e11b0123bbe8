// One step of F along a given smooth branch, over balls or duals: no search, no choice.
//
// map/README.md, "Flight", "Impact". S is Ball, or Sloped where the scene's numbers range; T is S, or Dual over S for
// the derivatives.
#pragma once

#include "map/intervals/curved.hpp"
#include "map/intervals/dual.hpp"
#include "map/intervals/sloped.hpp"
#include "map/proof/ball_scene.hpp"
#include "map/proof/claim.hpp"

#include <string>
#include <vector>

namespace swirl::proof {

using intervals::sine_cosine;

/// A quantity that has to be positive for a step to be F's.
struct Margin {
    std::string name;
    Ball value;
};
using Margins = std::vector<Margin>;

/// A point of the section.
template <class T>
struct BallPoint {
    T psi{}, chi{}, vn{}, vt{}, spin{};
};

/// Slip velocities before the impact and the arm of the contact.
template <class T>
struct BallKinematics {
    T un, ut, rn, rt;
};

template <class S, class T>
BallKinematics<T> kinematics(const SceneIn<S>& scene, const BallPoint<T>& z) {
    const auto psi = sine_cosine(z.psi), chi = sine_cosine(z.chi);
    const T rn = scene.alpha * chi.cosine, rt = scene.alpha * chi.sine;
    return {z.vn - z.spin * rt - scene.beta * psi.sine, z.vt + z.spin * rn - scene.beta * psi.cosine, rn, rt};
}

template <class T>
struct BallImpulse {
    T p, q;
};

namespace detail {

/// What an impact that slips in one direction at first is made of.
///   sign  of u_t
template <class S, class T>
struct SlipPath {
    T b1, b2, b3;
    T first;     ///< c = B₂ − sμB₃
    T slowing;   ///< d = μB₁ − sB₃
    S friction;  ///< sμ
    S sign;

    SlipPath(const SceneIn<S>& scene, const BallKinematics<T>& at, int s) : friction(S(s) * scene.mu), sign(s) {
        b1 = scene.inverse_inertia * (at.rn * at.rn) + S(1);
        b2 = scene.inverse_inertia * (at.rt * at.rt) + S(1);
        b3 = scene.inverse_inertia * (at.rn * at.rt);
        first = b2 - friction * b3;
        slowing = scene.mu * b1 - sign * b3;
    }
};

template <class T>
void note(Margins* margins, const char* name, const T& value) {
    if (margins != nullptr) margins->push_back({name, intervals::values_of(intervals::value_of(value))});
}

/// The end of an impact whose slip stops at p_k.
///   second  f, the slope of C beyond;   at_kink  C_k
template <class S, class T>
T end_beyond_kink(const SceneIn<S>& scene, const T& un, const SlipPath<S, T>& path, const T& kink, const T& at_kink,
                  const T& second, bool early) {
    const S one_and_e = S(1) + scene.restitution;
    switch (scene.law) {
        case Law::poisson:
            break;
        case Law::newton:
            return kink + (scene.restitution * un - at_kink) / second;
        case Law::stronge: {
            const S squared = intervals::square(scene.restitution);
            const T level =
                early ? T(squared * (second * (un - at_kink) * kink + at_kink * at_kink))
                      : T(at_kink * at_kink + second / path.first * (squared * (un * un) - at_kink * at_kink));
            return kink + (sqrt(level) - at_kink) / second;
        }
    }
    return one_and_e * (early ? T(kink - at_kink / second) : T(un / path.first));
}

template <class S, class T>
BallImpulse<T> slipping_impulse(const SceneIn<S>& scene, const BallKinematics<T>& at, ContactMode mode, int sign,
                                Margins* margins) {
    const SlipPath<S, T> path(scene, at, sign);
    const T slip = path.sign * at.ut;
    if (mode == ContactMode::sliding) {
        const T p = (S(1) + scene.restitution) * (at.un / path.first);
        note(margins, "B2 - s mu B3 > 0", path.first);
        note(margins, "slip goes on to the end: s u_t after > 0", slip - p * path.slowing);
        return {p, -(path.friction * p)};
    }
    const bool sticks = ends_in_stick(mode);
    const bool early = mode == ContactMode::c_sticking || mode == ContactMode::c_reversed;
    const T kink = slip / path.slowing;
    const T at_kink = path.first * kink - at.un;
    const T beyond = sticks ? T(-(path.b3 / path.b1)) : T(T(0) + path.friction);
    const T second = path.b2 + beyond * path.b3;
    const T end = end_beyond_kink(scene, at.un, path, kink, at_kink, second, early);
    note(margins, "slip slows down: mu B1 - s B3 > 0", path.slowing);
    note(margins, early ? "slip stops in compression: p_c > p_k" : "slip stops in restitution: p_k > p_c",
         early ? T(-at_kink) : at_kink);
    if (!early) note(margins, "B2 - s mu B3 > 0", path.first);
    note(margins, "slip stops before the end: p > p_k", end - kink);
    note(margins, "C rises beyond the kink", second);
    const T pull = path.sign * path.b3;
    note(margins, sticks ? "friction holds: mu B1 > |B3|" : "friction does not hold: |B3| > mu B1",
         sticks ? T(scene.mu * path.b1 + pull) : T(-(scene.mu * path.b1) - pull));
    return {end, beyond * (end - kink) - path.friction * kink};
}

}  // namespace detail

/// The impulse of the mode. `margins` gets what has to be positive; null: none.
template <class S, class T>
BallImpulse<T> impulse_of(const SceneIn<S>& scene, const BallKinematics<T>& at, const Branch& branch,
                          Margins* margins) {
    detail::note(margins, "u_n before > 0", at.un);
    if (branch.mode == ContactMode::frictionless) {
        const T b2 = scene.inverse_inertia * (at.rt * at.rt) + S(1);
        return {(S(1) + scene.restitution) * at.un / b2, T(0)};
    }
    if (branch.slip != 0) {
        detail::note(margins, "s u_t before > 0", S(branch.slip) * at.ut);
        return detail::slipping_impulse(scene, at, branch.mode, branch.slip, margins);
    }
    // Slip that stops at once: p and q are continuous there, and the pieces on both sides are both enclosed.
    const BallImpulse<T> a = detail::slipping_impulse(scene, at, branch.mode, 1, margins);
    const BallImpulse<T> b = detail::slipping_impulse(scene, at, branch.mode, -1, margins);
    return {hull(a.p, b.p), hull(a.q, b.q)};
}

template <class T>
struct BallStep {
    T gap;  ///< of the vertex that strikes, at the flight's end
    BallPoint<T> before, after;
};

/// From z through a flight of time τ and the branch's impact. `after` is F(z) where gap = 0.
///   advance  the wall's advance arg n′ − arg n, roughly: the angle is counted from there
template <class T, class S>
BallStep<T> step_in_balls(const SceneIn<S>& scene, const Branch& branch, double advance, const BallPoint<T>& z,
                          const T& tau, Margins* margins = nullptr) {
    const auto psi = sine_cosine(z.psi), chi = sine_cosine(z.chi), phase = sine_cosine(tau - z.psi);
    T x = z.vn * tau - scene.alpha * chi.cosine + scene.beta * (psi.cosine - phase.cosine) + S(1);
    T y = z.vt * tau - scene.alpha * chi.sine - scene.beta * (psi.sine + phase.sine);
    const S reach = scene.is_disk() ? S(1) - scene.alpha : S(1);
    const T angle = z.chi + z.spin * tau + scene.spacing * S(branch.vertex_step);
    if (!scene.is_disk()) {
        const auto arm = sine_cosine(angle);
        x = x + scene.alpha * arm.cosine;
        y = y + scene.alpha * arm.sine;
    }
    const auto about = sine_cosine(S(advance));
    const T nu = atan2(about.cosine * y - about.sine * x, about.cosine * x + about.sine * y) + S(advance);
    BallStep<T> step;
    step.gap = x * x + y * y - intervals::square(reach);
    const S scale = S(1) / reach;
    step.before = {z.psi + nu - tau, scene.is_disk() ? T(0) : T(angle - nu), scale * (z.vn * x + z.vt * y),
                   scale * (z.vt * x - z.vn * y), z.spin};
    const BallKinematics<T> at = kinematics(scene, step.before);
    const BallImpulse<T> j = impulse_of(scene, at, branch, margins);
    step.after = step.before;
    step.after.vn = step.before.vn - j.p;
    step.after.vt = step.before.vt + j.q;
    step.after.spin = step.before.spin + scene.inverse_inertia * (at.rn * j.q + at.rt * j.p);
    return step;
}

}  // namespace swirl::proof
