// Chatter that sticks moves the body along the wall, which contact that sticks does not.
//
// Once an impact has stopped the slip each flight begins with u_t = 0 and lasts τ = 2v/a: the point that touches comes
// down ½ a_t τ² farther, a and a_t the free accelerations towards the wall and along it. The next impact stops it and
// sends it back at e′v, where e′, which with friction need not be e, is that of an impact at u_t/u_n = 2a_t/a, the same
// for all of them. In all
//
//     d = 2 a_t (v/a)²/(1 − e′²)                                                                         (order T²).
//
// (By e′ chatter lasts 2v/(a(1 − e′)): where e′ is close to 1 or beyond the sum does not hold.) Before that, while it
// slips, a flight takes the point u_t τ + ½ a_t τ² along the wall: those few impacts are followed one by one, with a,
// a_t and the lever arms of the landing. Contact in the same slip, once v is removed, would stop within u_t²/(2|u_t′|);
// d is what chatter is more than that. With A and B the differences in ∫p dt and ∫q dt between chatter and contact,
// B₂A + B₃B = 0 (both end at the wall) and B₃A + B₁B = d. So a polygon has turned by (r_n B + r_t A)/I = d r_n/(I +
// α²), and a disk's centre has run d/B₁ along the wall. About the place of contact both motions have the same angular
// momentum up to T³: of a polygon, with u = 0 at either end, that is (I + α²)S, less d S r_t for the vertex that has
// moved by d; a rolling disk's S goes with its ν′.
#pragma once

#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/impulse_by_law.hpp"
#include "map/sustained/removal.hpp"

#include <cmath>

namespace swirl {

/// Chatter may last so many times what it would by e for its sum to hold.
inline constexpr int most_longer = 64;

/// The rest of chatter, in the velocities of the point that touches; lever arms and accelerations are constant in it.
template <class T>
struct RestOfChatter {
    ContactKinematics<T> u;  ///< just after an impact: u_n = −v, u_t
    T acceleration;          ///< a > 0
    T along;                 ///< a_t
};

/// How far the point that touches goes along the wall until it rests there.
template <class T>
struct WayToRest {
    bool rests = false;  ///< false: its slip does not stop, or the sum does not hold
    T distance{};
};

/// From u_t = 0 on, in closed form.
template <class T>
WayToRest<T> way_while_stuck(const ContactScene<T>& scene, const RestOfChatter<T>& rest, const T& v) {
    ContactKinematics<T> u = rest.u;
    u.un = T(1);
    u.ut = T(2) * rest.along / rest.acceleration;
    const Impulse<T> next = impulse_by_law(scene, u, scene.restitution);
    const bool stops = next.mode == ContactMode::c_sticking || next.mode == ContactMode::r_sticking;
    const T rebound = u.b2() * next.normal + u.b3() * next.tangential - T(1);  // e′
    const bool accumulates = plain(T(T(1) - scene.restitution)) <= most_longer * plain(T(T(1) - rebound));
    if (!(stops && accumulates)) return {};
    const T flight = v / rest.acceleration;  // half of the first one's duration
    return {true, T(2) * rest.along * flight * flight / (T(1) - rebound * rebound)};
}

/// From a slip on, impact by impact until one stops it.
///   least  of v: below it the slip is taken not to stop
template <class T>
WayToRest<T> way_to_rest(const ContactScene<T>& scene, const RestOfChatter<T>& rest, const Plain<T>& least) {
    constexpr int most_impacts = 1000;  // v falls by e′ < 1 from one to the next, or this is no chatter
    ContactKinematics<T> u = rest.u;
    T v = -u.un, distance(0);
    for (int i = 0; i < most_impacts && plain(v) > least; ++i) {
        const T flight = T(2) * v / rest.acceleration;
        distance += (u.ut + T(0.5) * rest.along * flight) * flight;
        u.un = v;
        u.ut += rest.along * flight;
        const Impulse<T> j = impulse_by_law(scene, u, scene.restitution);
        v = u.b2() * j.normal + u.b3() * j.tangential - v;
        u.ut += u.b3() * j.normal + u.b1() * j.tangential;
        if (j.mode != ContactMode::c_sticking && j.mode != ContactMode::r_sticking) continue;
        const WayToRest<T> stuck = way_while_stuck(scene, rest, v);
        return {stuck.rests, distance + stuck.distance};
    }
    return {};
}

/// The way of contact that slips from `state` on at its present rate until it rests.
///   longest  the time within which it does
template <class T>
WayToRest<T> way_of_contact(const ContactScene<T>& scene, const ContactState<T>& state, const Plain<T>& longest) {
    if (plain(state.ut) == 0) return {true, T(0)};
    const auto motion = plain(state.ut) > 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
    const T rate = reaction_of(scene, scene.is_disk() ? Support::rim : Support::vertex, motion, state).ut_rate;
    if (!(plain(state.ut) * plain(rate) < 0 && -plain(state.ut) / plain(rate) <= longest)) return {};
    return {true, T(-0.5) * state.ut * state.ut / rate};
}

/// Moves a landing by what the rest of chatter that stops the slip does.
///   post_impact   the impact before
///   acceleration  a > 0 at rest
///   slip          of the rest of chatter
///   state         in contact, u_n removed; u_t = 0 where `slip` sticks
/// No move where v is rounding, where friction does not hold the point or does not stop the slip, and where e′ ≥ 1 or
/// is so close to 1 that 1 − e > `most_longer` (1 − e′).
template <class T>
void move_along_wall(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const T& acceleration,
                     const Slip<T>& slip, ContactState<T>& state) {
    using std::abs, std::sin;
    const Body<T>& body = scene.body;
    const ContactKinematics<T> u = contact_kinematics(body, post_impact);
    const Plain<T> rounding = plain(velocity_rounding(scene, post_impact));
    if (!(plain(T(-u.un)) > rounding) || !(plain(acceleration) > 0)) return;
    if (slip.slides && !can_stick(scene, post_impact)) return;
    const T along = -body.beta * sin(state.psi) - (scene.is_disk() ? T(0) : T(state.spin * state.spin * u.rt));
    const RestOfChatter<T> rest{u, acceleration, along};
    const Plain<T> lasts = -2 * plain(u.un) / (plain(acceleration) * (1 - plain(scene.restitution)));  // chatter, by e
    const WayToRest<T> contact =
        slip.slides ? way_of_contact(scene, state, most_longer * lasts) : WayToRest<T>{true, T(0)};
    if (!contact.rests) return;
    const bool stopped = plain(abs(u.ut)) <= rounding;
    const WayToRest<T> chatter = stopped ? way_while_stuck(scene, rest, T(-u.un)) : way_to_rest(scene, rest, rounding);
    if (!chatter.rests) return;
    const T d = chatter.distance - contact.distance;
    if (scene.is_disk()) {
        state.psi += d / (body.inner * u.b1());
        return;
    }
    const T about_vertex = body.inertia + body.alpha * body.alpha;
    state.psi += d;
    state.chi += d * u.rn / about_vertex - d;
    state.spin += d * state.spin * u.rt / about_vertex;
}

}  // namespace swirl
