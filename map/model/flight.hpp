// Free flight: the centre moves uniformly, the spin is constant; seen from the container's centre. map/README.md,
// "Flight".
//
// Axes are those of the start: along n and t of the impact that began the flight, or the laboratory's. With
// E(τ) = cis τ − 1, w = O(t) the swirl's arm and a the arm from the centre to a vertex,
//     X(τ) = X₀ + V τ − w₀ E(τ),   w(τ) = w₀ (1 + E(τ)),   a(τ) = a₀ (1 + E(Sτ)),
// X the body's centre and x = X + a the vertex, both from the container's centre. Steps compose: displacements are
// summed apart from the starting position, so that short flights keep their relative accuracy.
#pragma once

#include "map/model/body.hpp"
#include "map/numbers/turn.hpp"
#include "map/numbers/vec2.hpp"

namespace swirl {

#include "map/model/flight_formulas.hpp"

/// The disk's gap and the polygon's circumscribed circle's; of a disk that began on the wall, 2X₀·d + |d|² with d what
/// it has moved.
template <class T>
[[gnu::always_inline]] inline Gap<T> centre_gap(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at) {
    return centre_gap_of(flight.struck && body.sides == disk_sides
                             ? T(T(2) * (body.unbiased_inner * at.moved.x) + dot(at.moved, at.moved))
                             : circle_gap(body, at.centre),
                         at);
}

/// The vertex that began the flight.
template <class T>
[[gnu::always_inline]] inline Gap<T> struck_gap(const Flight<T>& flight, const Instant<T>& at) {
    Gap<T> gap = vertex_gap(flight, at, at.arm);
    gap.value = struck_value(at);
    return gap;
}

}  // namespace swirl
