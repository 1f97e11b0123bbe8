// The families of steady modes at e = 1: members against published numbers, ends against closed forms.
#include "map/steady/steady_modes.hpp"

#include <gtest/gtest.h>
#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl {
namespace {

Scene<double> elastic(int sides, double alpha, double beta, double mu) {
    return {sides, alpha, beta, mu, 1, Law::poisson, uniform_inertia_factor<double>(sides)};
}

SteadyFamily everywhere(SteadyBranch branch) {
    return {branch, 0, 0, 100, false};
}

void expect_moduli(const SteadyMode& mode, std::initializer_list<double> wanted, double tolerance) {
    ASSERT_EQ(mode.multipliers.size(), wanted.size());
    std::size_t i = 0;
    for (const double modulus : wanted) EXPECT_NEAR(std::abs(mode.multipliers[i++]), modulus, tolerance);
}

TEST(SteadyFamilies, MembersOfTheDiskAreThePublishedOnes) {
    const Scene<double> disk = elastic(disk_sides, 0.3, 0.1, 0.5);
    const auto a = member_of(disk, everywhere(SteadyBranch::plus), 1.33899);
    ASSERT_TRUE(a);
    EXPECT_NEAR(a->point.spin, -1.6049495, 5e-8);
    expect_moduli(*a, {1, 0.98723008, 0.98723008, 0}, 5e-9);
    EXPECT_NEAR(std::abs(a->multipliers.front()), 1, 1e-6);
    const auto b = member_of(disk, everywhere(SteadyBranch::plus), 2.5);
    ASSERT_TRUE(b);
    EXPECT_NEAR(b->point.spin, -0.30503695, 5e-9);
    expect_moduli(*b, {1.0072349, 1.0072349, 1, 0}, 5e-8);
    EXPECT_GT(std::abs(b->multipliers.front()), 1 + 1e-6);
    const auto c = member_of(disk, everywhere(SteadyBranch::minus), 1.5);
    ASSERT_TRUE(c);
    EXPECT_NEAR(c->point.spin, -1.663326648805, 5e-13);
    EXPECT_NEAR(std::abs(c->multipliers[0]), 1.6504701093, 5e-11);
}

/// Neimark–Sacker at τ = 2.33112237041442: the pair is on the circle there.
TEST(SteadyFamilies, TheDiskLosesStabilityWhereItIsPublished) {
    const Scene<double> disk = elastic(disk_sides, 0.3, 0.1, 0.5);
    const auto pair = [&](double tau) {
        const auto mode = member_of(disk, everywhere(SteadyBranch::plus), tau);
        for (const auto& m : mode->multipliers)
            if (std::fabs(m.imag()) > 1e-3) return std::abs(m);
        return 0.0;
    };
    EXPECT_NEAR(pair(2.33112237041442), 1, 1e-12);
    EXPECT_LT(pair(2.331), 1 - 1e-6);
    EXPECT_GT(pair(2.3313), 1 + 1e-6);
}

/// The disk's centre, seen from the container's at ξ = x/H from the middle of the flight, H = τ/2, is nearer than
/// 1 − α while ±βK < R, K = 2(1 − cos H cos x − ξ sin H sin x)/(sin²H (1 − ξ²)) (map/steady/README.md).
double clearance(double alpha, double beta, int branch, double tau) {
    const double h = 0.5 * tau, radius = 1 - alpha + branch * beta;
    double least = HUGE_VAL;
    for (int i = 0; i < 20000; ++i) {
        const double xi = i / 20000.0, x = xi * h, s = std::sin(h);
        const double k = 2 * (1 - std::cos(h) * std::cos(x) - xi * s * std::sin(x)) / (s * s * (1 - xi * xi));
        least = std::min(least, radius - branch * beta * k);
    }
    return least;
}

TEST(SteadyFamilies, TheDisksEndWhereTheFlightGrazes) {
    int ends = 0;
    for (const double alpha : {0.1, 0.3, 0.7})
        for (const double beta : {0.05, 0.1, 0.4, 2.0})
            for (const double mu : {0.0, 0.5}) {
                const SteadyModes result = steady_modes(elastic(disk_sides, alpha, beta, mu));
                EXPECT_EQ(result.set, SteadySet::families);
                ASSERT_FALSE(result.families.empty());
                for (const SteadyFamily& family : result.families) {
                    const int branch = static_cast<int>(family.branch);
                    EXPECT_EQ(family.spin_is_free, mu == 0);
                    EXPECT_GT(clearance(alpha, beta, branch, 0.5 * (family.from + family.to)), 0);
                    for (const double end : {family.from, family.to}) {
                        const double inwards = end == family.from ? 1e-4 : -1e-4;
                        const double turns = end / (2 * pi<double>());
                        if (std::fabs(turns - std::round(turns)) < 1e-12 || end == 12) continue;
                        ++ends;
                        EXPECT_LT(clearance(alpha, beta, branch, end - inwards), 0) << end;
                        EXPECT_GT(clearance(alpha, beta, branch, end + inwards), 0) << end;
                    }
                }
            }
    EXPECT_GE(ends, 20);
}

TEST(SteadyFamilies, TheFirstBeginsAtRolling) {
    for (const double alpha : {0.1, 0.3, 0.7}) {
        const Scene<double> disk = elastic(disk_sides, alpha, 0.2, 0.5);
        const SteadyFamily first = steady_modes(disk).families.front();
        EXPECT_EQ(first.from, 0);
        const auto mode = member_of(disk, first, 1e-3);
        ASSERT_TRUE(mode);
        EXPECT_NEAR(mode->point.spin, -(1 - alpha) / alpha, 1e-6 / alpha);  // the next term is Rτ²/6α
    }
}

/// Without friction a polygon has a family for each j, a frictionless disk one for every S: all their members close.
TEST(SteadyFamilies, MembersWithoutFrictionAreFixedPoints) {
    int members = 0;
    const auto check = [&](const Scene<double>& scene, double spin) {
        for (const SteadyFamily& family : steady_modes(scene, {.longest_flight = 7, .most_steps = 4}).families)
            for (const double share : {0.01, 0.3, 0.6, 0.99}) {
                const double tau = family.from + share * (family.to - family.from);
                const auto mode = member_of(scene, family, tau, spin);
                if (!mode && share > 0.05 && share < 0.95) ADD_FAILURE() << scene.sides << " tau = " << tau;
                members += mode.has_value();
                if (mode && !scene.is_disk()) {
                    EXPECT_DOUBLE_EQ(mode->point.spin, steady::spin_of(scene, tau, family.j));
                }
            }
    };
    for (const double beta : {0.1, 0.6}) {
        check(elastic(disk_sides, 0.3, beta, 0), 3.7);
        check(elastic(3, 0.5, beta, 0), 0);
        check(elastic(6, 0.3, beta, 0), 0);
    }
    EXPECT_GE(members, 100);
}

}  // namespace
}  // namespace swirl
