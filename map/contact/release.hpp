// The flight that begins where the normal force has fallen to zero.
#pragma once

#include "map/first_contact/certain_disk.hpp"
#include "map/first_contact/certain_polygon.hpp"
#include "map/first_contact/certificate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace swirl {

namespace detail {

/// A time for which a vertex with g = g′ = 0 (within rounding) is proven to stay inside: if g″ < 0 by the advance off
/// the wall; if g″ ≤ 0 and g‴ < 0 for τ₀ = 2|g‴|/M, |g⁗| ≤ M, where g ≤ τ³(g‴ + Mτ/4)/6 < 0. The longer of the two,
/// since a g″ that is only rounding (magnified by large friction) gives a short one. 0 if neither holds.
template <class T>
inline T leaving_time(const Gap<T>& gap, const T& third, const T& fourth, const T& rounding) {
    T time(0);
    if (gap.curvature < -rounding) time = safe_step_off_the_wall(Gap<T>{T(0), T(0), gap.curvature, gap.jerk}, third);
    if (gap.curvature <= rounding && gap.jerk < T(0)) time = std::max(time, T(T(-2) * gap.jerk / fourth));
    return time;
}

/// Advances by a time in which nothing can touch; false (still at the start) if no such time makes the gaps larger than
/// rounding. `departures` are a polygon's vertices that leave.
template <Shape shape, class T>
bool leave_wall(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds, Departures<T>& departures,
                Instant<T>& at) {
    using std::fabs;
    const T fourth = derivative_bounds<4, shape>(body, flight).vertex;
    // Below the scale of the flight's own accelerations and velocities, however weak the swirl.
    const T turning = body.alpha * fabs(flight.spin);
    const T rounding = tolerance<T>(1e-11) *
                       (std::min(T(1), T(body.beta + turning * fabs(flight.spin))) + bounds.drift * bounds.drift);
    const T slow = tolerance<T>(1e-12) * (std::min(T(1), T(body.beta + turning)) + bounds.drift);
    const Instant<T> start = at;
    if constexpr (shape == Shape::disk) {
        const T time = leaving_time(centre_gap(body, flight, at), bounds.centre_third, fourth, rounding);
        if (time > T(0)) advance<shape>(flight, at, time);
        if (centre_gap(body, flight, at).value < T(0)) return true;
    } else {
        NearestTwo<T> pair;
        look_around(body, flight, at, pair);
        departures = departures_of(body, flight, at, pair, true);
        T time = two_are_enough(body, flight, bounds, magnitude(at.centre));
        for (const auto* candidate : {&pair.first, &pair.second}) {
            const Gap<T>& gap = candidate->gap;
            const bool lifts = (candidate == &pair.first ? departures.first : departures.second).leaves;
            const bool closed = gap.value > -tolerance<T>(1e-12) && fabs(gap.rate) <= slow;
            time =
                std::min(time, closed ? leaving_time(gap, bounds.vertex_third, fourth, rounding)
                               // Half of it: the whole may lead to the wall itself.
                               : lifts && gap.rate < T(0) ? T(T(0.5) * safe_step_off_the_wall(gap, bounds.vertex_third))
                               : gap.value < T(0)         ? T(T(0.5) * safe_step(gap, bounds.vertex_third))
                                                          : T(0));
        }
        if (time > T(0)) advance<shape>(flight, at, time);
        look_around(body, flight, at, pair);
        leave_without_rounding(body, flight, departures, at, pair.first);
        leave_without_rounding(body, flight, departures, at, pair.second);
        if (pair.first.gap.value < T(0) && pair.second.gap.value < T(0)) return true;
    }
    at = start;
    return false;
}

}  // namespace detail

/// The first contact of a flight that begins with a release: the gap of what leaves the wall is O(τ²) or O(τ³) and at
/// first below rounding (both vertices of an edge may leave at once). So the search begins at a later moment before
/// which a contact is excluded, however short that time is: the gap of the released vertex (disk) is computed from its
/// displacement, to relative rounding. Empty if no such time makes the gaps larger than rounding.
template <Shape shape, class T>
std::optional<FirstContact<T>> contact_after_release(const Body<T>& body, const Flight<T>& flight) {
    FirstContact<T> contact;
    contact.at = instant_at_start(flight);
    const auto bounds = detail::bounds_of<shape>(body, flight);
    detail::Departures<T> departures;
    if (!detail::leave_wall<shape>(body, flight, bounds, departures, contact.at)) return {};
    if constexpr (shape == Shape::disk)
        detail::advance_to_contact_disk(body, flight, bounds, contact);
    else
        detail::advance_to_contact_polygon(body, flight, bounds, departures, contact);
    return contact;
}

}  // namespace swirl
