// Free flight: the centre moves uniformly, the spin is constant; seen from the container's centre. Design, section 2.
//
// Axes are those of the start: along n and t of the impact that began the flight, or the laboratory's. From there
//     X(τ) = X₀ + V τ − w₀ E(τ),   w(τ) = w₀ (1 + E(τ)),   a(τ) = a₀ (1 + E(Sτ)),   E(τ) = cis τ − 1,
// with X the body's centre and x = X + a a vertex, both from the container's centre, and w = O(t) the swirl's arm.
// Written with E, nothing is lost on flights that are short.
#pragma once

#include "map/body.hpp"
#include "map/turn.hpp"
#include "map/vec2.hpp"

namespace swirl {

/// The start of a flight.
template <class T>
struct Flight {
    Vec2<T> centre;    ///< X₀
    Vec2<T> velocity;  ///< V, in the laboratory
    Vec2<T> phase;     ///< cis φ₀, the direction of the swirl's arm at the start
    Vec2<T> swirl;     ///< w₀ = β cis φ₀, the arm itself
    Vec2<T> arm;       ///< a₀: from the centre to the reference vertex (disk: to the rim's point on the wall)
    T spin{};          ///< S
    bool struck = false;  ///< the reference vertex has just struck: X₀ + a₀ = (1, 0), its gap is zero by identity
};

/// A moment of a flight.
template <class T>
struct Instant {
    T time{};            ///< τ
    Vec2<T> swirl_turn;  ///< E(τ)
    Vec2<T> body_turn;   ///< E(Sτ); not kept for the disk
    Vec2<T> moved;       ///< X − X₀
    Vec2<T> centre;      ///< X
    Vec2<T> swirl;       ///< w = −X″ … the centre's acceleration in the container's frame is +w
    Vec2<T> drift;       ///< W = X′ = V − i w
};

namespace detail {

template <class T>
inline void settle(const Flight<T>& flight, Instant<T>& at) {
    const Vec2<T> swirl_moved = times(flight.swirl, at.swirl_turn);
    at.moved = at.time * flight.velocity - swirl_moved;
    at.centre = flight.centre + at.moved;
    at.swirl = flight.swirl + swirl_moved;
    at.drift = flight.velocity - quarter_turned(at.swirl);
}

}  // namespace detail

/// The moment τ, from the start.
template <Shape shape, class T>
inline Instant<T> instant_at(const Flight<T>& flight, const T& time) {
    Instant<T> at;
    at.time = time;
    at.swirl_turn = turn_minus_one(time);
    if constexpr (shape == Shape::polygon) at.body_turn = turn_minus_one(T(flight.spin * time));
    detail::settle(flight, at);
    return at;
}

/// The moment `step` later: rotations are composed, so a short step costs polynomials only.
template <Shape shape, class T>
inline void advance(const Flight<T>& flight, Instant<T>& at, const T& step) {
    at.time = at.time + step;
    at.swirl_turn = compose(at.swirl_turn, turn_minus_one(step));
    if constexpr (shape == Shape::polygon)
        at.body_turn = compose(at.body_turn, turn_minus_one(T(flight.spin * step)));
    detail::settle(flight, at);
}

/// A gap and its first two derivatives in time.
template <class T>
struct Gap {
    T value;  ///< g
    T rate;   ///< g′
    T bend;   ///< g″
};

/// g = |X|² − (1 − α)²: the disk's gap, and the polygon's circumscribed circle's. X″ = w.
template <class T>
inline Gap<T> centre_gap(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at) {
    const T value = flight.struck && body.sides == disk_sides
                        ? T(T(2) * body.inner * at.moved.x + dot(at.moved, at.moved))
                        : T(dot(at.centre, at.centre) - body.inner * body.inner);
    return {value, T(2) * dot(at.centre, at.drift), T(2) * (dot(at.drift, at.drift) + dot(at.centre, at.swirl))};
}

/// g = |x|² − 1 of the vertex at x = X + a; x′ = W + iSa, x″ = w − S²a.
template <class T>
inline Gap<T> vertex_gap(const Flight<T>& flight, const Instant<T>& at, const Vec2<T>& arm) {
    const Vec2<T> x = at.centre + arm;
    const Vec2<T> rate = at.drift + flight.spin * quarter_turned(arm);
    const Vec2<T> bend = at.swirl - (flight.spin * flight.spin) * arm;
    return {dot(x, x) - T(1), T(2) * dot(x, rate), T(2) * (dot(rate, rate) + dot(x, bend))};
}

/// The same for the vertex that began the flight: |(1, 0) + d|² − 1 = 2 d_x + |d|², with d what it has moved.
template <class T>
inline Gap<T> struck_gap(const Flight<T>& flight, const Instant<T>& at, const Vec2<T>& arm) {
    const Vec2<T> moved = at.moved + times(flight.arm, at.body_turn);
    Gap<T> gap = vertex_gap(flight, at, arm);
    gap.value = T(2) * moved.x + dot(moved, moved);
    return gap;
}

}  // namespace swirl
