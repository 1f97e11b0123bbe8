// The flight over a floor that drags that begins where the normal force has fallen to zero: map/contact/release.hpp.
#pragma once

#include "map/contact/release.hpp"
#include "map/dragged/dragged_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace swirl {

namespace detail {

/// How long what is near the wall at a release certainly does not touch it.
///   slow, rounding  g′ and g″ up to these are zero
template <class T>
T clear_time(const Gap<T>& gap, const T& third, const T& fourth, const T& slow, const T& rounding) {
    using std::fabs;
    const bool at_wall = gap.value > -tolerance<T>(1e-12);
    if (at_wall && fabs(gap.rate) <= slow) return leaving_time(gap, third, fourth, rounding);
    // Half of it: the whole may lead to the wall itself.
    if (at_wall && gap.rate < T(0)) return T(0.5) * safe_step_off_the_wall(gap, third);
    return gap.value < T(0) ? T(T(0.5) * safe_step(gap, third)) : T(0);
}

/// Advances by a time in which nothing can touch; false if no such time makes the gaps larger than rounding.
template <Shape shape, class T>
bool leave_wall(const Body<T>& body, const DraggedFlight<T>& flight, DraggedContact<T>& contact) {
    using std::fabs;
    contact.moment = dragged_instant<shape>(flight, T(0));
    const DraggedBounds<T> bounds = bounds_from<shape>(body, flight, contact.moment);
    const T fourth = fourth_bound<shape>(body, flight), turning = body.alpha * fabs(flight.start.spin);
    const T rounding = tolerance<T>(1e-11) *
                       (std::min(T(1), T(body.beta + turning * fabs(flight.start.spin))) + bounds.drift * bounds.drift);
    const T slow = tolerance<T>(1e-12) * (std::min(T(1), T(body.beta + turning)) + bounds.drift);
    if constexpr (shape == Shape::disk) {
        const T time = leaving_time(centre_gap(body, flight, contact.moment), bounds.centre_third, fourth, rounding);
        if (!(time > T(0))) return false;
        contact.moment = dragged_instant<shape>(flight, time);
        return centre_gap(body, flight, contact.moment).value < T(0);
    } else {
        NearestTwo<T> pair;
        look_around(body, flight, contact.moment, pair);
        T time = two_are_enough(body, bounds, magnitude(contact.moment.at.centre));
        for (const auto* candidate : {&pair.first, &pair.second})
            time = std::min(time, clear_time(candidate->gap, bounds.vertex_third, fourth, slow, rounding));
        if (!(time > T(0))) return false;
        contact.moment = dragged_instant<shape>(flight, time);
        look_around(body, flight, contact.moment, pair);
        return pair.first.gap.value < T(0) && pair.second.gap.value < T(0);
    }
}

}  // namespace detail

/// As `contact_after_release` without drag: a later moment before which a contact is excluded, and the search from
/// there. Empty if no such time makes the gaps larger than rounding.
template <Shape shape, class T>
std::optional<DraggedContact<T>> contact_after_release(const Body<T>& body, const DraggedFlight<T>& flight) {
    DraggedContact<T> contact;
    if (!detail::leave_wall<shape>(body, flight, contact)) return {};
    detail::advance_to_contact<shape>(body, flight, contact);
    return contact;
}

}  // namespace swirl
