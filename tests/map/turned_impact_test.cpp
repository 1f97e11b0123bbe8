// Impacts with a wall whose normal is turned: the circle's at η = 0, energy, J, and that the body leaves.
#include "map/model/turned_impact.hpp"

#include "map/collision_map.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace swirl {
namespace {

using tests::Random;
using tests::sample_count;

/// A scene, and a state just before an impact.
struct Approach {
    Scene<double> scene;
    Body<double> body;
    PostImpactState<double> before;
};

Approach random_approach(Random& random) {
    const Law law = static_cast<Law>(random.one_of({0, 1, 2}));
    const double mu = random.chance(0.2) ? 0 : random.log_between(0.01, 5);
    Approach a;
    a.scene = tests::random_scene(random, random.one_of({disk_sides, 3, 4, 6, 12}), mu, random.unit(), law);
    a.body = make_body(a.scene);
    const double chi = tests::largest_chi(a.scene) * random.between(-1, 1);
    a.before.psi = cis(random.angle());
    a.before.chi = cis(chi);
    a.before.vt = random.between(-2, 2);
    a.before.spin = random.between(-3, 3);
    const double un = contact_kinematics(a.body, a.before).un;  // with v_n = 0
    a.before.vn = random.log_between(1e-3, 2) - un;
    return a;
}

template <class Use>
void with_rule_of(const Scene<double>& scene, const Use& use) {
    scene.is_disk() ? with_rule<Shape::disk>(scene, use) : with_rule<Shape::polygon>(scene, use);
}

TurnedImpact<double> struck(const Approach& a, double eta) {
    TurnedImpact<double> impact;
    with_rule_of(a.scene, [&](auto rule) {
        impact = turned_impact<rule()>(a.body, a.before, a.scene.mu, a.scene.restitution, eta);
    });
    return impact;
}

/// ½|V − O′|² + ½ I S².
double energy_in_dish(const Body<double>& body, const PostImpactState<double>& z) {
    const double vn = z.vn - body.beta * z.psi.y, vt = z.vt - body.beta * z.psi.x;
    return (vn * vn + vt * vt + body.inertia * z.spin * z.spin) / 2;
}

TEST(TurnedImpact, IsTheCirclesWhereNothingIsTurned) {
    Random random(1);
    for (int i = 0; i < sample_count(20'000); ++i) {
        const Approach a = random_approach(random);
        const TurnedImpact<double> impact = struck(a, 0);
        with_rule_of(a.scene, [&](auto rule) {
            const ContactKinematics<double> before = contact_kinematics(a.body, a.before);
            PostImpactState<double> plain = a.before;
            Impulse<double> j;
            if constexpr (rule() == ImpactRule::frictionless)
                j = impulse<rule()>(before, a.scene.mu, a.scene.restitution);
            else
                j = a.scene.is_disk()
                        ? disk_impulse(before.un, before.ut, a.body.disk_grip, a.scene.mu, a.scene.restitution)
                        : impulse<rule()>(before, a.scene.mu, a.scene.restitution);
            apply_impulse(before, j.normal, j.tangential, plain);
            EXPECT_EQ(impact.impulse.normal, j.normal);
            EXPECT_EQ(impact.after.vt, plain.vt);
            EXPECT_EQ(impact.after.spin, plain.spin);
            const PostImpactState<double> back = before_impact(a.body, plain, j);
            const double size = 1 + std::abs(j.normal) + std::abs(j.tangential) / a.body.inertia;
            EXPECT_NEAR(back.vn, a.before.vn, 1e-14 * size);
            EXPECT_NEAR(back.spin, a.before.spin, 1e-14 * size);
        });
    }
}

TEST(TurnedImpact, BalancesJAndLeavesTheCircle) {
    Random random(2);
    int twice = 0;
    double worst = 0;
    for (int i = 0; i < sample_count(50'000); ++i) {
        const Approach a = random_approach(random);
        const TurnedImpact<double> impact = struck(a, random.between(-0.7, 0.7));
        twice += impact.struck_twice ? 1 : 0;
        EXPECT_LE(contact_kinematics(a.body, impact.after).un, 1e-13 * (1 + std::abs(impact.impulse.normal)));
        const double change = jacobi_of(a.body, impact.after) - jacobi_of(a.body, a.before);
        const double size = 1 + std::abs(jacobi_of(a.body, impact.after)) + std::abs(jacobi_of(a.body, a.before));
        worst = std::max(worst, std::abs(change - impact.jacobi_restitution - impact.jacobi_friction) / size);
    }
    EXPECT_LT(worst, 1e-13);
    EXPECT_GT(twice, sample_count(50'000) / 1000);
}

TEST(TurnedImpact, NeverGainsEnergyInTheDishByStronge) {
    Random random(3);
    for (int i = 0; i < sample_count(50'000); ++i) {
        Approach a = random_approach(random);
        a.scene.law = Law::stronge;
        const double before = energy_in_dish(a.body, a.before);
        EXPECT_LE(energy_in_dish(a.body, struck(a, random.between(-0.7, 0.7)).after), before * (1 + 1e-13));
    }
}

}  // namespace
}  // namespace swirl
