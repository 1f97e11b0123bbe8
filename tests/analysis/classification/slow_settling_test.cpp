// A quantity that comes to its limit like a power, exponentially, or not at all.
#include "analysis/classification/settled.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace swirl::analysis {
namespace {

/// Means over the quarters of n = 1 … 2.
template <class Function>
std::array<double, 4> quarters_of(const Function& value) {
    std::array<double, 4> means{};
    for (int q = 0; q < 4; ++q)
        for (int i = 0; i < 1000; ++i)
            means[static_cast<std::size_t>(q)] += value(1 + 0.25 * (q + (i + 0.5) / 1000)) / 1000;
    return means;
}

TEST(SlowSettling, APowerIsSeenAndWhatIsLeftOfIt) {
    for (const double s : {0.5, 1.0, 2.0, 4.0}) {
        const auto found = settling_of(quarters_of([&](double n) { return 3 + std::pow(n, -s); }));
        EXPECT_NEAR(found.exponent, s + 1, 0.05 * (s + 1)) << s;  // means over quarters, not values
        EXPECT_NEAR(found.remaining / std::pow(2, -s), 1, 0.15) << s;
    }
}

TEST(SlowSettling, WhatFallsFasterLeavesLittle) {
    const auto found = settling_of(quarters_of([](double n) { return -std::exp(-20 * n); }));
    EXPECT_GT(found.exponent, 10);
    EXPECT_LT(found.remaining, 1e-8);
}

TEST(SlowSettling, NoLimitIsNone) {
    for (const auto& quarters : {quarters_of([](double n) { return std::log(n); }),       // p = 1
                                 quarters_of([](double n) { return std::sqrt(n); }),      // grows for ever
                                 quarters_of([](double n) { return n; }),                 // a drift
                                 quarters_of([](double n) { return std::sin(20 * n); }),  // swings
                                 std::array<double, 4>{1, 1, 1, 1}}) {
        EXPECT_FALSE(settling_of(quarters).remaining < 10);
    }
}

}  // namespace
}  // namespace swirl::analysis
