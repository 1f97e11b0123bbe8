// What a landing may be off by in first order of the last velocity, beside the second order of chatter_completion.hpp:
// where the rest of chatter meets what contact in its place does not. README.md, "Chattering".
#pragma once

#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/edge_landing.hpp"
#include "map/sustained/motion_choice.hpp"
#include "map/sustained/reaction.hpp"
#include "map/sustained/removal.hpp"

#include <algorithm>
#include <cmath>

namespace swirl {

/// What S of a landed edge may be off by, in first order of v, where its slip is of that order: the rest of chatter may
/// stop the slip at any moment, or turn it, and friction acts by the sense that it then has. Both the impulses and, for
/// as long as chatter lasts, contact's forces differ by as much as between slips either way and none.
///   before  just after the impact, on either vertex
///   lasts   how long chatter goes on
template <class T>
T edge_error(const ContactScene<T>& scene, const PostImpactState<T>& before, const ContactState<T>& landed,
             const T& lasts) {
    ContactState<T> still = landed;
    still.ut = still.spin = T(0);
    const bool held = reaction_of(scene, Support::edge, ContactMotion::sticking, still).reserve >= T(0);
    using std::abs;
    if (!(scene.mu > T(0)) || (landed.ut == T(0) && held)) return T(0);
    const T ut = contact_kinematics(scene.body, before).ut;
    const T rounding = velocity_rounding(scene, before);
    T apart(0), rates(0);
    for (const T& ratio : {T(-scene.mu), T(0), scene.mu})
        if (const auto rate = edge_rate_with(scene, before, ratio)) apart = std::max(apart, T(abs(*rate - landed.ut)));
    for (const auto motion : {ContactMotion::sliding_forward, ContactMotion::sliding_backward})
        rates = std::max(rates, T(abs(reaction_of(scene, Support::edge, motion, landed).spin_rate)));
    const T may_change = apart + 2 * rates * lasts;
    if (apart <= rounding || abs(ut) > 2 * may_change) return T(0);  // or its slip goes on in the same sense
    return may_change;
}

/// The error of u_t of a vertex (rim) that friction does not hold: the rest of chatter may stop a slip of the order of
/// v, but contact slips.
///   taken  in contact, u_n removed
template <class T>
T unheld_error(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const ContactState<T>& taken,
               const T& lasts) {
    using std::abs;
    if (!(scene.mu > T(0)) || can_stick(scene, post_impact)) return T(0);
    const T ut = contact_kinematics(scene.body, post_impact).ut;
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    T rate(0);
    for (const auto motion : {ContactMotion::sliding_forward, ContactMotion::sliding_backward})
        rate = std::max(rate, T(abs(reaction_of(scene, support, motion, taken).ut_rate)));
    const T may_change = abs(taken.ut - ut) + rate * lasts;
    return abs(ut) <= 2 * may_change ? may_change : T(0);
}

/// The velocities that a landing removes.
///   before  just after an impact
///   taken   in contact, u_n removed
template <class T>
T velocities_removed(const ContactScene<T>& scene, const PostImpactState<T>& before, const ContactState<T>& taken) {
    using std::abs;
    const ContactKinematics<T> u = contact_kinematics(scene.body, before);
    return abs(u.un) + abs(taken.ut - u.ut) + scene.body.alpha * abs(taken.spin - before.spin);
}

/// For how long a neighbour's strike may come too early or too late, its distance to the wall being known to `unsure`
/// only; 0 where it does not come within a time `lasts`.
///   room            χ_m − |χ|
///   closing, acceleration  rate at which the neighbour comes to the wall, and that of the rate
template <class T>
T moment_unsure(const T& room, const T& closing, const T& acceleration, const T& lasts, const T& unsure) {
    using std::abs, std::sqrt;
    const T most = unsure + closing * lasts + T(0.5) * std::max(T(0), acceleration) * lasts * lasts;
    if (room > most || !(closing > T(0) || acceleration > T(0))) return T(0);
    const T late = acceleration > T(0) ? T(sqrt(T(2) * unsure / acceleration)) : T(closing / abs(acceleration));
    return closing > T(0) ? std::min(T(unsure / closing), late) : late;
}

/// The error of a vertex whose neighbour comes to the wall before the rest of chatter is over: it strikes while the
/// vertex still leaves the wall at some of v, and in contact it strikes while the vertex rests. Where the neighbour is
/// at the wall within rounding the moment of its strike is unsure as well.
///   unsure  what its distance to the wall is known to
template <class T>
T neighbour_error(const ContactScene<T>& scene, const PostImpactState<T>& before, const ContactState<T>& taken,
                  const T& lasts, const T& unsure) {
    using std::abs;
    if (scene.is_disk()) return T(0);
    const MotionChoice<T> choice = choose_motion(scene, Support::vertex, taken, 0);
    const Reaction<T> r = reaction_of(scene, Support::vertex, choice.motion, taken);
    const T side = taken.chi < T(0) ? T(-1) : T(1);
    const T rounding = velocity_rounding(scene, before) / scene.body.alpha;
    const auto closes = [&](const T& spin, const T& ut) { return T(side * (spin - ut)); };
    const T still = closes(taken.spin, taken.ut),
            flies = closes(before.spin, contact_kinematics(scene.body, before).ut);
    const T closing = std::max(still, flies) > rounding ? std::max(still, flies) : T(0);
    const T room = std::max(T(0), T(scene.widest_chi - abs(taken.chi)));
    const T late = moment_unsure(room, closing, closes(r.spin_rate, r.ut_rate), lasts, unsure);
    if (!(late > T(0))) return T(0);
    const T rate = abs(r.ut_rate) + scene.body.alpha * abs(r.spin_rate) + scene.body.beta + taken.ut * taken.ut +
                   scene.body.alpha * taken.spin * taken.spin;
    return velocities_removed(scene, before, taken) + rate * (lasts + late);
}

}  // namespace swirl
