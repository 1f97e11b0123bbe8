// The two equations of a fixed point over balls (map/README.md, "Steady modes"; map/steady/README.md, "One equation").
//
// Unknowns are τ and φ = ψ + χ. With s = sin χ = −β sin φ, w = β cos φ, c = cos χ, R = c − α + w, Q = R(1 − cos τ)/τ:
//
//     law   Q (s² + δc²) − s = 0 sticking (at e = 1, where s is a factor, divided by it)
//     j     Nτ(1 − S)/2π is whole
//
// φ serves both branches: nothing is singular where they meet, at w = 0. T is Ball or Dual;
// with ranges of the scene's numbers Sloped, or Dual over it.
#pragma once

#include "map/proof/step_in_balls.hpp"

#include <cstddef>

namespace swirl::proof {

template <std::size_t D, class S>
intervals::Dual<D, S> abs(const intervals::Dual<D, S>& x) {
    if (intervals::is_positive(x.value)) return x;
    if (intervals::is_negative(x.value)) return -x;
    return hull(x, -x);  // holds |x| and both slopes
}
using intervals::abs;

template <class T>
struct SteadyInBalls {
    T s, c, w, radius, slope;  ///< slope = |tan χ|
    T versine;                 ///< 1 − cos τ
    T sine;                    ///< sin τ
    T tau;
};

template <class T, class S>
SteadyInBalls<T> steady_in_balls(const SceneIn<S>& scene, const T& tau, const T& phi) {
    SteadyInBalls<T> at;
    const auto direction = sine_cosine(phi), half = sine_cosine(S(0.5) * tau), whole = sine_cosine(tau);
    at.s = S(-1) * (scene.beta * direction.sine);
    at.w = scene.beta * direction.cosine;
    at.c = sqrt(T(1) - at.s * at.s);
    at.radius = at.c + at.w - scene.alpha;
    at.slope = abs(at.s) / at.c;
    at.versine = S(2) * (half.sine * half.sine);
    at.sine = whole.sine;
    at.tau = tau;
    return at;
}

/// The share of the impulse at which slip stops, p_k/p.
template <class T, class S>
T stop_share(const SceneIn<S>& scene, const SteadyInBalls<T>& at) {
    const T square = at.c * at.c;
    return scene.kappa * at.slope / (scene.mu * (square + scene.kappa) - at.slope * square);
}

/// Stronge's δ if slip stops in compression (`early`) or in restitution.
template <class T, class S>
T stronge_deficit(const SceneIn<S>& scene, const T& share, const T& d, const T& slipping, bool early) {
    const S e2 = intervals::square(scene.restitution), lost = S(0.25) * (S(1) - e2);
    const T more = d * (T(1) - share);
    if (early) {
        const T g = T(lost) / (d + S(1)), b = S(2) * g + e2, rest = g - e2 * more;
        return S(2) * rest / (b + sqrt(b * b - S(4) * g * rest));
    }
    const T h = T(lost) / slipping, m = T(1) - S(2) * h, rest = h - more;
    return S(2) * rest / (m + sqrt(m * m - S(4) * h * rest));
}

/// δ of a sticking contact; where the stop may be early or late, both. At e = 1 it is δ/s.
template <class T, class S>
T deficit(const SceneIn<S>& scene, const SteadyInBalls<T>& at, bool elastic) {
    const S one(1), bounce = one + scene.restitution, loss = one - scene.restitution;
    const T size = abs(at.s), square = at.c * at.c;
    const T d = at.s * at.s / (square + scene.kappa);
    const T share = stop_share(scene, at);
    const T pull = size - scene.mu * at.c;                        // f − 1 = |s|(|s| − μc)/κ
    const T slipping = S(1) / scene.kappa * (size * pull) + one;  // f
    if (scene.law == Law::newton) return elastic ? T(0) : T(loss / bounce);
    T early, late, order;  // order < 0: early
    if (scene.law == Law::poisson) {
        order = bounce * share - one;
        if (elastic) {
            early = S(-1) * (at.s / (square + scene.kappa));
            late = S(1) / scene.kappa * pull;
        } else {
            early = S(1) / bounce * (T(loss) - S(2) * scene.restitution * d);
            late = S(1) / bounce * (T(loss) + S(2) * (slipping - one));
        }
    } else if (elastic) {  // −d(1 − k)/s in both
        return S(-1) * (at.s / (square + scene.kappa) * (T(1) - share));
    } else {
        early = stronge_deficit(scene, share, d, slipping, true);
        order = S(0.5) * (T(1) - early) - (d + one) * (T(1) - share);
        late = intervals::is_negative(intervals::value_of(order)) ? early
                                                                  : stronge_deficit(scene, share, d, slipping, false);
    }
    if (elastic) {  // the sign of s is a factor of what was divided
        const S& s = intervals::value_of(at.s);
        if (intervals::is_negative(s)) late = -late;
        if (intervals::contains_zero(s)) late = hull(late, -late);
    }
    const S& decides = intervals::value_of(order);
    if (intervals::is_negative(decides)) return early;
    if (intervals::is_positive(decides)) return late;
    return hull(early, late);
}

/// τ times the law's equation, so that nothing is divided by τ.
template <class T, class S>
T sticking_law(const SceneIn<S>& scene, const SteadyInBalls<T>& at, bool elastic) {
    const T push = at.radius * at.versine, delta = deficit(scene, at, elastic);
    if (elastic) return push * (at.s + delta * (at.c * at.c)) - at.tau;
    return push * (at.s * at.s + delta * (at.c * at.c)) - at.s * at.tau;
}

/// Nτ(1 − S)/2π of a contact that ends without slip.
template <class T, class S>
T sticking_steps(const SceneIn<S>& scene, const SteadyInBalls<T>& at) {
    const T inner =
        at.tau * (T(scene.alpha) - at.w) + at.radius * at.sine + at.s / at.c * (at.s * at.tau - at.radius * at.versine);
    return S(1) / (scene.spacing * scene.alpha) * inner;
}

/// Nτ(1 − S)/2π of a contact that slips throughout.
template <class T, class S>
T sliding_steps(const SceneIn<S>& scene, const SteadyInBalls<T>& at) {
    const S kept = scene.restitution / (S(1) + scene.restitution);
    const T push = at.c * at.radius * at.versine;
    const T turned = at.s * (at.c + at.w) * at.tau - push - at.s * at.radius * at.sine + S(2) * kept * push;
    return S(1) / scene.spacing * (at.tau - S(1) / scene.alpha * (turned / at.s));
}

}  // namespace swirl::proof
