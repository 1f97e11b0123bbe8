// A disk on the wall is a pendulum: the integrated contact and the closed forms against Jacobi's functions.
#include "map/contact/rim_pendulum.hpp"
#include "map/contact/contact_phase.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace swirl {
namespace {

using tests::contact_of;

Scene<double> scene_of(int sides, double alpha, double beta, double mu, double e, Law law = Law::poisson) {
    return tests::uniform_scene(sides, alpha, beta, mu, e, law);
}

/// ψ at time t of ψ″ = −ω² sin ψ from ψ = 0 with ψ′ = 2ωk, k < 1 (libration) or > 1 (circulation).
double pendulum(double omega, double k, double t) {
    double cn, dn;
    if (k < 1) return 2 * std::asin(k * boost::math::jacobi_elliptic(k, omega * t, &cn, &dn));
    // sin(ψ/2) = sn(ωk t, 1/k); the number of half turns from the period.
    const double quarter = boost::math::ellint_1(1 / k) / (omega * k);  // ψ: 0 → π
    const double turns = std::floor((t + quarter) / (2 * quarter));
    const double rest = t - 2 * quarter * turns;
    return 2 * pi<double>() * turns + 2 * std::asin(boost::math::jacobi_elliptic(1 / k, omega * k * rest, &cn, &dn));
}

TEST(DiskInContact, IsAPendulumForAHundredPeriods) {
    for (const double mu : {0.0, 5.0})
        for (const double k : {0.1, 0.7, 0.99, 1.2}) {
            const auto scene = contact_of(scene_of(disk_sides, 0.4, 0.05, mu, 0.5));
            const double rho = 0.6, kappa = 0.5;
            const double omega = std::sqrt(0.05 / (rho * (mu > 0 ? 1 + kappa : 1)));
            // Circulating with ψ′ > 0, λ > 0 all the time.
            ContactState<double> z{0, 0, 0, mu > 0 ? 0 : 0.7};
            const double rate = 2 * omega * k;
            if (mu > 0)
                z.spin = -rho * (1 + rate) / 0.4;
            else
                z.ut = rho * (1 + rate) + 0.4 * z.spin;
            const auto motion = mu > 0 ? ContactMotion::sticking : ContactMotion::sliding_forward;
            const double period = 4 * boost::math::ellint_1(k < 1 ? k : 1 / k) / (omega * std::max(1.0, k));
            double largest = 0;
            const auto end = run_contact(
                scene, Support::rim, motion, z, 100 * period,
                [&](const ContactSums<double>& sums, Support, ContactMotion, const ContactState<double>& at) {
                    largest = std::max(largest, std::abs(at.psi - pendulum(omega, k, sums.time)));
                });
            EXPECT_EQ(end.event, ContactEvent::horizon) << name_of(end.event);
            std::printf("disk, mu = %g, k = %g: largest error of psi over 100 periods %.1e\n", mu, k, largest);
            // Near the separatrix (k = 0.99) a rounding of the start grows with time like the period's derivative does.
            EXPECT_LE(largest, 1e-10);
            if (mu > 0)
                EXPECT_NEAR(end.state.spin, -rho * (1 + (normal_rate(scene, Support::rim, end.state) - 1)) / 0.4,
                            1e-12);
            else
                EXPECT_EQ(end.state.spin, 0.7);
        }
}

TEST(DiskInContact, LibratesWithTheExactMeanSpin) {
    const auto scene = contact_of(scene_of(disk_sides, 0.4, 0.3, 5, 0.5));
    const double omega = std::sqrt(0.3 / 0.9), k = 0.6;
    const double period = 4 * boost::math::ellint_1(k) / omega;
    const auto end = run_contact(scene, Support::rim, ContactMotion::sticking, {0, 0, 0, -1.5 * (1 + 2 * omega * k)},
                                 50 * period, [](const auto&...) {});
    EXPECT_NEAR(end.sums.turned / end.sums.time, -1.5, 1e-12);
}

TEST(DiskInContact, IsReleasedWhereTheNormalForceVanishes) {
    // λ = β cos ψ + ρ(1 + ψ′)² with ψ′² = 2(H + ω² cos ψ), ψ′ < 0 on the way: both roots in closed form but for one
    // solve.
    for (const double mu : {0.0, 50.0}) {
        const double beta = 2, rho = 0.6, omega2 = beta / (rho * (mu > 0 ? 1.5 : 1));
        const auto scene = contact_of(scene_of(disk_sides, 0.4, beta, mu, 0.5));
        const double start_rate = -1.7 * std::sqrt(omega2);
        const double energy = 0.5 * start_rate * start_rate - omega2;
        const auto rate_at = [&](double psi) { return -std::sqrt(2 * (energy + omega2 * std::cos(psi))); };
        const auto lambda = [&](double psi) { return beta * std::cos(psi) + rho * std::pow(1 + rate_at(psi), 2); };
        std::uintmax_t iterations = 100;
        const auto [a, b] = boost::math::tools::toms748_solve(
            lambda, -1.87, -0.5, boost::math::tools::eps_tolerance<double>(52), iterations);
        ContactState<double> z{0, 0, 0, mu > 0 ? -rho * (1 + start_rate) / 0.4 : 0};
        if (mu == 0) z.ut = rho * (1 + start_rate);
        const auto motion = mu > 0 ? ContactMotion::sticking : ContactMotion::sliding_forward;
        const auto end = run_contact(scene, Support::rim, motion, z, 100);
        if (mu > 0) {  // friction ceases to hold just before: μλ = |f|
            EXPECT_EQ(end.event, ContactEvent::slip);
            continue;
        }
        ASSERT_EQ(end.event, ContactEvent::release);
        EXPECT_NEAR(end.state.psi, 0.5 * (a + b), 1e-11);
        // t = ∫ dψ/ψ′ = F(φ, k)/ω with sin φ = sin(ψ/2)/k
        const double k = std::abs(start_rate) / (2 * std::sqrt(omega2));
        const double time = boost::math::ellint_1(k, std::asin(std::sin(-end.state.psi / 2) / k)) / std::sqrt(omega2);
        EXPECT_NEAR(end.sums.time, time, 1e-10);
        std::printf("release at psi = %.12f, t = %.12f\n", end.state.psi, end.sums.time);
    }
}

// ---- closed forms

/// A disk's state in contact with ψ′ = rate: rolling, or without friction at a spin.
ContactState<double> state_on_rim(const ContactScene<double>& scene, double psi, double rate, double spin) {
    const double turning = scene.body.inner * (1 + rate), alpha = scene.body.alpha;
    if (scene.mu > 0) return {psi, 0, 0, -turning / alpha};
    return {psi, 0, turning + alpha * spin, spin};
}

TEST(RimPendulum, InClosedFormIsWhatIntegrationFinds) {
    tests::Random random(17);
    const long cases = tests::sample_count(400);
    long lasting = 0, turning = 0;
    double worst = 0;
    for (long i = 0; i < cases; ++i) {
        const double mu = i % 3 == 0 ? 0 : 5, alpha = random.between(0.05, 0.97), beta = random.between(0, 1);
        const auto scene = contact_of(scene_of(disk_sides, alpha, beta, mu, 0.5));
        const ContactState<double> z =
            state_on_rim(scene, random.between(-9, 9), random.between(-6, 6), random.between(-1, 1));
        const RimPendulum pendulum = rim_pendulum(scene, z);
        if (!(least_hold(scene, pendulum) > 1e-3)) continue;
        const auto motion = mu > 0 ? ContactMotion::sticking : ContactMotion::sliding_forward;
        const double time = 200;
        const auto seen = run_contact(scene, Support::rim, motion, z, time, [](const auto&...) {}),
                   by_pendulum = run_contact(scene, Support::rim, motion, z, time);
        ASSERT_EQ(seen.event, ContactEvent::horizon);
        EXPECT_EQ(by_pendulum.steps, 1);
        // An error of ψ grows along the orbit with dψ/dh t: with the number of swings, and faster near the separatrix.
        const double near = std::abs(pendulum.height / (2 * pendulum.strength) - 1);
        const double scale = (1 + std::sqrt(pendulum.height) * time) / std::min(1.0, near);
        const double difference =
            std::max({std::abs(seen.state.psi - by_pendulum.state.psi), std::abs(seen.state.ut - by_pendulum.state.ut),
                      std::abs(seen.state.spin - by_pendulum.state.spin) * alpha,
                      std::abs(seen.sums.turned - by_pendulum.sums.turned) * alpha,
                      std::abs(seen.sums.work - by_pendulum.sums.work)});
        worst = std::max(worst, difference / scale);
        ++lasting;
        turning += pendulum.turns();
    }
    std::printf("%ld lasting contacts (%ld turn on): largest difference after 200 units of time %.1e per turn\n",
                lasting, turning, worst);
    EXPECT_GE(lasting, cases / 8);
    EXPECT_GE(turning, cases / 20);
    EXPECT_LE(worst, 1e-13);
}

TEST(RimPendulum, HasTheMeanSpinThatIntegrationFinds) {
    double worst = 0;
    for (const double alpha : {0.1, 0.35, 0.62})
        for (const double rate : {-9.0, -0.5, 0.02, 4.0}) {
            const auto scene = contact_of(scene_of(disk_sides, alpha, 0.05, 50, 0.5));
            const ContactState<double> z = state_on_rim(scene, 0, rate, 0);
            const RimPendulum pendulum = rim_pendulum(scene, z);
            const double period = period_of(pendulum);
            const auto end =
                run_contact(scene, Support::rim, ContactMotion::sticking, z, 10 * period, [](const auto&...) {});
            ASSERT_EQ(end.event, ContactEvent::horizon);
            const double mean = mean_rolling_spin(scene, pendulum);
            worst = std::max(worst, std::abs(end.sums.turned / end.sums.time - mean) / (1 + std::abs(mean)));
        }
    std::printf("mean S of a rolling disk: largest difference %.1e\n", worst);
    EXPECT_LE(worst, 1e-13);
}

/// The slips on either side of ψ = 0 cancel to leading order, O(x^{3/2}) in the missing share x of friction; the rest,
/// O(x²) per period, lowers the energy to where friction just holds, like 1/n in n periods.
TEST(RimPendulum, IsSettledOnWhereFrictionJustHolds) {
    for (const double alpha : {0.1, 0.15, 0.35, 0.62}) {
        const auto scene = contact_of(scene_of(disk_sides, alpha, 0.05, 0.4, 0));
        const ContactState<double> z = state_on_rim(scene, 0, -0.85, 0);
        const auto limit = settled_pendulum(scene, rim_pendulum(scene, z));
        ASSERT_TRUE(limit);
        ASSERT_TRUE(limit->turns());
        EXPECT_NEAR(least_hold(scene, *limit), 0, 1e-12);
        double before = 0;
        std::printf("alpha = %g, mean S of the limit %.9f, energy above it:", alpha, mean_rolling_spin(scene, *limit));
        for (const double time : {1e3, 1e4, 1e5}) {
            const ContactPhase<double> phase =
                follow_contact(scene, {true, Support::rim, z, 0, 0, 0}, time, {}, 10 * most_contact_steps);
            ASSERT_EQ(phase.finish, ContactEvent::horizon);
            double above = 0;  // the mean of the last two pieces of rolling, on either side
            for (std::size_t k = phase.segments.size() - 5, found = 0; found < 2; ++k)
                if (phase.segments[k].motion == ContactMotion::sticking) {
                    above += 0.5 * (rim_pendulum(scene, phase.segments[k].from).height - limit->height);
                    ++found;
                }
            std::printf(" %.2e (t = %g)", above, time);
            EXPECT_GT(above, 0);
            if (time > 1e4) {
                EXPECT_NEAR(above / before, 0.1, 0.02);
            }
            before = above;
        }
        std::printf("\n");
    }
}

}  // namespace
}  // namespace swirl
