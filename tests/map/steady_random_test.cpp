// Random polygons under the three laws: every steady mode returned is a fixed point of the map, and Newton's method on
// the map itself, from random starts, comes to none that is not among them.
#include "map/steady/steady_modes.hpp"
#include "tests/map/differentiated_map.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <type_traits>
#include <vector>

namespace swirl {
namespace {

using Vector = Eigen::Matrix<double, 5, 1>;
using Matrix = Eigen::Matrix<double, 5, 5>;

struct Draw {
    std::mt19937_64 generator;
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
    bool chance(double share) { return between(0, 1) < share; }
};

/// All regimes: small and large swirls, friction above and below tan χ_m, no loss, nearly none, and no restitution.
Scene<double> random_scene(Draw& draw, long number) {
    Scene<double> s;
    s.sides = 3 + static_cast<int>(draw.chance(0.6) ? draw.between(0, 5) : draw.between(0, 30));
    s.alpha = draw.between(0.05, 0.95);
    s.beta = draw.chance(0.3) ? draw.between(1, 5) : draw.between(0.02, 1);
    s.mu = draw.chance(0.5) ? draw.between(0.3, 2) : std::exp(draw.between(-6, -1));
    const double which = draw.between(0, 1);
    s.restitution = which < 0.15   ? 1
                    : which < 0.25 ? 0
                    : which < 0.35 ? 1 - std::exp(draw.between(-18, -3))
                                   : draw.between(0, 1);
    s.law = static_cast<Law>(number % 3);
    s.inertia_factor = draw.chance(0.7) ? uniform_inertia_factor<double>(s.sides) : draw.between(0.05, 1);
    return s;
}

SectionPoint<double> random_point(Draw& draw, const Scene<double>& s, double room) {
    const double speed = s.beta + 0.3, rolling = (1 - s.alpha) / s.alpha;
    SectionPoint<double> z;
    z.psi = draw.chance(0.5) ? draw.between(-pi<double>(), pi<double>()) : draw.between(-0.5, 0.5);
    z.chi = 0.999 * room * draw.between(-1, 1);
    z.spin = draw.between(-1.5 * rolling - 0.5, 0.5 * rolling + 1.5);
    const double leaving = draw.between(0, 1);
    z.vn = -2 * speed * leaving * leaving + s.alpha * z.spin * std::sin(z.chi) + s.beta * std::sin(z.psi);
    z.vt = s.beta * std::cos(z.psi) - s.alpha * z.spin * std::cos(z.chi) +
           (draw.chance(0.5) ? 0 : draw.between(-speed, speed));
    return z;
}

/// Below it the search leaves modes out (u_n < 10⁻⁶), and what nearly closes can't be told from what closes.
constexpr double least_impulse = 1e-5;

struct FixedPoint {
    SectionPoint<double> z;
    double tau = 0;
    double impulse = 0;
};

/// Newton's method for F(z) = z, steps of at most ½; settled when the next step is below 10⁻⁹ (near u_n = 0 everything
/// nearly closes).
template <class Map>
std::optional<FixedPoint> newton(const Map& map, SectionPoint<double> z, double room) {
    for (int i = 0; i < 25; ++i) {
        const auto step = map.linearise(z);
        if (step.collision.outcome != FirstContactOutcome::contact) return {};
        const SectionPoint<double> next = section_point(step.collision.after);
        Vector left;
        left << wrapped_angle(next.psi - z.psi), wrapped_angle(next.chi - z.chi), next.vn - z.vn, next.vt - z.vt,
            next.spin - z.spin;
        Vector move = (step.derivative - Matrix::Identity()).partialPivLu().solve(left);
        const double size = move.template lpNorm<Eigen::Infinity>();
        if (!(size < 1e6)) return {};
        if (size < 1e-9 && left.template lpNorm<Eigen::Infinity>() < 1e-11)
            return FixedPoint{z, step.collision.flight_time, step.collision.impulse.normal};
        if (size > 0.5) move *= 0.5 / size;
        z = {wrapped_angle(z.psi - move[0]), z.chi - move[1], z.vn - move[2], z.vt - move[3], z.spin - move[4]};
        if (std::fabs(z.chi) > room) return {};
    }
    return {};
}

/// |F(z) − z| by the map alone.
double misclosure(const Scene<double>& scene, const SectionPoint<double>& z) {
    return with_collision_map(scene, [&](const auto& map) {
        const auto step = map.advance(post_impact_state(z));
        if (step.outcome != FirstContactOutcome::contact) return HUGE_VAL;
        const SectionPoint<double> next = section_point(step.after);
        return std::max({std::fabs(wrapped_angle(next.psi - z.psi)), std::fabs(next.chi - z.chi),
                         std::fabs(next.vn - z.vn), std::fabs(next.vt - z.vt), std::fabs(next.spin - z.spin)});
    });
}

struct Counts {
    long modes = 0, sliding = 0, late = 0, hits = 0, cut_short = 0;
    double worst = 0;  ///< |F(z) − z| in ε (1 + |z|)(1 + ‖DF‖ + (1 + |S|)/u_n)
};

void check_modes(const Scene<double>& scene, const SteadyModes& result, Counts& counts) {
    for (const SteadyMode& mode : result.modes) {
        const SectionPoint<double>& z = mode.point;
        const double size = 1 + std::max({std::fabs(z.vn), std::fabs(z.vt), std::fabs(z.spin)});
        const double unit = epsilon<double>() * size * (1 + mode.amplification + (1 + std::fabs(z.spin)) / mode.speed);
        counts.worst = std::max(counts.worst, misclosure(scene, z) / unit);
        EXPECT_NEAR(z.spin, 1 - 2 * pi<double>() * static_cast<double>(mode.j) / (scene.sides * mode.tau),
                    1e-15 * size);
        // Reversed slip is impossible, and slip is at the angle of friction.
        EXPECT_TRUE(mode.contact == ContactMode::sliding || ends_in_stick(mode.contact));
        EXPECT_LE(std::fabs(std::tan(mode.chi)), scene.mu * (1 + 1e-12));
        ++counts.modes;
        counts.sliding += mode.contact == ContactMode::sliding;
        counts.late += mode.contact == ContactMode::r_sticking;
    }
}

void search_from_random_starts(const Scene<double>& scene, const SteadyModes& result, int starts, Draw& draw,
                               Counts& counts) {
    const double room = pi<double>() / scene.sides - std::asin(scene.alpha * std::sin(pi<double>() / scene.sides));
    with_collision_map(scene, [&](const auto& map) {
        if constexpr (std::decay_t<decltype(map)>::shape == Shape::polygon) {
            const tests::DifferentiatedMap differentiated(map);
            for (int i = 0; i < starts; ++i) {
                const auto found = newton(differentiated, random_point(draw, scene, room), room);
                if (!found || found->tau > 12 || found->impulse < least_impulse) continue;
                ++counts.hits;
                const bool known = std::any_of(result.modes.begin(), result.modes.end(), [&](const SteadyMode& mode) {
                    return std::fabs(mode.tau - found->tau) < 1e-6 && std::fabs(mode.point.spin - found->z.spin) < 1e-6;
                });
                EXPECT_TRUE(known) << "N = " << scene.sides << ", alpha = " << scene.alpha << ", beta = " << scene.beta
                                   << ", mu = " << scene.mu << ", e = " << scene.restitution << ": tau = " << found->tau
                                   << ", S = " << found->z.spin;
            }
        }
    });
}

void check_random_scenes(std::uint64_t seed, long scenes, int starts) {
    Draw draw{std::mt19937_64(seed)};
    Counts counts;
    for (long number = 0; number < scenes; ++number) {
        const Scene<double> scene = random_scene(draw, number);
        const SteadyModes result = steady_modes(scene);
        if (result.complete_to < 12) {  // weak friction on a small body: slip spins it so fast that 10⁵ vertices pass
            ++counts.cut_short;
            continue;
        }
        check_modes(scene, result, counts);
        search_from_random_starts(scene, result, starts, draw, counts);
    }
    std::printf(
        "%ld scenes: %ld modes (%ld sliding, %ld stick in restitution), |F(z) - z| %.1f units; %ld hits; %ld cut "
        "short\n",
        scenes, counts.modes, counts.sliding, counts.late, counts.worst, counts.hits, counts.cut_short);
    EXPECT_LE(counts.worst, 16);
    EXPECT_LE(50 * counts.cut_short, scenes);
    EXPECT_GE(counts.hits, 10 * scenes);
    EXPECT_GE(counts.sliding, scenes);
    EXPECT_GE(counts.late, 1);
}

TEST(SteadyRandom, EveryModeClosesAndNoneIsMissing) {
    check_random_scenes(5, tests::sample_count(150), 200);
}

TEST(SteadyRandom, NightlyEveryModeClosesAndNoneIsMissing) {
    check_random_scenes(6, tests::sample_count(4000), 500);
}

bool attracts(const SteadyMode& mode) {
    return std::abs(mode.multipliers.front()) < 1 - 1e-6;
}

std::vector<SteadyMode> found_quickly(const Scene<double>& scene) {
    SteadyOptions quick;
    quick.longest_flight = longest_attracting_flight;
    quick.attracting = true;
    std::vector<SteadyMode> found = steady_modes(scene, quick).modes;
    std::erase_if(found, [](const SteadyMode& mode) { return !attracts(mode); });
    return found;
}

/// The quick search finds what attracts, and nothing that the whole one does not.
void compare_attracting(long scenes, std::uint64_t seed) {
    Draw draw{std::mt19937_64(seed)};
    long attracting = 0, missed = 0, more = 0;
    double longest = 0;
    for (long i = 0; i < scenes; ++i) {
        const Scene<double> scene = random_scene(draw, i);
        std::vector<SteadyMode> all = steady_modes(scene).modes;
        std::erase_if(all, [](const SteadyMode& mode) { return !attracts(mode); });
        const std::vector<SteadyMode> some = found_quickly(scene);
        const auto has = [](const std::vector<SteadyMode>& modes, const SteadyMode& one) {
            return std::any_of(modes.begin(), modes.end(), [&](const SteadyMode& mode) {
                return mode.branch == one.branch && mode.j == one.j && std::fabs(mode.tau - one.tau) < 1e-9;
            });
        };
        for (const SteadyMode& mode : all) {
            ++attracting;
            longest = std::max(longest, mode.tau);
            if (has(some, mode)) continue;
            ++missed;
            std::printf("missed: N = %d alpha %.17g beta %.17g mu %.17g e %.17g law %d: tau %.17g\n", scene.sides,
                        scene.alpha, scene.beta, scene.mu, scene.restitution, static_cast<int>(scene.law), mode.tau);
        }
        for (const SteadyMode& mode : some) more += has(all, mode) ? 0 : 1;
    }
    std::printf("%ld scenes: %ld attracting modes, the longest flight %.3f; missed %ld, more %ld\n", scenes, attracting,
                longest, missed, more);
    EXPECT_GT(attracting, 0);
    EXPECT_EQ(more, 0);
    EXPECT_LE(missed, attracting / 1000);
}

TEST(SteadyAttracting, TheQuickSearchFindsThem) {
    compare_attracting(tests::sample_count(40), 11);
}

/// At small e a few attract on the − branch: a triangle's fixed point of S = −0.354871936, multiplier 0.679.
TEST(SteadyAttracting, TheQuickSearchFindsOneOnTheMinusBranch) {
    const auto found =
        found_quickly({3, 0.6425, 0.1945, 0.2279, 0.01, Law::poisson, uniform_inertia_factor<double>(3)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().branch, SteadyBranch::minus);
    EXPECT_NEAR(found.front().point.spin, -0.35487193612986, 1e-12);
}

/// Two in 1,400 slide: one vertex on, τ = 3.3493, with |tan χ| = μ; beside one that sticks.
TEST(SteadyAttracting, TheQuickSearchFindsOneThatSlides) {
    const double mu = 0.1617515627;
    const auto found = found_quickly(
        {3, 0.8090463513, 0.1745154876, mu, 0.0822257955, Law::newton, uniform_inertia_factor<double>(3)});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_LT(std::abs(std::tan(found[0].chi)), 0.99 * mu);
    EXPECT_NEAR(std::abs(std::tan(found[1].chi)), mu, 1e-12);
    EXPECT_NEAR(found[1].point.spin, 1 - 2 * pi<double>() / (3 * found[1].tau), 1e-12);
}

/// With 30,000 sides so many solutions slide that none of these was left where all were counted together.
TEST(SteadyAttracting, TheQuickSearchFindsThemBesideThoseThatSlide) {
    const auto found =
        found_quickly({30'000, 0.1, 0.5, 4e-5, 0.9999, Law::poisson, uniform_inertia_factor<double>(30'000)});
    EXPECT_EQ(found.size(), 97U);
}

TEST(SteadyAttractingNightly, TheQuickSearchFindsThemInFiveThousandScenes) {
    compare_attracting(5000, 12);
}

}  // namespace
}  // namespace swirl
