// The first contact of a disk.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/circle_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace detail {

/// Fills in a contact of the disk at the moment that `contact.at` holds.
template <class T>
[[gnu::always_inline]] inline void touch_disk(const Body<T>& body, FirstContact<T>& contact) {
    contact.outcome = FirstContactOutcome::contact;
    contact.arm = (body.alpha / body.inner) * contact.at.centre;
}

/// A time at which the disk's gap is zero, g growing, with the moment of the last look and the gap's series there.
template <class T>
struct DiskRoot {
    TurnedMoment<T> near;
    GapSeries<T> gap;
    SeriesRoot<T> root;
    T time;
};

/// Sought from a guess, without guarantee. False if none is found.
///   steps  counts looks
template <class T>
[[gnu::always_inline]] inline bool seek_disk_root(const CirclePath<T>& path, const T& guess, const T& eleventh,
                                                  int& steps, DiskRoot<T>& found) {
    using std::fabs;
    found.time = guess;
    while (true) {  // ends: converged, or gives up
        if (!(found.time > 0 && found.time <= T(longest_guess)) || ++steps > correction_limit) return false;
        found.near = moment_near(found.time);
        found.gap = series_along(path, found.near);
        found.root = root_of(found.gap);
        const SeriesRoot<T>& root = found.root;
        if (!(root.rate > 0 && fabs(root.first) + fabs(root.second) <= T(longest_correction))) return false;
        found.time = found.near.time + (root.first + root.second);
        if (is_converged(root, found.time, eleventh)) return found.time > 0;
    }
}

/// The disk at the root.
template <class T>
[[gnu::always_inline]] inline void touch_at_root(const Body<T>& body, const Flight<T>& flight, const DiskRoot<T>& found,
                                                 FirstContact<T>& contact) {
    contact.at = instant_at<Shape::disk>(flight, T(found.near.time + found.root.first),
                                         turn_after(found.near, found.root.first));
    advance_slightly(flight, contact.at, found.root.second);
    contact.at.time = found.time;
    touch_disk(body, contact);
}

/// The usual flight from wall to wall: a root is sought without guarantee, then proven to be the first. False if either
/// fails; `sampled_contact_disk` and conservative advancement, below, then decide.
template <class T>
[[gnu::always_inline]] inline bool direct_contact_disk(const Body<T>& body, const Flight<T>& flight,
                                                       FirstContact<T>& contact) {
    const CirclePath<T> path = circle_path_from_wall(body, flight, Vec2<T>(flight.beta * flight.phase));
    const CircleGap<T> start = gap_at_start(path);
    if (!(start.rate < -rate_rounding(body, flight))) return false;  // it may not leave at all
    DiskRoot<T> found;
    const T eleventh = derivative_bounds<11, Shape::disk>(body, flight).centre;
    if (!seek_disk_root(path, return_guess(start), eleventh, contact.steps, found)) return false;
    const T sixth = derivative_bounds<6, Shape::disk>(body, flight).centre;
    if (!clear_between<T>(start, gap_at(found.gap, found.root), found.time, sixth)) return false;
    touch_at_root(body, flight, found, contact);
    return true;
}

/// True if g ≤ 4ε is proven up to the root, in pieces: each begins with all that is left, and is halved until it is
/// proven. False after `most_pieces` looks.
template <class T>
inline bool is_clear_in_pieces(const CirclePath<T>& path, const CircleGap<T>& start, const DiskRoot<T>& found,
                               const T& sixth) {
    const Gap<T> end = gap_at(found.gap, found.root);
    Gap<T> from = start;
    T begin(0);
    T piece = found.time;
    for (int looks = 0; looks < most_pieces; ++looks) {
        const T left = found.time - begin;
        if (piece >= left) {
            if (clear_between(from, end, left, sixth)) return true;
            piece = T(0.5) * left;
        }
        const TurnedMoment<T> middle = moment_near(T(begin + piece));
        if (!(middle.time > begin && middle.time < found.time)) return false;  // a piece below the table's steps
        const GapSeries<T> series = series_along(path, middle);
        const Gap<T> to{series.c[0], series.c[1], T(2) * series.c[2], T(6) * series.c[3]};
        if (clear_between(from, to, T(middle.time - begin), sixth)) {
            from = to;
            begin = middle.time;
            piece = found.time;
        } else {
            piece = T(0.5) * piece;
        }
    }
    return false;
}

/// Long or curved flights, of which the start's derivatives do not tell where they return: the root is sought from a
/// sampled guess and proven to be the first in pieces. No outcome but `contact` is found; conservative advancement then
/// decides. Of a frictionless disk (α = 0.3, β = 0.5) that is one flight in six.
template <class T>
[[gnu::noinline]] FirstContact<T> sampled_contact_disk(const Body<T>& body, const Flight<T>& flight) {
    FirstContact<T> contact;
    if (!flight.struck) return contact;
    const CirclePath<T> path = circle_path_from_wall(body, flight, Vec2<T>(flight.beta * flight.phase));
    const CircleGap<T> start = gap_at_start(path);
    if (!(start.rate < -rate_rounding(body, flight))) return contact;
    DiskRoot<T> found;
    const T eleventh = derivative_bounds<11, Shape::disk>(body, flight).centre;
    if (!seek_disk_root(path, sampled_guess(path), eleventh, contact.steps, found)) return contact;
    const T sixth = derivative_bounds<6, Shape::disk>(body, flight).centre;
    if (is_clear_in_pieces(path, start, found, sixth)) touch_at_root(body, flight, found, contact);
    return contact;
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
