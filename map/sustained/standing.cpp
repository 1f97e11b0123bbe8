#include "map/sustained/standing.hpp"

#include "map/sustained/reaction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

/// The acceleration towards the wall of the point that touches, in free flight with u_n = 0.
double free_acceleration(const ContactScene& scene, const Launch<double>& launch, double ut) {
    const Body<double>& body = scene.body;
    const double wn = body.beta * launch.psi.x;
    if (scene.is_disk()) {
        const double along = ut - body.alpha * launch.spin;
        return wn + along * along / body.inner;
    }
    return wn + ut * ut - launch.spin * launch.spin * body.alpha * launch.chi.x;
}

struct Touch {
    bool rests;    ///< no normal velocity but rounding and the end of chatter
    bool pressed;  ///< free flight would take it into the wall
    double error;
};

Touch touch_of(const ContactScene& scene, const Launch<double>& launch) {
    const Approach<double> u = approach_of(scene.body, launch);
    const double rounding = velocity_rounding(scene, launch);
    const double acceleration = free_acceleration(scene, launch, u.ut);
    if (std::abs(u.un) <= rounding) return {true, acceleration > 0, 0};
    const ChatterError error = chatter_error(scene, launch);
    return {u.un < 0 && error.moved <= chatter_tolerance, acceleration > 0, error.estimate};
}

/// How friction goes with a normal impulse: −1 and 1 by the sign of u_t while it slides, 0 while it sticks.
struct Slip {
    bool slides;
    double sign;
};

Slip slip_of(const ContactScene& scene, const Launch<double>& launch) {
    const double ut = approach_of(scene.body, launch).ut;
    return {scene.mu > 0 && std::abs(ut) > velocity_rounding(scene, launch), ut > 0 ? 1.0 : -1.0};
}

/// Takes v out by the impulse that contact would have needed less of: p = u_n/c < 0, friction with it.
ContactState without_normal_velocity(const ContactScene& scene, const Launch<double>& launch, const Slip& slip,
                                     double& jacobi) {
    const Approach<double> u = approach_of(scene.body, launch);
    ContactState state = contact_state(scene, launch);
    const double ratio = scene.mu == 0 ? 0 : slip.slides ? -scene.mu * slip.sign : -u.b3() / u.b1();  // q/p
    const double c = u.b2() + u.b3() * ratio;
    const double p = c > 0 ? u.un / c : 0;
    const double q = ratio * p;
    state.ut += u.b3() * p + u.b1() * q;
    state.spin += (u.rn * q + u.rt * p) / u.inertia;
    jacobi = -p * 0.5 * u.un + q * (0.5 * (u.ut + state.ut) - 1);
    return state;
}

ContactState landed(const ContactScene& scene, const Launch<double>& launch, double& jacobi) {
    const Slip slip = slip_of(scene, launch);
    ContactState state = without_normal_velocity(scene, launch, slip, jacobi);
    if (scene.mu > 0 && (!slip.slides || state.ut * slip.sign <= 0)) state.ut = 0;
    return state;
}

/// How fast an edge turns about the container's centre once its rocking has died: normal impulses point to there.
double edge_rate(const ContactScene& scene, const Launch<double>& launch) {
    const Body<double>& body = scene.body;
    const Vec2<double> place{1 - body.alpha * launch.chi.x, -(body.alpha * launch.chi.y)};
    const Vec2<double> velocity{launch.vn - body.beta * launch.psi.y, launch.vt - body.beta * launch.psi.x};
    return (cross(place, velocity) + body.inertia * launch.spin) / (dot(place, place) + body.inertia);
}

/// How far an edge that lands slides on, if friction then holds it; infinite if that does not. Where no sliding is
/// consistent it jams at once.
double slide_of(const ContactScene& scene, const ContactState& landed) {
    ContactState z = landed;
    z.ut = z.spin = 0;
    const Reaction held = reaction_of(scene, Support::edge, ContactMotion::sticking, z);
    if (scene.mu == 0 || held.reserve < 0) return std::numeric_limits<double>::infinity();
    z.ut = z.spin = landed.ut;
    const auto motion = landed.ut > 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
    const Reaction slips = reaction_of(scene, Support::edge, motion, z);
    const bool pushes = slips.stiffness > 0 && slips.normal >= 0 && slips.second >= 0;
    const double slowing =
        pushes ? (landed.ut > 0 ? -slips.ut_rate : slips.ut_rate) : scene.mu * (held.normal + held.second);
    return slowing > 0 ? landed.ut * landed.ut / (2 * slowing) : std::numeric_limits<double>::infinity();
}

/// Puts χ at ±χ_m if it is that close: the neighbour touches, too. An ulp inside it would fall by an ulp, which gives
/// it a velocity of 10⁻⁸ that it did not have: where the two vertices strike in turn it would be taken and given for
/// ever.
void keep_neighbour_at_wall(const ContactScene& scene, double tolerance, ContactState& state) {
    if (scene.is_disk() || std::abs(std::abs(state.chi) - scene.widest_chi) > tolerance) return;
    state.chi = std::copysign(scene.widest_chi, state.chi);
}

}  // namespace

ChatterError chatter_error(const ContactScene& scene, const Launch<double>& launch) {
    const Approach<double> u = approach_of(scene.body, launch);
    const double acceleration = free_acceleration(scene, launch, u.ut);
    const double v = std::abs(u.un);
    if (!(acceleration > 0)) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const double lasts = 2 * v / (acceleration * (1 - scene.restitution));
    const double turning = scene.is_disk() ? std::abs(u.ut - scene.body.alpha * launch.spin) * scene.body.per_inner
                                           : std::abs(u.ut) + std::abs(launch.spin);
    const double passes = lasts * (1 + turning);
    double unused;
    const ContactState taken = without_normal_velocity(scene, launch, slip_of(scene, launch), unused);
    const double removed = v + std::abs(taken.ut - u.ut) + scene.body.alpha * std::abs(taken.spin - launch.spin);
    return {v * lasts, 4 * removed * std::min(1.0, passes * passes)};
}

bool rests_still(const ContactScene& scene, const Standing& standing) {
    return scene.mu > 0 && standing.support == Support::edge && standing.state.ut == 0 && standing.state.spin == 0;
}

ContactState landed_like(const ContactScene& scene, const Launch<double>& base, const Standing& standing,
                         const Launch<double>& near) {
    const auto seen = [&](const Launch<double>& launch) {
        return standing.vertex_step == 0 ? launch : seen_from_neighbour(scene, launch);
    };
    if (standing.support == Support::edge) {
        ContactState state = contact_state(scene, seen(near));
        state.chi = standing.state.chi;
        state.spin = state.ut = rests_still(scene, standing) ? 0 : edge_rate(scene, seen(near));
        return state;
    }
    double jacobi = 0;
    return without_normal_velocity(scene, seen(near), slip_of(scene, seen(base)), jacobi);
}

Standing standing_of(const ContactScene& scene, const Launch<double>& launch) {
    Standing standing;
    const Touch here = touch_of(scene, launch);
    bool there_rests = false;
    bool there_approaches = false;
    Launch<double> neighbour;
    Touch there{false, false, 0};
    if (!scene.is_disk()) {
        const double apart = std::abs(std::abs(std::atan2(launch.chi.y, launch.chi.x)) - scene.widest_chi);
        if (apart <= neighbour_tolerance) {
            neighbour = seen_from_neighbour(scene, launch);
            there = touch_of(scene, neighbour);
            there_rests = there.rests;
            there_approaches = !there.rests && apart <= chatter_tolerance && approach_of(scene.body, neighbour).un > 0;
        }
    }
    const int step = launch.chi.y > 0 ? -1 : 1;
    if (here.rests && there_rests) {
        const bool clockwise = launch.chi.y < 0;
        standing = {true,
                    Support::edge,
                    contact_state(scene, clockwise ? launch : neighbour),
                    clockwise ? 0 : step,
                    std::max(here.error, there.error),
                    0};
        standing.state.chi = -scene.widest_chi;
        // The slip of one vertex is also what is left of rocking on the other.
        const bool still = scene.mu > 0 && (std::abs(standing.state.ut) <= velocity_rounding(scene, launch) ||
                                            slide_of(scene, standing.state) <= chatter_tolerance);
        standing.state.ut = standing.state.spin = still ? 0 : standing.state.ut;
        standing.jacobi = jacobi_of(scene.body, launch_from(scene, standing.state)) - jacobi_of(scene.body, launch);
    } else if (here.rests && here.pressed) {
        standing = {true, scene.is_disk() ? Support::rim : Support::vertex, {}, 0, here.error, 0};
        standing.state = landed(scene, launch, standing.jacobi);
        keep_neighbour_at_wall(scene, chatter_tolerance, standing.state);
    } else if (there_rests && there.pressed) {
        standing = {true, Support::vertex, {}, step, there.error, 0};
        standing.state = landed(scene, neighbour, standing.jacobi);
        keep_neighbour_at_wall(scene, neighbour_tolerance, standing.state);  // as exact as its rebound is small
    } else {
        standing.struck = here.rests && there_approaches;
    }
    return standing;
}

}  // namespace swirl
