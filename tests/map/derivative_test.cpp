// DF: two forms that share no formula against each other, and the facts that hold without friction at e = 1.
#include "map/derivative/saltation.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/differentiated_map.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace swirl {
namespace {

using tests::DifferentiatedMap;
using tests::Random;
using tests::sample_count;

double slip_normal(const Body<double>& body, const PostImpactState<double>& post_impact) {
    return contact_kinematics(body, post_impact).un;
}

/// Largest relative differences over random states, one count per contact mode: of the two forms, and of the saltation
/// form from what an orbit keeps of a collision.
struct Comparison {
    std::array<long, 6> count{};
    std::array<double, 6> worst{}, worst_of_kept{};
};

template <class Map>
void compare_forms(const Map& map, const SectionPoint<double>& z, long wanted, Comparison& comparison) {
    const auto collision = map.advance(post_impact_state(z));
    if (collision.outcome != FirstContactOutcome::contact || collision.simultaneous) return;
    const auto mode = static_cast<std::size_t>(collision.impulse.mode);
    if (comparison.count[mode] >= wanted) return;
    const auto jets = DifferentiatedMap(map).linearise(z);
    const auto saltation = linearise_by_saltation(map, z);
    // At the contact DF is of the order 1/u_n and so is its condition: both forms read u_n with an error of a few ε.
    const double un = -slip_normal(map.body(), jets.collision.after);
    if (un < 1e-3) return;
    const double scale = saltation.derivative.cwiseAbs().maxCoeff();
    const double error = (jets.derivative - saltation.derivative).cwiseAbs().maxCoeff() / scale;
    ++comparison.count[mode];
    comparison.worst[mode] = std::max(comparison.worst[mode], error);
    EXPECT_LE(error, 1e-11) << name_of(collision.impulse.mode) << ", u_n = " << un;

    const auto kept = derivative_by_saltation(
        map, post_impact_state(z),
        KeptFlight{collision.flight_time, collision.vertex_step, collision.impulse.mode, collision.after});
    const double off = (kept - saltation.derivative).cwiseAbs().maxCoeff() / scale;
    comparison.worst_of_kept[mode] = std::max(comparison.worst_of_kept[mode], off);
    EXPECT_LE(off, 1e-11) << name_of(collision.impulse.mode) << ", u_n = " << un << ", of a kept flight";
}

void report(const std::string& what, const Comparison& comparison, const std::vector<ContactMode>& modes, long wanted) {
    for (const ContactMode mode : modes) {
        const auto m = static_cast<std::size_t>(mode);
        std::printf("%-9s %-13s %6ld states, largest relative difference %.2e, of kept flights %.2e\n", what.c_str(),
                    std::string(name_of(mode)).c_str(), comparison.count[m], comparison.worst[m],
                    comparison.worst_of_kept[m]);
        EXPECT_EQ(comparison.count[m], wanted) << what << ' ' << name_of(mode);
    }
}

bool all_done(const Comparison& comparison, const std::vector<ContactMode>& modes, long wanted) {
    return std::all_of(modes.begin(), modes.end(),
                       [&](ContactMode mode) { return comparison.count[static_cast<std::size_t>(mode)] >= wanted; });
}

void compare_on(const char* what, Law law, bool disk, bool friction, const std::vector<ContactMode>& modes) {
    const long wanted = sample_count(10000);
    Random random(2024 + static_cast<unsigned>(law) + (disk ? 10 : 0) + (friction ? 100 : 0));
    Comparison comparison;
    for (long tries = 0; tries < 200 * wanted && !all_done(comparison, modes, wanted); ++tries) {
        const int sides = disk ? disk_sides : random.one_of({3, 3, 3, 4, 4, 5, 6, 7, 12, 100000});
        const double mu = friction ? random.log_between(0.02, 5) : 0;
        const double e = random.chance(0.2) ? 1 : random.between(0.1, 1);
        const Scene<double> scene = tests::random_scene(random, sides, mu, e, law);
        const double leaving = random.log_between(1e-3, 3);
        const SectionPoint<double> z = tests::random_point(random, scene, leaving, random.log_between(0.1, 3));
        with_collision_map(scene, [&](const auto& map) { compare_forms(map, z, wanted, comparison); });
    }
    report(what, comparison, modes, wanted);
}

const std::vector<ContactMode> all_five = {ContactMode::sliding, ContactMode::c_sticking, ContactMode::r_sticking,
                                           ContactMode::c_reversed, ContactMode::r_reversed};

TEST(Derivative, JetsAgreeWithSaltationInEveryModePoisson) {
    compare_on("poisson", Law::poisson, false, true, all_five);
}
TEST(Derivative, JetsAgreeWithSaltationInEveryModeNewton) {
    compare_on("newton", Law::newton, false, true, all_five);
}
TEST(Derivative, JetsAgreeWithSaltationInEveryModeStronge) {
    compare_on("stronge", Law::stronge, false, true, all_five);
}
TEST(Derivative, JetsAgreeWithSaltationWithoutFriction) {
    compare_on("polygon", Law::poisson, false, false, {ContactMode::frictionless});
}
TEST(Derivative, JetsAgreeWithSaltationForTheDisk) {
    compare_on("disk", Law::poisson, true, false, {ContactMode::frictionless});
    compare_on("disk", Law::poisson, true, true,
               {ContactMode::sliding, ContactMode::c_sticking, ContactMode::r_sticking});
}

/// Both forms in 113 bits: what is left of the difference is rounding, so it shrinks with ε.
TEST(Derivative, BothFormsAgreeToRoundingInQuad) {
    Random random(5);
    double worst = 0;
    const long wanted = sample_count(200);
    for (long i = 0; i < wanted; ++i) {
        const Scene<double> s = tests::random_scene(random, random.one_of({3, 4, 6}), 0.4, 0.8, Law::stronge);
        const SectionPoint<double> z = tests::random_point(random, s, 0.5);
        const Scene<Quad> scene{s.sides, s.alpha, s.beta, s.mu, s.restitution, s.law, s.inertia_factor};
        const CollisionMap<Quad, Shape::polygon, ImpactRule::stronge> map(scene);
        const SectionPoint<Quad> point{z.psi, z.chi, z.vn, z.vt, z.spin};
        const auto jets = DifferentiatedMap(map).linearise(point);
        const auto saltation = linearise_by_saltation(map, point);
        ASSERT_EQ(jets.collision.outcome, FirstContactOutcome::contact);
        if (-contact_kinematics(map.body(), jets.collision.after).un < Quad(1e-3)) continue;
        double difference = 0, scale = 0;
        for (int k = 0; k < 25; ++k) {
            const Quad change = jets.derivative(k) - saltation.derivative(k);
            difference = std::max(difference, static_cast<double>(fabs(change)));
            scale = std::max(scale, static_cast<double>(fabs(saltation.derivative(k))));
        }
        worst = std::max(worst, difference / scale);
    }
    std::printf("%ld states in 113 bits, largest relative difference %.2e\n", wanted, worst);
    EXPECT_LE(worst, 1e-29);  // 10⁻¹¹ scaled by the ratio of the two ε
}

/// The time reversal: the velocities before the impact, seen in a mirror. Without friction, e = 1.
SectionPoint<double> reversed(const Body<double>& body, const SectionPoint<double>& z) {
    const ContactKinematics<double> a = contact_kinematics(body, post_impact_state(z));
    const double p = -2 * a.un / a.b2();
    return {-z.psi, -z.chi, -(z.vn + p), z.vt, z.spin - a.rt * p / body.inertia};
}

double distance(const SectionPoint<double>& a, const SectionPoint<double>& b) {
    return std::max({std::fabs(wrapped_angle(a.psi - b.psi)), std::fabs(wrapped_angle(a.chi - b.chi)),
                     std::fabs(a.vn - b.vn), std::fabs(a.vt - b.vt), std::fabs(a.spin - b.spin)});
}

/// Calls `check(map, z, linearised)` on random frictionless elastic states whose |u_n| before and after are ≥ 10⁻³.
template <class Check>
long over_elastic_states(std::uint64_t seed, long wanted, Check&& check) {
    Random random(seed);
    long count = 0;
    for (long i = 0; i < 10 * wanted && count < wanted; ++i) {
        const int sides = random.one_of({disk_sides, 3, 4, 5, 6, 7, 12, 100, 1000, 100000});
        const Scene<double> scene = tests::random_scene(random, sides, 0, 1, Law::poisson);
        const SectionPoint<double> z = tests::random_point(random, scene, random.log_between(1e-3, 3));
        with_collision_map(scene, [&](const auto& map) {
            const auto linearised = DifferentiatedMap(map).linearise(z);
            if (linearised.collision.outcome != FirstContactOutcome::contact || linearised.collision.simultaneous)
                return;
            if (-slip_normal(map.body(), linearised.collision.after) < 1e-3) return;
            ++count;
            check(map, z, linearised);
        });
    }
    return count;
}

TEST(Derivative, DeterminantIsTheRatioOfNormalVelocities) {
    double worst = 0;
    const long wanted = sample_count(20000);
    const long count = over_elastic_states(7, wanted, [&](const auto& map, const auto& z, const auto& linearised) {
        const double ratio =
            slip_normal(map.body(), post_impact_state(z)) / slip_normal(map.body(), linearised.collision.after);
        const double error = std::fabs(linearised.derivative.determinant() - ratio) / std::max(1.0, ratio);
        worst = std::max(worst, error);
        EXPECT_LE(error, 1e-10) << "N = " << map.scene().sides << ", ratio " << ratio;
    });
    std::printf("%ld states, largest error of det DF %.2e\n", count, worst);
    EXPECT_EQ(count, wanted);
}

TEST(Derivative, ElasticMotionWithoutFrictionIsReversible) {
    double worst = 0;
    const long wanted = sample_count(20000);
    const long count = over_elastic_states(8, wanted, [&](const auto& map, const auto& z, const auto& linearised) {
        const SectionPoint<double> there = section_point(linearised.collision.after);
        const auto back = map.advance(post_impact_state(reversed(map.body(), there)));
        ASSERT_EQ(back.outcome, FirstContactOutcome::contact);
        const double error = distance(reversed(map.body(), section_point(back.after)), z);
        const double norm = linearised.derivative.norm();
        worst = std::max(worst, error / norm);
        EXPECT_LE(error, 1e-12 * norm) << "N = " << map.scene().sides;
    });
    std::printf("%ld states, largest |RFRF(z) - z| / |DF| %.2e\n", count, worst);
    EXPECT_EQ(count, wanted);
}

}  // namespace
}  // namespace swirl
