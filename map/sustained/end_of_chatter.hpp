// Whether the chatter of a vertex (rim) has ended: it rests, or what is left of it is below rounding.
#pragma once

#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/motion_choice.hpp"
#include "map/sustained/rocking.hpp"
#include "map/sustained/sticking_chatter.hpp"

#include <cmath>
#include <optional>

namespace swirl {

/// The acceleration towards the wall of the point that touches, in free flight with u_n = 0.
template <class T>
T free_acceleration(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const T& ut) {
    const Body<T>& body = scene.body;
    const T wn = body.beta * post_impact.psi.x;
    if (scene.is_disk()) {
        const T along = ut - body.alpha * post_impact.spin;
        return wn + along * along / body.inner;
    }
    return wn + ut * ut - post_impact.spin * post_impact.spin * body.alpha * post_impact.chi.x;
}

template <class T>
struct Touch {
    bool rests;    ///< the normal velocity is zero within rounding, or chatter has ended
    bool pressed;  ///< in free flight it would accelerate into the wall
    T error;
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

/// A vertex leaves while its neighbour rests on the wall.
template <class T>
struct OnEdge {
    bool rocks = false;       ///< the neighbour does rest: the body rocks about it
    std::optional<T> back{};  ///< the acceleration of the one that leaves, where the other stays
    bool rolls_over = false;  ///< once it is back the neighbour would leave for good
};

template <class T>
OnEdge<T> on_edge(const ContactScene<T>& scene, const PostImpactState<T>& leaves, const PostImpactState<T>& neighbour) {
    using std::abs;
    if (!is_still(scene, neighbour) || is_still(scene, leaves)) return {is_still(scene, neighbour), {}, false};
    const T slip = contact_kinematics(scene.body, neighbour).ut;  // that of both, as v vanishes
    const T ut = abs(slip) <= velocity_rounding(scene, neighbour) ? T(0) : slip;
    const std::optional<T> then = rocking_about(scene, leaves, ut);
    return {true, rocking_about(scene, neighbour, ut), then && *then <= T(0)};
}

/// Does v come to nothing? Where the body rocks about a neighbour that stays, v comes back as that rocking has it; else
/// impacts that stick, and a slip beyond Painlevé's border, may make the rest of chatter longer.
template <class T>
Touch<T> touch_of(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const OnEdge<T>& edge) {
    const ContactKinematics<T> u = contact_kinematics(scene.body, post_impact);
    const T acceleration = free_acceleration(scene, post_impact, u.ut);
    if (is_still(scene, post_impact)) return {true, acceleration > 0, T(0)};
    ChatterError<T> error = chatter_error(scene, post_impact);
    if (edge.back) {
        const T longer = acceleration / *edge.back;
        if (edge.rolls_over || !(longer > T(0))) return {false, acceleration > 0, error.estimate};
        error.moved *= longer;
        error.estimate *= longer * longer;
    }
    bool rests = u.un < 0 && error.moved <= chatter_tolerance<T>();
    if (rests && !edge.rocks && scene.mu > T(0)) {
        const T at_rest = free_acceleration(scene, post_impact, T(0));
        const RestOfChatter<T> rest = rest_of_chatter(scene, post_impact, at_rest);
        rests = !slips_beyond_painleve(scene, post_impact) &&
                error.moved * longer_by_sticking(scene, rest, velocity_rounding(scene, post_impact)) <=
                    chatter_tolerance<T>();
    }
    return {rests, acceleration > 0, error.estimate};
}

}  // namespace swirl
