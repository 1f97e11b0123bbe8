// The flight that begins where the normal force has fallen to zero.
#pragma once

#include "map/contact_polygon.hpp"

namespace swirl {

namespace detail {

/// A bound of |g⁗| along a flight, of the gap that begins it (see certificate.hpp for the pattern).
template <Shape shape, class T>
inline T fourth_bound(const Body<T>& body, const Flight<T>& flight) {
    using std::fabs;
    const T speed = fabs(flight.velocity.x) + fabs(flight.velocity.y);
    const T place = body.outer + body.beta;
    T bound = T(2) * body.beta * (T(4) * speed + place);
    if constexpr (shape == Shape::polygon) {
        const T s = fabs(flight.spin);
        const T relative = (flight.spin - T(1)) * (flight.spin - T(1));
        bound = bound + T(2) * body.alpha * (s * s * s * (s * place + T(4) * speed) + body.beta * relative * relative);
    }
    return bound;
}

}  // namespace detail

namespace detail {

/// How long a gap that is (all but) closed and at rest certainly stays inside: with g = g′ = 0 and g″ < 0 by the advance
/// off the wall; with g″ = 0 too and g‴ < 0 for τ₀ = 2|g‴|/M, |g⁗| ≤ M, where g ≤ τ³(g‴ + Mτ/4)/6 < 0. 0 if neither.
template <class T>
inline T leaving_time(const Gap<T>& gap, const T& third, const T& fourth, const T& rounding) {
    if (gap.bend < -rounding) return safe_step_off_the_wall(Gap<T>{T(0), T(0), gap.bend, gap.jerk}, third);
    return gap.bend <= rounding && gap.jerk < T(0) ? T(T(-2) * gap.jerk / fourth) : T(0);
}

}  // namespace detail

/// At a release the gap of what leaves the wall is as small as τ² or τ³ and drowns in rounding at first. Both vertices of
/// an edge may leave at once. Returns a time for which nothing can touch, and turns `flight` into what follows; 0 (and an
/// unchanged flight) if there is none that lifts the gap out of rounding: then the ordinary search decides.
template <Shape shape, class T>
T leave_released(const Body<T>& body, Flight<T>& flight) {
    using std::fabs;
    Instant<T> at = instant_at_start(flight);
    const auto bounds = detail::bounds_of<shape>(body, flight);
    const T fourth = detail::fourth_bound<shape>(body, flight);
    const T rounding = T(1e-11) * (T(1) + bounds.drift * bounds.drift);
    T time;
    if constexpr (shape == Shape::disk) {
        time = detail::leaving_time(centre_gap(body, flight, at), bounds.centre_third, fourth, rounding);
    } else {
        detail::NearestTwo<T> pair;
        detail::look_around(body, flight, at, pair);
        time = detail::two_are_enough(body, flight, bounds, detail::magnitude(at.centre));
        for (const auto* candidate : {&pair.first, &pair.second}) {
            const Gap<T>& gap = candidate->gap;
            const bool closed = gap.value > T(-1e-12) && fabs(gap.rate) <= T(1e-12) * (T(1) + bounds.drift);
            time = std::min(time, closed ? detail::leaving_time(gap, bounds.vertex_third, fourth, rounding)
                                         : gap.value < T(0) ? detail::safe_step(gap, bounds.vertex_third) : T(0));
        }
    }
    if (!(time > T(1e-4))) return T(0);
    advance<shape>(flight, at, time);
    flight.centre = at.centre;
    flight.phase = at.phase;
    if constexpr (shape == Shape::polygon) flight.arm = at.arm;
    flight.struck = false;
    return time;
}

}  // namespace swirl
