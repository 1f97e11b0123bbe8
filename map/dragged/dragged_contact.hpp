// The first contact of a flight over a floor that drags: conservative advancement by bounds that fall with the flight,
// at a cost that does not grow with N. map/dragged/README.md, "First contact".
#pragma once

#include "map/dragged/direct_contact.hpp"
#include "map/first_contact/bounds.hpp"
#include "map/first_contact/certain_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

/// As FirstContact, with the flight's velocities at the contact.
template <class T>
struct DraggedContact {
    FirstContact<T> found;  ///< its `at` is the moment's
    DraggedInstant<T> moment;
};

namespace detail {

/// Steps after which a flight is asked whether it ever ends, and then each time after so many: ordinary ones take
/// fewer.
inline constexpr int steps_to_ride = 16;

/// True if no contact follows, proven. From a moment on X + h w goes along a straight line to its end Q, which it comes
/// to at γ > 0, and the body turns by S/γ_r: with l and φ what is left of both, |x| ≤ |Q + a_end| + l + αφ + |h w|.
template <Shape shape, class T>
bool rides(const Body<T>& body, const DraggedFlight<T>& flight, const DraggedInstant<T>& moment) {
    using std::fabs;
    const T &drag = flight.floor.drag, &spin_drag = flight.floor.spin_drag;
    const T circle = magnitude(moment.ridden), stream = magnitude(moment.stream);
    if (stream != T(0) && !(drag > T(0))) return false;
    const Vec2<T> now = moment.at.centre + moment.ridden;
    const T left = stream == T(0) ? T(0) : T(stream / drag);
    const Vec2<T> end = stream == T(0) ? now : now + (T(1) / drag) * moment.stream;
    const T rounding = T(16) * epsilon<T>() * (T(1) + left);
    if (std::max(magnitude(now), magnitude(end)) + circle + rounding < body.inner) return true;
    if constexpr (shape == Shape::polygon) {
        if (moment.spin != T(0) && !(spin_drag > T(0))) return false;
        const T turn = moment.spin == T(0) ? T(0) : T(moment.spin / spin_drag);
        if (!(fabs(turn) < T(1)) || magnitude(end) == T(0)) return false;
        const Vec2<T> arm = turned(moment.at.arm, cis_minus_one(turn));
        Candidate<T> nearest;
        nearest.arm = arm;
        turn_to_nearest(body, end, arm, nearest);
        return magnitude(Vec2<T>(end + nearest.arm)) + left + body.alpha * fabs(turn) + circle + rounding < T(1);
    }
    return false;
}

/// `sheltered_time` over a floor that drags: while X + h w, which goes along a straight line, is within 1 − α − |h|β.
template <class T>
inline T sheltered_time(const Body<T>& body, const DraggedFlight<T>& flight, const DraggedInstant<T>& moment) {
    using std::sqrt;
    const T radius = body.inner - magnitude(moment.ridden);
    if (radius <= 0) return T(0);
    const Vec2<T> place = moment.at.centre + moment.ridden;
    const T depth = dot(place, place) - radius * radius;
    if (depth >= T(-16) * epsilon<T>() * radius) return T(0);
    const T speed2 = dot(moment.stream, moment.stream);
    if (speed2 == 0) return std::numeric_limits<T>::infinity();
    const T outward = dot(place, moment.stream);
    const T root = sqrt(outward * outward - speed2 * depth);
    return time_decayed(flight.floor.drag, outward > 0 ? T(-depth / (outward + root)) : T((root - outward) / speed2));
}

/// The pair of vertices nearest to the centre's direction, at a moment.
template <class T>
inline void look_around(const Body<T>& body, const DraggedFlight<T>& flight, const DraggedInstant<T>& moment,
                        NearestTwo<T>& pair) {
    const Instant<T>& at = moment.at;
    pair.first.arm = body.turned_to_vertex(at.arm, pair.first.vertex);
    turn_to_nearest(body, at.centre, at.arm, pair.first);
    pair.first.gap = vertex_gap(body, flight, moment, pair.first.arm, pair.first.vertex);
    const int side = cross(pair.first.arm, at.centre) >= 0 ? 1 : -1;
    pair.second.vertex = body.vertex_number(pair.first.vertex + side);
    pair.second.arm = body.turned_to_vertex(at.arm, pair.second.vertex);
    pair.second.gap = vertex_gap(body, flight, moment, pair.second.arm, pair.second.vertex);
}

/// As `two_are_enough` without drag.
template <class T>
inline T two_are_enough(const Body<T>& body, const DraggedBounds<T>& bounds, const T& distance) {
    const T turning = T(0.5) * body.spacing / (bounds.spin + T(2) * bounds.drift / distance);
    return std::min(turning, T(distance / (T(2) * bounds.drift)));
}

template <class T>
inline NextStep<T> step_among_vertices(const Body<T>& body, const DraggedBounds<T>& bounds, const Instant<T>& at,
                                       const NearestTwo<T>& pair) {
    const T first = safe_step_of(pair.first, bounds.vertex_third);
    const T second = safe_step_of(pair.second, bounds.vertex_third);
    const T step = std::min(first, second);
    const Gap<T>& gap = (second < first ? pair.second : pair.first).gap;
    const T limit = two_are_enough(body, bounds, magnitude(at.centre));
    if (limit < step) return {limit, false};
    return {step, gap.value < 0 && is_last(gap, bounds.vertex_third, step, at.time)};
}

/// The rounding of g′ at a start on the wall, as `rate_rounding` without drag.
template <class T>
inline T rate_rounding(const Body<T>& body, const DraggedFlight<T>& flight) {
    using std::fabs;
    const T speed = fabs(flight.stream.x) + fabs(flight.stream.y);
    return T(16) * epsilon<T>() * (speed + body.beta + fabs(flight.start.spin) * body.alpha);
}

/// True if what starts on the wall stays there: g′ zero within rounding and g″ ≥ 0, or pressed into it.
template <class T>
inline bool stays(Gap<T>& gap, const T& rounding) {
    if (gap.rate < -rounding) return false;
    if (gap.rate > rounding) return true;
    if (gap.curvature < 0) gap.rate = std::min(gap.rate, T(0));
    return gap.curvature >= 0;
}

/// How a search goes on from a moment.
template <class T>
struct DraggedStep {
    NextStep<T> next;
    bool ended = false;  ///< `found.outcome` says how
};

/// A step of a polygon. Away from the wall the circumscribed circle decides, in the ring 1 − α ≤ |X| the two vertices
/// nearest to the centre's direction.
///   last  this moment is a contact to rounding
template <class T>
DraggedStep<T> step_of_polygon(const Body<T>& body, const DraggedFlight<T>& flight, bool last, NearestTwo<T>& pair,
                               DraggedContact<T>& contact) {
    const DraggedInstant<T>& moment = contact.moment;
    const DraggedBounds<T> bounds = bounds_from<Shape::polygon>(body, flight, moment);
    const T ring = std::max(T(T(0.25) * (body.outer * body.outer - body.inner * body.inner)), T(64) * epsilon<T>());
    const Gap<T> circle = centre_gap(body, flight, moment);
    if (!last && circle.value < 0 && (circle.value < -ring || circle.rate < 0))
        return {{std::max(safe_step(circle, bounds.centre_third), sheltered_time(body, flight, moment)), false}};
    look_around(body, flight, moment, pair);
    if (!last && !touches(pair.first.gap) && !touches(pair.second.gap))
        return {step_among_vertices(body, bounds, moment.at, pair)};
    FirstContact<T>& found = contact.found;
    found.at.time = moment.at.time;
    choose(pair, T(1), found);
    if (!last) {
        const Candidate<T>& chosen = found.vertex == pair.first.vertex ? pair.first : pair.second;
        if (const T back = overshoot(chosen.gap, moment.at.time); back != 0) {
            contact.moment = dragged_instant<Shape::polygon>(flight, T(moment.at.time - back));
            found.arm = body.turned_to_vertex(contact.moment.at.arm, found.vertex);
        }
    }
    return {{}, true};
}

template <class T>
void touch_disk(const Body<T>& body, DraggedContact<T>& contact) {
    contact.found.outcome = FirstContactOutcome::contact;
    contact.found.arm = (body.alpha / body.inner) * contact.moment.at.centre;
}

template <class T>
DraggedStep<T> step_of_disk(const Body<T>& body, const DraggedFlight<T>& flight, bool last,
                            DraggedContact<T>& contact) {
    const DraggedInstant<T>& moment = contact.moment;
    const Gap<T> gap = centre_gap(body, flight, moment);
    if (last || touches(gap)) {
        const T back = last ? T(0) : overshoot(gap, moment.at.time);
        if (back != 0) contact.moment = dragged_instant<Shape::disk>(flight, T(moment.at.time - back));
        touch_disk(body, contact);
        return {{}, true};
    }
    const T third = bounds_from<Shape::disk>(body, flight, moment).centre_third;
    const T step = gap.value < 0 ? safe_step(gap, third) : safe_step_off_the_wall(gap, third);
    const bool ends = gap.value < 0 && is_last(gap, third, step, moment.at.time);
    const T shelter = sheltered_time(body, flight, moment);
    return {shelter > step ? NextStep<T>{shelter, false} : NextStep<T>{step, ends}};
}

/// A step off the wall from the start there, or what keeps the body from it.
template <Shape shape, class T>
DraggedStep<T> step_off_the_wall(const Body<T>& body, const DraggedFlight<T>& flight, NearestTwo<T>& pair,
                                 DraggedContact<T>& contact) {
    const DraggedInstant<T>& moment = contact.moment;
    const T rounding = rate_rounding(body, flight);
    const DraggedBounds<T> bounds = bounds_from<shape>(body, flight, moment);
    FirstContact<T>& found = contact.found;
    if constexpr (shape == Shape::disk) {
        Gap<T> gap = centre_gap(body, flight, moment);
        gap.value = T(0);
        if (stays(gap, rounding)) {
            found.outcome = FirstContactOutcome::sustained;
            return {{}, true};
        }
        return {{safe_step_off_the_wall(gap, bounds.centre_third), false}};
    } else {
        look_around(body, flight, moment, pair);
        if (stays(struck_of(pair).gap, rounding)) {
            found.outcome = FirstContactOutcome::sustained;
            return {{}, true};
        }
        if (const auto* neighbour = touching_neighbour(pair, rounding)) {
            take(*neighbour, found);
            found.simultaneous = true;
            return {{}, true};
        }
        return {step_among_vertices(body, bounds, moment.at, pair)};
    }
}

/// Advances by safe steps from the contact's moment until something touches.
///   off_the_wall  it is the start, on the wall
template <Shape shape, class T>
[[gnu::noinline]] void advance_to_contact(const Body<T>& body, const DraggedFlight<T>& flight,
                                          DraggedContact<T>& contact, bool off_the_wall = false) {
    FirstContact<T>& found = contact.found;
    NearestTwo<T> pair;
    bool last = false;
    for (; found.steps < step_limit; off_the_wall = false) {
        ++found.steps;
        DraggedStep<T> step;
        if (off_the_wall)
            step = step_off_the_wall<shape>(body, flight, pair, contact);
        else if constexpr (shape == Shape::polygon)
            step = step_of_polygon(body, flight, last, pair, contact);
        else
            step = step_of_disk(body, flight, last, contact);
        if (step.ended) return;
        if (!(step.next.length < std::numeric_limits<T>::infinity()) ||
            (found.steps % steps_to_ride == 0 && rides<shape>(body, flight, contact.moment))) {
            found.outcome = step.next.length == step.next.length ? FirstContactOutcome::no_contact
                                                                 : FirstContactOutcome::unresolved;
            return;
        }
        last = step.next.last;
        contact.moment = dragged_instant<shape>(flight, T(contact.moment.at.time + step.next.length));
    }
    found.outcome = FirstContactOutcome::unresolved;
}

}  // namespace detail

/// The first time at which the disk's rim or a vertex reaches the wall from within. Outcomes as of `first_contact`:
/// `no_contact` is proven.
template <Shape shape, class T>
void first_contact(const Body<T>& body, const DraggedFlight<T>& flight, DraggedContact<T>& contact) {
    if (flight.start.struck && !body.short_sides) {
        detail::DraggedRoot<T> root;
        const T rounding = detail::rate_rounding(body, flight);
        bool is_found = false;
        if constexpr (shape == Shape::disk)
            is_found = detail::direct_contact(body, flight, rounding, contact.found, root);
        else
            is_found = detail::direct_contact_of_vertex(body, flight, rounding, contact.found, root);
        if (is_found) {
            contact.moment = root.moment;
            return;
        }
        contact.found = FirstContact<T>{};
    }
    contact.moment = dragged_instant<shape>(flight, T(0));
    detail::advance_to_contact<shape>(body, flight, contact, flight.start.struck);
}

}  // namespace swirl
