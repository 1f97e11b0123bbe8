// How chatter comes to its end: what its rest removes of the velocities, how far a rest that sticks moves the body, and
// whether a vertex (rim) is at rest or chatters below rounding. README.md, "Chattering".
//
// Chatter that sticks, or comes to stick, moves the body along the wall, which contact that sticks does not.
//
// Once an impact has stopped the slip each flight begins with u_t = 0 and lasts τ = 2v/a: the point that touches comes
// down ½ a_t τ² farther, a and a_t the free accelerations towards the wall and along it. The next impact stops it and
// sends it back at e′v, where e′, which with friction need not be e, is that of an impact at u_t/u_n = 2a_t/a, the same
// for all of them. In all
//
//     d = 2 a_t (v/a)²/(1 − e′²)                                                                         (order T²).
//
// (By e′ chatter lasts 2v/(a(1 − e′)): where e′ is close to 1 or beyond the sum does not hold.) Before that, while it
// slips, a flight takes the point u_t τ + ½ a_t τ² along the wall, with a, a_t and the lever arms of the landing. Under
// all three laws an impact that slips throughout sends the body back at ev, so that after m of them
//
//     v_m = v eᵐ,  u_t,m = u_t + k v G,  way = (2v/a)(u_t G + k v (G² − H)/2) + ½ a_t (2v/a)² H
//     G = (1 − eᵐ)/(1 − e),  H = (1 − e²ᵐ)/(1 − e²),  k = 2a_t/a + (B₃ − sμB₁)(1 + e)/(B₂ − sμB₃)
//
// (Σ eⁱ G_i = (G² − H)/2); those next to the impact that stops the slip, or to the flight that turns it round, are made
// one by one. Where impacts do not stick though contact would, chatter ends slipping, and contact goes on from there.
// Contact in the same slip, once v is removed, would stop within −u_t²/(2u_t′); d is what chatter is more than that.
// With A and B the differences in ∫p dt and ∫q dt between chatter and contact, B₂A + B₃B = 0 (both end at the wall) and
// B₃A + B₁B = d. So a polygon has turned by (r_n B + r_t A)/I = d r_n/(I + α²), and a disk's centre has run d/B₁ along
// the wall. About the place of contact both motions have the same angular momentum up to T³: of a polygon, with u = 0
// at either end, that is (I + α²)S, less d S r_t for the vertex that has moved by d; a rolling disk's S goes with its
// ν′.
#pragma once

#include "map/contact/chatter_completion.hpp"
#include "map/contact/contact_state.hpp"
#include "map/contact/motion_choice.hpp"
#include "map/contact/reaction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace swirl {

/// The slip in which the rest of chatter goes on, which decides the friction of its impulses.
template <class T>
struct Slip {
    bool slides;
    T sign;  ///< of u_t
};

/// Normal and tangential impulse, p and q, that remove u_n: q is −μ sign p while it slides, and what removes u_t as
/// well while it sticks.
template <class T>
struct Removal {
    T normal, tangential;
};

template <class T>
Removal<T> removal_of(const ContactScene<T>& scene, const ContactKinematics<T>& u, const Slip<T>& slip) {
    const T along = scene.mu == T(0) ? T(0) : slip.slides ? T(-scene.mu * slip.sign) : T(-u.b3() / u.b1());  // q/p
    const T c = u.b2() + u.b3() * along;
    const bool stops = scene.mu > T(0) && !slip.slides;
    const T still = stops ? T(-u.ut / u.b1()) : T(0);  // q at p = 0
    const T p = c > T(0) ? T((u.un - u.b3() * still) / c) : T(0);
    return {p, still + along * p};
}

/// Whether friction holds the vertex (rim) at u_t = 0.
template <class T>
bool can_stick(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    ContactState<T> still = contact_state(scene, post_impact);
    still.ut = T(0);
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    return reaction_of(scene, support, ContactMotion::sticking, still).reserve >= T(0);
}

/// It sticks also where the removal of u_n would turn so slow a slip round, and friction holds it: the flights between
/// the impacts that are left bring it to an end.
template <class T>
Slip<T> slip_of(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::abs;
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    const Slip<T> slip{scene.mu > T(0) && abs(u.ut) > velocity_rounding(scene, post_impact),
                       u.ut > T(0) ? T(1) : T(-1)};
    if (!slip.slides) return slip;
    const Removal<T> j = removal_of(scene, u, slip);
    const bool goes_on = (u.ut + u.b3() * j.normal + u.b1() * j.tangential) * slip.sign > T(0);
    return {goes_on || !can_stick(scene, post_impact), slip.sign};
}

template <class T>
bool sticks(const ContactScene<T>& scene, const Slip<T>& slip) {
    return scene.mu > T(0) && !slip.slides;
}

/// Chatter may last so many times what it would by e for its sum to hold.
inline constexpr int most_longer = 64;

/// The rest of chatter, in the velocities of the point that touches; lever arms and accelerations are constant in it.
template <class T>
struct RemainingChatter {
    ContactKinematics<T> u;  ///< just after an impact: u_n = −v, u_t
    T acceleration;          ///< a > 0
    T along;                 ///< a_t
};

/// What a floor adds to a_t at u_t = 0: of the centre −γX′ and the push, of a vertex (−γ_r S + its torque by I) r_n
/// besides, of a disk's rim that by α.
template <class T>
T along_by_floor(const ContactScene<T>& scene, const PostImpactState<T>& z) {
    const ContactFloor<T>& floor = scene.floor;
    const T rn = scene.is_disk() ? scene.body.alpha : T(scene.body.alpha * z.chi.x);
    return ((floor.drag - floor.spin_drag) * z.spin + floor.turning) * rn - floor.tilt * scene.body.beta * z.psi.x +
           (floor.push.y * z.psi.x - floor.push.x * z.psi.y);
}

/// Just after an impact.
///   acceleration  a > 0 at rest
template <class T>
RemainingChatter<T> remaining_chatter(const ContactScene<T>& scene, const PostImpactState<T>& post_impact,
                                      const T& acceleration) {
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    const T turning = scene.is_disk() ? T(0) : T(post_impact.spin * post_impact.spin * u.rt);
    T along = -scene.body.beta * post_impact.psi.y - turning;
    if (scene.floor.drags) along += along_by_floor(scene, post_impact);
    return {u, acceleration, along};
}

/// How far the point that touches goes along the wall until it rests there.
template <class T>
struct DistanceToRest {
    bool rests = false;  ///< false: its slip does not stop, or the sum does not hold
    T distance{};
};

/// e′, at which impacts after flights from u_t = 0 on rebound; nothing where such an impact does not stick.
template <class T>
std::optional<T> rebound_while_stuck(const ContactScene<T>& scene, const RemainingChatter<T>& rest) {
    ContactKinematics<T> u = rest.u;
    u.un = T(1);
    u.ut = T(2) * rest.along / rest.acceleration;
    const Impulse<T> next = impulse_by_law(scene, u, scene.restitution);
    if (!ends_in_stick(next.mode)) return {};
    return T(u.b2() * next.normal + u.b3() * next.tangential - T(1));
}

/// Does the sum not hold, since chatter lasts too long by e′?
template <class T>
bool lasts_too_long(const ContactScene<T>& scene, const T& rebound) {
    return plain(T(T(1) - scene.restitution)) > most_longer * plain(T(T(1) - rebound));
}

/// From u_t = 0 on, in closed form; nothing where the next impact does not stick.
template <class T>
std::optional<DistanceToRest<T>> distance_while_stuck(const ContactScene<T>& scene, const RemainingChatter<T>& rest,
                                                      const T& v) {
    const std::optional<T> rebound = rebound_while_stuck(scene, rest);
    if (!rebound) return {};
    if (lasts_too_long(scene, *rebound)) return DistanceToRest<T>{};
    const T flight = v / rest.acceleration;  // half of the first one's duration
    return DistanceToRest<T>{true, T(2) * rest.along * flight * flight / (T(1) - *rebound * *rebound)};
}

/// A slip in the rest of chatter, and the way so far.
template <class T>
struct SlipSoFar {
    T v, ut;  ///< just after an impact
    T way{};
};

/// k: how much v changes u_t in a flight and the impact after it, which slips throughout.
///   friction_ratio  q/p = −sμ
template <class T>
T change_by_sliding(const ContactScene<T>& scene, const RemainingChatter<T>& rest, const T& friction_ratio) {
    const ContactKinematics<T>& u = rest.u;
    const T c = u.b2() + u.b3() * friction_ratio;
    return (u.b3() + u.b1() * friction_ratio) * (T(1) + scene.restitution) / c + T(2) * rest.along / rest.acceleration;
}

/// After impacts that all slip throughout, in closed form.
///   change  k
///   fallen  eᵐ; 0: after all of them
template <class T>
SlipSoFar<T> slide(const ContactScene<T>& scene, const RemainingChatter<T>& rest, const SlipSoFar<T>& from,
                   const T& change, const T& fallen) {
    const T& e = scene.restitution;
    const T flight = T(2) * from.v / rest.acceleration, g = (T(1) - fallen) / (T(1) - e),
            h = (T(1) - fallen * fallen) / (T(1) - e * e);
    return {from.v * fallen, from.ut + change * from.v * g,
            from.way + flight * (from.ut * g + T(0.5) * change * from.v * (g * g - h)) +
                T(0.5) * rest.along * flight * flight * h};
}

/// Where |B₃| ≤ μB₁: the slip stops as G comes to `share` of its limit 1/(1 − e), u_t + k v G = 0; nothing where it
/// never does.
template <class T>
std::optional<Plain<T>> share_that_slides(const ContactScene<T>& scene, const SlipSoFar<T>& from, const T& change) {
    const Plain<T> share = -plain(from.ut) * (1 - plain(scene.restitution)) / (plain(change) * plain(from.v));
    if (share > 0 && share < 1) return share;
    return {};
}

/// q/p = −sμ of a slip in the sense s of `along`.
template <class T>
T friction_ratio_of(const ContactScene<T>& scene, const T& along) {
    return plain(along) > 0 ? T(-scene.mu) : scene.mu;
}

/// Past all impacts but the last two that slip throughout; nothing where the slip never stops. Where |B₃| ≤ μB₁.
template <class T>
std::optional<SlipSoFar<T>> slide_on(const ContactScene<T>& scene, const RemainingChatter<T>& rest,
                                     const SlipSoFar<T>& from) {
    using std::floor, std::log, std::log1p, std::pow;
    const T& e = scene.restitution;
    const T change = change_by_sliding(scene, rest, friction_ratio_of(scene, from.ut));
    const auto slides = share_that_slides(scene, from, change);
    if (!slides) return {};
    const Plain<T> share = *slides;
    const Plain<T> m = plain(e) > 0 ? Plain<T>(floor(Plain<T>(log1p(-share) / log(plain(e)))) - 1) : Plain<T>(0);
    if (!(m > 0)) return from;
    return slide(scene, rest, from, change, T(pow(e, m)));
}

/// Slipping in the sense of `along` until v is zero.
template <class T>
SlipSoFar<T> slide_to_the_end(const ContactScene<T>& scene, const RemainingChatter<T>& rest, const SlipSoFar<T>& from,
                              const T& along) {
    return slide(scene, rest, from, change_by_sliding(scene, rest, friction_ratio_of(scene, along)), T(0));
}

/// After one more flight and impact; does that stop the slip?
template <class T>
bool goes_on_to_stick(const ContactScene<T>& scene, const RemainingChatter<T>& rest, SlipSoFar<T>& slip) {
    const T flight = T(2) * slip.v / rest.acceleration;
    slip.way += (slip.ut + T(0.5) * rest.along * flight) * flight;
    ContactKinematics<T> u = rest.u;
    u.un = slip.v;
    u.ut = slip.ut + rest.along * flight;
    const Impulse<T> j = impulse_by_law(scene, u, scene.restitution);
    slip.v = u.b2() * j.normal + u.b3() * j.tangential - u.un;
    slip.ut = u.ut + u.b3() * j.normal + u.b1() * j.tangential;
    return ends_in_stick(j.mode);
}

/// How many times as long as by e chatter lasts where its impacts come to stick, and rebound at e′ from then on: (1 −
/// e)/(1 − e′), +∞ for e′ ≥ 1, where v grows (reverse chatter: Nordmark, Dankowicz & Champneys, IMA J. Appl. Math. 76
/// (2011) 85). 1 where that is at most `most_longer`, and where no impact sticks.
///   least  u_t up to this is rounding
template <class T>
Plain<T> longer_by_sticking(const ContactScene<T>& scene, const RemainingChatter<T>& rest, const Plain<T>& least) {
    using std::abs;
    const ContactKinematics<T>& u = rest.u;
    if (plain(abs(u.b3())) > plain(T(scene.mu * u.b1()))) return 1;
    const T ratio = friction_ratio_of(scene, u.ut);
    // Beyond Painlevé's border the next impact stops the slip.
    const bool stops = plain(abs(u.ut)) <= least || plain(T(u.b2() + u.b3() * ratio)) <= 0;
    if (!stops && !share_that_slides(scene, {T(-u.un), u.ut}, change_by_sliding(scene, rest, ratio))) return 1;
    const std::optional<T> rebound = rebound_while_stuck(scene, rest);
    if (!rebound || !lasts_too_long(scene, *rebound)) return 1;
    const Plain<T> lost = 1 - plain(*rebound);
    return lost > 0 ? Plain<T>((1 - plain(scene.restitution)) / lost) : std::numeric_limits<Plain<T>>::infinity();
}

/// The way of contact that slips from `state` on at its present rate until it rests.
///   longest  the time within which it does
template <class T>
DistanceToRest<T> distance_of_contact(const ContactScene<T>& scene, const ContactState<T>& state,
                                      const Plain<T>& longest) {
    if (plain(state.ut) == 0) return {true, T(0)};
    const auto motion = plain(state.ut) > 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
    const Reaction<T> slips = reaction_of(scene, scene.is_disk() ? Support::rim : Support::vertex, motion, state);
    const T& rate = slips.ut_rate;
    const bool slows = plain(slips.stiffness) > 0 && plain(state.ut) * plain(rate) < 0;
    if (!(slows && -plain(state.ut) / plain(rate) <= longest)) return {};
    return {true, T(-0.5) * state.ut * state.ut / rate};
}

/// From just after an impact until an impact stops the slip, and from there. Where impacts do not stick chatter ends
/// slipping, and contact goes on from there: because |B₃| > μB₁ (followed one by one), or because they have (1 + e)/2
/// of the friction that contact has (after the one that stopped the slip all of them slide).
///   landing  in contact; its u_t is not read
///   least    v and u_t up to this are rounding
///   longest  as in `distance_of_contact`
/// Cost: a few impacts; up to 1,000 where |B₃| > μB₁.
template <class T>
DistanceToRest<T> distance_to_rest(const ContactScene<T>& scene, const RemainingChatter<T>& rest,
                                   ContactState<T> landing, const Plain<T>& least, const Plain<T>& longest) {
    using std::abs;
    const ContactKinematics<T>& u = rest.u;
    const SlipSoFar<T> begin{T(-u.un), u.ut};
    const bool holds = plain(abs(u.b3())) <= plain(T(scene.mu * u.b1()));
    bool stuck = plain(abs(u.ut)) <= least;
    std::optional<SlipSoFar<T>> slip = holds && !stuck ? slide_on(scene, rest, begin) : begin;
    if (!slip) return {};
    const int most_impacts = holds ? 8 : 1000;  // two before a flight turns the slip, two after, one that sticks; room
    for (int i = 0; i < most_impacts && plain(slip->v) > least; ++i) {
        if (stuck) {
            if (const auto on = distance_while_stuck(scene, rest, slip->v))
                return {on->rests, slip->way + on->distance};
            if (holds) {
                slip = slide_to_the_end(scene, rest, *slip, rest.along);
                break;
            }
        }
        const bool forward = plain(slip->ut) > 0;
        stuck = goes_on_to_stick(scene, rest, *slip);
        const bool turned = !stuck && forward != (plain(slip->ut) > 0);  // by the flight
        if (!(holds && turned)) continue;
        const auto on = slide_on(scene, rest, *slip);
        slip = on ? *on : slide_to_the_end(scene, rest, *slip, slip->ut);
    }
    if (plain(slip->v) > least) return {};
    landing.ut = stuck && plain(abs(slip->ut)) <= least ? T(0) : slip->ut;
    const DistanceToRest<T> on = distance_of_contact(scene, landing, longest);
    return {on.rests, slip->way + on.distance};
}

/// `distance_to_rest` of a disk whose sticking impacts return the slip: u_t⁺ = −e_t u_t⁻ is of the order of v and falls
/// with it, in turns of either sign; impact by impact. Nothing beyond `most_returned` of them (e up to some 0.9998).
inline constexpr long most_returned = 100'000;
template <class T>
DistanceToRest<T> distance_while_returned(const ContactScene<T>& scene, const RemainingChatter<T>& rest,
                                          ContactState<T> landing, const Plain<T>& least, const Plain<T>& longest) {
    using std::abs;
    SlipSoFar<T> slip{T(-rest.u.un), rest.u.ut};
    for (long i = 0; plain(slip.v) > least; ++i) {
        if (i == most_returned) return {};
        goes_on_to_stick(scene, rest, slip);
    }
    landing.ut = plain(abs(slip.ut)) <= least ? T(0) : slip.ut;
    const DistanceToRest<T> on = distance_of_contact(scene, landing, longest);
    return {on.rests, slip.way + on.distance};
}

/// Moves a landing by what the rest of chatter that stops the slip does.
///   post_impact   the impact before
///   acceleration  a > 0 at rest
///   slip          of the rest of chatter
///   state         in contact, u_n removed; u_t = 0 where `slip` sticks
/// No move where v is rounding, where friction does not hold the point in contact or does not stop the slip, where e′ ≥
/// 1 or is so close to 1 that 1 − e > `most_longer` (1 − e′), and where impacts that can't stick are more than 1,000.
template <class T>
void move_along_wall(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const T& acceleration,
                     const Slip<T>& slip, ContactState<T>& state) {
    const Body<T>& body = scene.body;
    const RemainingChatter<T> rest = remaining_chatter(scene, post_impact, acceleration);
    const ContactKinematics<T>& u = rest.u;
    const Plain<T> rounding = plain(velocity_rounding(scene, post_impact));
    if (!(plain(T(-u.un)) > rounding) || !(plain(acceleration) > 0)) return;
    if (!can_stick(scene, post_impact)) return;
    const Plain<T> lasts = -2 * plain(u.un) / (plain(acceleration) * (1 - plain(scene.restitution)));  // chatter, by e
    const Plain<T> longest = most_longer * lasts;
    const DistanceToRest<T> contact =
        slip.slides ? distance_of_contact(scene, state, longest) : DistanceToRest<T>{true, T(0)};
    if (!contact.rests) return;
    const DistanceToRest<T> chatter = body.tangential_restitution != T(0)
                                          ? distance_while_returned(scene, rest, state, rounding, longest)
                                          : distance_to_rest(scene, rest, state, rounding, longest);
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

/// The acceleration towards the wall of the point that touches, in free flight with u_n = 0.
template <class T>
T free_acceleration(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const T& ut) {
    const Body<T>& body = scene.body;
    const T wn = swirl_force(scene, post_impact.psi).x;
    if (scene.is_disk()) {
        const T along = ut - body.alpha * post_impact.spin;
        return wn + along * along / body.inner;
    }
    const T free = wn + ut * ut - post_impact.spin * post_impact.spin * body.alpha * post_impact.chi.x;
    if (!scene.floor.drags) return free;
    const T rt = body.alpha * post_impact.chi.y;
    return free - ((scene.floor.drag - scene.floor.spin_drag) * post_impact.spin + scene.floor.turning) * rt;
}

template <class T>
struct Touch {
    bool rests = false;    ///< the normal velocity is zero within rounding, or chatter has ended
    bool on_edge = false;  ///< the same, as a vertex of an edge whose other one is in contact
    bool pressed = false;  ///< in free flight it would accelerate into the wall
    T error{};
    T lasts{};  ///< how long its chatter goes on
};

template <class T>
bool is_still(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::abs;
    return abs(contact_kinematics(scene.body, post_impact).un) <= velocity_rounding(scene, post_impact);
}

/// A slip beyond Painlevé's border, B₂ − sμB₃ ≤ 0: contact would jam, and the next impact stops it.
template <class T>
bool slips_beyond_painleve(const ContactScene<T>& scene, const PostImpactState<T>& post_impact) {
    using std::abs;
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    if (!(abs(u.ut) > velocity_rounding(scene, post_impact))) return false;
    return u.b2() + u.b3() * friction_ratio_of(scene, u.ut) <= T(0);
}

/// Where the vertex `pivot` of an edge is in contact and slips at u_t, the acceleration of its neighbour towards the
/// wall; nothing if the forces do not keep it there.
template <class T>
std::optional<T> rocking_about(const ContactScene<T>& scene, const PostImpactState<T>& pivot, const T& ut) {
    ContactState<T> state = contact_state(scene, pivot);
    state.ut = ut;
    const MotionChoice<T> choice = choose_motion(scene, Support::vertex, state, 0);
    if (!choice.stays) return {};
    return rocking_of(scene, choice.motion, choice.state).acceleration;
}

/// The slip of an edge: that of the vertex that rests, zero where it is rounding.
template <class T>
T edge_slip(const ContactScene<T>& scene, const PostImpactState<T>& here, const PostImpactState<T>& there) {
    using std::abs;
    const PostImpactState<T>& of = is_still(scene, there) ? there : here;
    const T ut = contact_kinematics(scene.body, of).ut;
    return abs(ut) <= velocity_rounding(scene, of) ? T(0) : ut;
}

/// The other vertex of an edge.
template <class T>
struct Neighbour {
    bool still = false;       ///< it rests on the wall
    std::optional<T> back{};  ///< if it stays there: how rocking about it brings this one back (`rocking_about`)
};

/// Has its chatter ended? In free flight, and by impacts that stick as long as the neighbour is off the wall; as a
/// vertex of an edge with the slower of free flight and rocking. No slip beyond Painlevé's border ends it.
template <class T>
Touch<T> touch_of(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const Neighbour<T>& neighbour) {
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    const T acceleration = free_acceleration(scene, post_impact, u.ut);
    const bool pressed = acceleration > 0;
    if (is_still(scene, post_impact)) return {true, true, pressed, T(0)};
    if (!(u.un < 0) || (scene.mu > T(0) && slips_beyond_painleve(scene, post_impact)))
        return {false, false, pressed, T(0)};
    const ChatterError<T> error = chatter_error(scene, post_impact);
    Touch<T> touch{error.moved <= chatter_tolerance<T>(), false, pressed, error.estimate, T(-error.moved / u.un)};
    if (neighbour.back && *neighbour.back > 0) {
        const T longer = std::max(T(1), T(acceleration / *neighbour.back));
        touch.on_edge = error.moved * longer <= chatter_tolerance<T>();
        if (touch.on_edge) touch.error *= longer * longer;
        touch.lasts *= longer;
    }
    if (neighbour.still) {
        touch.rests = touch.rests && !neighbour.back;  // else the body rocks about the neighbour
        return touch;
    }
    if (touch.rests && scene.mu > T(0)) {
        const T at_rest = free_acceleration(scene, post_impact, T(0));
        const RemainingChatter<T> rest = remaining_chatter(scene, post_impact, at_rest);
        touch.rests = error.moved * longer_by_sticking(scene, rest, velocity_rounding(scene, post_impact)) <=
                      chatter_tolerance<T>();
    }
    return touch;
}

/// The vertex that struck and its neighbour, which touches, too.
template <class T>
struct EdgeTouch {
    Touch<T> here, there;
    bool lies = false;         ///< the edge does: both are still, or rocking about either brings the other back
    bool there_lasts = false;  ///< about the neighbour this one leaves for good
};

template <class T>
EdgeTouch<T> edge_touch(const ContactScene<T>& scene, const PostImpactState<T>& here, const PostImpactState<T>& there) {
    const bool here_still = is_still(scene, here), there_still = is_still(scene, there);
    if (here_still && there_still) {
        const Touch<T> first = touch_of(scene, here, {}), second = touch_of(scene, there, {});
        return {first, second, true, false};
    }
    const T slip = edge_slip(scene, here, there);
    const std::optional<T> about_here = rocking_about(scene, here, slip),
                           about_there = rocking_about(scene, there, slip);
    EdgeTouch<T> edge{touch_of(scene, here, {there_still, about_there}),
                      touch_of(scene, there, {here_still, about_here})};
    edge.lies =
        edge.here.on_edge && edge.there.on_edge && about_here && *about_here > 0 && about_there && *about_there > 0;
    edge.there_lasts = about_there && *about_there <= 0 && !(about_here && *about_here <= 0);
    return edge;
}

}  // namespace swirl
