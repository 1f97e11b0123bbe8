// The two equations of a fixed point in τ and φ for each contact, over enclosed numbers of any sort.
#pragma once

#include "map/intervals/curved.hpp"
#include "map/intervals/sloped.hpp"
#include "map/proof/steady_in_balls.hpp"

#include <cstddef>

namespace swirl::proof {

/// Which contact a solution is sought for: one that sticks, or slips either way.
enum class ContactSet { sticking, sliding_ahead, sliding_back };

inline bool is_sliding(ContactSet set) {
    return set == ContactSet::sliding_ahead || set == ContactSet::sliding_back;
}
/// The sign of the slip of a contact that slides.
inline int slip_of(ContactSet set) {
    return set == ContactSet::sliding_ahead ? 1 : -1;
}

/// sin χ and cos χ of a contact that slides.
template <class S>
struct KnownOffset {
    S sine, cosine;
};
template <class S>
KnownOffset<S> known_offset(const SceneIn<S>& scene, ContactSet set) {
    const S cosine = S(1) / sqrt(S(1) + intervals::square(scene.mu));
    return {S(slip_of(set)) * scene.mu * cosine, cosine};
}

/// sin χ, w … as functions of τ and φ; χ is that of the set where it slides.
template <class T, class S>
SteadyInBalls<T> steady_on(const SceneIn<S>& scene, ContactSet set, const T& tau, const T& phi) {
    if (set == ContactSet::sticking) return steady_in_balls<T>(scene, tau, phi);
    const KnownOffset<S> offset = known_offset(scene, set);
    SteadyInBalls<T> at;
    const auto direction = sine_cosine(phi), half = sine_cosine(S(0.5) * tau);
    at.s = T(offset.sine);
    at.c = T(offset.cosine);
    at.w = scene.beta * direction.cosine;
    at.radius = at.c + at.w - scene.alpha;
    at.versine = S(2) * (half.sine * half.sine);
    at.sine = sine_cosine(tau).sine;
    at.tau = tau;
    return at;
}

/// (1 − cos τ)/τ, of a plain number also at 0.
template <class T>
T versine_per_time(const SteadyInBalls<T>& at) {
    return at.versine / at.tau;
}
template <std::size_t K>
intervals::Curved<K> versine_per_time(const SteadyInBalls<intervals::Curved<K>>& at) {
    return versine_rate(at.tau);
}
template <std::size_t K>
intervals::Sloped<K> versine_per_time(const SteadyInBalls<intervals::Sloped<K>>& at) {
    return versine_rate(at.tau);
}

/// f = 0 and j whole. f is the law of a contact that sticks, divided by τ, or sin χ less that of one that slides.
template <class T>
struct SolutionEquations {
    T f, j;
};
template <class T, class S>
SolutionEquations<T> solution_equations(const SceneIn<S>& scene, ContactSet set, const T& tau, const T& phi) {
    const SteadyInBalls<T> at = steady_on<T>(scene, set, tau, phi);
    if (set == ContactSet::sticking) {
        const T push = at.radius * versine_per_time(at);
        return {push * (at.s * at.s + deficit(scene, at, false) * (at.c * at.c)) - at.s, sticking_steps(scene, at)};
    }
    const T f = T(scene.beta * sine_cosine(phi).sine) + at.s;  // sin χ = −β sin φ
    return {f, sliding_steps(scene, at)};
}

/// The section point of a solution of vertex step j.
template <class S>
BallPoint<S> section_point_of(const SceneIn<S>& scene, ContactSet set, long j, const S& tau, const S& phi) {
    const SteadyInBalls<S> at = steady_on<S>(scene, set, tau, phi);
    const S chi = asin(at.s), half = S(0.5) * tau, speed = at.radius * sinc(half);
    const auto along = sine_cosine(chi + half);
    const S spin = S(1) - scene.spacing * S(static_cast<double>(j)) / tau;
    return {phi - chi, chi, -(speed * along.sine), speed * along.cosine, spin};
}

}  // namespace swirl::proof
