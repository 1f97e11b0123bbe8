// The first contact of a polygon, at a cost that does not grow with its number of vertices.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/slow_bodies.hpp"
#include "map/first_contact/vertices.hpp"

#include <algorithm>
#include <limits>

namespace swirl {

namespace detail {

template <class T>
inline T safe_step_of(const Candidate<T>& candidate, const T& third) {
    return candidate.gap.value < 0 ? safe_step(candidate.gap, third) : safe_step_off_the_wall(candidate.gap, third);
}

/// The next step, and whether it ends on a contact to rounding.
template <class T>
struct NextStep {
    T length;
    bool last;
    bool at_wall = false;  ///< the wall is within rounding: no longer step
};

template <class T>
inline NextStep<T> step_among_vertices(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                                       const Instant<T>& at, const NearestTwo<T>& pair, const T& distance) {
    const T first = safe_step_of(pair.first, bounds.vertex_third);
    const T second = safe_step_of(pair.second, bounds.vertex_third);
    const bool second_binds = second < first;
    const T step = second_binds ? second : first;
    const Candidate<T>& binding = second_binds ? pair.second : pair.first;
    const Gap<T>& gap = binding.gap;
    const T limit = two_are_enough(body, flight, bounds, distance);
    if (limit < step) return {limit, false};
    return {step, gap.value < 0 && is_last(gap, bounds.vertex_third, step, at.time)};
}

/// The two vertices against the wall as nearly as the numbers can say.
enum class AtWall { no, near, first, second, both };

/// Which of the two is at the wall and approaches; `near` if one does only when the swirl is left out.
template <class T>
AtWall at_wall(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at, const NearestTwo<T>& pair,
               const T& first_size, const T& second_size) {
    const bool first = is_at_wall(pair.first.gap.value, pair.first.gap.rate, at.time, first_size);
    const bool second = is_at_wall(pair.second.gap.value, pair.second.gap.rate, at.time, second_size);
    if (first || second) return first && second ? AtWall::both : first ? AtWall::first : AtWall::second;
    const T rounding = rate_rounding(body, flight);
    const auto is_near = [&](const Candidate<T>& vertex, const T& size) {
        const Vec2<T> velocity = flight.velocity + flight.spin * quarter_turned(vertex.arm);
        const T free_rate =
            T(2) * dot(at.centre + at.swirl + vertex.arm, velocity);  // of |y|², from the swirl's centre
        return free_rate > rounding && is_at_wall(vertex.gap.value, free_rate, at.time, size);
    };
    return is_near(pair.first, first_size) || is_near(pair.second, second_size) ? AtWall::near : AtWall::no;
}

/// What the gaps of the two are known to ε of, for `choose`.
template <class T>
inline T size_of_two(const Body<T>& body, const Flight<T>& flight, const T& time, const NearestTwo<T>& pair) {
    if (!flight.struck || !body.short_sides) return T(1);
    return std::max(rounded_size(body, flight, time, pair.first.vertex),
                    rounded_size(body, flight, time, pair.second.vertex));
}

/// Sets a contact that was reached from beyond back to its time.
template <class T>
inline void step_back(const Body<T>& body, const Flight<T>& flight, const NearestTwo<T>& pair,
                      FirstContact<T>& contact) {
    const Candidate<T>& chosen = contact.vertex == pair.first.vertex ? pair.first : pair.second;
    const T back = overshoot(chosen.gap, contact.at.time);
    if (back == 0) return;
    advance<Shape::polygon>(flight, contact.at, T(-back));
    contact.arm = body.turned_to_vertex(contact.at.arm, contact.vertex);
}

/// Advances by safe steps until a vertex touches, from a moment on its way, `contact.at`. Away from the wall the
/// circumscribed circle decides; in the ring 1 − α ≤ |X| where vertices can touch, the two nearest to the centre's
/// direction do (and within rounding of the wall, where the circle of a polygon of many sides leaves no room for a
/// step).
template <class T>
void advance_to_contact_polygon(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                                const Departures<T>& departures, FirstContact<T>& contact) {
    const T ring = std::max(T(T(0.25) * (body.outer * body.outer - body.inner * body.inner)), T(64) * epsilon<T>());
    NearestTwo<T> pair;
    bool last = false;
    T stride(0);
    while (contact.steps < step_limit) {  // ends at: contact, proof of none, or the limit
        ++contact.steps;
        const Gap<T> circle = circumcircle_gap(body, flight, contact.at);
        NextStep<T> next;
        if (!last && circle.value < 0 && (circle.value < -ring || circle.rate < 0)) {
            const T shelter = sheltered_time(body, flight, contact.at);
            next = {std::max(safe_step(circle, bounds.centre_third), shelter), false};
        } else {
            look_around(body, flight, contact.at, pair);
            const T first_size = leave_without_rounding(body, flight, departures, contact.at, pair.first);
            const T second_size = leave_without_rounding(body, flight, departures, contact.at, pair.second);
            // Not where the swirl has turned and the vertex recedes: its neighbour, far from the wall, would be taken.
            last = last && std::min(time_left(pair.first.gap), time_left(pair.second.gap)) <= stride + T(0.5);
            if (last || touches(pair.first.gap) || touches(pair.second.gap)) {
                choose(pair, size_of_two(body, flight, contact.at.time, pair), contact);
                if (!last) step_back(body, flight, pair, contact);
                return;
            }
            const AtWall here = contact.steps > ordinary_steps
                                    ? at_wall(body, flight, contact.at, pair, first_size, second_size)
                                    : AtWall::no;
            if (here == AtWall::first) return take(pair.first, contact);
            if (here == AtWall::second) return take(pair.second, contact);
            if (here == AtWall::both) return choose(pair, size_of_two(body, flight, contact.at.time, pair), contact);
            next = step_among_vertices(body, flight, bounds, contact.at, pair, magnitude(contact.at.centre));
            if (here == AtWall::near && step_at_wall < next.length) next = {T(step_at_wall), false, true};
        }
        if (contact.steps > ordinary_steps && !next.at_wall) {
            const T longer = longer_step(body, flight, bounds, departures, contact.at, circle);
            if (longer > next.length) next = {longer, false};
        }
        if (has_recurred<Shape::polygon>(body, flight, contact.at)) return;
        if (!(next.length < std::numeric_limits<T>::infinity())) {
            contact.outcome = without_step(next.length);
            return;
        }
        last = next.last;
        stride = next.length;
        advance<Shape::polygon>(flight, contact.at, next.length);
    }
    contact.outcome = FirstContactOutcome::unresolved;
}

/// From a start on the wall: true if a vertex stays there or touches at once, with the outcome in `contact`; else the
/// first safe step away is taken, and `departures` are those that leave.
template <class T>
bool begins_in_contact(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                       Departures<T>& departures, FirstContact<T>& contact) {
    NearestTwo<T> pair;
    look_around(body, flight, contact.at, pair);
    ++contact.steps;
    if (stays(body, flight, struck_of(pair).gap)) {
        contact.outcome = FirstContactOutcome::sustained;
        return true;
    }
    if (const auto* neighbour = touching_neighbour(pair, rate_rounding(body, flight))) {
        take(*neighbour, contact);
        contact.simultaneous = true;
        return true;
    }
    departures = departures_of(body, flight, contact.at, pair, false);
    const T step = step_among_vertices(body, flight, bounds, contact.at, pair, magnitude(contact.at.centre)).length;
    if (!(step < std::numeric_limits<T>::infinity())) {
        contact.outcome = without_step(step);
        return true;
    }
    advance<Shape::polygon>(flight, contact.at, step);
    return false;
}

/// The first contact of a polygon by conservative advancement alone: slower, and certified at every step.
template <class T>
[[gnu::noinline]] FirstContact<T> certain_contact_polygon(const Body<T>& body, const Flight<T>& flight) {
    const auto bounds = bounds_of<Shape::polygon>(body, flight);
    FirstContact<T> contact;
    contact.at = instant_at_start(flight);
    Departures<T> departures;
    if (flight.struck && begins_in_contact(body, flight, bounds, departures, contact)) return contact;
    advance_to_contact_polygon(body, flight, bounds, departures, contact);
    return contact;
}

}  // namespace detail

}  // namespace swirl
