// The first contact of a flight, certified: no root is passed, however close to another or to a double root.
// Derivation of the bounds, and of why two vertices are enough for every N: map/README.md, "First contact".
#pragma once

#include "map/first_contact/certificate.hpp"
#include "map/first_contact/conservative_advancement.hpp"
#include "map/model/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

enum class FirstContactOutcome {
    contact,     ///< found
    no_contact,  ///< proven that there will be none
    sustained,   ///< the vertex that began the flight does not leave the wall: g = 0, g′ = 0, g″ ≥ 0
    unresolved   ///< the step limit was reached first (a slow body that the moving wall passes closely many times)
};

/// A contact: when, which vertex (counted from the reference vertex), and everything known of that moment.
template <class T>
struct FirstContact {
    FirstContactOutcome outcome = FirstContactOutcome::no_contact;
    Instant<T> at;
    Vec2<T> arm;                ///< a of the vertex that touches (disk: along the contact's normal)
    int vertex = 0;             ///< its number from the reference vertex, 0 … N − 1; the disk has one, 0
    bool simultaneous = false;  ///< another vertex touches within rounding of the same time
    int steps = 0;              ///< moments at which the flight was evaluated
};

namespace detail {

/// Flights are given up as unresolved after so many steps; ordinary ones take fewer than 20.
inline constexpr int step_limit = 1'000'000;

/// Bounds that hold along a whole flight, while nothing is outside.
template <class T>
struct FlightBounds {
    T speed;         ///< |V|
    T drift;         ///< |W| ≤ |V| + β
    T centre_third;  ///< |g‴| of the centre's gap
    T vertex_third;  ///< |g‴| of any vertex
};

template <class T>
inline T magnitude(const Vec2<T>& v) {
    using std::sqrt;
    return sqrt(dot(v, v));
}

template <Shape shape, class T>
inline FlightBounds<T> bounds_of(const Body<T>& body, const Flight<T>& flight) {
    FlightBounds<T> bounds;
    bounds.speed = magnitude(flight.velocity);
    bounds.drift = bounds.speed + body.beta;
    bounds.centre_third = centre_third(body, bounds.drift);
    bounds.vertex_third = bounds.centre_third;
    if constexpr (shape == Shape::polygon) bounds.vertex_third = vertex_third(body, flight, bounds.drift);
    return bounds;
}

/// The outcome where the safe step is not finite: +∞ proves that no contact follows; NaN (an overflow) leaves the
/// search unresolved.
template <class T>
inline FirstContactOutcome without_step(const T& step) {
    return step > T(0) ? FirstContactOutcome::no_contact : FirstContactOutcome::unresolved;
}

/// True once the error that a last step leaves, M h³/g′, is far below the rounding of τ, M h³ itself below that of a
/// place, and g′ is still positive after it. (After a flight so long that τ's rounding is no small part of a turn the
/// first alone is not enough.) The step must lead to a root of the gap's own parabola, within rounding: one that a
/// bound from far away has shortened ends before the wall, where the vertex may yet turn away.
template <class T>
inline bool is_last(const Gap<T>& gap, const T& third, const T& step, const T& time) {
    using std::fabs;
    const T change = third * step * step;
    const T moves = std::min(T(gap.rate * (time + step)), T(1000));
    const T left = -gap.value - step * (gap.rate + T(0.5) * step * gap.curvature);
    return gap.rate > 0 && change * step <= T(0.001) * epsilon<T>() * moves &&
           gap.rate + step * std::min(gap.curvature, T(0)) > T(0.5) * change &&
           left <= change * step + T(16) * epsilon<T>() * fabs(gap.value);
}

/// Steps after which bounds that are seldom of use are tried as well. Ordinary flights take fewer than 20.
inline constexpr int ordinary_steps = 200;

/// True if what moves outward at `rate` is at the wall as nearly as the numbers can say: the way left is within the
/// rounding of g, or the time to it within τ's. So slow a body is within rounding of the wall for longer than the swirl
/// takes to turn. (The second alone is not enough: a fast spin moves a vertex far within τ's rounding, but steps as
/// short as that lead it on.)
///   size  of what g is the difference of: its rounding in units of ε
template <class T>
inline bool is_at_wall(const T& gap, const T& rate, const T& time, const T& size) {
    using std::fabs;
    const T steady = T(4) * epsilon<T>() * std::max(size, T(time * rate));
    return rate > 0 && fabs(gap) <= std::min(steady, T(T(16) * epsilon<T>() * size));
}

/// A step where the wall is at hand when the swirl is left out: it strikes in that part of the swirl's turn in which it
/// approaches, so no longer than a part of that turn.
inline constexpr double step_at_wall = 0.5;

/// The time by which a moment lies beyond its contact, g/g′ where rounding left g > 0: the search goes back by it.
/// Otherwise contacts reached from beyond would be late and those reached from before exact, a bias that accumulates in
/// J. Not where g′ would change its sign on the way: then rounding had g > 0 before it approached, and further back it
/// recedes.
template <class T>
inline T overshoot(const Gap<T>& gap, const T& time) {
    if (!(gap.value > 0 && gap.rate > 0)) return T(0);
    using std::sqrt;
    T back = gap.value / gap.rate;
    // Just before the top of a double root g′ is rounding, too, and the tangent would lead back too far: the parabola.
    const T curved = T(-2) * gap.curvature * gap.value;
    if (curved > T(0x1p-10) * (gap.rate * gap.rate))
        back = T(2) * gap.value / (gap.rate + sqrt(gap.rate * gap.rate + curved));
    back = std::min(back, time);
    return back * gap.curvature < gap.rate ? back : T(0);
}

/// True if a vertex (disk) is at the wall and does not leave it. (One that began the flight with u_n = 0 and g″ < 0
/// leaves, though g and g′ stay zero within rounding for a while.)
template <class T>
inline bool touches(const Gap<T>& gap) {
    return gap.value >= 0 && (gap.rate > 0 || (gap.rate == 0 && gap.curvature >= 0));
}

/// Time until an approaching vertex touches, to first order; 0 for one that touches without approaching, +∞ for the
/// others.
template <class T>
inline T time_left(const Gap<T>& gap) {
    if (gap.rate > 0) return T(-gap.value / gap.rate);
    return touches(gap) ? T(0) : std::numeric_limits<T>::infinity();
}

/// A difference of squares below this share of either has lost half of a double's digits.
inline constexpr double few_digits_left = 0x1p-26;

/// How long the centre of a disk that began on the wall stays sheltered (below), where the difference of squares would
/// be rounding alone. As X₀ = (ρ, 0) with ρ = 1 − α, |P|² − (ρ − β)² = 2ρ(β + w₀ₓ) + 2τ P₀·V + τ²|V|², each term of
/// which is exact to its own rounding.
template <class T>
inline T sheltered_time_near_start(const Body<T>& body, const Flight<T>& flight, const T& time) {
    using std::sqrt;
    const Vec2<T> swirl = flight.beta * flight.phase;
    const T start = T(2) * body.inner * (body.beta + swirl.x);
    const T outward = dot(flight.centre + swirl, flight.velocity);
    const T speed2 = dot(flight.velocity, flight.velocity);
    if (!(start + time * (T(2) * outward + time * speed2) < 0)) return T(0);
    // D < 0 only between its roots: outward < 0, and this is the later one.
    return (sqrt(outward * outward - speed2 * start) - outward) / speed2 - time;
}

/// While the centre is within 1 − α − β of the swirl's centre nothing can touch wherever the container is: how long it
/// stays there (0 if it is not there; +∞ if it never leaves).
template <class T>
inline T sheltered_time(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at) {
    using std::sqrt;
    const T radius = body.inner - body.beta;
    if (radius <= 0) return T(0);
    const Vec2<T> place = at.centre + at.swirl;
    const T depth = dot(place, place) - radius * radius;
    if (body.sides != disk_sides) {
        if (depth >= T(-16) * epsilon<T>() * radius) return T(0);  // the rounding of |P|
    } else if (flight.struck && depth >= T(-few_digits_left) * (radius * radius)) {
        return sheltered_time_near_start(body, flight, at.time);
    }
    if (depth >= 0) return T(0);
    const T speed2 = dot(flight.velocity, flight.velocity);
    if (speed2 == 0) return std::numeric_limits<T>::infinity();
    const T outward = dot(place, flight.velocity);
    const T root = sqrt(outward * outward - speed2 * depth);
    return outward > 0 ? T(-depth / (outward + root)) : T((root - outward) / speed2);
}

/// Recurrence for a centre at rest: gaps are then periodic in time if orientation and swirl are commensurate, and a
/// whole period without contact proves that none follows. The period is one turn of the swirl for a disk, q turns for a
/// polygon if qSN is an integer (q ≤ 64 are tried; otherwise orientation and phase come arbitrarily close to every pair
/// of values), and 1/N turn of the body if β = 0.
template <Shape shape, class T>
inline bool has_recurred(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at) {
    using std::fabs;
    using std::floor;
    if (dot(flight.velocity, flight.velocity) != 0) return false;
    const T turn = T(2 * pi<T>());
    if (shape == Shape::disk) return at.time > turn;
    const T symmetry = T(body.sides);
    if (body.beta == 0) return fabs(flight.spin) * symmetry * at.time > turn;
    for (int q = 1; q <= 64 && at.time > T(q) * turn; ++q) {
        const T turns = T(q) * flight.spin * symmetry;
        if (floor(turns) == turns) return true;
    }
    return false;
}

/// True if a vertex that starts on the wall stays there: normal velocity zero within rounding, and g″ ≥ 0.
template <class T>
inline bool stays(const Body<T>& body, const Flight<T>& flight, Gap<T>& gap) {
    const T rounding = rate_rounding(body, flight);
    if (gap.rate < -rounding) return false;
    if (gap.rate > rounding) return true;  // pressed into the wall: no flight begins here
    if (gap.curvature < 0) gap.rate = std::min(gap.rate, T(0));
    return gap.curvature >= 0;
}

}  // namespace detail

}  // namespace swirl
