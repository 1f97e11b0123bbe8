// Contact motion of one kind, integrated until something ends it.
#pragma once

#include "map/sustained/reaction.hpp"

#include <functional>
#include <string_view>

namespace swirl {

/// What ends (or begins) a contact.
enum class ContactEvent {
    horizon,  ///< no event within the time asked for
    release,  ///< the normal force fell to zero
    slip,     ///< friction no longer holds: |f| = μλ
    stick,    ///< u_t came to zero (and stays there, or slips back)
    strike,   ///< the neighbouring vertex reached the wall
    lift,     ///< an edge's other vertex left the wall
    jam,      ///< Painlevé: the normal force grew without bound; an impulse at zero normal velocity resolves it
    landing   ///< begins: chatter ended, or an impact without restitution
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
    double work = 0;  ///< ∫ f (u_t − 1) dt: change of J by friction (the normal force in contact does not change J)
};

/// The end of a contact motion.
struct ContactEnd {
    ContactEvent event = ContactEvent::horizon;
    ContactState state;
    ContactSums sums;
    bool first_lifts = false;  ///< of an edge: it is the clockwise vertex that lifts
    long steps = 0;            ///< number of power series
};

/// Called with the motion in contact: the sums since its beginning, support, motion, state.
using ContactSink = std::function<void(const ContactSums&, Support, ContactMotion, const ContactState&)>;

/// Contact ends as cut after so many steps (0.3 s): reached by a body that swings ten thousand times within the
/// duration.
inline constexpr long most_contact_steps = 100'000;

/// Integrates one kind of contact motion until an event, at most for `duration` (or `most_steps`: event
/// horizon, with a shorter time).
/// Each step is a power series in time (contact_series.hpp) with last terms below 10⁻¹⁶. Its coefficients bound the
/// forces on the step, which on most steps proves that it has no event; the others are examined in sixteen parts. An
/// event is located to rounding on the step's polynomial. A disk's pendulum that no event can end takes its whole
/// duration in one closed-form step, unless a sink is given (rim_pendulum.hpp).
/// Cost: one to three microseconds per step, a few steps per radian of swirl or turn.
ContactEnd run_contact(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& start,
                       double duration, const ContactSink& sink = {}, long most_steps = most_contact_steps);

}  // namespace swirl
