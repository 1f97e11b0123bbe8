// β = 0: the disk in a container at rest is the circular billiard of radius 1 − α, exact.
#include "map/collision_map.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace swirl {
namespace {

using tests::Random;

constexpr double eps = 0x1p-52;

Scene<double> still_disk(double alpha, double mu, double restitution) {
    return {disk_sides, alpha, 0.0, mu, restitution, Law::poisson, 0.5};
}

/// From v = |v|(−cos γ, sin γ): every chord takes 2(1 − α) cos γ/|v|, turns n by π − 2γ, and changes nothing else.
TEST(CircularBilliard, FrictionlessElasticDiskKeepsItsAngleOfIncidence) {
    Random random(11);
    const int impacts = 2000;
    const long orbits = tests::sample_count(200);
    double worst = 0;
    for (long i = 0; i < orbits; ++i) {
        const Scene<double> scene = still_disk(random.between(0.01, 0.99), 0, 1);
        const CollisionMap<double, Shape::disk, ImpactRule::frictionless> map(scene);
        const double speed = random.log_between(1e-3, 10), gamma = random.between(-1.5, 1.5),
                     spin = random.between(-5, 5);
        const double time = 2 * (1 - scene.alpha) * std::cos(gamma) / speed;
        const double advance = M_PI - 2 * gamma;
        PostImpactState<double> post_impact =
            post_impact_state(SectionPoint<double>{0.3, 0, -speed * std::cos(gamma), speed * std::sin(gamma), spin});
        for (int k = 1; k <= impacts; ++k) {
            const auto step = map.advance(post_impact);
            ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
            post_impact = step.after;
            // Each impact adds a few ε to the direction, which a chord turns into a time by its slope.
            const double allowed = 32 * eps * k / std::cos(gamma);
            const double error =
                std::max({std::fabs(wrapped_angle(std::atan2(step.normal.y, step.normal.x) - advance)),
                          std::fabs(step.flight_time / time - 1), std::fabs(post_impact.vn / speed + std::cos(gamma)),
                          std::fabs(post_impact.vt / speed - std::sin(gamma))});
            ASSERT_LE(error, allowed) << "impact " << k << ", gamma " << gamma;
            ASSERT_EQ(post_impact.spin, spin);
            worst = std::max(worst, error);
        }
        const double psi = 0.3 + impacts * (advance - time);
        const double psi_error = std::fabs(wrapped_angle(section_point(post_impact).psi - psi));
        ASSERT_LE(psi_error, 64 * eps * impacts * (impacts + std::fabs(time)) / std::cos(gamma));
    }
    std::printf("%ld orbits of %d impacts, largest error in an impact %.1e\n", orbits, impacts, worst);
}

/// With e < 1 only v_n shrinks, by e at every impact: to rounding a geometric sequence.
TEST(CircularBilliard, RestitutionShrinksTheNormalVelocityGeometrically) {
    Random random(12);
    for (long i = 0; i < tests::sample_count(200); ++i) {
        const Scene<double> scene = still_disk(random.between(0.01, 0.99), 0, random.between(0.5, 1));
        const CollisionMap<double, Shape::disk, ImpactRule::frictionless> map(scene);
        const double vn = -random.between(0.1, 2), vt = random.between(-2, 2);
        PostImpactState<double> post_impact = post_impact_state(SectionPoint<double>{0, 0, vn, vt, 0});
        double expected = vn;
        for (int k = 1; k <= 10; ++k) {
            const double chord = -2 * (1 - scene.alpha) * post_impact.vn /
                                 (post_impact.vn * post_impact.vn + post_impact.vt * post_impact.vt);
            const auto step = map.advance(post_impact);
            ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
            post_impact = step.after;
            expected *= scene.restitution;
            const double allowed = 64 * eps * k * std::hypot(vn, vt);
            EXPECT_NEAR(post_impact.vn, expected, allowed);
            EXPECT_NEAR(post_impact.vt, vt, allowed);
            EXPECT_NEAR(step.flight_time, chord, 64 * eps * chord * (1 + std::fabs(vt / post_impact.vn)));
        }
    }
}

/// With friction and e = 1: |v_n| and v_t − κα S are conserved, |u_t| never grows, and once slip has stopped
/// v_t = −αS = (v_t − κα S)₀/(1 + κ) from then on.
TEST(CircularBilliard, FrictionConservesAngularMomentumAboutTheWallAndEndsInRolling) {
    Random random(13);
    const long orbits = tests::sample_count(500);
    const int impacts = 400;
    long rolling = 0;
    for (long i = 0; i < orbits; ++i) {
        const Scene<double> scene = still_disk(random.between(0.05, 0.95), random.log_between(0.05, 3), 1);
        const CollisionMap<double, Shape::disk, ImpactRule::poisson> map(scene);
        const double vn = -random.between(0.3, 2), vt = random.between(-2, 2), spin = random.between(-3, 3);
        const double conserved = vt - 0.5 * scene.alpha * spin;
        PostImpactState<double> post_impact = post_impact_state(SectionPoint<double>{0, 0, vn, vt, spin});
        double slip = std::fabs(vt + scene.alpha * spin);
        for (int k = 1; k <= impacts; ++k) {
            const auto step = map.advance(post_impact);
            ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
            post_impact = step.after;
            const double allowed = 64 * eps * k * 4;
            ASSERT_NEAR(post_impact.vn, vn, allowed * (1 + std::fabs(vt / vn)));
            ASSERT_NEAR(post_impact.vt - 0.5 * scene.alpha * post_impact.spin, conserved, allowed);
            const double now = std::fabs(post_impact.vt + scene.alpha * post_impact.spin);
            ASSERT_LE(now, slip + allowed);
            slip = now;
        }
        if (slip > 1e-10) continue;
        ++rolling;
        EXPECT_NEAR(post_impact.vt, conserved / 1.5, 1e-10);
        EXPECT_NEAR(post_impact.spin, -conserved / 1.5 / scene.alpha, 1e-10 / scene.alpha);
    }
    std::printf("%ld orbits, %ld of them without slip after %d impacts\n", orbits, rolling, impacts);
    EXPECT_EQ(rolling, orbits);  // Δu_t ≥ 3 · 0.05 · 2 · 0.3 per impact: at most 60 of them slip
}

}  // namespace
}  // namespace swirl
