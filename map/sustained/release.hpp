// The flight that begins where the normal force has fallen to zero.
#pragma once

#include "map/contact_disk.hpp"
#include "map/contact_polygon.hpp"

#include <optional>
#include <type_traits>

namespace swirl {

namespace detail {

/// A bound of |g⁗| along a flight, of the gap that begins it (see certificate.hpp for the pattern).
template <Shape shape, class T>
inline T fourth_bound(const Body<T>& body, const Flight<T>& flight) {
    using std::fabs;
    const T speed = fabs(flight.velocity.x) + fabs(flight.velocity.y);
    const T place = body.outer + body.beta;
    T bound = T(2) * body.beta * (T(4) * speed + place);
    if constexpr (shape == Shape::polygon) {
        const T s = fabs(flight.spin);
        const T relative = (flight.spin - T(1)) * (flight.spin - T(1));
        bound = bound + T(2) * body.alpha * (s * s * s * (s * place + T(4) * speed) + body.beta * relative * relative);
    }
    return bound;
}

/// How long a gap that is (all but) closed and at rest certainly stays inside: with g = g′ = 0 and g″ < 0 by the advance
/// off the wall; with g″ = 0 too and g‴ < 0 for τ₀ = 2|g‴|/M, |g⁗| ≤ M, where g ≤ τ³(g‴ + Mτ/4)/6 < 0. 0 if neither.
template <class T>
inline T leaving_time(const Gap<T>& gap, const T& third, const T& fourth, const T& rounding) {
    if (gap.bend < -rounding) return safe_step_off_the_wall(Gap<T>{T(0), T(0), gap.bend, gap.jerk}, third);
    return gap.bend <= rounding && gap.jerk < T(0) ? T(T(-2) * gap.jerk / fourth) : T(0);
}

/// Goes on for a time in which nothing can touch; false (and still at the start) if none lifts the gaps out of
/// rounding.
template <Shape shape, class T>
bool leave_wall(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds, Instant<T>& at) {
    using std::fabs;
    const T fourth = fourth_bound<shape>(body, flight);
    const T rounding = T(1e-11) * (T(1) + bounds.drift * bounds.drift);
    const Instant<T> start = at;
    if constexpr (shape == Shape::disk) {
        const T time = leaving_time(centre_gap(body, flight, at), bounds.centre_third, fourth, rounding);
        if (time > T(0)) advance<shape>(flight, at, time);
        if (centre_gap(body, flight, at).value < T(0)) return true;
    } else {
        NearestTwo<T> pair;
        look_around(body, flight, at, pair);
        T time = two_are_enough(body, flight, bounds, magnitude(at.centre));
        for (const auto* candidate : {&pair.first, &pair.second}) {
            const Gap<T>& gap = candidate->gap;
            const bool closed = gap.value > T(-1e-12) && fabs(gap.rate) <= T(1e-12) * (T(1) + bounds.drift);
            time = std::min(time, closed ? leaving_time(gap, bounds.vertex_third, fourth, rounding)
                                         : gap.value < T(0) ? safe_step(gap, bounds.vertex_third) : T(0));
        }
        if (time > T(0)) advance<shape>(flight, at, time);
        look_around(body, flight, at, pair);
        if (pair.first.gap.value < T(0) && pair.second.gap.value < T(0)) return true;
    }
    at = start;
    return false;
}

/// The advance of contact_disk.hpp, from a moment on the way.
template <class T>
void search_on(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds, Contact<T>& contact,
               std::integral_constant<Shape, Shape::disk>) {
    bool last = false;
    while (contact.steps++ < step_limit) {  // ends at: contact, proof of none, or the limit
        const Gap<T> gap = centre_gap(body, flight, contact.at);
        if (last || (gap.value >= 0 && gap.rate >= 0)) {
            if (!last) advance<Shape::disk>(flight, contact.at, T(-overshoot(gap, contact.at.time)));
            return touch_disk(body, contact);
        }
        T step = gap.value < 0 ? safe_step(gap, bounds.centre_third) : safe_step_off_the_wall(gap, bounds.centre_third);
        last = gap.value < 0 && is_last(gap, bounds.centre_third, step, contact.at.time);
        step = std::max(step, sheltered_time(body, flight, contact.at));
        if (!(step < std::numeric_limits<T>::infinity())) return;
        if (has_recurred<Shape::disk>(body, flight, contact.at)) return;
        advance<Shape::disk>(flight, contact.at, step);
    }
    contact.outcome = ContactOutcome::unresolved;
}

/// The advance of contact_polygon.hpp, from a moment on the way.
template <class T>
void search_on(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds, Contact<T>& contact,
               std::integral_constant<Shape, Shape::polygon>) {
    const T ring = T(0.25) * (body.outer * body.outer - body.inner * body.inner);
    NearestTwo<T> pair;
    bool last = false;
    while (contact.steps++ < step_limit) {  // ends at: contact, proof of none, or the limit
        const Gap<T> circle = centre_gap(body, flight, contact.at);
        if (has_recurred<Shape::polygon>(body, flight, contact.at)) return;
        NextStep<T> next;
        if (!last && circle.value < 0 && (circle.value < -ring || circle.rate < 0)) {
            const T shelter = sheltered_time(body, flight, contact.at);
            next = {std::max(safe_step(circle, bounds.centre_third), shelter), false};
        } else {
            look_around(body, flight, contact.at, pair);
            if (last || touches(pair.first) || touches(pair.second)) {
                choose(pair, contact);
                return last ? void() : step_back(body, flight, pair, contact);
            }
            next = step_among_vertices(body, flight, bounds, contact.at, pair, magnitude(contact.at.centre));
        }
        if (!(next.length < std::numeric_limits<T>::infinity())) return;
        last = next.last;
        advance<Shape::polygon>(flight, contact.at, next.length);
    }
    contact.outcome = ContactOutcome::unresolved;
}

}  // namespace detail

/// The first contact of a flight that begins with a release: the gap of what leaves the wall is as small as τ² or τ³
/// and drowns in rounding at first (both vertices of an edge may leave at once). So the search begins where nothing can
/// have touched before, however soon that is: the gap of the vertex (disk) that is released is known from what it has
/// moved, to rounding of its own size. Nothing if no such time lifts the gaps out of rounding.
template <Shape shape, class T>
std::optional<Contact<T>> contact_after_release(const Body<T>& body, const Flight<T>& flight) {
    Contact<T> contact;
    contact.at = instant_at_start(flight);
    const auto bounds = detail::bounds_of<shape>(body, flight);
    if (!detail::leave_wall<shape>(body, flight, bounds, contact.at)) return {};
    detail::search_on(body, flight, bounds, contact, std::integral_constant<Shape, shape>{});
    return contact;
}

}  // namespace swirl
