#include "map/contact/rim_pendulum.hpp"

#include "map/contact/reaction.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace swirl {

namespace {

using boost::math::ellint_1;

/// ψ′ at ψ, on the way in `direction`.
double rate_at(const RimPendulum& p, double psi, double direction) {
    const double s = std::sin(0.5 * psi);
    return direction * std::sqrt(std::max(0.0, 2 * p.height - 4 * p.strength * s * s));
}

double hold_at(const ContactScene<double>& scene, const RimPendulum& p, double psi, double direction) {
    const Body<double>& body = scene.body;
    const double turning = 1 + rate_at(p, psi, direction);
    const double normal = body.beta * std::cos(psi) + body.inner * turning * turning;
    if (!p.rolls) return normal;
    const double kappa = scene.inertia_factor();
    return scene.mu * normal - kappa / (1 + kappa) * body.beta * std::abs(std::sin(psi));
}

/// The minimum over ψ from 0 to `widest` (it is even in ψ): the least of equally spaced values, refined.
double least_of_way(const ContactScene<double>& scene, const RimPendulum& p, double widest, double direction) {
    constexpr int parts = 32;
    const auto hold = [&](double psi) { return hold_at(scene, p, psi, direction); };
    double least = hold(widest);
    int best = parts;
    for (int i = 0; i < parts; ++i)
        if (const double value = hold(widest * i / parts); value < least) least = value, best = i;
    const double low = widest * std::max(0, best - 1) / parts, high = widest * std::min(parts, best + 1) / parts;
    std::uintmax_t iterations = 40;
    return std::min(least, boost::math::tools::brent_find_minima(hold, low, high, 26, iterations).second);
}

}  // namespace

RimPendulum rim_pendulum(const ContactScene<double>& scene, const ContactState<double>& state) {
    const bool rolls = scene.mu > 0;
    const double rate = normal_rate(scene, Support::rim, state) - 1, s = std::sin(0.5 * state.psi);
    const double strength = scene.body.beta * scene.body.inverse_inner / (rolls ? 1 + scene.inertia_factor() : 1);
    return {rolls, strength, 0.5 * rate * rate + 2 * strength * s * s, rate < 0 ? -1.0 : 1.0};
}

double period_of(const RimPendulum& p) {
    const double omega = std::sqrt(p.strength), size = std::sqrt(p.height / 2);  // ω√m
    if (p.height == 2 * p.strength) return std::numeric_limits<double>::infinity();
    return p.turns() ? 2 * ellint_1(omega / size) / size : 4 * ellint_1(size / omega) / omega;
}

double mean_rolling_spin(const ContactScene<double>& scene, const RimPendulum& p) {
    const double mean_rate = p.turns() ? p.direction * 2 * pi<double>() / period_of(p) : 0;
    return -(scene.body.inner / scene.body.alpha) * (1 + mean_rate);
}

double least_hold(const ContactScene<double>& scene, const RimPendulum& p) {
    if (p.turns()) return least_of_way(scene, p, pi<double>(), p.direction);
    const double widest = p.strength > 0 ? 2 * std::asin(std::min(1.0, std::sqrt(p.height / (2 * p.strength)))) : 0;
    return std::min(least_of_way(scene, p, widest, 1), least_of_way(scene, p, widest, -1));
}

std::optional<RimPendulum> settled_pendulum(const ContactScene<double>& scene, const RimPendulum& pendulum) {
    const auto with = [&](double height) {
        RimPendulum p = pendulum;
        p.height = height;
        return p;
    };
    const auto hold = [&](double height) { return least_hold(scene, with(height)); };
    if (hold(pendulum.height) >= 0) return pendulum;
    // Downwards by small steps, to the separatrix or to rest.
    constexpr int parts = 64;
    const double lowest = pendulum.turns() ? 2 * pendulum.strength * (1 + 1e-12) : 0;
    double above = pendulum.height;
    for (int i = 1; i <= parts; ++i) {
        const double below = pendulum.height + (lowest - pendulum.height) * i / parts;
        if (hold(below) < 0) {
            above = below;
            continue;
        }
        std::uintmax_t iterations = 80;
        const auto [low, high] = boost::math::tools::toms748_solve(
            hold, below, above, boost::math::tools::eps_tolerance<double>(45), iterations);
        return with(low);
    }
    return {};
}

ContactState<double> advance_rim(const ContactScene<double>& scene, const ContactState<double>& state, double time) {
    const RimPendulum p = rim_pendulum(scene, state);
    const double omega = std::sqrt(p.strength), size = std::sqrt(p.height / 2);
    const double half = 0.5 * state.psi, whole = std::floor(half / pi<double>() + 0.5);
    double psi = state.psi, rate = 0, cn = 0, dn = 0;
    if (p.strength == 0) {
        rate = 2 * p.direction * size;
        psi += rate * time;
    } else if (p.turns()) {
        const double m = omega / size, quarter = ellint_1(m);
        const double u = p.direction * ellint_1(m, half - pi<double>() * whole) + size * time;
        const double turns = std::floor(u / (2 * quarter) + 0.5);
        const double sn = boost::math::jacobi_elliptic(m, u - 2 * quarter * turns, &cn, &dn);
        psi = 2 * (pi<double>() * (whole + p.direction * turns) + p.direction * std::asin(sn));
        rate = 2 * p.direction * size * dn;
    } else if (p.height > 0) {
        const double m = size / omega;
        const double start_rate = normal_rate(scene, Support::rim, state) - 1;
        const double u =
            ellint_1(m, std::atan2(std::sin(half - pi<double>() * whole) / m, start_rate / (2 * size))) + omega * time;
        const double quarter = ellint_1(m);
        const double sn = boost::math::jacobi_elliptic(m, u - 4 * quarter * std::floor(u / (4 * quarter)), &cn, &dn);
        psi = 2 * (pi<double>() * whole + std::asin(m * sn));
        rate = 2 * size * cn;
    }
    const double turning = scene.body.inner * (1 + rate);  // u_t − αS
    if (p.rolls) return {psi, 0, 0, -turning / scene.body.alpha};
    return {psi, 0, turning + scene.body.alpha * state.spin, state.spin};
}

}  // namespace swirl
