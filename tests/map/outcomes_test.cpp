// Endings other than an ordinary contact: none, sustained, two at once; and no hang on the way.
#include "map/orbit/orbit.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace swirl {
namespace {

Scene<double> scene_of(int sides, double alpha, double beta, double mu = 0, double e = 1, Law law = Law::poisson) {
    return {sides, alpha, beta, mu, e, law, uniform_inertia_factor<double>(sides)};
}

Collision<double> first_impact(const Scene<double>& scene, const LabStart<double>& start) {
    return with_collision_map(scene, [&](const auto& map) { return map.advance(flight_from(map.body(), start)); });
}

TEST(Outcome, ABodyAtRestThatTheSwirlDoesNotReachHasNoContact) {
    for (const int sides : {disk_sides, 3, 6, 1000})
        for (const double spin : {0.0, 1.0, -2.0, 0.3, 17.77})
            EXPECT_EQ(first_impact(scene_of(sides, 0.4, 0.3), {0, 0, 0, 0, 0.1, spin}).outcome,
                      FirstContactOutcome::no_contact)
                << "N = " << sides << ", S = " << spin;
}

TEST(Outcome, ABodyAtRestThatTheSwirlReachesIsStruck) {
    // The disk at rest at distance d from the swirl's centre is struck if d + β > 1 − α.
    const auto collision = first_impact(scene_of(disk_sides, 0.4, 0.3), {0.301, 0, 0, 0, 0, 0});
    ASSERT_EQ(collision.outcome, FirstContactOutcome::contact);
    // |X|² = d² + β² − 2dβ cos t = (1 − α)²
    const double expected = std::acos((0.301 * 0.301 + 0.09 - 0.36) / (2 * 0.301 * 0.3));
    EXPECT_NEAR(collision.flight_time, expected, 1e-13);
    EXPECT_EQ(first_impact(scene_of(disk_sides, 0.4, 0.3), {0.299, 0, 0, 0, 0, 0}).outcome,
              FirstContactOutcome::no_contact);
}

TEST(Outcome, ARestingPolygonWithAWholeNumberOfTurnsPerTurnRecurs) {
    // Outside the shelter |P| < 1 − α − β, so that only the periodicity of body and swirl proves that nothing will
    // touch: an edge passes.
    long none = 0, struck = 0;
    for (const int spin : {-3, -2, -1, 0, 1, 2, 3})
        for (int i = 0; i < 60; ++i) {
            const LabStart<double> start{0.31, 0, 0, 0, 2 * M_PI / 3 * i / 60, static_cast<double>(spin)};
            const auto collision = first_impact(scene_of(3, 0.4, 0.3), start);
            (collision.outcome == FirstContactOutcome::contact ? struck : none) += 1;
            ASSERT_TRUE(collision.outcome == FirstContactOutcome::contact ||
                        collision.outcome == FirstContactOutcome::no_contact);
            // Independent: one turn, sampled.
            double farthest = 0;
            for (int k = 0; k < 3; ++k)
                for (int s = 0; s <= 20000; ++s) {
                    const double t = 2 * M_PI * s / 20000, a = start.angle + spin * t + 2 * M_PI * k / 3;
                    farthest = std::max(farthest, std::hypot(0.31 + 0.4 * std::cos(a) - 0.3 * std::cos(t),
                                                             0.4 * std::sin(a) - 0.3 * std::sin(t)));
                }
            if (std::fabs(farthest - 1) > 1e-6) {
                EXPECT_EQ(collision.outcome == FirstContactOutcome::contact, farthest > 1);
            }
        }
    std::printf("%ld resting triangles are struck, %ld never\n", struck, none);
    EXPECT_GT(struck, 0);
    EXPECT_GT(none, 0);
}

TEST(Outcome, AStillContainerAndABodyAtRest) {
    EXPECT_EQ(first_impact(scene_of(disk_sides, 0.4, 0), {0.3, 0, 0, 0, 0, 5}).outcome,
              FirstContactOutcome::no_contact);
    EXPECT_EQ(first_impact(scene_of(5, 0.4, 0), {0.3, 0, 0, 0, 0, 5}).outcome, FirstContactOutcome::no_contact);
    EXPECT_EQ(first_impact(scene_of(5, 0.4, 0), {0.3, 0, 0, 0, 0, 0}).outcome, FirstContactOutcome::no_contact);
    // Beyond the shelter a turning polygon strikes with a vertex: here the one at π turns to 0.
    const auto collision = first_impact(scene_of(3, 0.4, 0), {0.605, 0, 0, 0, M_PI, 0.5});
    ASSERT_EQ(collision.outcome, FirstContactOutcome::contact);
    // |x|² = d² + α² + 2dα cos θ = 1 of the vertex at θ = π + 4π/3 − 2π = π/3, which comes down to … from −π/3 up.
    const double at = std::acos((1 - 0.605 * 0.605 - 0.16) / (2 * 0.605 * 0.4));
    EXPECT_NEAR(collision.flight_time, (M_PI / 3 - at) / 0.5, 1e-12);
}

TEST(Outcome, WithoutRestitutionContactIsSustainedUnlessTheWallFallsAway) {
    long sustained = 0, released = 0;
    for (int i = 0; i < 200; ++i) {
        const double psi = -M_PI + 2 * M_PI * (i + 0.5) / 200;
        const Scene<double> scene = scene_of(disk_sides, 0.4, 2, 0, 0);
        const CollisionMap<double, Shape::disk, ImpactRule::frictionless> map(scene);
        // Just after an impact with e = 0: u_n = 0. Then g″/2 = |W|² + X·w = u_t² (less the spin) + ρβ cos ψ.
        SectionPoint<double> z{psi, 0, 2 * std::sin(psi), 2 * std::cos(psi) + 0.3, 0};
        const double curvature = 0.3 * 0.3 + 0.6 * 2 * std::cos(psi);
        const auto step = map.advance(post_impact_state(z));
        if (curvature > 1e-6) {
            EXPECT_EQ(step.outcome, FirstContactOutcome::sustained) << psi;
            ++sustained;
        } else if (curvature < -1e-6) {
            EXPECT_EQ(step.outcome, FirstContactOutcome::contact) << psi;
            EXPECT_GT(step.flight_time, 0) << psi;
            ++released;
        }
    }
    std::printf("e = 0: %ld sustained, %ld released\n", sustained, released);
    EXPECT_GE(sustained, 50);
    EXPECT_GE(released, 50);
}

/// The impacts of e = 0 themselves, from flight to sustained contact or release.
TEST(Outcome, EveryLawEndsWithoutNormalVelocityAtZeroRestitution) {
    for (const Law law : {Law::poisson, Law::newton, Law::stronge})
        for (const int sides : {3, 6}) {
            const Scene<double> scene = scene_of(sides, 0.4, 0.3, 0.4, 0, law);
            with_collision_map(scene, [&](const auto& map) {
                auto step = map.advance(flight_from(map.body(), LabStart<double>{0.3, 0, 0.7, 0.2, 0.1, 0.4}));
                ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
                EXPECT_NEAR(contact_kinematics(map.body(), step.after).un, 0, 1e-15);
                step = map.advance(step.after);
                EXPECT_TRUE(step.outcome == FirstContactOutcome::sustained ||
                            step.outcome == FirstContactOutcome::contact);
            });
        }
}

TEST(Outcome, TwoVerticesHeadOnAreFlaggedSimultaneous) {
    const Scene<double> square = scene_of(4, 0.5, 0);
    for (const double quarter : {0.0, 0.5, 1.0, 1.5}) {
        const double direction = quarter * M_PI;
        const LabStart<double> start{0, 0, 0.3 * std::cos(direction), 0.3 * std::sin(direction), direction + M_PI / 4,
                                     0};
        const auto collision = first_impact(square, start);
        ASSERT_EQ(collision.outcome, FirstContactOutcome::contact);
        EXPECT_TRUE(collision.simultaneous) << direction;
        const double across = 0.5 * std::sqrt(0.5);
        EXPECT_NEAR(collision.flight_time, (std::sqrt(1 - across * across) - across) / 0.3, 1e-14);
    }
    // An exact tie, in numbers that are mirror images to the last bit: equal u_n, so the lower number.
    const auto tie = first_impact(square, {0, 0, 0.3, 0, M_PI / 4, 0});
    EXPECT_EQ(tie.vertex_step, 0);
    // Slightly off symmetry only one vertex strikes.
    EXPECT_FALSE(first_impact(square, {0, 0, 0.3, 0, M_PI / 4 + 1e-6, 0}).simultaneous);
}

TEST(Outcome, VerySlowBodiesComeToAnEnd) {
    int most = 0;
    for (const int sides : {disk_sides, 3, 6, 1000})
        for (const double beta : {0.0, 0.1, 0.6, 5.0})
            for (const double speed : {1e-3, 1e-6, 1e-9, 1e-12})
                for (const double spin : {0.0, 1.0, 0.37}) {
                    const auto collision =
                        first_impact(scene_of(sides, 0.4, beta), {0.9 * beta, 0, speed, 0, 0.2, spin});
                    most = std::max(most, collision.steps);
                    // Away from the wall by an open distance the body must meet it in the end; unless the step limit is
                    // reached first, which gives `unresolved`.
                    EXPECT_TRUE(collision.outcome == FirstContactOutcome::contact ||
                                collision.outcome == FirstContactOutcome::unresolved)
                        << "N " << sides << " beta " << beta << " speed " << speed << " outcome "
                        << static_cast<int>(collision.outcome);
                    if (collision.outcome == FirstContactOutcome::unresolved) {
                        EXPECT_LE(speed, 1e-6);
                    }
                }
    std::printf("most moments looked at: %d\n", most);
}

// e = 0 leaves u_n = 0 within rounding of either sign: such states are valid starts, and orbits from them follow the
// original orbit.
TEST(Outcome, AStateOfAnOrbitIsAStart) {
    tests::Random random(17);
    int above = 0, compared = 0;
    for (int i = 0; i < 300; ++i) {
        const Scene<double> scene = tests::random_scene(random, 3 + i % 8, random.between(0, 1), 0, Law::poisson);
        with_collision_map(scene, [&](const auto& map) {
            Orbit orbit(map, tests::random_point(random, scene, 0.5));
            for (int n = 0; n < 10 && orbit.advance(5); ++n) {
                const SectionPoint<double> z = section_point(orbit.post_impact());
                if (contact_kinematics(map.body(), post_impact_state(z)).un > 0) ++above;
                Orbit begun(map, z);
                Orbit goes_on = orbit;
                if (!goes_on.advance(5)) continue;
                ++compared;
                ASSERT_TRUE(begun.advance(5));
            }
        });
    }
    EXPECT_GT(above, 30);
    EXPECT_GT(compared, 300);
}

TEST(Outcome, OnTheWallAreThoseInContactAndCutShort) {
    using enum Outcome;
    for (const Outcome outcome : {in_contact, contact_cut}) EXPECT_TRUE(ends_in_contact(outcome));
    for (const Outcome outcome : {completed, no_contact, resting, diverged, unresolved})
        EXPECT_FALSE(ends_in_contact(outcome)) << name_of(outcome);
}

/// χ beyond what the neighbour leaves room for: the vertex itself is on the wall, the neighbour outside.
TEST(Outcome, AStateWithAnotherVertexOutsideIsNoStart) {
    const Scene<double> scene = scene_of(6, 0.4, 0.5, 0.5, 0.9);
    const double widest = tests::largest_chi(scene);
    for (const double side : {-1.0, 1.0})
        with_collision_map(scene, [&](const auto& map) {
            SectionPoint<double> z{0.3, side * (widest - 1e-6), -2, 0.1, 0};
            EXPECT_NO_THROW(ReducedOrbit(map, z));
            z.chi = side * (widest + 1e-6);
            EXPECT_THROW(ReducedOrbit(map, z), std::invalid_argument);
        });
}

TEST(Outcome, AStateThatApproachesTheWallIsNoStart) {
    const Scene<double> scene = scene_of(6, 0.4, 0.5, 0.5, 0);
    const auto body = make_body(scene);
    const SectionPoint<double> still{0, 0, 0, 0.3, -1};
    EXPECT_NO_THROW(require_leaving(body, still));
    SectionPoint<double> approaching = still;
    approaching.vn = 1e-13;
    EXPECT_THROW(require_leaving(body, approaching), std::invalid_argument);
}

}  // namespace
}  // namespace swirl
