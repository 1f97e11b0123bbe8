// The first contact of a disk.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/circle_path.hpp"

namespace swirl {

namespace detail {

/// Fills in a contact of the disk at the moment that `contact.at` holds.
template <class T>
[[gnu::always_inline]] inline void touch_disk(const Body<T>& body, FirstContact<T>& contact) {
    contact.outcome = FirstContactOutcome::contact;
    contact.arm = (body.alpha / body.inner) * contact.at.centre;
}

/// The usual flight from wall to wall: a root is sought without guarantee, then proven to be the first. False if either
/// fails; conservative advancement, below, then decides.
template <class T>
[[gnu::always_inline]] inline bool direct_contact_disk(const Body<T>& body, const Flight<T>& flight,
                                                       FirstContact<T>& contact) {
    using std::fabs;
    const CirclePath<T> path = circle_path_from_wall(body, flight, Vec2<T>(flight.beta * flight.phase));
    const CircleGap<T> start = gap_at_start(path);
    if (!(start.rate < -rate_rounding(body, flight))) return false;  // it may not leave at all
    const T eleventh = derivative_bounds<11, Shape::disk>(body, flight).centre;
    T time = return_guess(start);
    while (true) {  // ends: converged, or gives up
        if (!(time > 0 && time <= T(longest_guess)) || ++contact.steps > correction_limit) return false;
        const TurnedMoment<T> near = moment_near(time);
        const GapSeries<T> gap = series_along(path, near);
        const SeriesRoot<T> root = root_of(gap);
        if (!(root.rate > 0 && fabs(root.first) + fabs(root.second) <= T(longest_correction))) return false;
        time = near.time + (root.first + root.second);
        if (!is_converged(root, time, eleventh)) continue;
        const T sixth = derivative_bounds<6, Shape::disk>(body, flight).centre;
        if (!(time > 0 && clear_between<T>(start, gap_at(gap, root), time, sixth))) return false;
        contact.at = instant_at<Shape::disk>(flight, T(near.time + root.first), turn_after(near, root.first));
        advance_slightly(flight, contact.at, root.second);
        contact.at.time = time;
        touch_disk(body, contact);
        return true;
    }
}

/// The rounding of the disk's g, in units of ε: of 2X·moved, as small as the room that the disk has, and of |X|² if it
/// did not begin on the wall.
template <class T>
inline T rounded_size_of_disk(const Body<T>& body, const Flight<T>& flight, const T& time) {
    using std::fabs;
    const T speed = fabs(flight.velocity.x) + fabs(flight.velocity.y);
    const T moved = time * speed + std::min(time, T(2)) * body.beta;
    return body.inner * (flight.struck ? moved : T(body.inner + moved));
}

/// Advances by safe steps until the disk touches, from a moment on its way. `contact.at` is that moment.
template <class T>
void advance_to_contact_disk(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                             FirstContact<T>& contact) {
    bool last = false;
    while (contact.steps < step_limit) {  // ends at: contact, proof of none, or the limit
        ++contact.steps;
        const Gap<T> gap = centre_gap(body, flight, contact.at);
        if (last || touches(gap)) {
            if (!last) advance<Shape::disk>(flight, contact.at, T(-overshoot(gap, contact.at.time)));
            return touch_disk(body, contact);
        }
        T step = gap.value < 0 ? safe_step(gap, bounds.centre_third) : safe_step_off_the_wall(gap, bounds.centre_third);
        last = gap.value < 0 && is_last(gap, bounds.centre_third, step, contact.at.time);
        if (contact.steps > ordinary_steps) {
            const T size = rounded_size_of_disk(body, flight, contact.at.time);
            if (is_at_wall(gap.value, gap.rate, contact.at.time, size)) return touch_disk(body, contact);
            const T free_rate = T(2) * dot(contact.at.centre + contact.at.swirl, flight.velocity);
            if (free_rate > rate_rounding(body, flight) && is_at_wall(gap.value, free_rate, contact.at.time, size))
                step = std::min(step, T(step_at_wall));
        }
        step = std::max(step, sheltered_time(body, flight, contact.at));
        if (!(step < std::numeric_limits<T>::infinity())) {
            contact.outcome = without_step(step);
            return;
        }
        if (has_recurred<Shape::disk>(body, flight, contact.at)) return;
        advance<Shape::disk>(flight, contact.at, step);
    }
    contact.outcome = FirstContactOutcome::unresolved;
}

/// The first contact of a disk by conservative advancement alone: slower, and certified at every step.
template <class T>
[[gnu::noinline]] FirstContact<T> certain_contact_disk(const Body<T>& body, const Flight<T>& flight) {
    const auto bounds = bounds_of<Shape::disk>(body, flight);
    FirstContact<T> contact;
    contact.at = instant_at_start(flight);
    if (flight.struck) {
        Gap<T> gap = centre_gap(body, flight, contact.at);
        ++contact.steps;
        if (stays(body, flight, gap)) {
            contact.outcome = FirstContactOutcome::sustained;
            return contact;
        }
        const T step =
            gap.value < 0 ? safe_step(gap, bounds.centre_third) : safe_step_off_the_wall(gap, bounds.centre_third);
        if (!(step < std::numeric_limits<T>::infinity())) {
            contact.outcome = without_step(step);
            return contact;
        }
        advance<Shape::disk>(flight, contact.at, step);
    }
    advance_to_contact_disk(body, flight, bounds, contact);
    return contact;
}

}  // namespace detail

}  // namespace swirl
