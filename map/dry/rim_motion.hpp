// A disk on the wall, over a floor with dry friction: what acts on it, and which motion begins. map/dry/README.md,
// "Contact".
#pragma once

#include "map/contact/contact_state.hpp"
#include "map/dry/uniform_pressure.hpp"

#include <cmath>

namespace swirl {

/// What contact needs of a scene with a disk.
template <class T>
struct RimScene {
    const Body<T>* body = nullptr;
    T mu{};  ///< of the wall
    const UniformPressure* pressure = nullptr;
    T deceleration{};     ///< a_f
    bool is_dish = true;  ///< else the floor is at rest

    T inertia_factor() const { return body->inertia / (body->alpha * body->alpha); }
};

/// ρν′, the velocity of the disk's centre along the wall.
template <class T>
T along_wall(const RimScene<T>& scene, const ContactState<T>& z) {
    return z.ut - scene.body->alpha * z.spin;
}

/// The motion that a disk is in.
struct RimMotion {
    ContactMotion motion = ContactMotion::sticking;
    bool rests = false;  ///< against a dish, whose friction holds it: ρν′ = 0 and S = 0
    /// Where it begins at ρν′ = 0 and S = 0 these go as `heading` to αS as `turning`. Of a disk that rolls on a dish,
    /// or slides on it without friction of the wall and without spin, `heading` is the sign of ρν′.
    double heading = 1, turning = 0;

    bool rolls() const { return motion == ContactMotion::sticking; }
    /// s of u_t.
    double sense() const { return motion == ContactMotion::sliding_backward ? -1 : 1; }
};

/// The wall's force, −λ n + f t, and the rates of the motion.
template <class T>
struct RimForces {
    T normal{}, friction{};  ///< λ, f
    T ut_rate{}, spin_rate{};
};

namespace detail {

/// What the floor adds to λ, to ρν″ and to αS′.
template <class T>
struct FloorPush {
    T normal{}, along{}, turning{};
};

/// The disk's means of |U| = α|S|, at which it rolls on a dish: 8/3π, and 8α/9π.
template <class T>
FloorPush<T> push_while_rolling(const RimScene<T>& scene, double heading) {
    const T a = T(heading) * scene.deceleration;
    const double third = 8 / (3 * pi<double>());
    return {T(0), T(-third) * a, T(third / 3) * a / scene.inertia_factor()};
}

/// Does it move in one line against a dish, at one ratio of ρν′ and αS? The floor's push is then constant.
template <class T>
bool goes_in_line(const RimScene<T>& scene, const RimMotion& motion, const T& spin) {
    return scene.is_dish && (motion.rolls() || (plain(scene.mu) == 0 && plain(spin) == 0));
}

template <class T>
FloorPush<T> push_of_floor(const RimScene<T>& scene, const RimMotion& motion, const ContactState<T>& z,
                           const Vec2<T>& swirl) {
    const Body<T>& body = *scene.body;
    if (goes_in_line(scene, motion, z.spin)) {
        if (motion.rolls()) return push_while_rolling(scene, motion.heading);
        return {T(0), T(-motion.heading) * scene.deceleration, T(0)};
    }
    const T along = along_wall(scene, z);
    Vec2<T> slip = scene.is_dish ? Vec2<T>{T(0), along} : Vec2<T>{T(-swirl.y), T(along + swirl.x)};
    T spin = z.spin;
    if (plain(slip.x) == 0 && plain(slip.y) == 0 && plain(spin) == 0) {
        slip = {T(0), T(motion.heading)};
        spin = T(motion.turning) / body.alpha;
    }
    const MeanSlip<T> mean = scene.pressure->mean_slip(body, slip, spin, Vec2<T>{body.alpha, T(0)});
    const T a = -scene.deceleration;
    return {a * mean.direction.x, a * mean.direction.y, a * body.alpha * mean.moment * body.inverse_inertia};
}

}  // namespace detail

/// With w the swirl's arm, p the floor's push (p_n, p_t along t, p_s of αS′) and f on the rim
///     λ = w_n + p_n + ρν′²     ρν″ = w_t + p_t + f     αS′ = f/κ + p_s
/// closed by f = −sμλ, or by u_t′ = 0: f = −κ(w_t + p_t + p_s)/(1 + κ). Not of a disk that rests.
template <class T>
RimForces<T> rim_forces(const RimScene<T>& scene, const RimMotion& motion, const ContactState<T>& z) {
    using std::cos, std::sin;
    const Body<T>& body = *scene.body;
    const Vec2<T> swirl{T(body.beta * cos(z.psi)), T(-body.beta * sin(z.psi))};
    const detail::FloorPush<T> push = detail::push_of_floor(scene, motion, z, swirl);
    const T along = along_wall(scene, z), kappa = scene.inertia_factor();
    RimForces<T> forces;
    forces.normal = swirl.x + push.normal + along * along * body.inverse_inner;
    const T pull = swirl.y + push.along + push.turning;
    forces.friction =
        motion.rolls() ? T(-kappa * pull / (T(1) + kappa)) : T(T(-motion.sense()) * scene.mu * forces.normal);
    if (!motion.rolls()) forces.ut_rate = pull + forces.friction * (T(1) + T(1) / kappa);
    forces.spin_rate = (forces.friction / kappa + push.turning) / body.alpha;
    return forces;
}

/// How a disk that is at rest against a dish is held. The forces of wall and floor are not unique; it rests as long as
/// some of them balance the swirl: a λ and a |f| ≤ μλ, and of the floor a force and a torque −αf within its limits,
/// which are those of a disk that slides and spins at some ratio.
struct RimRest {
    double reserve;           ///< a_f's, what is left of it in the pair that leaves most; it is held where ≥ 0
    double normal, friction;  ///< λ and f of that pair
};

/// Cost: some 40 means.
RimRest rest_on_rim(const RimScene<double>& scene, double psi);

/// The motion that begins, or that the disk leaves the wall.
struct RimChoice {
    bool stays = false;
    RimMotion motion;
    bool is_consistent = true;  ///< false: it is pressed to the wall, and no motion agrees with the forces of its own
};

/// Sliding where u_t ≠ 0; else rolling where friction holds it, else the slip against the friction that it would need.
/// At rest against a dish: rest where that is held, else flight where the swirl pulls it off the wall, else rolling, or
/// the slip that keeps the ratio ρν′ : αS in which it begins.
///   broken  friction has just ceased to hold: no rest after a rest, no rolling after rolling
RimChoice choose_rim_motion(const RimScene<double>& scene, const ContactState<double>& z, bool broken);

/// A slip that has begun at rest a time ago. (ρν′, αS) goes at first in the ratio of its rates, which changes as ψ
/// does: ratios beside it come to it at a rate of a_f over the speed, faster than steps could follow.
struct Creep {
    double time = 0;
    double ut = 0, spin = 0;  ///< then; ψ has fallen by as much time
};

Creep creep_from_rest(const RimScene<double>& scene, const RimMotion& motion, double psi, double time);

/// How long a slip from rest creeps so: until its speed is 10⁻⁶ a_f/ω_s, where the ratio is known to 10⁻⁶ of itself.
double creep_lasts(const RimScene<double>& scene, const RimMotion& motion, double psi);

/// The motion of a state on the way, as it was chosen when it began.
RimMotion rim_motion_at(const RimScene<double>& scene, ContactMotion motion, const ContactState<double>& z);

}  // namespace swirl
