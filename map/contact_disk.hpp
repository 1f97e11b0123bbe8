// The first contact of a disk.
#pragma once

#include "map/contact.hpp"

namespace swirl {

/// The first time at which |X| reaches 1 − α from below. Cost: some four moments, one rotation each.
template <class T>
Contact<T> first_contact_disk(const Body<T>& body, const Flight<T>& flight) {
    const auto bounds = detail::bounds_of<Shape::disk>(body, flight);
    Contact<T> contact;
    contact.at = instant_at<Shape::disk>(flight, T(0));
    bool last = false;
    while (contact.steps < detail::step_limit) {  // ends at: contact, proof of none, or the limit
        Gap<T> gap = centre_gap(body, flight, contact.at);
        const bool starting = flight.struck && contact.steps == 0;
        ++contact.steps;
        if (starting && detail::stays(body, flight, bounds, gap)) {
            contact.outcome = ContactOutcome::sustained;
            return contact;
        }
        if (last || (!starting && gap.value >= 0 && gap.rate >= 0)) {
            contact.outcome = ContactOutcome::contact;
            contact.arm = (body.alpha / detail::magnitude(contact.at.centre)) * contact.at.centre;
            return contact;
        }
        T step = gap.value < 0 ? detail::safe_step(gap, bounds.centre_third)
                               : detail::safe_step_off_the_wall(gap, bounds.centre_third);
        last = gap.value < 0 && detail::is_last(gap, bounds.centre_third, step, contact.at.time);
        step = std::max(step, detail::sheltered_time(body, flight, contact.at));
        if (!(step < std::numeric_limits<T>::infinity())) return contact;
        if (detail::has_recurred<Shape::disk>(body, flight, contact.at)) return contact;
        advance<Shape::disk>(flight, contact.at, step);
    }
    contact.outcome = ContactOutcome::unresolved;
    return contact;
}

}  // namespace swirl
