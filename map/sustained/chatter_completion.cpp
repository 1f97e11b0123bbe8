#include "map/sustained/chatter_completion.hpp"

#include "map/sustained/reaction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl {

namespace {

/// The acceleration towards the wall of the point that touches, in free flight with u_n = 0.
double free_acceleration(const ContactScene& scene, const PostImpactState<double>& post_impact, double ut) {
    const Body<double>& body = scene.body;
    const double wn = body.beta * post_impact.psi.x;
    if (scene.is_disk()) {
        const double along = ut - body.alpha * post_impact.spin;
        return wn + along * along / body.inner;
    }
    return wn + ut * ut - post_impact.spin * post_impact.spin * body.alpha * post_impact.chi.x;
}

struct Touch {
    bool rests;    ///< the normal velocity is zero within rounding, or chatter has ended
    bool pressed;  ///< in free flight it would accelerate into the wall
    double error;
};

Touch touch_of(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    const ContactKinematics<double> u = contact_kinematics(scene.body, post_impact);
    const double rounding = velocity_rounding(scene, post_impact);
    const double acceleration = free_acceleration(scene, post_impact, u.ut);
    if (std::abs(u.un) <= rounding) return {true, acceleration > 0, 0};
    const ChatterError error = chatter_error(scene, post_impact);
    return {u.un < 0 && error.moved <= chatter_tolerance, acceleration > 0, error.estimate};
}

/// The direction of slip, which decides the friction of a normal impulse: −1 and 1 by the sign of u_t while it slides,
/// 0 while it sticks.
struct Slip {
    bool slides;
    double sign;
};

Slip slip_of(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    const double ut = contact_kinematics(scene.body, post_impact).ut;
    return {scene.mu > 0 && std::abs(ut) > velocity_rounding(scene, post_impact), ut > 0 ? 1.0 : -1.0};
}

/// Removes v by the normal impulse p = u_n/c < 0, the difference of chatter's from contact's, with the friction that
/// goes with it.
ContactState without_normal_velocity(const ContactScene& scene, const PostImpactState<double>& post_impact,
                                     const Slip& slip, double& jacobi) {
    const ContactKinematics<double> u = contact_kinematics(scene.body, post_impact);
    ContactState state = contact_state(scene, post_impact);
    const double ratio = scene.mu == 0 ? 0 : slip.slides ? -scene.mu * slip.sign : -u.b3() / u.b1();  // q/p
    const double c = u.b2() + u.b3() * ratio;
    const double p = c > 0 ? u.un / c : 0;
    const double q = ratio * p;
    state.ut += u.b3() * p + u.b1() * q;
    state.spin += (u.rn * q + u.rt * p) / u.inertia;
    jacobi = -p * 0.5 * u.un + q * (0.5 * (u.ut + state.ut) - 1);
    return state;
}

ContactState landed(const ContactScene& scene, const PostImpactState<double>& post_impact, double& jacobi) {
    const Slip slip = slip_of(scene, post_impact);
    ContactState state = without_normal_velocity(scene, post_impact, slip, jacobi);
    if (scene.mu > 0 && (!slip.slides || state.ut * slip.sign <= 0)) state.ut = 0;
    return state;
}

/// |c′|/c: how fast the impulse that removes v changes with χ; c = B₂ − sμB₃ while the vertex slides, B₂ − B₃²/B₁ while
/// it sticks. Here and below with the magnitudes of all terms, since a sum may be small by chance.
double impulse_change(const ContactScene& scene, const Slip& slip, double chi) {
    const double kappa = scene.inertia_factor(), c = std::cos(chi), s = std::sin(chi);
    if (scene.mu > 0 && !slip.slides) return std::abs(2 * s * c) / (kappa + c * c);
    return (std::abs(2 * s * c) + scene.mu * std::abs(c * c - s * s)) /
           std::abs(kappa + s * (s - scene.mu * slip.sign * c));
}

/// (r(r + |a′|/a) + r′)(1 + |c′|/c) of chatter_completion.hpp, each with the magnitudes of its terms, since a sum may
/// be small by chance.
///   before, contact  velocities just after the impact, and with u_n removed
double second_order(const ContactScene& scene, const Slip& slip, const ContactState& before,
                    const ContactState& contact) {
    const Body<double>& body = scene.body;
    const ContactMotion motion = scene.mu > 0 && !slip.slides    ? ContactMotion::sticking
                                 : scene.mu > 0 && slip.sign < 0 ? ContactMotion::sliding_backward
                                                                 : ContactMotion::sliding_forward;
    const Support support = scene.is_disk() ? Support::rim : Support::vertex;
    const Reaction change = reaction_of(scene, support, motion, contact);
    const double wn = body.beta * std::cos(contact.psi), wt = body.beta * std::abs(std::sin(contact.psi));
    if (scene.is_disk()) {
        const double rate = 1 + std::abs(normal_rate(scene, support, before));
        const double turning = normal_rate(scene, support, contact);
        const double faster = std::abs(change.ut_rate - body.alpha * change.spin_rate) * body.per_inner;
        const double a = wn + body.inner * turning * turning;
        const double a_rate = wt * std::abs(turning - 1) + 2 * body.inner * std::abs(turning) * faster;
        return rate * (rate + a_rate / std::abs(a)) + faster;
    }
    const double rate = 1 + std::abs(before.ut) + std::abs(before.spin);
    const double faster = std::abs(change.ut_rate) + std::abs(change.spin_rate);
    const double rn = body.alpha * std::abs(std::cos(contact.chi)), rt = body.alpha * std::abs(std::sin(contact.chi));
    const double spin2 = contact.spin * contact.spin;
    const double a = wn + contact.ut * contact.ut - spin2 * body.alpha * std::cos(contact.chi);
    const double a_rate = wt * std::abs(contact.ut - 1) + 2 * std::abs(contact.ut * change.ut_rate) +
                          2 * std::abs(contact.spin * change.spin_rate) * rn +
                          spin2 * std::abs(contact.spin - contact.ut) * rt;
    return (rate * (rate + a_rate / std::abs(a)) + faster) * (1 + impulse_change(scene, slip, contact.chi));
}

/// The rate at which an edge turns about the container's centre once its rocking has ended: the angular momentum about
/// that centre is conserved, since normal impulses point at it.
double edge_rate(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    const Body<double>& body = scene.body;
    const Vec2<double> place{1 - body.alpha * post_impact.chi.x, -(body.alpha * post_impact.chi.y)};
    const Vec2<double> velocity{post_impact.vn - body.beta * post_impact.psi.y,
                                post_impact.vt - body.beta * post_impact.psi.x};
    return (cross(place, velocity) + body.inertia * post_impact.spin) / (dot(place, place) + body.inertia);
}

/// The distance an edge slides after landing until friction holds it; infinite if friction does not. Where no sliding
/// is consistent the edge jams at once.
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

/// Sets χ to ±χ_m if it is within `tolerance` of it: the neighbour touches, too. Left an ulp inside, the neighbour
/// would fall by an ulp and gain a velocity of order √ε = 10⁻⁸ that it did not have: where two vertices strike in turn,
/// this gain balances the loss at each strike and the alternation does not end.
void keep_neighbour_at_wall(const ContactScene& scene, double tolerance, ContactState& state) {
    if (scene.is_disk() || std::abs(std::abs(state.chi) - scene.widest_chi) > tolerance) return;
    state.chi = std::copysign(scene.widest_chi, state.chi);
}

}  // namespace

ChatterError chatter_error(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    const ContactKinematics<double> u = contact_kinematics(scene.body, post_impact);
    const double acceleration = free_acceleration(scene, post_impact, u.ut);
    const double v = std::abs(u.un);
    if (!(acceleration > 0)) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const double lasts = 2 * v / (acceleration * (1 - scene.restitution));
    const Slip slip = slip_of(scene, post_impact);
    double unused;
    const ContactState taken = without_normal_velocity(scene, post_impact, slip, unused);
    const double removed = v + std::abs(taken.ut - u.ut) + scene.body.alpha * std::abs(taken.spin - post_impact.spin);
    const double order = second_order(scene, slip, contact_state(scene, post_impact), taken);
    const double estimate = 0.5 * removed * lasts * lasts * order;
    return {v * lasts, std::isnan(estimate) ? std::numeric_limits<double>::infinity() : estimate};  // a or c is 0
}

bool rests_still(const ContactScene& scene, const ChatterCompletion& completion) {
    return scene.mu > 0 && completion.support == Support::edge && completion.state.ut == 0 &&
           completion.state.spin == 0;
}

ContactState landed_like(const ContactScene& scene, const PostImpactState<double>& base,
                         const ChatterCompletion& completion, const PostImpactState<double>& near) {
    const auto seen = [&](const PostImpactState<double>& post_impact) {
        return completion.vertex_step == 0 ? post_impact : seen_from_neighbour(scene, post_impact);
    };
    if (completion.support == Support::edge) {
        ContactState state = contact_state(scene, seen(near));
        state.chi = completion.state.chi;
        state.spin = state.ut = rests_still(scene, completion) ? 0 : edge_rate(scene, seen(near));
        return state;
    }
    double jacobi = 0;
    return without_normal_velocity(scene, seen(near), slip_of(scene, seen(base)), jacobi);
}

ChatterCompletion chatter_completion(const ContactScene& scene, const PostImpactState<double>& post_impact) {
    ChatterCompletion completion;
    const Touch here = touch_of(scene, post_impact);
    bool there_rests = false;
    bool there_approaches = false;
    PostImpactState<double> neighbour;
    Touch there{false, false, 0};
    if (!scene.is_disk()) {
        const double apart = std::abs(std::abs(std::atan2(post_impact.chi.y, post_impact.chi.x)) - scene.widest_chi);
        if (apart <= neighbour_tolerance) {
            neighbour = seen_from_neighbour(scene, post_impact);
            there = touch_of(scene, neighbour);
            there_rests = there.rests;
            there_approaches =
                !there.rests && apart <= chatter_tolerance && contact_kinematics(scene.body, neighbour).un > 0;
        }
    }
    const int step = post_impact.chi.y > 0 ? -1 : 1;
    if (here.rests && there_rests) {
        const bool clockwise = post_impact.chi.y < 0;
        completion = {true,
                      Support::edge,
                      contact_state(scene, clockwise ? post_impact : neighbour),
                      clockwise ? 0 : step,
                      std::max(here.error, there.error),
                      0};
        completion.state.chi = -scene.widest_chi;
        // The slip of one vertex includes the remaining rocking on the other.
        const bool still = scene.mu > 0 && (std::abs(completion.state.ut) <= velocity_rounding(scene, post_impact) ||
                                            slide_of(scene, completion.state) <= chatter_tolerance);
        completion.state.ut = completion.state.spin = still ? 0 : completion.state.ut;
        completion.jacobi =
            jacobi_of(scene.body, post_impact_state(scene, completion.state)) - jacobi_of(scene.body, post_impact);
    } else if (here.rests && here.pressed) {
        completion = {true, scene.is_disk() ? Support::rim : Support::vertex, {}, 0, here.error, 0};
        completion.state = landed(scene, post_impact, completion.jacobi);
        keep_neighbour_at_wall(scene, chatter_tolerance, completion.state);
    } else if (there_rests && there.pressed) {
        completion = {true, Support::vertex, {}, step, there.error, 0};
        completion.state = landed(scene, neighbour, completion.jacobi);
        keep_neighbour_at_wall(scene, neighbour_tolerance, completion.state);  // known only to its rebound
    } else {
        completion.struck = here.rests && there_approaches;
    }
    return completion;
}

}  // namespace swirl
