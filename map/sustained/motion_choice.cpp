#include "map/sustained/motion_choice.hpp"

#include "map/map_list.hpp"
#include "map/sustained/reaction.hpp"

namespace swirl {

namespace {

template <class T>
bool pushes(Support support, const Reaction<T>& r) {
    return r.stiffness > 0 && r.normal >= 0 && (support != Support::edge || r.second >= 0);
}

/// The motion that is consistent on this support; none if there is none.
///   broken  friction has just stopped holding: not sticking
template <class T>
std::optional<ContactMotion> consistent_motion(const ContactScene<T>& scene, Support support, const ContactState<T>& z,
                                               bool broken = false) {
    using enum ContactMotion;
    if (scene.mu == 0 || z.ut != 0) {
        const ContactMotion motion = z.ut < 0 && scene.mu > 0 ? sliding_backward : sliding_forward;
        if (pushes(support, reaction_of(scene, support, motion, z))) return motion;
        return {};
    }
    const Reaction<T> held = reaction_of(scene, support, sticking, z);
    const T margin = stick_margin(scene, z);
    if (!broken && held.reserve >= T(-0.5) * margin && (support == Support::edge || held.normal >= 0)) return sticking;
    // Where friction has just ceased to hold, the forces of slip against it differ from those of sticking by rounding
    // only.
    const T rounding = broken ? margin : T(0);
    const ContactMotion against = held.friction < 0 ? sliding_forward : sliding_backward;
    const ContactMotion along = held.friction < 0 ? sliding_backward : sliding_forward;
    for (const ContactMotion motion : {against, along}) {
        const Reaction<T> r = reaction_of(scene, support, motion, z);
        const int sign = motion == sliding_forward ? 1 : -1;
        if (pushes(support, r) && sign * r.ut_rate > (motion == against ? T(-rounding) : T(0))) return motion;
    }
    return {};
}

/// The state on an edge's other vertex.
template <class T>
ContactState<T> other_end(const ContactScene<T>& scene, const ContactState<T>& z) {
    return {z.psi + 2 * scene.half_chord, scene.widest_chi, z.ut, z.spin};
}

/// An edge lifts one of its vertices: contact goes on at the other, and the lifted one must leave the wall.
template <class T>
std::optional<MotionChoice<T>> lift_vertex(const ContactScene<T>& scene, const ContactState<T>& edge, int vertex_step) {
    for (const int step : {0, 1}) {
        const ContactState<T> z = step == 0 ? edge : other_end(scene, edge);
        const auto motion = consistent_motion(scene, Support::vertex, z);
        if (!motion) continue;
        const Reaction<T> r = reaction_of(scene, Support::vertex, *motion, z);
        const T turning = r.spin_rate - r.ut_rate;  // χ″: away from |χ| = χ_m
        if (step == 0 ? turning > 0 : turning < 0)
            return MotionChoice<T>{true, Support::vertex, *motion, z, vertex_step + step, ContactEvent::lift};
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

}  // namespace

template <class T>
MotionChoice<T> choose_motion(const ContactScene<T>& scene, Support support, const ContactState<T>& state,
                              int vertex_step, bool broken) {
    MotionChoice<T> choice{true, support, ContactMotion::sticking, state, vertex_step, ContactEvent::release};
    if (const auto motion = consistent_motion(scene, support, state, broken)) {
        choice.motion = *motion;
        return choice;
    }
    if (support == Support::edge)
        if (const auto lifted = lift_vertex(scene, state, vertex_step)) return *lifted;
    choice.stays = false;
    if (support == Support::vertex && jams(scene, state)) choice.ends = ContactEvent::jam;
    if (support != Support::edge) return choice;
    for (const int step : {0, 1}) {
        const ContactState<T> z = step == 0 ? state : other_end(scene, state);
        if (!jams(scene, z)) continue;
        return {false, Support::vertex, choice.motion, z, vertex_step + step, ContactEvent::jam};
    }
    return choice;
}

#define SWIRL_COMPILE_MOTION_CHOICE(T) \
    template MotionChoice<T> choose_motion(const ContactScene<T>&, Support, const ContactState<T>&, int, bool);
SWIRL_EVERY_NUMBER(SWIRL_COMPILE_MOTION_CHOICE)

}  // namespace swirl
