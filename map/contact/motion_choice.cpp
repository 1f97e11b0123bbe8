#include "map/contact/motion_choice.hpp"

#include "map/contact/end_of_chatter.hpp"
#include "map/contact/reaction.hpp"
#include "map/map_list.hpp"
#include "map/numbers/quad.hpp"

#include <array>

namespace swirl {

namespace {

template <class T>
bool pushes(Support support, const Reaction<T>& r) {
    return r.stiffness > 0 && r.normal >= 0 && (support != Support::edge || r.second >= 0);
}

/// The slip that friction holds back while the contact sticks.
template <class T>
ContactMotion against_friction(const ContactScene<T>& scene, Support support, const ContactState<T>& z) {
    const Reaction<T> held = reaction_of(scene, support, ContactMotion::sticking, z);
    return held.friction < 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
}

/// Is the motion consistent on this support?
///   broken  friction has just stopped holding: not sticking
template <class T>
bool is_consistent(const ContactScene<T>& scene, Support support, ContactMotion motion, const ContactState<T>& z,
                   bool broken) {
    const Reaction<T> r = reaction_of(scene, support, motion, z);
    if (scene.mu == 0 || z.ut != 0) {
        const bool backward = z.ut < 0 && scene.mu > 0;
        return motion == (backward ? ContactMotion::sliding_backward : ContactMotion::sliding_forward) &&
               pushes(support, r);
    }
    const T margin = stick_margin(scene, z);
    if (motion == ContactMotion::sticking)
        return !broken && r.reserve >= T(-0.5) * margin && (support == Support::edge || r.normal >= 0);
    // Where friction has just ceased to hold, the forces of slip against it differ from those of sticking by rounding
    // only.
    const bool against = motion == against_friction(scene, support, z);
    const int sign = motion == ContactMotion::sliding_forward ? 1 : -1;
    return pushes(support, r) && sign * r.ut_rate > (broken && against ? T(-margin) : T(0));
}

/// Sticking, the slip against the friction that it would need, the other: the order in which they are tried.
template <class T>
std::array<ContactMotion, 3> motions_of(const ContactScene<T>& scene, Support support, const ContactState<T>& z) {
    using enum ContactMotion;
    const ContactMotion against = against_friction(scene, support, z);
    return {sticking, against, against == sliding_forward ? sliding_backward : sliding_forward};
}

/// The motion that is consistent on this support; none if there is none.
template <class T>
std::optional<ContactMotion> consistent_motion(const ContactScene<T>& scene, Support support, const ContactState<T>& z,
                                               bool broken) {
    for (const ContactMotion motion : motions_of(scene, support, z))
        if (is_consistent(scene, support, motion, z, broken)) return motion;
    return {};
}

/// In free flight it would leave the wall.
template <class T>
bool leaves(const ContactScene<T>& scene, const ContactState<T>& z) {
    return free_acceleration(scene, post_impact_state(scene, z), z.ut) < 0;
}

/// An edge lifts one of its vertices: contact goes on at the other, in any motion in which the lifted one leaves the
/// wall.
///   begins  contact does: at a vertex that in free flight would not leave
///   margin  what χ″ may fall short of leaving the wall by: rounding, where an edge has just ceased to rest because it
///           rises through zero
template <class T>
std::optional<MotionChoice<T>> lift_vertex(const ContactScene<T>& scene, const ContactState<T>& edge, int vertex_step,
                                           bool begins, const T& margin) {
    for (const int step : {0, 1}) {
        const ContactState<T> z = step == 0 ? edge : other_end(scene, edge);
        if (begins && leaves(scene, z)) continue;
        for (const ContactMotion motion : motions_of(scene, Support::vertex, z)) {
            if (!is_consistent(scene, Support::vertex, motion, z, false)) continue;
            const Reaction<T> r = reaction_of(scene, Support::vertex, motion, z);
            const T turning = r.spin_rate - r.ut_rate;  // χ″: away from |χ| = χ_m
            if ((step == 0 ? turning : T(-turning)) > -margin)
                return MotionChoice<T>{true, Support::vertex, motion, z, vertex_step + step, ContactEvent::lift};
        }
    }
    return {};
}

/// True if a vertex that slides has no unique force (Painlevé).
template <class T>
bool jams(const ContactScene<T>& scene, const ContactState<T>& z) {
    if (scene.mu == 0 || z.ut == 0) return false;
    const auto motion = z.ut > 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
    return reaction_of(scene, Support::vertex, motion, z).stiffness <= 0;
}

/// A vertex or rim.
template <class T>
MotionChoice<T> motion_at_one(const ContactScene<T>& scene, MotionChoice<T> choice, bool broken) {
    if (const auto motion = consistent_motion(scene, choice.support, choice.state, broken)) {
        choice.motion = *motion;
        return choice;
    }
    choice.stays = false;
    if (choice.support == Support::vertex && jams(scene, choice.state)) choice.ends = ContactEvent::jam;
    return choice;
}

/// An edge whose contact goes on keeps both vertices where it can; one whose contact begins as few as it can.
template <class T>
MotionChoice<T> motion_of_edge(const ContactScene<T>& scene, MotionChoice<T> choice, bool broken, bool begins) {
    const ContactState<T> ends[] = {choice.state, other_end(scene, choice.state)};
    choice.stays = !(begins && leaves(scene, ends[0]) && leaves(scene, ends[1]));
    if (!choice.stays) return choice;
    const auto lifted = [&](const T& margin) {
        return lift_vertex(scene, choice.state, choice.vertex_step, begins, margin);
    };
    if (begins)
        if (const auto first = lifted(T(0))) return *first;
    if (const auto motion = consistent_motion(scene, Support::edge, choice.state, broken)) {
        choice.motion = *motion;
        return choice;
    }
    if (const auto then = lifted(T(0))) return *then;
    if (broken)
        if (const auto then = lifted(T(stick_margin(scene, choice.state) / scene.body.alpha))) return *then;
    choice.stays = false;
    for (const int step : {0, 1})
        if (jams(scene, ends[step]))
            return {false, Support::vertex, choice.motion, ends[step], choice.vertex_step + step, ContactEvent::jam};
    return choice;
}

}  // namespace

template <class T>
MotionChoice<T> choose_motion(const ContactScene<T>& scene, Support support, const ContactState<T>& state,
                              int vertex_step, ContactEvent before) {
    const bool broken = before == ContactEvent::slip;
    const bool begins = before == ContactEvent::landing || before == ContactEvent::strike;
    const MotionChoice<T> stays{true, support, ContactMotion::sticking, state, vertex_step, ContactEvent::release};
    return support == Support::edge ? motion_of_edge(scene, stays, broken, begins)
                                    : motion_at_one(scene, stays, broken);
}

#define SWIRL_COMPILE_MOTION_CHOICE(T) \
    template MotionChoice<T> choose_motion(const ContactScene<T>&, Support, const ContactState<T>&, int, ContactEvent);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_MOTION_CHOICE)

}  // namespace swirl
