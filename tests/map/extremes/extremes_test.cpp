// One step at the ends of every range, against 113 bits: at most 50 ε × condition, as in between.
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/extremes/one_step.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>

namespace swirl {
namespace {

using tests::Random;

/// What a family of scenes holds fixed; the rest is random.
struct Family {
    const char* name;
    double alpha = -1, beta = -1, mu = -1, e = -1;  ///< −1: random
    double speed = 1, spin = 3;                     ///< of the starts
    int sides = -1;                                 ///< −1: the disk, or 3 … 12
    bool vanishing = false;              ///< μ is such that B₂ − sμB₃ = 0 at the next impact, within ε
    double slowest = 0.05, fastest = 1;  ///< |u_n| after the impact, in units of speed
};

Scene<double> scene_of(Random& random, const Family& family) {
    const int sides = family.sides >= 0 ? family.sides : random.one_of({disk_sides, 3, 4, 5, 6, 12});
    const double mu = family.mu >= 0 ? family.mu : random.log_between(0.01, 5);
    const double e = family.e >= 0 ? family.e : random.between(0.2, 1);
    const Law law = random.one_of({0, 1}) ? Law::poisson : Law::stronge;
    Scene<double> scene = tests::random_scene(random, sides, mu, e, law);
    if (family.alpha >= 0) scene.alpha = family.alpha;
    if (family.beta >= 0) scene.beta = family.beta;
    return scene;
}

struct Figure {
    long steps = 0, compared = 0, others = 0;
    double worst = 0, condition = 0;
};

template <class Use>
void with_both_maps(const Scene<double>& scene, Use&& use) {
    with_collision_map(scene, [&](const auto& map) {
        using Map = std::decay_t<decltype(map)>;
        use(map, CollisionMap<Quad, Map::shape, Map::rule>(tests::widened(scene)));
    });
}

/// μ at which sliding's B₂ − sμB₃ vanishes at the impact that ends the flight from z; 0 if B₃ is 0.
double vanishing_mu(const Scene<double>& scene, const PostImpactState<double>& z) {
    double mu = 0;
    with_collision_map(scene, [&](const auto& map) {
        const auto step = map.advance(z);
        if (step.outcome != FirstContactOutcome::contact) return;
        const auto at = contact_kinematics(map.body(), step.after);
        if (at.b3() != 0) mu = std::fabs(at.b2() / at.b3());
    });
    return mu;
}

void look_at(const Family& family, Random& random, Figure& figure) {
    Scene<double> scene = scene_of(random, family);
    const double leaving = family.speed * random.log_between(family.slowest, family.fastest);
    const auto z = post_impact_state(tests::random_point(random, scene, leaving, family.speed, family.spin));
    if (family.vanishing) {
        scene.mu = vanishing_mu(scene, z);
        if (!(scene.mu > 0 && scene.mu < 1e6)) return;
    }
    with_both_maps(scene, [&](const auto& map, const auto& wide_map) {
        const auto step = tests::one_step_error(map, wide_map, z);
        ++figure.steps;
        figure.compared += step.compared;
        figure.others += step.contact && !step.compared;
        figure.worst = std::max(figure.worst, step.error);
        figure.condition = std::max(figure.condition, step.condition);
    });
}

constexpr double allowed_error = 50;  // ε × condition

/// The steps of one orbit, as far as it goes without chatter or contact.
Figure along_an_orbit(const Scene<double>& scene, const SectionPoint<double>& start, long steps) {
    Figure figure;
    with_both_maps(scene, [&](const auto& map, const auto& wide_map) {
        auto z = post_impact_state(start);
        while (figure.steps < steps) {
            const auto next = map.advance(z);
            if (next.outcome != FirstContactOutcome::contact) return;
            const auto step = tests::one_step_error(map, wide_map, z);
            ++figure.steps;
            figure.compared += step.compared;
            figure.others += !step.compared;
            figure.worst = std::max(figure.worst, step.error);
            figure.condition = std::max(figure.condition, step.condition);
            z = next.after;
        }
    });
    return figure;
}

/// Orbits that hop along the wall from a vertex to the next: all contacts are of the vertex that strikes in 113 bits.
///   most  ε × condition
void check_hops(int sides, double alpha, double beta, double e, double most = 4) {
    const Scene<double> scene{sides, alpha, beta, 0.5, e, Law::poisson, uniform_inertia_factor<double>(sides)};
    const long steps = tests::sample_count(500);
    const Figure figure = along_an_orbit(scene, {0.3, 0, -0.9, 0.4, 0.2}, steps);
    std::printf(
        "%7d sides, alpha %-6g %4ld steps compared, %ld decided otherwise; error at most %8.3g epsilon x condition "
        "(which is at most %.2g)\n",
        sides, alpha, figure.compared, figure.others, figure.worst, figure.condition);
    EXPECT_LE(figure.worst, most) << sides;
    EXPECT_EQ(figure.others, 0) << sides;
    EXPECT_EQ(figure.compared, steps) << sides;
}

/// A start that only one arithmetic decides so is close to a border, or ends without a contact: at least half do not.
void check(const Family& family, long full = 150) {
    Random random(77);
    Figure figure;
    const long starts = tests::sample_count(full);
    for (long i = 0; i < starts; ++i) look_at(family, random, figure);
    std::printf(
        "%-24s %4ld of %4ld steps compared, %ld decided otherwise; error at most %8.3g epsilon x condition "
        "(which is at most %.2g)\n",
        family.name, figure.compared, figure.steps, figure.others, figure.worst, figure.condition);
    EXPECT_LE(figure.worst, allowed_error) << family.name;
    EXPECT_GE(2 * figure.compared, figure.steps) << family.name;
    EXPECT_GT(figure.steps, starts / 2) << family.name;
}

Family with_alpha(const char* name, double alpha) {
    Family family{name};
    family.alpha = alpha;
    return family;
}
Family with_beta(const char* name, double beta) {
    Family family{name};
    family.beta = beta;
    family.speed = std::max(1.0, beta);
    return family;
}
Family with_mu(const char* name, double mu) {
    Family family{name};
    family.mu = mu;
    return family;
}
Family with_restitution(const char* name, double e) {
    Family family{name};
    family.e = e;
    return family;
}
Family with_sides(const char* name, int sides) {
    Family family{name};
    family.sides = sides;
    return family;
}
Family with_speed(const char* name, double speed, double spin, double beta) {
    Family family{name};
    family.speed = speed;
    family.spin = spin;
    family.beta = beta;
    return family;
}

TEST(Extremes, OrdinaryScenesForComparison) {
    check({"ordinary"}, 300);
}
TEST(Extremes, BodiesThatFillTheContainerAndPoints) {
    check(with_alpha("alpha 0.999999", 0.999999));
    check(with_alpha("alpha 1e-9", 1e-9));
}
TEST(Extremes, TrianglesAndAMillionSides) {
    check(with_sides("N 3", 3));
    check(with_sides("N 1000000", 1'000'000));
}
TEST(Extremes, SwirlsFromNoneToAThousandRadii) {
    check(with_beta("beta 0", 0));
    check(with_beta("beta 1e-70", 1e-70));
    check(with_beta("beta 1e-12", 1e-12));
    check(with_beta("beta 50", 50));
    check(with_beta("beta 1000", 1000));
}
TEST(Extremes, FrictionFromNoneToAMillion) {
    check(with_mu("mu 0", 0));
    check(with_mu("mu 1e-70", 1e-70));
    check(with_mu("mu 1e6", 1e6));
}
TEST(Extremes, FrictionThatBalancesTheNormalCoefficient) {
    Family family{"B2 - s mu B3 = 0"};
    family.vanishing = true;
    family.sides = 3;
    check(family);
}
TEST(Extremes, RestitutionNoneAndAllButWhole) {
    check(with_restitution("e 0", 0));
    check(with_restitution("e 1 - 1e-16", 1 - 1e-16));
}
TEST(Extremes, HopsFarShorterThanTheCircumscribedCirclesReturn) {
    Family family = with_sides("hops of a triangle", 3);
    family.alpha = 0.4;
    family.beta = 0.8;
    family.slowest = 1e-7;
    family.fastest = 1e-2;
    check(family, 1000);
    family.name = "hops of a hexagon";
    family.sides = 6;
    check(family, 1000);
}
TEST(Extremes, HopsFromNeighbourToNeighbour) {
    check_hops(50, 0.4, 0.5, 0.9, allowed_error);  // whose sides are not short
    for (const int sides : {100, 300, 1000, 10'000, 1'000'000}) check_hops(sides, 0.4, 0.5, 0.9);
    check_hops(300, 0.4, 0.5, 1);
    for (const double alpha : {1e-3, 1e-5, 1e-6}) check_hops(1'000'000, alpha, 0.5, 0.9);
    for (const double alpha : {1e-9, 1e-13}) check_hops(3, alpha, 0.5, 0.9);
    check_hops(6, 0.01, 0.5, 0.9);
}
TEST(Extremes, SpeedsAndSpins) {
    check(with_speed("speed 1e-12, beta 1e-12", 1e-12, 1e-12, 1e-12));
    check(with_speed("speed 1e-12, beta 0.5", 1e-12, 3, 0.5));
    check(with_speed("speed 1e8", 1e8, 3, 0.5));
    check(with_speed("spin 1e8", 1, 1e8, 0.5));
    check(with_speed("speed 1e8, spin 1e8", 1e8, 1e8, 0.5));
}

}  // namespace
}  // namespace swirl
