// Longer safe steps for flights on which ordinary ones are many: a body that is slow against the swirl, one that spins
// fast against its own approach, one that all but fills the container.
//
// Ordinary steps are limited by g‴, to which the swirl contributes β however slow the body is: a flight of 10¹² units
// of time would take as many steps. But seen from the swirl's centre the body moves freely. A vertex at
// y = x + w has |y| ≤ |x| + β, so that nothing touches while
//
//     G = |y|² − (1 − β)² = g + 2(β + x·w)   is negative,   G′ = 2 y·y′,  y′ = V + iSa,
//     |G‴| = |2(P·a)‴| ≤ 2α S²(3|V| + |S||P|),               P = X + w the body's centre,
//
// in which the swirl's own motion does not occur. The two vertices nearest to the direction of P are the farthest from
// the swirl's centre, whatever N is. For a disk (and a polygon's circumscribed circle) the same bound is
// `sheltered_time`. Once G ≥ 0 the wall reaches the vertex within a turn of the swirl, or the vertex turns away.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/conservative_advancement.hpp"
#include "map/first_contact/departure.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::detail {

/// The time for which G < 0 of one vertex; 0 if it is not negative now.
template <class T>
inline T sheltered_time_of(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at,
                           const Candidate<T>& vertex) {
    using std::fabs;
    const Vec2<T> x = at.centre + vertex.arm;
    const Vec2<T> y = x + at.swirl;
    const Vec2<T> rate = flight.velocity + flight.spin * quarter_turned(vertex.arm);
    const T spin2 = flight.spin * flight.spin;
    // G and G′ from g and g′, which of a vertex that leaves slowly are known to their own rounding. What is added to g′
    // has that of β: for a slower vertex the product is known better.
    const T slow_rate = T(2) * dot(y, rate);
    const T rate_by_gap = vertex.gap.rate + T(2) * (dot(rate, at.swirl) + dot(x, quarter_turned(at.swirl)));
    const bool is_slower = dot(rate, rate) < body.beta * body.beta;
    const Gap<T> gap{vertex.gap.value + T(2) * (body.beta + dot(x, at.swirl)), is_slower ? slow_rate : rate_by_gap,
                     T(2) * (dot(rate, rate) - spin2 * dot(y, vertex.arm)), T(0)};
    if (!(gap.value < 0)) return T(0);
    const T third =
        T(2) * body.alpha * spin2 * (T(3) * magnitude(flight.velocity) + fabs(flight.spin) * (body.outer + body.beta));
    return safe_step(gap, third);
}

/// The time for which no vertex can touch because the container does not come so far; 0 if that is not so.
template <class T>
T sheltered_time_of_vertices(const Body<T>& body, const Flight<T>& flight, const Departures<T>& departures,
                             const Instant<T>& at) {
    using std::fabs;
    const Vec2<T> place = at.centre + at.swirl;
    const T distance = magnitude(place);
    const T speed = magnitude(flight.velocity);
    if (!(distance > T(0) && body.beta < T(1))) return T(0);
    NearestTwo<T> pair;
    look_around(body, flight, at, place, pair);
    leave_without_rounding(body, flight, departures, at, pair.first, true);
    leave_without_rounding(body, flight, departures, at, pair.second, true);
    // As `two_are_enough`, about the swirl's centre.
    const T turning = T(0.5) * body.spacing / (fabs(flight.spin) + T(2) * speed / distance);
    const T enough = std::min(turning, T(distance / (T(2) * speed)));
    return std::min(
        {enough, sheltered_time_of(body, flight, at, pair.first), sheltered_time_of(body, flight, at, pair.second)});
}

/// The largest h with h (b + a h) ≤ c, for a, b, c ≥ 0.
template <class T>
inline T largest_with(const T& a, const T& b, const T& c) {
    using std::sqrt;
    return T(2) * c / (b + sqrt(b * b + T(4) * a * c));
}

/// A safe step by the velocity in the container that the body has now, |W(h)| ≤ |W| + βh, instead of |V| + β: a body
/// with little room moves along with the container, and its |W| is smaller by many orders of magnitude. Of the
/// direction of X, which turns by less than 2|W|/|X| while |X| at most halves, and of |g‴|.
template <class T>
T step_by_velocity_now(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                       const Departures<T>& departures, const Instant<T>& at) {
    using std::fabs;
    const T distance = magnitude(at.centre);
    if (!(distance > T(0))) return T(0);
    NearestTwo<T> pair;
    look_around(body, flight, at, pair);
    leave_without_rounding(body, flight, departures, at, pair.first, true);
    leave_without_rounding(body, flight, departures, at, pair.second, true);
    if (touches(pair.first.gap) || touches(pair.second.gap)) return T(0);
    const T drift = magnitude(at.drift) + T(8) * epsilon<T>() * bounds.drift;
    const T per_distance = T(2) / distance;
    const T turns = largest_with(T(per_distance * body.beta), T(fabs(flight.spin) + per_distance * drift),
                                 T(T(0.5) * body.spacing));
    const T limit = std::min(turns, largest_with(body.beta, drift, T(T(0.5) * distance)));
    const T third = vertex_third(body, flight, T(drift + body.beta * limit));
    const auto step_of = [&](const Gap<T>& gap) {
        return gap.value < 0 ? safe_step(gap, third) : safe_step_off_the_wall(gap, third);
    };
    return std::min({limit, step_of(pair.first.gap), step_of(pair.second.gap)});
}

/// The longest of the safe steps beside the ordinary one: the circumscribed circle's wherever it is inside, the one by
/// the velocity now, and the one from the swirl's centre.
template <class T>
[[gnu::noinline]] T longer_step(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                                const Departures<T>& departures, const Instant<T>& at, const Gap<T>& circle) {
    const bool inside = circle.value < T(-16) * epsilon<T>() * body.inner;  // beyond the rounding of |X|
    const T round = inside ? safe_step(circle, bounds.centre_third) : T(0);
    return std::max({round, step_by_velocity_now(body, flight, bounds, departures, at),
                     sheltered_time(body, flight, at), sheltered_time_of_vertices(body, flight, departures, at)});
}

}  // namespace swirl::detail
