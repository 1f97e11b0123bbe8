// The rod, N = 2: its numbers, first contacts, conservation, DF, contact that lasts, reference orbits.
#include "map/derivative/saltation.hpp"
#include "map/dragged/dragged_map.hpp"
#include "map/orbit/laboratory.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "map/steady/steady_modes.hpp"
#include "tests/map/container_scan.hpp"
#include "tests/map/differentiated_map.hpp"
#include "tests/map/landings.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/map/reference_orbits.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace swirl {
namespace {

using tests::Random;

Scene<double> random_rod(Random& random) {
    const double mu = random.chance(0.2) ? 0 : random.between(0, 1),
                 e = random.chance(0.3) ? 1 : random.between(0.3, 1);
    return tests::random_scene(random, rod_sides, mu, e, static_cast<Law>(random.one_of({0, 1, 2})));
}

TEST(Rod, HasTheNumbersOfASegment) {
    const Scene<double> scene{rod_sides, 0.4, 0.5, 0.5, 0.9, Law::poisson, uniform_inertia_factor<double>(rod_sides)};
    EXPECT_EQ(scene.inertia_factor, 1.0 / 3);  // (2R_p)²/12
    const Body<double> body = make_body(validated(scene));
    EXPECT_DOUBLE_EQ(body.outer, std::sqrt(1 - 0.4 * 0.4));  // across, both ends on the wall
    EXPECT_DOUBLE_EQ(body.side, 0.8);
    const ContactScene<double> contact = tests::contact_of(scene);
    EXPECT_DOUBLE_EQ(contact.widest_chi, std::numbers::pi / 2 - std::asin(0.4));
    const Body<Quad> wide = make_body(tests::scene_in<Quad>(scene));
    EXPECT_GT(wide.half_slope, Quad(1e30));
}

TEST(Rod, NothingIsOutsideBeforeItsFirstContact) {
    Random random(21);
    int flights = 0;
    for (int k = 0; k < 60; ++k) {
        const Scene<double> scene = random_rod(random);
        with_collision_map(scene, [&](const auto& map) {
            Collision<double> step;
            step.after = post_impact_state(tests::random_point(random, scene, random.log_between(0.01, 2)));
            for (int i = 0; i < 30; ++i) {
                const SectionPoint<double> z = section_point(step.after);
                const tests::Real alpha = scene.alpha;
                const tests::ScannedFlight flight{rod_sides,
                                                  alpha,
                                                  scene.beta,
                                                  1 - alpha * std::cos(static_cast<tests::Real>(z.chi)),
                                                  -alpha * std::sin(static_cast<tests::Real>(z.chi)),
                                                  z.vn,
                                                  z.vt,
                                                  -static_cast<tests::Real>(z.psi),
                                                  z.chi,
                                                  z.spin,
                                                  true};
                map.advance(step.after, step);
                if (step.outcome != FirstContactOutcome::contact) return;
                if (step.flight_time > 20) continue;
                const tests::Scan clear = tests::scan(flight, step.flight_time, 1e-10L);
                EXPECT_TRUE(clear.clear) << "scene " << k << ", impact " << i << ", at "
                                         << static_cast<double>(clear.earliest) << " of " << step.flight_time;
                EXPECT_NEAR(static_cast<double>(flight.gap(step.flight_time)), 0, 1e-10);
                ++flights;
            }
        });
    }
    EXPECT_GT(flights, 1000);
}

TEST(Rod, KeepsJAndVolumesWithoutFriction) {
    Random random(22);
    for (int k = 0; k < 10; ++k) {
        const Scene<double> scene = tests::random_scene(random, rod_sides, 0, 1, Law::poisson);
        const CollisionMap<double, Shape::polygon, ImpactRule::frictionless> map(scene);
        Collision<double> step;
        step.after = post_impact_state(tests::random_point(random, scene, 0.7));
        const double start = jacobi_of(map.body(), step.after);
        for (int i = 0; i < 5000; ++i) {
            const PostImpactState<double> before = step.after;
            map.advance(step.after, step);
            ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
            if (i >= 100) continue;
            const auto d = derivative_by_saltation(map, before, step);
            const double un = contact_kinematics(map.body(), step.after).un;
            if (un > -1e-2) continue;
            EXPECT_NEAR(d.determinant() * un / contact_kinematics(map.body(), before).un, 1, 1e-9);
        }
        EXPECT_NEAR(jacobi_of(map.body(), step.after), start, 1e-11 * (1 + std::abs(start)));
    }
}

TEST(Rod, DerivativesByHandAndByJetsAgree) {
    Random random(23);
    double worst = 0;
    int count = 0;
    for (int i = 0; i < 1000; ++i) {
        const Scene<double> scene = random_rod(random);
        with_collision_map(scene, [&](const auto& map) {
            const SectionPoint<double> z = tests::random_point(random, scene, random.log_between(0.05, 2));
            const auto jets = tests::DifferentiatedMap(map).linearise(z);
            if (jets.collision.outcome != FirstContactOutcome::contact || jets.collision.simultaneous) return;
            if (-contact_kinematics(map.body(), jets.collision.after).un < 1e-3) return;
            const auto hand = linearise_by_saltation(map, z);
            worst = std::max(worst, (jets.derivative - hand.derivative).cwiseAbs().maxCoeff() /
                                        hand.derivative.cwiseAbs().maxCoeff());
            ++count;
        });
    }
    std::printf("%d states, DF within %.2g\n", count, worst);
    EXPECT_GT(count, 700);
    EXPECT_LE(worst, 1e-11);
}

/// Lying on both ends, without friction, it is a pendulum about the container's centre: with d = √(1 − α²) and ψ_c the
/// chord's direction less t, (d² + κα²) ψ_c″ = −βd sin ψ_c.
TEST(Rod, LiesAsAChordAndSwingsAsAPendulum) {
    Random random(26);
    int pieces = 0;
    double worst = 0, longest = 0;
    for (int k = 0; k < 15; ++k) {
        const double restitution = random.chance(0.5) ? 0 : random.between(0.1, 0.5);
        Scene<double> scene = tests::random_scene(random, rod_sides, 0, restitution, Law::poisson);
        scene.beta = std::min(scene.beta, 1.0);
        const CollisionMap<double, Shape::polygon, ImpactRule::frictionless> map(scene);
        Orbit orbit(map, LabStart<double>{scene.beta, 0, random.between(-0.2, 0.2), random.between(-0.2, 0.2),
                                          random.angle(), random.between(-0.5, 0.5)});
        const double d2 = 1 - scene.alpha * scene.alpha, inertia = d2 + scene.alpha * scene.alpha / 3;
        const double pull = scene.beta * std::sqrt(d2) / inertia, half = std::asin(scene.alpha);
        const auto energy = [&](const ContactState<double>& z) {
            return 0.5 * (z.ut - 1) * (z.ut - 1) - pull * std::cos(z.psi + half);
        };
        bool goes_on = true;
        while (goes_on && orbit.impacts() < 2000) {
            goes_on = orbit.advance(20);
            for (const ContactSegment& piece : orbit.contacts()) {
                if (piece.support != Support::edge || !(piece.end > piece.start)) continue;
                EXPECT_NEAR(piece.from.ut, piece.from.spin, 1e-14);
                EXPECT_NEAR(piece.from.chi, -(std::numbers::pi / 2 - half), 1e-14);
                worst = std::max(worst, std::abs(energy(piece.to) - energy(piece.from)));
                longest = std::max(longest, piece.end - piece.start);
                ++pieces;
            }
        }
    }
    std::printf("%d pieces on both ends, up to %.3g long, energy within %.2g\n", pieces, longest, worst);
    EXPECT_GT(pieces, 20);
    EXPECT_GT(longest, 10);
    EXPECT_LE(worst, 1e-12);
}

/// Through chatter and contact on an end to the next impact: in double as in 113 bits.
TEST(Rod, LastingContactIsThatOf113Bits) {
    Random random(24);
    int compared = 0, off = 0;
    for (int tries = 0; compared < 40 && tries < 400; ++tries) {
        const auto landing = tests::random_landing(random, rod_sides);
        if (!landing) continue;
        with_collision_map(tests::scene_in<Quad>(landing->scene), [&](const auto& wide) {
            const auto from = tests::widened(wide.body(), landing->from);
            const auto reference = tests::contact_return(wide, from);
            if (!reference) return;
            const Quad balance =
                jacobi_of(wide.body(), reference->after) - jacobi_of(wide.body(), from) - reference->work;
            EXPECT_LE(std::abs(static_cast<double>(balance)), 1e-28);
            with_collision_map(landing->scene, [&](const auto& map) {
                const auto found = tests::contact_return(map, landing->from);
                if (!found || found->way != reference->way) return void(++off);
                ++compared;
                const double size = 1 + std::abs(landing->from.spin);
                EXPECT_NEAR(found->after.spin, static_cast<double>(reference->after.spin), 1e-7 * size);
                EXPECT_NEAR(static_cast<double>(found->time), static_cast<double>(reference->time), 1e-7 * size);
            });
        });
    }
    std::printf("%d returns compared; %d went another way\n", compared, off);
    EXPECT_EQ(compared, 40);
    EXPECT_LE(off, 4);
}

TEST(Rod, SteadyModesAreFixedPoints) {
    const Scene<double> scene{rod_sides, 0.4, 0.5, 0.5, 1, Law::poisson, uniform_inertia_factor<double>(rod_sides)};
    const auto found = steady_modes(scene);
    EXPECT_GT(found.modes.size(), 2U);
    with_collision_map(scene, [&](const auto& map) {
        for (const SteadyMode& mode : found.modes) {
            const SectionPoint<double> next = section_point(map.advance(post_impact_state(mode.point)).after);
            EXPECT_NEAR(next.vn, mode.point.vn, 1e-9);
            EXPECT_NEAR(next.vt, mode.point.vt, 1e-9);
            EXPECT_NEAR(next.spin, mode.point.spin, 1e-9);
        }
    });
    std::printf("%zu steady modes\n", found.modes.size());
}

TEST(Rod, GoesWithAFloorThatDrags) {
    Random random(25);
    int compared = 0;
    for (int i = 0; i < 100; ++i) {
        Scene<double> scene = tests::random_scene(random, rod_sides, 0.5, 0.9, Law::poisson);
        const PostImpactState<double> z = post_impact_state(tests::random_point(random, scene, 0.5));
        const Collision<double> still = CollisionMap<double, Shape::polygon, ImpactRule::poisson>(scene).advance(z);
        scene.drag = 1e-13;
        const Collision<double> dragged = DraggedMap<double, Shape::polygon, ImpactRule::poisson>(scene).advance(z);
        ASSERT_EQ(still.outcome, dragged.outcome);
        if (still.outcome != FirstContactOutcome::contact || still.flight_time > 5) continue;
        EXPECT_NEAR(still.flight_time, dragged.flight_time, 1e-9);
        EXPECT_EQ(still.vertex_step, dragged.vertex_step);
        ++compared;
    }
    EXPECT_GT(compared, 80);
}

/// The 24 orbits of tests/references/rod_trajectories.json.
template <class T>
void reproduce(const tests::Tolerance& tolerance, int least) {
    tests::reproduce<T>("rod_trajectories.json", tolerance, 24, least);
}

TEST(Rod, ReferenceOrbitsAreReproducedInDouble) {
    reproduce<double>({1e-13, 1e-12, 1e10}, 250);
}
TEST(Rod, ReferenceOrbitsAreReproducedInLongDouble) {
    reproduce<long double>({1e-13 / 2048, 1e-12 / 2048, 1e13}, 250);
}
TEST(Rod, ReferenceOrbitsAreReproducedInQuad) {
    reproduce<Quad>({1e-24, 1e-22, HUGE_VAL}, 288);
}

}  // namespace
}  // namespace swirl
