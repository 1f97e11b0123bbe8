// What is known of a scene in closed form, against the numbers of its sources and against the impact and the map.
#include "map/steady/scene_facts.hpp"
#include "map/contact/rim_pendulum.hpp"
#include "map/first_contact/first_contact.hpp"
#include "map/model/impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace swirl {
namespace {

Scene<double> lamina(int sides, double alpha, double beta, double mu, double e) {
    return {sides, alpha, beta, mu, e, Law::poisson, uniform_inertia_factor<double>(sides)};
}

TEST(SceneFacts, PainleveThresholdsOfTheTriangleAndTheHexagon) {
    EXPECT_NEAR(*scene_facts(lamina(3, 0.3, 0.1, 0.5, 0.9)).painleve_friction, 1.118, 5e-4);
    EXPECT_NEAR(*scene_facts(lamina(6, 0.4, 0.1, 0.5, 0.9)).painleve_friction, 1.721, 5e-4);
    EXPECT_FALSE(scene_facts(lamina(disk_sides, 0.4, 0.1, 0.5, 0.9)).painleve_friction);
}

/// B₂ − μB₃ is negative for some |χ| ≤ χ_m just above the threshold and for none below it.
TEST(SceneFacts, PainleveThresholdIsWhereTheImpactChanges) {
    for (const int sides : {3, 4, 6, 11})
        for (const double alpha : {0.1, 0.4, 0.8}) {
            const Scene<double> scene = lamina(sides, alpha, 0.1, 0, 0.9);
            const SceneFacts facts = scene_facts(scene);
            const auto least_slope = [&](double mu) {
                double least = HUGE_VAL;
                for (int i = 1; i <= 20000; ++i) {
                    const double chi = facts.widest_chi * i / 20000;
                    const ContactKinematics<double> at{1, 1, alpha * std::cos(chi), alpha * std::sin(chi),
                                                       scene.inertia_factor * alpha * alpha};
                    least = std::min(least, at.b2() - mu * at.b3());
                }
                return least;
            };
            EXPECT_LT(least_slope(*facts.painleve_friction * 1.0001), 0);
            EXPECT_GT(least_slope(*facts.painleve_friction * 0.9999), 0);
            Scene<double> above = scene;
            above.mu = *facts.painleve_friction * 1.0001;
            EXPECT_TRUE(scene_facts(above).can_jam);
            EXPECT_FALSE(facts.can_jam);
        }
}

/// At |χ| = χ_m the neighbour is on the wall.
TEST(SceneFacts, WidestChiPutsTheNeighbourOnTheWall) {
    for (const int sides : {3, 4, 7, 100})
        for (const double alpha : {0.1, 0.5, 0.9}) {
            const double chi = scene_facts(lamina(sides, alpha, 0.1, 0.5, 0.9)).widest_chi;
            const double next = chi - 2 * pi<double>() / sides;
            const double x = 1 - alpha * std::cos(chi) + alpha * std::cos(next);
            const double y = -alpha * std::sin(chi) + alpha * std::sin(next);
            EXPECT_NEAR(std::hypot(x, y), 1, 1e-15);
        }
}

bool is_touched(const Scene<double>& scene, double spin, double angle) {
    const Body<double> body = make_body(scene);
    Flight<double> flight;
    flight.centre = {-scene.beta, 0};  // the swirl's centre
    flight.phase = {1, 0};
    flight.arm = scene.alpha * cis(angle);
    flight.spin = spin;
    flight.beta = scene.beta;
    const auto contact =
        scene.is_disk() ? first_contact<Shape::disk>(body, flight) : first_contact<Shape::polygon>(body, flight);
    return contact.outcome == FirstContactOutcome::contact;
}

/// A body at rest at the swirl's centre is left alone for ever just where the radius says so.
TEST(SceneFacts, AnUntouchedBodyIsOneThatTheMapNeverTouches) {
    for (const int sides : {disk_sides, 3, 6})
        for (const double slack : {0.01, -0.01}) {
            const Scene<double> scene = lamina(sides, 0.4, 0.6 - slack, 0.5, 0.9);
            EXPECT_NEAR(scene_facts(scene).untouched_radius, slack, 1e-15);
            EXPECT_EQ(is_touched(scene, 0, 0.3), slack < 0);
        }
}

/// Turning with the swirl, an edge's middle towards the wall that comes nearest, there is more room.
TEST(SceneFacts, APolygonThatTurnsWithTheSwirlHasMoreRoom) {
    for (const int sides : {3, 6}) {
        const double outer = make_body(lamina(sides, 0.4, 0.1, 0.5, 0.9)).outer;
        EXPECT_GT(outer, 0.6);
        const Scene<double> inside = lamina(sides, 0.4, outer - 1e-3, 0.5, 0.9);
        EXPECT_NEAR(scene_facts(inside).untouched_room_turning, 1e-3, 1e-15);
        EXPECT_LT(scene_facts(inside).untouched_radius, 0);
        const Body<double> body = make_body(inside);
        double farthest = 0;  // at rest in the frame that turns with the swirl
        for (int k = 0; k < sides; ++k) {
            const double angle = pi<double>() + (2 * k + 1) * pi<double>() / sides;
            farthest = std::max(farthest,
                                std::hypot(-inside.beta + body.alpha * std::cos(angle), body.alpha * std::sin(angle)));
        }
        EXPECT_LT(farthest, 1);
        EXPECT_GT(farthest, 1 - 2e-3);
    }
}

TEST(SceneFacts, WhatBecomesOfImpacts) {
    const auto fate = [](int sides, double beta, double mu, double e) {
        return scene_facts(lamina(sides, 0.4, beta, mu, e)).impacts;
    };
    for (const int sides : {disk_sides, 6}) {
        EXPECT_EQ(fate(sides, 0.5, 0, 0.9), ImpactFate::fade);
        EXPECT_EQ(fate(sides, 0, 0.5, 0.9), ImpactFate::fade);
        EXPECT_EQ(fate(sides, 0.5, 0, 1), ImpactFate::conserved);
        EXPECT_EQ(fate(sides, 0.5, 0.5, 0.9), ImpactFate::can_last);
        EXPECT_EQ(fate(sides, 0, 0.5, 1), ImpactFate::can_last);
    }
    // Newton's law can create energy on a polygon with friction, and only there.
    Scene<double> newton = lamina(6, 0.4, 0, 0.5, 0.9);
    newton.law = Law::newton;
    EXPECT_EQ(scene_facts(newton).impacts, ImpactFate::can_last);
}

TEST(SceneFacts, ARollingDiskIsAPendulum) {
    const Scene<double> disk = lamina(disk_sides, 0.3, 0.1, 0.5, 0.5);
    const RimFacts rim = *scene_facts(disk).rim;
    EXPECT_DOUBLE_EQ(rim.strength, 0.1 / (1.5 * 0.7));
    EXPECT_DOUBLE_EQ(rim.circulation_energy, rim.strength);
    EXPECT_DOUBLE_EQ(rim.rest_force, 0.8);
    EXPECT_DOUBLE_EQ(*rim.mean_spin, -0.7 / 0.3);
    const RimPendulum small{true, rim.strength, 1e-12 * rim.strength, 1};
    EXPECT_NEAR(period_of(small) * rim.small_frequency, 2 * pi<double>(), 1e-11);

    const RimFacts sliding = *scene_facts(lamina(disk_sides, 0.3, 0.1, 0, 0.5)).rim;
    EXPECT_DOUBLE_EQ(sliding.strength, 0.1 / 0.7);
    EXPECT_FALSE(sliding.mean_spin);
}

/// The widest libration touches the bound κβ|sin ψ|/(1 + κ) ≤ μλ somewhere, and nowhere passes it.
TEST(SceneFacts, TheWidestLibrationIsWhereFrictionJustHolds) {
    int bounded = 0;
    for (const double mu : {0.02, 0.1, 0.4})
        for (const double beta : {0.05, 0.3, 1.0}) {
            const Scene<double> disk = lamina(disk_sides, 0.35, beta, mu, 0.5);
            const RimFacts rim = *scene_facts(disk).rim;
            ASSERT_GT(rim.widest_libration, 0);
            double least = HUGE_VAL;
            for (int i = 0; i <= 20000; ++i)
                for (const double direction : {1.0, -1.0}) {
                    const double psi = rim.widest_libration * i / 20000;
                    const double square = 2 * rim.strength * (std::cos(psi) - std::cos(rim.widest_libration));
                    const double rate = 1 + direction * std::sqrt(std::max(0.0, square));
                    const double force = beta * std::cos(psi) + 0.65 * rate * rate;
                    least = std::min(least, mu * force - beta * std::sin(psi) / 3);  // κ/(1 + κ) = 1/3
                }
            EXPECT_GE(least, -1e-6 * beta);
            if (rim.widest_libration > 3.14159) continue;
            ++bounded;
            EXPECT_LE(least, 1e-6 * beta);
        }
    EXPECT_GE(bounded, 3);
}

/// By how much friction holds on the separatrix, in a direction: μλ − |f| at its least.
double hold_on_separatrix(double alpha, double beta, double mu, double direction) {
    const double rho = 1 - alpha, strength = beta / (1.5 * rho);
    double least = HUGE_VAL;
    for (int i = 0; i <= 100000; ++i) {
        const double psi = pi<double>() * i / 100000,
                     turning = 1 + direction * 2 * std::sqrt(strength) * std::cos(psi / 2);
        const double force = beta * std::cos(psi) + rho * turning * turning;
        least = std::min(least, mu * force - beta * std::sin(psi) / 3);
    }
    return least;
}

/// map/contact/README.md, "The final states of a disk": at μ = 0.4 circulation (against the swirl's turning) lasts
/// for β = 0.05 with α ≤ 0.62 only.
TEST(SceneFacts, CirculationLastsWhereTheTableSaysSo) {
    for (const double alpha : {0.1, 0.15, 0.35, 0.62, 0.8, 0.9})
        for (const double beta : {0.05, 0.23, 0.6, 1.0}) {
            const RimFacts rim = *scene_facts(lamina(disk_sides, alpha, beta, 0.4, 0.9)).rim;
            EXPECT_EQ(rim.circulates_backward, beta == 0.05 && alpha <= 0.62) << alpha << ' ' << beta;
            EXPECT_EQ(rim.circulates_backward, hold_on_separatrix(alpha, beta, 0.4, -1) > 0);
            EXPECT_EQ(rim.circulates_forward, hold_on_separatrix(alpha, beta, 0.4, 1) > 0);
        }
}

}  // namespace
}  // namespace swirl
