// The gap of a vertex that leaves the wall without normal velocity, to its own rounding.
//
// After an impact with e = 0, at a release, or when an edge lifts, a vertex leaves with u_n = 0: its gap is of second
// order in τ, its displacement of first. As a difference of places g is rounding until τ ≈ ε v/g″, which is 10⁴ units
// of time for a body of speed 10⁻²⁰: for so long it seemed to touch, or not to leave. But with r₀ = V + iSa₀ − iw₀, its
// velocity at the start,
//
//     x = x₀ + r₀τ + D,   D = a₀(E(Sτ) − iSτ) − w₀(E(τ) − iτ),   g = 2(u_n τ + x₀·D) + |r₀τ + D|²,
//
// where the terms of first order are gone, and u_n is what it is taken to be at the start: zero within rounding.
#pragma once

#include "map/first_contact/vertices.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::detail {

/// A vertex that is on the wall at the start and does not approach it.
template <class T>
struct Departure {
    bool leaves = false;   ///< without normal velocity
    bool recedes = false;  ///< with one, and not the vertex that struck: its g is rounding, of either sign
    int vertex = 0;
    Vec2<T> place;  ///< x₀, where |x₀| = 1
    Vec2<T> arm;    ///< a₀
    Vec2<T> rate;   ///< r₀
    T normal{};     ///< u_n ≤ 0
    T value{};      ///< g ≤ 0 at the start, zero of the vertex that struck
};

/// Those of the two vertices that may touch at the start.
template <class T>
struct Departures {
    Departure<T> first, second;
};

/// E(φ) − iφ = cis φ − 1 − iφ to a few ε of itself, |φ| ≤ ¼.
template <class T>
inline Vec2<T> turn_beyond_first_order(const T& angle) {
    const T s = angle * angle;
    T cosine(1), sine(1);
    for (int n = 30; n >= 4; n -= 2) {  // |φ|³⁰/30! is below the rounding of every number type
        cosine = T(1) - cosine * (s / T(n * (n - 1)));
        sine = T(1) - sine * (s / T(n * (n + 1)));
    }
    return {T(-0.5) * s * cosine, fraction<T>(-1, 6) * (s * angle) * sine};
}

/// The rounding of a vertex's g, in units of ε: of all that it has moved, and, if it did not begin on the wall as
/// (1, 0), of |x|² or of how far it is from the one that did (`short_side_gap`).
template <class T>
inline T rounded_size(const Body<T>& body, const Flight<T>& flight, const T& time, int vertex) {
    using std::fabs;
    const T speed = fabs(flight.velocity.x) + fabs(flight.velocity.y);
    const T turning = body.beta + body.alpha * fabs(flight.spin);
    const T moved = time * speed + std::min(T(time * turning), T(T(2) * (body.alpha + body.beta)));
    if (flight.struck && vertex == 0) return moved;
    if (!flight.struck || !body.short_sides) return moved + T(1);
    return moved + std::min(T(T(std::min(vertex, body.sides - vertex)) * body.side), T(T(2) * body.alpha));
}

/// Whether a vertex that is on the wall at the start leaves it without normal velocity (else its displacement has the
/// digits of its gap).
///   released  contact has just ended: g″ = 0 within rounding, and an edge's other end may already be moving away
template <class T>
inline Departure<T> departure_of(const Body<T>& body, const Flight<T>& flight, const Instant<T>& start,
                                 const Candidate<T>& vertex, bool released) {
    using std::fabs;
    const T rounding = rate_rounding(body, flight);
    const Gap<T>& gap = vertex.gap;
    Departure<T> departure;
    if (!flight.struck || !(gap.rate <= rounding)) return departure;
    const bool rests = gap.rate >= -rounding;
    if (vertex.vertex == 0)
        departure.leaves = rests;
    else
        departure.leaves = fabs(gap.value) <= T(16) * epsilon<T>() && (released || (rests && gap.curvature < T(0)));
    departure.recedes = vertex.vertex != 0 && !rests && fabs(gap.value) <= T(16) * epsilon<T>();
    departure.vertex = vertex.vertex;
    departure.place = vertex.vertex == 0 ? Vec2<T>{T(1), T(0)} : start.centre + vertex.arm;
    departure.arm = vertex.arm;
    departure.rate = start.drift + flight.spin * quarter_turned(vertex.arm);
    departure.normal = std::min(T(T(0.5) * gap.rate), T(0));
    departure.value = std::min(gap.value, T(0));
    return departure;
}

template <class T>
inline Departures<T> departures_of(const Body<T>& body, const Flight<T>& flight, const Instant<T>& start,
                                   const NearestTwo<T>& pair, bool released) {
    return {departure_of(body, flight, start, pair.first, released),
            departure_of(body, flight, start, pair.second, released)};
}

/// Replaces g and g′ of a vertex that has left, as long as g is below the rounding of what it has moved. Returns the
/// size of the terms that its g is now the sum of.
template <class T>
T gap_of_departure(const Flight<T>& flight, const Departure<T>& from, const Instant<T>& at, Candidate<T>& vertex) {
    using std::fabs;
    const T& time = at.time;
    const T angle = flight.spin * time;
    const Vec2<T> swirl = flight.beta * flight.phase;
    const bool turns_little = fabs(angle) <= T(0.25);
    const Vec2<T> arm_moved = turns_little ? times(from.arm, cis_minus_one(angle)) : vertex.arm - from.arm;
    const Vec2<T> arm_bent =
        turns_little ? times(from.arm, turn_beyond_first_order(angle)) : arm_moved - angle * quarter_turned(from.arm);
    const bool begins = time <= T(0.25);
    const Vec2<T> swirl_moved = begins ? times(swirl, cis_minus_one(time)) : at.swirl - swirl;
    const Vec2<T> swirl_bent =
        begins ? times(swirl, turn_beyond_first_order(time)) : swirl_moved - time * quarter_turned(swirl);
    const Vec2<T> bent = arm_bent - swirl_bent;
    const Vec2<T> faster = quarter_turned(flight.spin * arm_moved - swirl_moved);
    const Vec2<T> moved = time * from.rate + bent;
    vertex.gap.value = from.value + T(2) * (from.normal * time + dot(from.place, bent)) + dot(moved, moved);
    vertex.gap.rate = T(2) * (from.normal + dot(from.place, faster) + dot(moved, from.rate + faster));
    return T(2) * (magnitude(arm_bent) + magnitude(swirl_bent)) + dot(moved, moved);
}

/// The gap of a vertex as it is best known: replaced, if it has left the wall, its g is rounding, and the terms without
/// those of first order are far smaller. Returns the rounding of g in units of ε.
///   receding  also of one that has left at a normal velocity: for long steps, which need g < 0 (ordinary ones off the
///             wall read only g′ and g″)
template <class T>
inline T leave_without_rounding(const Body<T>& body, const Flight<T>& flight, const Departures<T>& departures,
                                const Instant<T>& at, Candidate<T>& vertex, bool receding = false) {
    using std::fabs;
    const T size = rounded_size(body, flight, at.time, vertex.vertex);
    if (!(fabs(vertex.gap.value) <= T(16) * epsilon<T>() * size)) return size;
    for (const auto* departure : {&departures.first, &departures.second}) {
        const bool applies = departure->leaves || (receding && departure->recedes);
        if (!applies || departure->vertex != vertex.vertex) continue;
        Candidate<T> better = vertex;
        const T terms = gap_of_departure(flight, *departure, at, better);
        if (!(T(64) * terms < size)) return size;
        vertex = better;
        return terms;
    }
    return size;
}

}  // namespace swirl::detail
