// Contact motion of one kind, integrated until something ends it.
#pragma once

#include "map/sustained/reaction.hpp"

#include <functional>
#include <string_view>

namespace swirl {

/// What ends (or begins) a contact.
enum class ContactEvent {
    horizon,  ///< nothing did: the time that was asked for is over
    release,  ///< the normal force fell to zero
    slip,     ///< friction no longer held
    stick,    ///< u_t came to zero (and stays there, or slips back)
    strike,   ///< the neighbouring vertex reached the wall
    lift,     ///< an edge's other vertex left the wall
    jam,      ///< Painlevé: the normal force grew without bound; an impulse without approach resolves it
    landing   ///< begins: chatter came to its end, or an impact without restitution
};

inline std::string_view name_of(ContactEvent event) {
    switch (event) {
        case ContactEvent::horizon:
            return "horizon";
        case ContactEvent::release:
            return "release";
        case ContactEvent::slip:
            return "slip";
        case ContactEvent::stick:
            return "stick";
        case ContactEvent::strike:
            return "strike";
        case ContactEvent::lift:
            return "lift";
        case ContactEvent::jam:
            return "jam";
        case ContactEvent::landing:
            return "landing";
    }
    return "";
}

/// What accumulates along a contact.
struct ContactSums {
    double time = 0;
    double turned = 0;  ///< ∫ S dt
    double work = 0;  ///< ∫ f (u_t − 1) dt: what friction adds to J (in contact the wall's normal force adds nothing)
};

/// Where a contact motion stands at its end.
struct ContactEnd {
    ContactEvent event = ContactEvent::horizon;
    ContactState state;
    ContactSums sums;
    bool first_lifts = false;  ///< of an edge: it is the clockwise vertex that lifts
    long steps = 0;            ///< power series that it took
};

/// Looks at a contact on its way: what accumulated since its beginning, support, motion, state.
using ContactSink = std::function<void(const ContactSums&, Support, ContactMotion, const ContactState&)>;

/// Contact motion of one kind is given up after so many steps (some seconds): a body that swings so fast against
/// the swirl's turn that the duration holds millions of swings.
inline constexpr long most_contact_steps = 1'000'000;

/// Integrates one kind of contact motion until an event, at most for `duration` (or `most_contact_steps`: event
/// horizon, with a shorter time).
/// Each step is a power series in time (contact_series.hpp) with last terms below 10⁻¹⁶. Its coefficients bound what
/// the forces do on the step, which mostly proves that no event is in it; if not it is looked at in sixteen parts. An
/// event is located to rounding on the step's polynomial.
/// A disk's pendulum that nothing can end, of which no sink wants to see more, takes its whole duration at once
/// (rim_pendulum.hpp).
/// Cost: one to three microseconds per step, a few steps per radian of swirl or turn.
ContactEnd run_contact(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& start,
                       double duration, const ContactSink& sink = {});

}  // namespace swirl
