#include "analysis/lyapunov/exponent_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace {

using namespace swirl::analysis;

BlockSums accumulate(int steps, const std::vector<double>& series) {
    BlockSums blocks(1);
    for (int i = 0; i < steps; ++i) blocks.add({series[i]});
    return blocks;
}

TEST(BlockSums, KeepsEverythingInBetween32And64Blocks) {
    std::vector<double> ones(10000, 1.0);
    for (const int steps : {64, 100, 1000, 9999}) {
        const BlockSums blocks = accumulate(steps, ones);
        EXPECT_GE(blocks.blocks(), 32U);
        EXPECT_LT(blocks.blocks(), 64U);
        for (const double sum : blocks.sums(0)) EXPECT_EQ(sum, static_cast<double>(blocks.block_length()));
        EXPECT_LE(static_cast<std::int64_t>(blocks.blocks()) * blocks.block_length(), steps);
        EXPECT_GT(static_cast<std::int64_t>(blocks.blocks() + 1) * blocks.block_length(), steps);
    }
}

TEST(BlockSums, StandardErrorOfWhiteNoiseAndOfSlowNoise) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    // 32 to 64 blocks know the error to 1/√(2·32) = 12 %; 4 of these.
    std::vector<double> white(60000);
    for (double& x : white) x = normal(random);
    const BlockSums blocks = accumulate(60000, white);
    const double found = block_error(blocks.sums(0)).standard_error / static_cast<double>(blocks.block_length());
    EXPECT_NEAR(found, 1 / std::sqrt(60000.0), 0.5 / std::sqrt(60000.0));
    // An autoregression of correlation a has (1 + a)/(1 − a) times the variance of the mean.
    std::vector<double> slow(60000);
    double x = 0;
    for (double& y : slow) {
        x = 0.98 * x + std::sqrt(1 - 0.98 * 0.98) * normal(random);
        y = x;
    }
    const BlockSums slow_blocks = accumulate(60000, slow);
    const double slow_error =
        block_error(slow_blocks.sums(0)).standard_error / static_cast<double>(slow_blocks.block_length());
    const double exact = std::sqrt(1.98 / 0.02 / 60000);
    EXPECT_NEAR(slow_error, exact, 0.5 * exact);
}

TEST(DyadicSquares, GrowthOrders) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    DyadicSquares drift;
    DyadicSquares bounded;
    DyadicSquares none;
    for (int i = 0; i < 4000; ++i) {
        drift.add(0.1);
        bounded.add(std::cos(1.0 * (i + 1)) - std::cos(1.0 * i));
        none.add(0);
    }
    EXPECT_NEAR(drift.growth_order(), 1, 1e-12);
    EXPECT_NEAR(bounded.growth_order(), 0, 0.1);
    EXPECT_EQ(none.growth_order(), 0);
    EXPECT_TRUE(std::isnan(DyadicSquares{}.growth_order()));
    // A walk's longest blocks, 16 to 31, know their size to 1/√32; over five octaves that is 0.05 in the slope.
    for (int repeat = 0; repeat < 50; ++repeat) {
        DyadicSquares walk;
        for (int i = 0; i < 4000; ++i) walk.add(normal(random));
        EXPECT_NEAR(walk.growth_order(), 0.5, 4 * 0.06);
    }
}

}  // namespace
