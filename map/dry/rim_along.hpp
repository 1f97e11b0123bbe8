// A disk's contact over a floor with dry friction, known in double, once more in Jets: the derivative of its end.
// map/dry/README.md, "Derivative".
#pragma once

#include "map/contact/contact_jets.hpp"
#include "map/dry/rim_contact.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace swirl {

namespace detail {

/// The number of a scene's contact in several kinds of number.
template <class J>
struct RimInJets {
    const RimScene<double>& plain;
    const RimScene<J>& scene;
    const RimScene<ContactJet<1>>& in_time;  ///< carries no derivatives of its own
};

inline std::size_t condition_of(const RimScene<double>& scene, const RimMotion& motion, double spin,
                                ContactEvent event) {
    if (event == ContactEvent::release) return 0;
    return event == ContactEvent::stick && goes_in_line(scene, motion, spin) ? 2 : 1;
}

/// d/dτ of what ends a motion.
inline double rate_of_condition(const RimScene<ContactJet<1>>& scene, const RimMotion& motion,
                                const RimPlace<double>& y, const RimPlace<double>& rate, std::size_t which) {
    RimPlace<ContactJet<1>> moving;
    for (std::size_t i = 0; i < y.size(); ++i) {
        moving[i] = ContactJet<1>(y[i]);
        moving[i].v[0] = rate[i];
    }
    return rim_condition(scene, motion, contact_of(moving), which).v[0];
}

template <class J>
ContactState<J> piece_along(const RimInJets<J>& rim, const ContactSegment& piece, ContactState<J> z) {
    z.psi.a = piece.from.psi;
    z.ut.a = piece.from.ut;
    z.spin.a = piece.from.spin;
    RimMotion motion = rim_motion_at(rim.plain, piece.motion, piece.from);
    if (motion.rolls()) z.ut = J(0);
    const double duration = piece.end - piece.start;
    RimCourse course(rim.plain, motion, piece.from);
    const double creeps = course.station().time;
    if (creeps > 0) {  // from rest: its state depends on psi alone, known to √ε
        constexpr double apart = 1e-6;
        const Creep after = creep_from_rest(rim.plain, motion, piece.from.psi + apart, creeps);
        const Creep before = creep_from_rest(rim.plain, motion, piece.from.psi - apart, creeps);
        const RimPlace<double>& y = course.station().y;
        z.psi.a = y[0];
        z.ut = J(y[1]) + J((after.ut - before.ut) / (2 * apart)) * (z.psi - J(y[0]));
        z.spin = J(y[2]) + J((after.spin - before.spin) / (2 * apart)) * (z.psi - J(y[0]));
    }
    RimStation<J> at = rim_station(rim.scene, motion, J(creeps), {z.psi, z.ut, z.spin, J(0), J(0)});
    while (true) {  // ends with the duration: the piece was integrated in these steps
        course.advance(std::numeric_limits<double>::infinity());
        if (course.station().time >= duration) break;
        RimPlace<J> next = rim_place_after(rim.scene, motion, at, J(course.step()));
        if (course.station().y[2] == 0 && !motion.rolls()) next[2] = J(0);  // its spin has come to an end
        motion = course.motion();
        at = rim_station(rim.scene, motion, J(course.station().time), next);
    }
    RimPlace<J> y = rim_place_after(rim.scene, motion, at, J(duration - course.before().time));
    RimPlace<double> here{};
    for (std::size_t i = 0; i < y.size(); ++i) here[i] = y[i].a;
    const RimPlace<double> rate = rim_rate(rim.plain, motion, here);
    const std::size_t which = condition_of(rim.plain, motion, here[2], piece.finish);
    const double falls = rate_of_condition(rim.in_time, motion, here, rate, which);
    J later(0);
    if (falls != 0) later.v = -rim_condition(rim.scene, motion, contact_of(y), which).v / falls;
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += J(rate[i]) * later;
    ContactState<J> end = contact_of(y);
    if (piece.finish == ContactEvent::stick) end.ut = J(0);
    if (which == 2) end.spin = J(0);
    return end;
}

}  // namespace detail

/// The state in contact at the end of the pieces, none of them a rest.
///   landing  the state where they begin, with its derivatives
template <class J>
ContactState<J> rim_along(const detail::RimInJets<J>& rim, const std::vector<ContactSegment>& pieces,
                          ContactState<J> landing) {
    for (const ContactSegment& piece : pieces)
        if (piece.end > piece.start) landing = detail::piece_along(rim, piece, landing);
    return landing;
}

}  // namespace swirl
