// The first contact of a polygon, at a cost that does not grow with its number of vertices.
#pragma once

#include "map/contact.hpp"

namespace swirl {

namespace detail {

/// A vertex that may touch next.
template <class T>
struct Candidate {
    int vertex = 0;   ///< number from the reference vertex
    Vec2<T> arm;      ///< a now
    Gap<T> gap;
};

/// The two vertices nearest to the centre's direction.
template <class T>
struct NearestTwo {
    Candidate<T> first;
    Candidate<T> second;
};

/// Turns arm and number by whole vertices until the arm is the nearest one to X: |X × a| ≤ tan(π/N) X·a.
template <class T>
inline void turn_to_nearest(const Body<T>& body, const Vec2<T>& centre, const Vec2<T>& reference, Candidate<T>& c) {
    using std::atan2;
    using std::fabs;
    using std::round;
    if (fabs(cross(c.arm, centre)) <= body.half_slope * dot(c.arm, centre)) return;
    const T angle = atan2(cross(reference, centre), dot(reference, centre));
    c.vertex = body.vertex_number(static_cast<long long>(round(angle / body.spacing)));
    c.arm = times(reference, body.vertex_direction(c.vertex));
}

template <class T>
inline Gap<T> gap_of(const Flight<T>& flight, const Instant<T>& at, const Candidate<T>& candidate) {
    return flight.struck && candidate.vertex == 0 ? struck_gap(flight, at, candidate.arm)
                                                  : vertex_gap(flight, at, candidate.arm);
}

/// Brings the pair up to date at a moment.
template <class T>
inline void look_around(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at, NearestTwo<T>& pair) {
    const Vec2<T> reference = turned(flight.arm, at.body_turn);
    pair.first.arm = pair.first.vertex == 0 ? reference : times(reference, body.vertex_direction(pair.first.vertex));
    turn_to_nearest(body, at.centre, reference, pair.first);
    const int side = cross(pair.first.arm, at.centre) >= 0 ? 1 : -1;
    pair.second.vertex = body.vertex_number(pair.first.vertex + side);
    pair.second.arm = times(reference, body.vertex_direction(pair.second.vertex));
    pair.first.gap = gap_of(flight, at, pair.first);
    pair.second.gap = gap_of(flight, at, pair.second);
}

/// How long the third nearest vertex stays out of it: it is at least 2π/N away from the centre's direction and would
/// have to come within π/N to be first. The direction turns by less than 2|W|/|X| while |X| halves at most.
template <class T>
inline T two_are_enough(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds, const T& distance) {
    using std::fabs;
    const T turning = T(0.5) * body.spacing / (fabs(flight.spin) + T(2) * bounds.drift / distance);
    return std::min(turning, T(distance / (T(2) * bounds.drift)));
}

template <class T>
inline bool touches(const Candidate<T>& candidate, bool starting) {
    return candidate.gap.value >= 0 && candidate.gap.rate >= 0 && !(starting && candidate.vertex == 0);
}

/// Time until an approaching vertex touches, to first order; +∞ for one that does not approach.
template <class T>
inline T time_left(const Gap<T>& gap) {
    return gap.rate > 0 ? T(-gap.value / gap.rate) : std::numeric_limits<T>::infinity();
}

/// Settles which of the two it is: the earlier; on an exact tie the larger u_n, then the lower number.
template <class T>
inline void choose(const NearestTwo<T>& pair, Contact<T>& contact) {
    using std::fabs;
    const T first = time_left(pair.first.gap);
    const T second = time_left(pair.second.gap);
    const T rounding = T(16) * epsilon<T>() * (T(1) + contact.at.time);
    contact.simultaneous = fabs(first - second) <= rounding;
    bool take_second = second < first;
    if (first == second) {
        const T difference = pair.second.gap.rate - pair.first.gap.rate;  // g′ = 2 u_n
        take_second = difference > 0 || (difference == 0 && pair.second.vertex < pair.first.vertex);
    }
    const Candidate<T>& chosen = take_second ? pair.second : pair.first;
    contact.outcome = ContactOutcome::contact;
    contact.vertex = chosen.vertex;
    contact.arm = chosen.arm;
}

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

}  // namespace detail

/// The first time at which a vertex reaches the wall from within. Away from the wall the circumscribed circle decides;
/// in the ring 1 − α ≤ |X| where vertices can touch, the two nearest to the centre's direction do.
template <class T>
Contact<T> first_contact_polygon(const Body<T>& body, const Flight<T>& flight) {
    const auto bounds = detail::bounds_of<Shape::polygon>(body, flight);
    const T ring = T(0.25) * (body.outer * body.outer - body.inner * body.inner);
    Contact<T> contact;
    contact.at = instant_at<Shape::polygon>(flight, T(0));
    detail::NearestTwo<T> pair;
    bool last = false;
    while (contact.steps < detail::step_limit) {  // ends at: contact, proof of none, or the limit
        const Gap<T> circle = centre_gap(body, flight, contact.at);
        const bool starting = flight.struck && contact.steps == 0;
        ++contact.steps;
        detail::NextStep<T> next;
        if (!last && circle.value < 0 && (circle.value < -ring || circle.rate < 0)) {
            const T shelter = detail::sheltered_time(body, flight, contact.at);
            next = {std::max(detail::safe_step(circle, bounds.centre_third), shelter), false};
            if (detail::has_recurred<Shape::polygon>(body, flight, contact.at)) return contact;
        } else {
            detail::look_around(body, flight, contact.at, pair);
            if (starting && detail::stays(body, flight, bounds, pair.first.gap)) {
                contact.outcome = ContactOutcome::sustained;
                return contact;
            }
            if (last || detail::touches(pair.first, starting) || detail::touches(pair.second, starting)) {
                detail::choose(pair, contact);
                return contact;
            }
            const T distance = detail::magnitude(contact.at.centre);
            next = detail::step_among_vertices(body, flight, bounds, contact.at, pair, distance);
            if (detail::has_recurred<Shape::polygon>(body, flight, contact.at)) return contact;
        }
        if (!(next.length < std::numeric_limits<T>::infinity())) return contact;
        last = next.last;
        advance<Shape::polygon>(flight, contact.at, next.length);
    }
    contact.outcome = ContactOutcome::unresolved;
    return contact;
}

template <Shape shape, class T>
inline Contact<T> first_contact(const Body<T>& body, const Flight<T>& flight) {
    if constexpr (shape == Shape::disk)
        return first_contact_disk(body, flight);
    else
        return first_contact_polygon(body, flight);
}

}  // namespace swirl
