// Steady modes at e = 1 against their closed form (map/README.md, "Steady modes"), worked out here on a grid of its
// own.
#include "analysis/continuation/continue_branch.hpp"
#include "analysis/cycles/family.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/studies/branches/branches.hpp"
#include "tests/apps/studies/cycles/scene_cycles.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>
#include <vector>

namespace swirl {
namespace {

/// At e = 1 with ψ = χ = 0 (`side` 1) or ψ = π, χ = 0 (−1): R, S and how many vertices on the next one is, whole for a
/// steady mode.
double radius_of(const Scene<double>& scene, int side) {
    return side * scene.beta + 1 - scene.alpha;
}
double spin_at(const Scene<double>& scene, double tau, int side = 1) {
    return (side * scene.beta - radius_of(scene, side) * std::sin(tau) / tau) / scene.alpha;
}
double vertices_on(const Scene<double>& scene, double tau, int side) {
    return scene.sides * tau * (1 - spin_at(scene, tau, side)) / (2 * M_PI);
}

/// Every steady mode with χ = 0: roots of vertices_on(τ) = j by bisection, kept where the map itself returns to them.
std::vector<Eigen::VectorXd> steady_modes(const Scene<double>& scene, double longest) {
    const auto map = studies::shooting_map_of(scene);
    std::vector<Eigen::VectorXd> modes;
    constexpr double step = 0.0037;
    for (const int side : {1, -1}) {
        const double radius = radius_of(scene, side);
        if (radius <= 0) continue;
        for (double begin = step; begin < longest; begin += step) {
            const double a = vertices_on(scene, begin, side), b = vertices_on(scene, begin + step, side);
            for (double j = std::ceil(std::min(a, b)); j <= std::max(a, b); ++j) {
                double low = begin, high = begin + step;
                for (int i = 0; i < 60; ++i) {
                    const double middle = 0.5 * (low + high);
                    ((vertices_on(scene, middle, side) - j) * (a - j) > 0 ? low : high) = middle;
                }
                if (low > longest) continue;
                const double half = std::sin(0.5 * low);
                const Eigen::VectorXd z =
                    studies::coordinates_of({side > 0 ? 0 : M_PI, 0, -2 * radius / low * half * half,
                                             radius * std::sin(low) / low, spin_at(scene, low, side)},
                                            false);
                const auto image = map.step(z, 0);
                if (image.alive && map.distance(image.state, z) < 1e-9) modes.push_back(z);
            }
        }
    }
    return modes;
}

/// Of 3 to 12 sides, each `stride`-th.
void expect_every_steady_mode_found(int stride) {
    tests::Random random(4);
    std::size_t all = 0, scenes = 0;
    for (int i = 0; i < 10; ++i) {
        const auto scene = tests::random_scene(random, 3 + i, random.between(0.1, 1), 1, Law::poisson);
        if (i % stride != 0) continue;
        ++scenes;
        const auto modes = steady_modes(scene, 12);
        studies::cycles::FindOptions options;
        options.candidates.starts = options.candidates.trajectories = 0;  // those through contact are not asked for
        const auto cycles = tests::cycles_of(scene, 1, options);
        const auto map = studies::shooting_map_of(scene);
        for (const auto& z : modes) {
            double nearest = 1;
            for (const auto& cycle : cycles) nearest = std::min(nearest, tests::distance_to(map, cycle, z));
            EXPECT_LE(nearest, 1e-9) << "N = " << scene.sides << ", S = " << z[4];
        }
        all += modes.size();
    }
    std::printf("%zu steady modes on %zu scenes\n", all, scenes);
    EXPECT_GE(all, 5 * scenes);
}

TEST(ClosedForm, EverySteadyModeOfFourPolygonsIsFound) {
    expect_every_steady_mode_found(3);
}
TEST(ClosedFormNightly, EverySteadyModeOfTenPolygonsIsFound) {
    expect_every_steady_mode_found(1);
}

// As α → 0 S grows as 1/α, and DF with it; every mode is isolated all the same, and none is missing.
void expect_all_modes_isolated(double alpha) {
    Scene<double> scene{5, alpha, 0.5, 0.5, 1, Law::poisson, uniform_inertia_factor<double>(5)};
    constexpr double longest = 3;
    studies::cycles::FindOptions options;
    options.candidates.starts = options.candidates.trajectories = 0;
    options.max_time = longest;
    const auto cycles = tests::cycles_of(scene, 1, options);
    for (const auto& cycle : cycles) {
        double nearest = 1;
        for (const auto& m : cycle.multipliers) nearest = std::min(nearest, std::abs(m - 1.0));
        EXPECT_EQ(cycle.is_family(), nearest <= analysis::neutral_margin) << "S = " << cycle.points[0][4];
    }
    const auto map = studies::shooting_map_of(scene);
    const auto modes = steady_modes(scene, longest);
    std::size_t missing = 0;
    for (const auto& z : modes)
        if (std::none_of(cycles.begin(), cycles.end(),
                         [&](const auto& c) { return tests::distance_to(map, c, z) < 1e-6; }))
            ++missing;
    std::printf("alpha = %g: %zu modes with psi = chi = 0 listed, %zu found in all\n", alpha, modes.size(),
                cycles.size());
    EXPECT_GE(modes.size(), 50U);
    EXPECT_EQ(missing, 0U) << "alpha = " << alpha;
}

TEST(ClosedForm, ModesOfASmallBodyAreIsolatedAndAllFound) {
    expect_all_modes_isolated(0.003);
}
TEST(ClosedFormNightly, ModesOfATinyBodyAreIsolatedAndAllFound) {
    expect_all_modes_isolated(0.001);
}

Scene<double> disk() {
    return {disk_sides, 0.3, 0.1, 0.5, 1, Law::poisson, 0.5};
}

// [tests/references/README.md] τ = 1.33899: S = −1.6049495, |multipliers| 0.98723008 (a pair), 1, 0; τ
// = 2.5: 1.0072349.
TEST(ClosedForm, MembersOfTheDisksFamily) {
    const auto map = studies::shooting_map_of(disk());
    analysis::Cycle seed;
    seed.points = {studies::coordinates_of(
        {0, 0, -0.8 * std::pow(std::sin(0.5), 2) * 2, 0.8 * std::sin(1.0), spin_at(disk(), 1)}, true)};
    ASSERT_TRUE(analysis::complete_cycle(map, 0, seed));
    ASSERT_EQ(seed.tangents.cols(), 1);
    const auto family = analysis::walk_family(map, 0, seed);
    for (const auto& [tau, spin, modulus] :
         {std::tuple{1.33899, -1.6049495, 0.98723008}, {2.5, -0.30503695, 1.0072349}}) {
        const auto members = analysis::pinned_members(
            map, family, [](const auto& point) { return point.shooting.duration; }, tau);
        ASSERT_EQ(members.size(), 1U);
        analysis::Cycle member;
        member.points = members.front();
        ASSERT_TRUE(analysis::complete_cycle(map, 0, member));
        EXPECT_NEAR(member.return_time, tau, 1e-13);
        EXPECT_NEAR(member.points[0][3], spin_at(disk(), tau), 1e-12);
        EXPECT_NEAR(member.points[0][3], spin, 6e-8);  // as printed
        std::vector<double> moduli;
        for (const auto& m : member.multipliers) moduli.push_back(std::abs(m));
        std::sort(moduli.begin(), moduli.end());
        EXPECT_NEAR(moduli[0], 0, 1e-9);
        EXPECT_NEAR(std::min(moduli[1], moduli[3]), modulus < 1 ? modulus : 1, 6e-8);
        EXPECT_NEAR(moduli[3], modulus < 1 ? 1 : modulus, 6e-8);
    }
}

// [tests/references/README.md] The family loses its stability (Neimark–Sacker) at τ = 2.33112237041442.
TEST(ClosedForm, TheDisksFamilyLosesItsStability) {
    const auto along = apps::parameter_range_from("tau=1:3", false, true);
    const auto scene = studies::scene_branches(disk(), along);
    const double tau = 2;
    const analysis::CyclePoints member = {studies::coordinates_of(
        {0, 0, -2 * 0.8 / tau * std::pow(std::sin(0.5 * tau), 2), 0.8 * std::sin(tau) / tau, spin_at(disk(), tau)},
        true)};
    analysis::Branch branch;
    ASSERT_TRUE(analysis::continue_branch(scene.map, member, 0, scene.options, branch));
    EXPECT_EQ(branch.begin, analysis::CurveEnd::range);
    EXPECT_EQ(branch.end, analysis::CurveEnd::range);
    ASSERT_EQ(branch.special.size(), 1U);
    EXPECT_EQ(branch.special[0].kind, analysis::SpecialKind::neimark_sacker);
    EXPECT_NEAR(branch.special[0].cycle.at.shooting.duration, 2.33112237041442, 1e-8);
    for (const auto& point : branch.points) {
        const double t = point.at.shooting.duration;
        EXPECT_NEAR(point.at.points()[0][3], spin_at(disk(), t), 1e-12) << "tau " << t;
    }
}

}  // namespace
}  // namespace swirl
