// Whether the chatter of a vertex (rim) has ended: it rests, or what is left of it is below rounding.
#pragma once

#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/motion_choice.hpp"
#include "map/sustained/rocking.hpp"
#include "map/sustained/sticking_chatter.hpp"

#include <algorithm>
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
        const RestOfChatter<T> rest = rest_of_chatter(scene, post_impact, at_rest);
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
