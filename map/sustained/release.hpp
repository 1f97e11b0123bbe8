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

/// At a release g = g′ = g″ = 0 and g‴ < 0, so the gap is as small as τ³ and drowns in rounding at first. On [0, τ₀],
/// τ₀ = 2|g‴|/M with |g⁗| ≤ M, g ≤ τ³(g‴ + Mτ/4)/6 < 0: no contact; the search begins there. Returns τ₀ and turns `flight`
/// into what follows; 0 (and an unchanged flight) if g‴ is not negative, or another vertex is too near for that.
template <Shape shape, class T>
T leave_released(const Body<T>& body, Flight<T>& flight) {
    Instant<T> at = instant_at_start(flight);
    Gap<T> gap;
    T clear = std::numeric_limits<T>::infinity();
    if constexpr (shape == Shape::disk) {
        gap = centre_gap(body, flight, at);
    } else {
        detail::NearestTwo<T> pair;
        detail::look_around(body, flight, at, pair);
        const auto bounds = detail::bounds_of<shape>(body, flight);
        const auto& other = pair.second.vertex == 0 ? pair.first : pair.second;
        gap = detail::struck_of(pair).gap;
        clear = std::min(other.gap.value < T(0) ? detail::safe_step(other.gap, bounds.vertex_third) : T(0),
                         detail::two_are_enough(body, flight, bounds, detail::magnitude(at.centre)));
    }
    if (!(gap.jerk < T(0))) return T(0);
    const T time = std::min(clear, T(T(-2) * gap.jerk / detail::fourth_bound<shape>(body, flight)));
    // Below this g‴τ³/12 is not told from rounding; then the ordinary search decides.
    if (!(time > T(1e-4))) return T(0);
    advance<shape>(flight, at, time);
    flight.centre = at.centre;
    flight.phase = at.phase;
    if constexpr (shape == Shape::polygon) flight.arm = at.arm;
    flight.struck = false;
    return time;
}

}  // namespace swirl
