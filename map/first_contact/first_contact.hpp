// The first contact of any flight: the direct search for the usual one from wall to wall, two more for those that keep
// near the wall or strike again before the direct search expects it, conservative advancement for the others.
#pragma once

#include "map/first_contact/certain_disk.hpp"
#include "map/first_contact/certain_polygon.hpp"
#include "map/first_contact/direct_polygon.hpp"

namespace swirl {

namespace detail {

/// True if the direct search found a contact and proved it the first; polygons of short sides have one of their own.
/// `contact` is local to the caller and nothing takes its address, so that it stays in registers.
template <Shape shape, class T>
[[gnu::always_inline]] inline bool direct_contact(const Body<T>& body, const Flight<T>& flight,
                                                  FirstContact<T>& contact) {
    if (!flight.struck) return false;
    if constexpr (shape == Shape::disk) {
        return direct_contact_disk(body, flight, contact);
    } else {
        if (body.short_sides) [[unlikely]]
            return false;
        return direct_contact_polygon<Sides::not_short>(body, flight, contact);
    }
}

template <Shape shape, class T>
inline FirstContact<T> certain_contact(const Body<T>& body, const Flight<T>& flight) {
    if constexpr (shape == Shape::disk)
        return certain_contact_disk(body, flight);
    else
        return certain_contact_polygon(body, flight);
}

/// Of a flight that no search from the circle's return decides.
template <Shape shape, class T>
inline FirstContact<T> contact_without_return(const Body<T>& body, const Flight<T>& flight) {
    const auto found = [&] {
        if constexpr (shape == Shape::polygon)
            return contact_of_next_vertex(body, flight);
        else
            return sampled_contact_disk(body, flight);
    }();
    return found.outcome == FirstContactOutcome::contact ? found : certain_contact<shape>(body, flight);
}

/// Of a flight that `direct_contact` does not decide.
template <Shape shape, class T>
inline FirstContact<T> undecided_contact(const Body<T>& body, const Flight<T>& flight) {
    if constexpr (shape == Shape::polygon) {
        if (flight.struck && body.short_sides)
            if (const auto usual = direct_contact_of_short_sides(body, flight);
                usual.outcome == FirstContactOutcome::contact)
                return usual;
        if (const auto behind = contact_of_vertex_behind(body, flight); behind.outcome == FirstContactOutcome::contact)
            return behind;
    }
    return contact_without_return<shape>(body, flight);
}

}  // namespace detail

/// The first time at which the disk's rim or a vertex reaches the wall from within.
template <Shape shape, class T>
FirstContact<T> first_contact(const Body<T>& body, const Flight<T>& flight) {
    FirstContact<T> contact;
    if (detail::direct_contact<shape>(body, flight, contact)) return contact;
    return detail::undecided_contact<shape>(body, flight);
}

}  // namespace swirl
