// The centre's gap along a flight as a scalar function of time, for searches on the critical path.
//
// In the laboratory the centre is at P(τ) = P₀ + Vτ from the swirl's centre, and X = P − w. So
//     g = |X|² − (1 − α)² = g₀ + 2τ V·X₀ + τ²|V|² − 2 (A c + B s),   E(τ) = (c, s),
// with A = P·w₀ and B = P·(i w₀) linear in τ: seven numbers per flight, and every derivative from the same products.
#pragma once

#include "map/flight.hpp"

namespace swirl::detail {

template <class T>
struct CirclePath {
    T start;            ///< g₀
    T slope;            ///< 2 V·X₀
    T speed2;           ///< |V|²
    T a0, a1, b0, b1;   ///< A = a0 + a1 τ, B = b0 + b1 τ
};

/// The gap and its derivatives up to the fifth.
template <class T>
struct CircleGap : Gap<T> {
    T fourth, fifth;
};

template <class T>
inline CirclePath<T> circle_path(const Flight<T>& flight, const Vec2<T>& swirl, const T& start) {
    const Vec2<T> place = flight.centre + swirl;
    const Vec2<T> side = quarter_turned(swirl);
    return {start, T(2) * dot(flight.velocity, flight.centre), dot(flight.velocity, flight.velocity),
            dot(place, swirl), dot(flight.velocity, swirl), dot(place, side), dot(flight.velocity, side)};
}

/// At the start, E = 0.
template <class T>
inline CircleGap<T> gap_at_start(const CirclePath<T>& path) {
    CircleGap<T> gap;
    gap.value = path.start;
    gap.rate = path.slope - T(2) * path.b0;
    gap.bend = T(2) * (path.speed2 + (path.a0 - T(2) * path.b1));
    gap.jerk = T(2) * (path.b0 + T(3) * path.a1);
    gap.fourth = T(2) * (T(4) * path.b1 - path.a0);
    gap.fifth = T(-2) * (path.b0 + T(5) * path.a1);
    return gap;
}

/// At time τ, `turn` = E(τ).
template <class T>
inline CircleGap<T> gap_along(const CirclePath<T>& path, const T& time, const Vec2<T>& turn) {
    const T cosine = T(1) + turn.x;
    const T a = path.a0 + path.a1 * time;
    const T b = path.b0 + path.b1 * time;
    const T place_along = a * cosine + b * turn.y;             // P·w
    const T place_across = b * cosine - a * turn.y;            // P·(i w)
    const T speed_along = path.a1 * cosine + path.b1 * turn.y;  // V·w
    const T speed_across = path.b1 * cosine - path.a1 * turn.y;
    const T twice = path.speed2 * time;
    CircleGap<T> gap;
    gap.value = (path.start + time * (path.slope + twice)) - T(2) * (a * turn.x + b * turn.y);
    gap.rate = (path.slope + (twice + twice)) - T(2) * ((path.a1 * turn.x + path.b1 * turn.y) + place_across);
    gap.bend = T(2) * (path.speed2 + (place_along - T(2) * speed_across));
    gap.jerk = T(2) * (place_across + T(3) * speed_along);
    gap.fourth = T(2) * (T(4) * speed_across - place_along);
    gap.fifth = T(-2) * (place_across + T(5) * speed_along);
    return gap;
}

/// Where a gap that is closed and opens at the start closes again: the parabola's root, then one Newton step on the
/// Taylor polynomial of fifth order (divided by τ, since g = 0 at the start). Not positive if the parabola has none.
template <class T>
inline T return_guess(const CircleGap<T>& start) {
    const T s = T(-2) * start.rate / start.bend;
    const T s2 = s * s;
    const T cubic = T(1.0 / 6) * start.jerk;
    const T quartic = T(1.0 / 24) * start.fourth * s;
    const T quintic = T(1.0 / 120) * start.fifth * s2;
    const T value = s2 * (cubic + (quartic + quintic));
    const T slope = T(0.5) * start.bend + s * (T(2) * cubic + (T(3) * quartic + T(4) * quintic));
    const T guess = s - value / slope;
    return slope > 0 && guess > T(0.25) * s && guess < T(4) * s ? guess : s;
}

/// The way to the zero of the Taylor polynomial of fifth order: Halley's step, then one of Newton's.
template <class T>
inline T far_correction(const CircleGap<T>& gap) {
    const T d = -(gap.value * gap.rate) / (gap.rate * gap.rate - T(0.5) * gap.value * gap.bend);
    const T d2 = d * d;
    const T half = T(0.5) * gap.bend;
    const T cubic = T(1.0 / 6) * gap.jerk;
    const T quartic = T(1.0 / 24) * gap.fourth;
    const T quintic = T(1.0 / 120) * gap.fifth;
    const T value = (gap.value + gap.rate * d) + d2 * ((half + cubic * d) + d2 * (quartic + quintic * d));
    const T rate = (gap.rate + gap.bend * d) + d2 * ((T(3) * cubic + T(4) * quartic * d) + d2 * (T(5) * quintic));
    return d - value / rate;
}

}  // namespace swirl::detail
