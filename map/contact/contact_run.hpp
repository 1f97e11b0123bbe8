// Contact motion of one kind, integrated until something ends it.
#pragma once

#include "map/contact/reaction.hpp"

#include <cstddef>
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
    static constexpr std::string_view names[] = {"horizon", "release", "slip", "stick",
                                                 "strike",  "lift",    "jam",  "landing"};
    return names[static_cast<std::size_t>(event)];
}

/// What accumulates along a contact.
template <class T>
struct ContactSums {
    T time{};
    T turned{};  ///< ∫ S dt
    T work{};    ///< ∫ f (u_t − 1) dt: change of J by friction (the normal force in contact does not change J)
};

/// The end of a contact motion.
template <class T>
struct ContactEnd {
    ContactEvent event = ContactEvent::horizon;
    ContactState<T> state;
    ContactSums<T> sums;
    bool first_lifts = false;  ///< of an edge: it is the clockwise vertex that lifts
    long steps = 0;            ///< number of power series
};

/// Called with the motion in contact: the sums since its beginning, support, motion, state. In double whatever the
/// number of the motion: samples and spectra are made of it.
using ContactSink =
    std::function<void(const ContactSums<double>&, Support, ContactMotion, const ContactState<double>&)>;

/// Contact ends as cut after so many steps (0.3 s; in 113 bits two minutes): reached by a body that swings ten thousand
/// times within the duration.
inline constexpr long most_contact_steps = 100'000;

/// Integrates one kind of contact motion until an event, at most for `duration` (or `most_steps`: event
/// horizon, with a shorter time).
/// Each step is a power series in time (contact_series.hpp) with last terms below ½ ε. Its coefficients bound the
/// forces on the step, which on most steps proves that it has no event; the others are examined in sixteen parts. An
/// event is located to rounding on the step's polynomial. A disk's pendulum that no event can end takes its whole
/// duration in one closed-form step, unless a sink is given (rim_pendulum.hpp): in double, since no impact follows it.
/// Cost in double: one to three microseconds per step, a few steps per radian of swirl or turn.
///   before  sums of the contact before this motion, which those that the sink is shown go on from
template <class T>
ContactEnd<T> run_contact(const ContactScene<T>& scene, Support support, ContactMotion motion,
                          const ContactState<T>& start, const Plain<T>& duration, const ContactSink& sink = {},
                          long most_steps = most_contact_steps, const ContactSums<T>& before = {});

}  // namespace swirl
