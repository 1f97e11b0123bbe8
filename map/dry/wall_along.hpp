// Contact over a floor with dry friction, known in double, once more in Jets: the derivative of its end.
// map/dry/README.md, "Derivative".
#pragma once

#include "map/contact/contact_jets.hpp"
#include "map/contact/segment_follower.hpp"
#include "map/dry/wall_contact.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace swirl {

/// A scene's contact where a number of the scene is `apart` larger and smaller.
struct DryWallsApart {
    DryWall<double> larger, smaller;
    double apart = 0;
};

/// A scene's contact, and what differentiates along it.
template <class J>
struct DryWallInJets {
    DryWall<double> plain;
    DryWall<J> wall;
    DryWall<ContactJet<1>> in_time;  ///< carries no derivatives of its own
    /// Of the number along which Jets are taken; nothing where they are taken along the state.
    std::optional<DryWallsApart> along;
};

namespace detail {

/// What vanishes where a motion ends by its event; 1 where nothing does.
///   at_rest  the body comes to rest there
template <class T>
T vanishing_over(const DryWall<T>& wall, const DryMotion& motion, ContactEvent event, bool first_lifts,
                 const ContactState<T>& z, bool at_rest) {
    using std::abs;
    if (event == ContactEvent::strike) return T(wall.contact.widest_chi - abs(z.chi));
    if (event == ContactEvent::stick)
        return at_rest && (motion.sticks() || motion.support == Support::edge) ? z.spin : z.ut;
    const Reaction<T> r = reaction_over(wall, motion, z);
    if (event == ContactEvent::release) return r.normal;
    if (event == ContactEvent::lift) return first_lifts ? r.normal : r.second;
    if (event == ContactEvent::slip) return r.reserve;
    return event == ContactEvent::jam ? r.stiffness : T(1);
}

/// Values of two numbers that depend on ψ and χ at rest and on the scene, known to √ε.
template <class J, class Of>
std::array<J, 2> through_rest(const DryWallInJets<J>& jets, const ContactState<J>& z, const Of& of) {
    constexpr double apart = 1e-6;
    const auto at = [&](const DryWall<double>& wall, double psi, double chi) {
        return of(wall, ContactState<double>{z.psi.a + psi, z.chi.a + chi, 0, 0});
    };
    const std::array<double, 2> here = at(jets.plain, 0, 0);
    const std::array<double, 2> after = at(jets.plain, apart, 0), before = at(jets.plain, -apart, 0);
    const std::array<double, 2> left = at(jets.plain, 0, apart), right = at(jets.plain, 0, -apart);
    std::array<J, 2> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = J(here[i]);
        values[i].v = (after[i] - before[i]) / (2 * apart) * z.psi.v + (left[i] - right[i]) / (2 * apart) * z.chi.v;
    }
    if (!jets.along) return values;
    const std::array<double, 2> more = at(jets.along->larger, 0, 0), less = at(jets.along->smaller, 0, 0);
    for (std::size_t i = 0; i < values.size(); ++i) values[i].v[0] += (more[i] - less[i]) / (2 * jets.along->apart);
    return values;
}

}  // namespace detail

/// What moves the body in a piece of contact, for `contact_detail::SegmentFollower`.
template <class J>
struct DryPieces {
    const DryWallInJets<J>& jets;

    ContactState<J> end_of(const ContactSegment& piece, bool first_lifts, ContactState<J> z) {
        const DryMotion motion = dry_motion_at(jets.plain, piece.support, piece.motion, piece.from);
        if (motion.rests) return after_rest(piece, z);
        WallCourse course(jets.plain, motion, piece.from);
        DryStation<J> at = begin(motion, course, z);
        const double duration = piece.end - piece.start;
        DryMotion now = motion;
        if (course.station().time < duration) {
            while (true) {  // ends with the duration: the piece was integrated in these steps
                course.advance(std::numeric_limits<double>::infinity());
                if (course.station().time >= duration) break;
                DryPlace<J> next = dry_place_after(jets.wall, now, at, J(course.step()));
                if (course.station().y[3] == 0 && !now.sticks() && now.support == Support::rim) next[3] = J(0);
                now = course.motion();
                at = dry_station(jets.wall, now, J(course.station().time), next);
            }
            at.y = dry_place_after(jets.wall, now, at, J(duration) - at.time);
        }
        return at_event(piece, now, first_lifts, at.y);
    }
    bool ends_second_chatter(const ContactSegment& last) const {
        const DryMotion motion = motion_at(last.support, last.motion, jets.plain.contact.body.alpha, last.to);
        return contact_detail::ends_second_chatter(scene_at(jets.plain, motion, last.to), last.motion, last.to);
    }

private:
    /// ψ at which the rest ends; χ stays.
    ContactState<J> after_rest(const ContactSegment& piece, const ContactState<J>& z) const {
        ContactState<J> end{J(piece.to.psi), z.chi, J(0), J(0)};
        const auto reserve = [&](const DryWall<double>& wall, const ContactState<double>& at) {
            return std::array<double, 2>{rest_reserve(wall, piece.support, at), 0};
        };
        const J changes = detail::through_rest(jets, end, reserve)[0];
        constexpr double apart = 1e-6;
        const auto at_psi = [&](double psi) {
            return rest_reserve(jets.plain, piece.support, {piece.to.psi + psi, piece.to.chi, 0, 0});
        };
        const double rate = (at_psi(apart) - at_psi(-apart)) / (2 * apart);
        if (rate != 0) end.psi.v = -changes.v / rate;
        return end;
    }

    DryStation<J> begin(const DryMotion& motion, const WallCourse& course, const ContactState<J>& z) const {
        const double creeps = course.station().time;
        if (!(creeps > 0)) return dry_station(jets.wall, motion, J(0), {z.psi, z.chi, z.ut, z.spin, J(0), J(0)});
        const auto creep = [&](const DryWall<double>& wall, const ContactState<double>& at) {
            const ContactState<double> state = creep_from_rest(wall, motion, at, creeps).state;
            return std::array<double, 2>{state.ut, state.spin};
        };
        const std::array<J, 2> slips = detail::through_rest(jets, z, creep);
        const DryPlace<double>& y = course.station().y;
        DryPlace<J> place{z.psi, z.chi, slips[0], slips[1], J(y[4]), J(y[5])};
        for (std::size_t i = 0; i < 4; ++i) place[i].a = y[i];
        return dry_station(jets.wall, motion, J(creeps), place);
    }

    /// d/dτ of what ends a motion.
    double rate_of_event(const ContactSegment& piece, const DryMotion& motion, bool first_lifts,
                         const DryPlace<double>& y, const DryPlace<double>& rate, bool at_rest) const {
        DryPlace<ContactJet<1>> moving;
        for (std::size_t i = 0; i < y.size(); ++i) {
            moving[i] = ContactJet<1>(y[i]);
            moving[i].v[0] = rate[i];
        }
        return detail::vanishing_over(jets.in_time, motion, piece.finish, first_lifts, contact_of(moving), at_rest)
            .v[0];
    }

    ContactState<J> at_event(const ContactSegment& piece, const DryMotion& motion, bool first_lifts,
                             DryPlace<J> y) const {
        const bool stops = piece.finish == ContactEvent::stick && piece.to.ut == 0 && piece.to.spin == 0;
        DryPlace<double> here{};
        for (std::size_t i = 0; i < y.size(); ++i) here[i] = y[i].a;
        const bool in_line = goes_in_line(jets.plain, motion, here[3]);
        if (!stops || in_line) {
            const DryPlace<double> rate = detail::dry_rate(jets.plain, motion, here);
            const double falls = rate_of_event(piece, motion, first_lifts, here, rate, stops);
            J later(0);
            if (falls != 0)
                later.v =
                    -detail::vanishing_over(jets.wall, motion, piece.finish, first_lifts, contact_of(y), stops).v /
                    falls;
            for (std::size_t i = 0; i < y.size(); ++i) y[i] += J(rate[i]) * later;
        }
        ContactState<J> end = contact_of(y);
        if (piece.finish == ContactEvent::stick) end.ut = J(0);
        if (stops) end.spin = J(0);
        return end;
    }
};

}  // namespace swirl
