#include "map/dry/rim_motion.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace swirl {

namespace {

/// The reserve of rest is known to less than this, of a_f.
constexpr double at_border = 1e-7;

Vec2<double> swirl_at(const RimScene<double>& scene, double psi) {
    return {scene.body->beta * std::cos(psi), -scene.body->beta * std::sin(psi)};
}

/// The floor's largest force beside a torque, in a_f, and that torque in α a_f: of a disk that slides and spins at a
/// ratio |U| : α|S| = part : 1 − part.
struct Limit {
    double force, torque;
};

Limit limit_at(const RimScene<double>& scene, double part) {
    const Body<double>& body = *scene.body;
    const MeanSlip<double> mean =
        scene.pressure->mean_slip(body, {0.0, part}, (1 - part) / body.alpha, {body.alpha, 0.0});
    return {mean.direction.y, mean.moment / body.alpha};
}

bool is_at_rest(const RimScene<double>& scene, const ContactState<double>& z) {
    return scene.is_dish && z.ut == 0 && z.spin == 0;
}

/// A slip from rest: ρν″ : αS″ as ρν′ : αS, the ratio on which the floor's push depends, and to which ratios beside it
/// come.
struct SlipFromRest {
    RimMotion motion;
    double growth;  ///< of (ρν′, αS) in that direction
};

/// Without friction of the wall nothing turns the disk.
std::optional<SlipFromRest> slide_from_rest(const RimScene<double>& scene, double psi) {
    const double pull = swirl_at(scene, psi).y, growth = std::fabs(pull) - scene.deceleration;
    if (!(growth > 0)) return {};
    return SlipFromRest{{ContactMotion::sliding_forward, false, pull < 0 ? -1.0 : 1.0, 0}, growth};
}

std::optional<SlipFromRest> slip_from_rest(const RimScene<double>& scene, double psi, ContactMotion kind) {
    if (scene.mu == 0) return slide_from_rest(scene, psi);
    struct Begin {
        double across, growth;  ///< of (ρν″, αS′) across the direction of (ρν′, αS) and along it
        double slip;            ///< u_t′
    };
    const auto motion_at = [kind](double angle) { return RimMotion{kind, false, std::cos(angle), std::sin(angle)}; };
    const auto begin = [&](const RimMotion& motion) {
        const RimForces<double> forces = rim_forces(scene, motion, {psi, 0, 0, 0});
        const double turning = scene.body->alpha * forces.spin_rate, along = forces.ut_rate - turning;
        return Begin{motion.heading * turning - motion.turning * along,
                     motion.heading * along + motion.turning * turning, forces.ut_rate};
    };
    const auto across = [&](double angle) { return begin(motion_at(angle)).across; };
    constexpr int parts = 96;
    constexpr double first = 0.01;  // any: it keeps ratios that symmetry gives, 0, 1 and ∞, off the grid
    for (int k = 0; k < parts; ++k) {
        const double low = first + 2 * pi<double>() * k / parts, high = low + 2 * pi<double>() / parts;
        const double before = across(low), after = across(high);
        if (!(before > 0 && after < 0)) continue;  // else ratios beside it move away from it
        std::uintmax_t iterations = 80;
        const auto root = boost::math::tools::toms748_solve(across, low, high, before, after,
                                                            boost::math::tools::eps_tolerance<double>(50), iterations);
        const RimMotion motion = motion_at(root.first);
        const Begin at = begin(motion);
        if (at.growth > 0 && at.slip * motion.sense() > 0) return SlipFromRest{motion, at.growth};
    }
    return {};
}

std::optional<SlipFromRest> slip_from_rest(const RimScene<double>& scene, double psi) {
    const auto forward = slip_from_rest(scene, psi, ContactMotion::sliding_forward);
    if (forward || scene.mu == 0) return forward;
    return slip_from_rest(scene, psi, ContactMotion::sliding_backward);
}

RimChoice from_rest(const RimScene<double>& scene, const ContactState<double>& z, bool broken) {
    RimMotion rest;
    rest.rests = true;
    if (!broken && rest_on_rim(scene, z.psi).reserve >= 0) return {true, rest};
    const Vec2<double> swirl = swirl_at(scene, z.psi);
    if (swirl.x <= 0) return {};  // and |w| > a_f: the floor alone would hold it
    const double heading = swirl.y < 0 ? -1 : 1;
    const RimMotion rolling{ContactMotion::sticking, false, heading, -heading};
    const RimForces<double> forces = rim_forces(scene, rolling, z);
    const bool is_held = scene.mu > 0 && std::fabs(forces.friction) <= scene.mu * forces.normal;
    if (is_held && -heading * forces.spin_rate > 0) return {true, rolling};
    if (const auto slip = slip_from_rest(scene, z.psi)) return {true, slip->motion};
    // Within rounding of the border it rests on, until what follows surely begins.
    const bool is_at_border = std::fabs(rest_on_rim(scene, z.psi).reserve) < at_border * scene.deceleration;
    return {is_at_border, rest, is_at_border};
}

}  // namespace

Creep creep_from_rest(const RimScene<double>& scene, const RimMotion& motion, double psi, double time) {
    Creep creep;
    RimMotion last = motion;
    const auto growth = [&](double later) {
        const auto slip = slip_from_rest(scene, psi - later, motion.motion);
        if (slip) last = slip->motion;
        return slip ? slip->growth : 0.0;
    };
    double size = 0;
    if (time > 0) size = boost::math::quadrature::gauss<double, 7>::integrate(growth, 0.0, time);
    growth(time);
    creep.time = time;
    creep.spin = size * last.turning / scene.body->alpha;
    creep.ut = size * (last.heading + last.turning);
    return creep;
}

double creep_lasts(const RimScene<double>& scene, const RimMotion& motion, double psi) {
    constexpr double soon = 1e-4;  // in which the growth's rate hardly changes, nor is lost in rounding
    const auto growth = [&](double later) {
        const auto slip = slip_from_rest(scene, psi - later, motion.motion);
        return slip ? slip->growth : 0.0;
    };
    const double size = 1e-6 * scene.deceleration, now = growth(0), rate = std::max(0.0, (growth(soon) - now) / soon);
    const double sum = now + std::sqrt(now * now + 2 * rate * size);  // now t + ½ rate t² = size
    constexpr double longest = 0.01;  // in which ψ, and with it the growth's rate, hardly changes
    return sum > 0 ? std::min(2 * size / sum, longest) : longest;
}

RimRest rest_on_rim(const RimScene<double>& scene, double psi) {
    const Vec2<double> swirl = swirl_at(scene, psi);
    const double a = scene.deceleration, sign = swirl.y > 0 ? -1 : 1;
    const auto held_by = [&](double friction, double force) {
        const double least = scene.mu > 0 ? std::fabs(friction) / scene.mu : 0.0;
        const double normal = std::max({swirl.x, least, 0.0});
        return RimRest{force - std::hypot(normal - swirl.x, swirl.y + friction), normal, friction};
    };
    const RimRest without = held_by(0, a);
    if (scene.mu == 0 || without.reserve >= 0) return without;
    const auto at = [&](double part) {
        const Limit limit = limit_at(scene, part);
        return held_by(sign * a * limit.torque, a * limit.force);
    };
    RimRest best = without;
    const auto take = [&](const RimRest& rest) {
        if (rest.reserve > best.reserve) best = rest;
    };
    std::uintmax_t iterations = 60;
    const auto minus = [&](double p) { return -at(p).reserve; };
    take(at(boost::math::tools::brent_find_minima(minus, 0.0, 1.0, 30, iterations).first));
    // Where more friction needs more than w_n to press it the reserve has a kink, and is not flat at its largest.
    const auto short_of_kink = [&](double p) { return scene.mu * swirl.x - a * limit_at(scene, p).torque; };
    if (swirl.x > 0 && short_of_kink(0) < 0) {
        iterations = 60;
        take(at(boost::math::tools::toms748_solve(short_of_kink, 0.0, 1.0,
                                                  boost::math::tools::eps_tolerance<double>(52), iterations)
                    .second));
    }
    return best;
}

RimChoice choose_rim_motion(const RimScene<double>& scene, const ContactState<double>& z, bool broken) {
    if (is_at_rest(scene, z)) return from_rest(scene, z, broken);
    RimMotion motion;
    motion.heading = along_wall(scene, z) < 0 ? -1 : 1;
    if (scene.mu == 0 || z.ut != 0) {
        motion.motion = scene.mu > 0 && z.ut < 0 ? ContactMotion::sliding_backward : ContactMotion::sliding_forward;
        return {rim_forces(scene, motion, z).normal >= 0, motion};
    }
    const RimForces<double> rolling = rim_forces(scene, motion, z);
    if (!(rolling.normal >= 0)) return {};
    if (!broken && std::fabs(rolling.friction) <= scene.mu * rolling.normal) return {true, motion};
    motion.motion = rolling.friction < 0 ? ContactMotion::sliding_forward : ContactMotion::sliding_backward;
    return {true, motion};
}

RimMotion rim_motion_at(const RimScene<double>& scene, ContactMotion motion, const ContactState<double>& z) {
    if (is_at_rest(scene, z)) {
        if (motion == ContactMotion::sticking) return from_rest(scene, z, false).motion;
        if (const auto slip = slip_from_rest(scene, z.psi, motion)) return slip->motion;
    }
    return {motion, false, along_wall(scene, z) < 0 ? -1.0 : 1.0, 0};
}

}  // namespace swirl
