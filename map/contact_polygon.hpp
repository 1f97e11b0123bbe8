// The first contact of a polygon, at a cost that does not grow with its number of vertices.
#pragma once

#include "map/certificate.hpp"
#include "map/circle_path.hpp"
#include "map/contact.hpp"
#include "map/vertices.hpp"

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
};

template <class T>
inline NextStep<T> step_among_vertices(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                                       const Instant<T>& at, const NearestTwo<T>& pair, const T& distance) {
    const T first = safe_step_of(pair.first, bounds.vertex_third);
    const T second = safe_step_of(pair.second, bounds.vertex_third);
    const bool second_binds = second < first;
    const T step = second_binds ? second : first;
    const Gap<T>& gap = second_binds ? pair.second.gap : pair.first.gap;
    const T limit = two_are_enough(body, flight, bounds, distance);
    if (limit < step) return {limit, false};
    return {step, gap.value < 0 && is_last(gap, bounds.vertex_third, step, at.time)};
}

/// Takes a contact that was met from beyond back to its time.
template <class T>
inline void step_back(const Body<T>& body, const Flight<T>& flight, const NearestTwo<T>& pair, Contact<T>& contact) {
    const Candidate<T>& chosen = contact.vertex == pair.first.vertex ? pair.first : pair.second;
    const T back = overshoot(chosen.gap, contact.at.time);
    if (back == 0) return;
    advance<Shape::polygon>(flight, contact.at, T(-back));
    contact.arm = body.turned_to_vertex(contact.at.arm, contact.vertex);
}

/// Advances by safe steps until a vertex touches. Away from the wall the circumscribed circle decides; in the ring
/// 1 − α ≤ |X| where vertices can touch, the two nearest to the centre's direction do.
template <class T>
[[gnu::noinline]] Contact<T> certain_contact_polygon(const Body<T>& body, const Flight<T>& flight) {
    const auto bounds = bounds_of<Shape::polygon>(body, flight);
    const T ring = T(0.25) * (body.outer * body.outer - body.inner * body.inner);
    Contact<T> contact;
    contact.at = instant_at_start(flight);
    NearestTwo<T> pair;
    bool last = false;
    while (contact.steps < step_limit) {  // ends at: contact, proof of none, or the limit
        const Gap<T> circle = centre_gap(body, flight, contact.at);
        const bool starting = flight.struck && contact.steps == 0;
        ++contact.steps;
        NextStep<T> next;
        if (!last && circle.value < 0 && (circle.value < -ring || circle.rate < 0)) {
            const T shelter = sheltered_time(body, flight, contact.at);
            next = {std::max(safe_step(circle, bounds.centre_third), shelter), false};
            if (has_recurred<Shape::polygon>(body, flight, contact.at)) return contact;
        } else {
            look_around(body, flight, contact.at, pair);
            if (starting && stays(body, flight, struck_of(pair).gap)) {
                contact.outcome = ContactOutcome::sustained;
                return contact;
            }
            if (starting) {
                if (const auto* neighbour = touching_neighbour(pair, rate_rounding(body, flight))) {
                    contact.outcome = ContactOutcome::contact;
                    contact.vertex = neighbour->vertex;
                    contact.arm = neighbour->arm;
                    contact.simultaneous = true;
                    return contact;
                }
            } else if (last || touches(pair.first) || touches(pair.second)) {
                choose(pair, contact);
                if (!last) step_back(body, flight, pair, contact);
                return contact;
            }
            const T distance = magnitude(contact.at.centre);
            next = step_among_vertices(body, flight, bounds, contact.at, pair, distance);
            if (has_recurred<Shape::polygon>(body, flight, contact.at)) return contact;
        }
        if (!(next.length < std::numeric_limits<T>::infinity())) return contact;
        last = next.last;
        advance<Shape::polygon>(flight, contact.at, next.length);
    }
    contact.outcome = ContactOutcome::unresolved;
    return contact;
}

/// The two candidates at a moment, when they are known by number.
template <class T>
inline void bring_to(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at, NearestTwo<T>& pair) {
    for (Candidate<T>* candidate : {&pair.first, &pair.second}) {
        candidate->arm = body.turned_to_vertex(at.arm, candidate->vertex);
        candidate->gap = gap_of(body, flight, at, *candidate);
    }
}

/// Both candidates clear of the wall between two moments.
template <class T>
inline bool both_clear(const NearestTwo<T>& from, const NearestTwo<T>& to, const T& h, const T& sixth) {
    return clear_between(from.first.gap, to.first.gap, h, sixth) &&
           clear_between(from.second.gap, to.second.gap, h, sixth);
}

/// Proves that nothing touched between start and end of a flight: leaving the ring and coming back into it the two
/// vertices nearest to the centre's direction are followed, in between the circumscribed circle.
template <class T>
inline bool clear_flight(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                         const Instant<T>& end, const NearestTwo<T>& last) {
    const auto sixth = derivative_bounds<6, Shape::polygon>(body, flight);
    const T reach = two_are_enough(body, flight, bounds, body.inner);
    const Instant<T> start = instant_at_start(flight);
    const Gap<T> leaving = centre_gap(body, flight, start);
    const Gap<T> arriving = centre_gap(body, flight, end);
    if (!(leaving.rate < 0 && arriving.rate > 0)) return false;
    // Twice the time that the circle takes through the ring, to first order.
    const T out = std::max(T(-2) * leaving.value / leaving.rate, T(0));
    const T in = std::max(T(2) * arriving.value / arriving.rate, T(0));
    if (!(out <= reach && in <= reach && out + in < end.time)) return false;

    const Instant<T> outside = instant_at<Shape::polygon>(flight, out);
    Instant<T> inside = end;
    advance<Shape::polygon>(flight, inside, T(-in));
    if (!clear_between(centre_gap(body, flight, outside), centre_gap(body, flight, inside),
                       T(end.time - in - out), sixth.centre))
        return false;

    NearestTwo<T> first;
    look_around(body, flight, start, first);
    if (!(struck_of(first).gap.rate < -rate_rounding(body, flight))) return false;  // it may not leave at all
    NearestTwo<T> first_later = first;
    bring_to(body, flight, outside, first_later);
    if (!both_clear(first, first_later, out, sixth.vertex)) return false;
    NearestTwo<T> last_earlier = last;
    bring_to(body, flight, inside, last_earlier);
    return both_clear(last_earlier, last, in, sixth.vertex);
}

/// The usual flight from wall to wall: the circle's return leads to the vertex nearest to the wall there, its root is
/// sought without care, then the whole flight is proven clear. False if anything fails; the advance then decides.
template <class T>
[[gnu::always_inline]] inline bool direct_contact_polygon(const Body<T>& body, const Flight<T>& flight, Contact<T>& contact) {
    using std::fabs;
    const CirclePath<T> path = circle_path(flight, Vec2<T>(flight.beta * flight.phase), T(0));
    T time = return_guess(gap_at_start(path));
    if (!(time > 0 && time <= T(longest_guess))) return false;
    const TurnedMoment<T> near = moment_near(time);
    const SeriesRoot<T> circle = root_of(series_along(path, near));
    const T closer = circle.first + circle.second;
    if (!(circle.rate > 0 && fabs(closer) <= time)) return false;
    time = near.time + closer;
    if (!(time > 0)) return false;
    Instant<T> at = instant_at<Shape::polygon>(flight, time, turn_after(near, closer));

    NearestTwo<T> pair;
    for (bool converged = false; !converged;) {  // ends: converged, or gives up
        look_at_nearest(body, flight, at, pair.first);
        if (++contact.steps > correction_limit) return false;
        const Gap<T>& gap = pair.first.gap;
        const T correction = householder(gap.value, gap.rate, T(T(0.5) * gap.bend), T(T(1.0 / 6) * gap.jerk));
        if (!(pair.first.gap.rate > 0 && fabs(correction) <= T(longest_correction))) return false;
        converged = is_converged(pair.first.gap, correction);
        advance<Shape::polygon>(flight, at, correction);
    }
    const int striking = pair.first.vertex;
    look_around(body, flight, at, pair);
    if (pair.first.vertex != striking) return false;  // its neighbour is nearer to the wall by now
    pair.first.gap.value = std::min(pair.first.gap.value, T(0));
    if (!(at.time > 0 && clear_flight(body, flight, bounds_of<Shape::polygon>(body, flight), at, pair))) return false;
    contact.at = at;
    choose(pair, contact);
    return true;
}

}  // namespace detail

}  // namespace swirl
