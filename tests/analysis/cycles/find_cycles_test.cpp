// Cycles of maps whose cycles are known.
#include "analysis/cycles/find_cycles.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/logistic.hpp"
#include "tests/analysis/maps/standard_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace swirl::analysis {
namespace {

double unit(std::mt19937_64& engine) {
    return static_cast<double>(engine() >> 11) * 0x1p-53;
}

CyclePoints guess_from(const ShootingMap& map, Eigen::VectorXd z, int k) {
    CyclePoints points;
    for (int i = 0; i < k; ++i) {
        points.push_back(z);
        const ShootingStep step = map.step(z, 0);
        if (!step.alive) return {};
        z = step.state;
    }
    return points;
}

/// Random points of a box, and the close returns of a trajectory that starts in it.
std::vector<CyclePoints> candidates_in_box(const ShootingMap& map, int k, int starts, double low, double high) {
    std::mt19937_64 engine(7);
    std::vector<CyclePoints> candidates;
    for (int i = 0; i < starts; ++i) {
        Eigen::VectorXd z(map.dimension);
        for (int j = 0; j < map.dimension; ++j) z[j] = low + (high - low) * unit(engine);
        CyclePoints guess = guess_from(map, z, k);
        if (!guess.empty()) candidates.push_back(std::move(guess));
    }
    return candidates;
}

std::vector<CyclePoints> returns_from(const ShootingMap& map, const Eigen::VectorXd& start, int k, int length) {
    const CyclePoints trajectory = guess_from(map, start, length);
    return close_returns(map, trajectory, k, 400, 0.2);
}

// Counts of prime cycles at a = 1.4, b = 0.3 (Biham & Wenzel 1989, and an exhaustive search over symbol sequences).
TEST(FindCycles, EveryCycleOfHenonUpToPeriodTen) {
    constexpr int counts[] = {2, 1, 0, 1, 0, 2, 4, 7, 6, 10};
    const maps::Henon henon;
    const ShootingMap map = shooting_map(henon);
    for (int k = 1; k <= 10; ++k) {
        auto candidates = candidates_in_box(map, k, 200, -1.3, 1.3);
        for (auto& guess : returns_from(map, Eigen::Vector2d(0.1, 0.1), k, 20000)) candidates.push_back(guess);
        SearchOptions options;
        options.period = k;
        const SearchResult result = find_cycles(map, 0, candidates, options);
        EXPECT_EQ(result.cycles.size(), static_cast<std::size_t>(counts[k - 1])) << "period " << k;
        for (const Cycle& cycle : result.cycles) {
            EXPECT_LE(cycle.residual, 64 * 0x1p-52) << "period " << k;
            EXPECT_EQ(cycle.stability, Stability::unstable);
            double product = 1;
            for (const auto& multiplier : cycle.multipliers) product *= std::abs(multiplier);
            EXPECT_NEAR(product, std::pow(0.3, k), 1e-12 * std::abs(cycle.multipliers[0]));  // det DF = −b
        }
    }
}

// [tests/references/README.md] Fixed points and the 2-cycle, with multipliers.
TEST(FindCycles, OfHenonHaveTheirPublishedMultipliers) {
    const maps::Henon henon;
    const ShootingMap map = shooting_map(henon);
    SearchOptions options;
    auto fixed = find_cycles(map, 0, candidates_in_box(map, 1, 50, -2, 2), options).cycles;
    ASSERT_EQ(fixed.size(), 2U);
    if (fixed[0].points[0][0] < 0) std::swap(fixed[0], fixed[1]);
    EXPECT_NEAR(fixed[0].points[0][0], 0.6313544770895047, 4e-16);
    EXPECT_NEAR(fixed[0].multipliers[0].real(), -1.92373886, 5e-9);
    EXPECT_NEAR(fixed[0].multipliers[1].real(), 0.15594632, 5e-9);
    EXPECT_NEAR(fixed[1].points[0][0], -1.1313544770895047, 4e-16);
    EXPECT_NEAR(fixed[1].multipliers[0].real(), 3.25982210, 5e-9);
    EXPECT_NEAR(fixed[1].multipliers[1].real(), -0.09202956, 5e-9);
    options.period = 2;
    const auto two = find_cycles(map, 0, candidates_in_box(map, 2, 50, -1.3, 1.3), options).cycles;
    ASSERT_EQ(two.size(), 1U);
    EXPECT_NEAR(std::max(two[0].points[0][0], two[0].points[1][0]), 0.975800051, 5e-10);
    EXPECT_NEAR(two[0].multipliers[0].real(), -3.01010067, 5e-9);
    EXPECT_NEAR(two[0].multipliers[1].real(), -0.02989933, 5e-9);
    EXPECT_EQ(two[0].index, 1);
}

// [tests/references/README.md, from ChaosTools.jl] Conservative: angles modulo 2π, multipliers of product 1.
TEST(FindCycles, OfTheStandardMapHoldAnglesAsAngles) {
    const maps::StandardMap standard;
    const ShootingMap map = shooting_map(standard);
    SearchOptions options;
    options.period = 2;
    const auto cycles = find_cycles(map, 0, candidates_in_box(map, 2, 400, -M_PI, M_PI), options).cycles;
    bool found = false;
    for (const Cycle& cycle : cycles) {
        EXPECT_NEAR(std::abs(cycle.multipliers[0] * cycle.multipliers[1]), 1, 1e-12);
        for (const auto& z : cycle.points)
            found = found || map.distance(z, Eigen::Vector2d(1.3346, 2.6693)) < 1e-4 ||
                    map.distance(z, Eigen::Vector2d(2.6693, 1.3346)) < 1e-4;
    }
    EXPECT_TRUE(found);
}

// The tangent 3-cycle at r = 1 + √8 is double: just above it there are two, below none.
TEST(FindCycles, TwoThreeCyclesAboveTheirFoldAndNoneBelow) {
    for (const double shift : {-1e-3, 1e-3}) {
        maps::Logistic logistic;
        logistic.r = 1 + std::sqrt(8.0) + shift;
        const ShootingMap map = shooting_map(logistic);
        SearchOptions options;
        options.period = 3;
        const auto cycles = find_cycles(map, 0, candidates_in_box(map, 3, 200, 0, 1), options).cycles;
        ASSERT_EQ(cycles.size(), shift < 0 ? 0U : 2U);
        if (!cycles.empty()) {
            EXPECT_NE(cycles[0].stability, cycles[1].stability);
        }
    }
}

TEST(FindCycles, DoesNotDependOnThreads) {
    const maps::Henon henon;
    const ShootingMap map = shooting_map(henon);
    const auto candidates = candidates_in_box(map, 4, 100, -1.3, 1.3);
    SearchOptions one, two;
    one.period = two.period = 4;
    one.threads = 1;
    two.threads = 2;
    const auto a = find_cycles(map, 0, candidates, one).cycles, b = find_cycles(map, 0, candidates, two).cycles;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a[i].points.size(); ++j) EXPECT_EQ(a[i].points[j], b[i].points[j]);
}

}  // namespace
}  // namespace swirl::analysis
