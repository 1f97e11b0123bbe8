// Rates of escape from lives whose rate is known.
#include "analysis/classification/escape_rate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace swirl::analysis {
namespace {

/// Lives at one rate, watched for `watched` steps.
std::vector<ChaoticStay> stays_at(std::mt19937_64& engine, double rate, int orbits, double watched) {
    std::exponential_distribution<double> life(rate);
    std::vector<ChaoticStay> stays;
    for (int i = 0; i < orbits; ++i) {
        const double end = life(engine);
        stays.push_back({static_cast<std::int64_t>(std::ceil(std::min(end, watched))), end < watched});
    }
    return stays;
}

TEST(EscapeRate, ByHand) {
    const ChaoticStay stays[] = {{1100, true}, {1300, true}, {1600, false}, {200, true}};
    const EscapeRate rate = escape_rate(stays, 100);
    EXPECT_EQ(rate.left, 3);
    EXPECT_EQ(rate.remaining, 1);
    EXPECT_DOUBLE_EQ(rate.rate, 3.0 / 3800);
    EXPECT_DOUBLE_EQ(rate.half_life, std::log(2) * 3800 / 3);
    // χ² with 6 degrees of freedom below, with 8 above, as one orbit is still watched: 1.237344 and 17.534546 (tables).
    EXPECT_NEAR(rate.least_rate * 2 * 3800, 1.237344, 1e-6);
    EXPECT_NEAR(rate.most_rate * 2 * 3800, 17.534546, 1e-6);
    // Of the first two both have left: 4 on both sides, 11.143287.
    EXPECT_NEAR(escape_rate(std::span(stays).first(2), 100).most_rate * 2 * 2200, 11.143287, 1e-6);
    EXPECT_TRUE(rate.others_will_leave);
}

TEST(EscapeRate, NoneThatLeftBoundsTheRate) {
    const ChaoticStay stays[] = {{1000, false}, {500, false}};
    const EscapeRate rate = escape_rate(stays, 0);
    EXPECT_EQ(rate.rate, 0);
    EXPECT_DOUBLE_EQ(rate.most_rate, 3.0 / 1500);
    EXPECT_TRUE(std::isinf(rate.half_life));
    EXPECT_FALSE(rate.others_will_leave);
}

TEST(EscapeRate, TheIntervalHoldsTheRateAndTheRestWillLeave) {
    std::mt19937_64 engine(5);
    constexpr double rate = 1e-4;
    constexpr int trials = 500;
    int held = 0, forecast = 0;
    for (int i = 0; i < trials; ++i) {
        const EscapeRate found = escape_rate(stays_at(engine, rate, 40, 10'000), 1000);
        held += found.least_rate <= rate && rate <= found.most_rate ? 1 : 0;
        forecast += found.others_will_leave ? 1 : 0;
    }
    EXPECT_GE(held, 0.92 * trials);      // 95 %, for lives that are cut, in about 20 escapes
    EXPECT_GE(forecast, 0.92 * trials);  // 5 % look improbable by definition
}

TEST(ChanceOfLeaving, ByHandAndOfLives) {
    // χ²_{0.95} with 2 and 6 degrees of freedom: 5.991465 and 12.591587 (tables).
    EXPECT_NEAR(chance_of_leaving(0, 1000, 500), 1 - std::exp(-5.991465 / 2000 * 500), 1e-6);
    EXPECT_NEAR(chance_of_leaving(2, 1000, 500), 1 - std::exp(-12.591587 / 2000 * 500), 1e-6);
    EXPECT_EQ(chance_of_leaving(0, 1000, 0), 0);
    EXPECT_EQ(chance_of_leaving(0, 0, 10), 1);
    std::mt19937_64 engine(7);
    constexpr double rate = 1e-4;
    constexpr int trials = 1000;
    int held = 0;
    for (int i = 0; i < trials; ++i) {
        const EscapeRate found = escape_rate(stays_at(engine, rate, 40, 10'000), 0);
        held += -std::expm1(-rate * 2000) <= chance_of_leaving(found.left, found.steps, 2000) ? 1 : 0;
    }
    EXPECT_GE(held, 0.93 * trials);  // 95 %, less three standard deviations of 0.7 %
}

// Half of the orbits on a chaotic attractor of their own: those are not said to leave.
TEST(EscapeRate, WhereAnAttractorIsChaoticTheRestStay) {
    std::mt19937_64 engine(6);
    constexpr int trials = 200;
    int wrong = 0;
    for (int i = 0; i < trials; ++i) {
        auto stays = stays_at(engine, 1e-3, 40, 10'000);
        for (int j = 0; j < 40; ++j) stays.push_back({10'000, false});
        wrong += escape_rate(stays, 500).others_will_leave ? 1 : 0;
    }
    EXPECT_LE(wrong, 0.02 * trials);
}

}  // namespace
}  // namespace swirl::analysis
