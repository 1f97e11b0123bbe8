// A body on the wall over a floor with dry friction: what the floor pushes at a moment, and the wall's force with it.
// map/dry/README.md, "Contact".
#pragma once

#include "map/contact/motion_choice.hpp"
#include "map/contact/reaction.hpp"
#include "map/dry/uniform_pressure.hpp"

#include <cmath>

namespace swirl {

/// What contact needs of a scene over a floor with dry friction.
template <class T>
struct DryWall {
    ContactScene<T> contact;  ///< without floor
    const UniformPressure* pressure = nullptr;
    T deceleration{};     ///< a_f
    bool is_dish = true;  ///< else the floor is at rest
};

/// How a body moves on the wall.
struct DryMotion {
    Support support = Support::vertex;
    ContactMotion motion = ContactMotion::sticking;
    bool rests = false;  ///< against a dish, whose friction holds it: u_t = 0 and S = 0
    /// u_t and αS, and where the motion begins at rest what they go as at first.
    double slipping = 0, turning = 0;

    bool sticks() const { return motion == ContactMotion::sticking; }
    /// s of u_t.
    double sense() const { return motion == ContactMotion::sliding_backward ? -1 : 1; }
};

/// From the centre to the vertex (rim) in contact, in the axes n and t.
template <class T>
Vec2<T> arm_on_wall(const T& alpha, Support support, const T& chi) {
    using std::cos, std::sin;
    if (support == Support::rim) return {alpha, T(0)};
    return {alpha * cos(chi), alpha * sin(chi)};
}

/// X′ of the centre of a body whose vertex (rim) runs along the wall at u_t, in the axes n and t.
template <class T>
Vec2<T> centre_on_wall_rate(const Vec2<T>& arm, const T& ut, const T& spin) {
    return {spin * arm.y, ut - spin * arm.x};
}

/// Does the body move in one line against a dish, at one ratio of u_t and S, so that the floor's push turns with it but
/// does not change? It pivots about a vertex, rolls, slides on an edge, or (a disk without friction and spin) slides.
template <class T>
bool goes_in_line(const DryWall<T>& wall, const DryMotion& motion, const T& spin) {
    if (!wall.is_dish) return false;
    if (motion.support == Support::edge || motion.sticks()) return true;
    return motion.support == Support::rim && plain(wall.contact.mu) == 0 && plain(spin) == 0;
}

/// The velocity of the dish, iw, in the axes n and t.
template <class T>
Vec2<T> dish_rate(const T& beta, const Vec2<T>& psi) {
    return quarter_turned(Vec2<T>{beta * psi.x, -beta * psi.y});
}

namespace detail {

/// What the floor pushes on a body; nothing on one that does not move against it.
///   arm, slip  r and X′ against the container, in the axes n and t; psi  cis ψ
template <class T>
ContactFloor<T> push_of_floor(const DryWall<T>& wall, const Vec2<T>& psi, const Vec2<T>& arm, Vec2<T> slip,
                              const T& spin) {
    const Body<T>& body = wall.contact.body;
    if (!wall.is_dish) slip = slip + dish_rate(body.beta, psi);
    ContactFloor<T> floor;
    floor.drags = true;
    if (plain(slip.x) == 0 && plain(slip.y) == 0 && plain(spin) == 0) return floor;
    const MeanSlip<T> mean = wall.pressure->mean_slip(body, slip, spin, arm);
    floor.push = times(psi, T(-wall.deceleration) * mean.direction);
    floor.turning = -wall.deceleration * mean.moment * body.inverse_inertia;
    return floor;
}

}  // namespace detail

/// What the floor pushes on a body in contact. At rest against a dish: on one that is about to move as `motion` says.
template <class T>
ContactFloor<T> floor_push(const DryWall<T>& wall, const DryMotion& motion, const ContactState<T>& z) {
    const Body<T>& body = wall.contact.body;
    const Vec2<T> arm = arm_on_wall(body.alpha, motion.support, z.chi);
    T ut = z.ut, spin = z.spin;
    const bool is_still = plain(ut) == 0 && plain(spin) == 0;
    if (goes_in_line(wall, motion, spin) || (wall.is_dish && is_still)) {
        spin = T(motion.turning) / body.alpha;
        ut = motion.support == Support::edge ? spin : motion.sticks() ? T(0) : T(motion.slipping);
    }
    return detail::push_of_floor(wall, cis(z.psi), arm, centre_on_wall_rate(arm, ut, spin), spin);
}

/// Just after an impact.
template <class T>
ContactFloor<T> floor_push(const DryWall<T>& wall, const PostImpactState<T>& post_impact) {
    const ContactKinematics<T> u = contact_kinematics(wall.contact.body, post_impact);
    const Vec2<T> arm{u.rn, u.rt}, slip = Vec2<T>{u.un, T(0)} + centre_on_wall_rate(arm, u.ut, post_impact.spin);
    return detail::push_of_floor(wall, post_impact.psi, arm, slip, post_impact.spin);
}

/// What contact needs of the scene at a moment: the floor pushes as it does then.
template <class T, class... Moment>
ContactScene<T> scene_at(const DryWall<T>& wall, const Moment&... moment) {
    ContactScene<T> scene = wall.contact;
    scene.floor = floor_push(wall, moment...);
    return scene;
}

template <class T>
Reaction<T> reaction_over(const DryWall<T>& wall, const DryMotion& motion, const ContactState<T>& z) {
    return reaction_of(scene_at(wall, motion, z), motion.support, motion.motion, z);
}

/// The motion that a state in contact goes on in: `motion` on `support`.
inline DryMotion motion_at(Support support, ContactMotion motion, double alpha, const ContactState<double>& z) {
    return {support, motion, false, z.ut, alpha * z.spin};
}

}  // namespace swirl
