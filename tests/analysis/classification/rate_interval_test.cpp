// The interval of a rate against closed forms, published values, and its own promise.
#include "analysis/classification/escape_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

namespace swirl::analysis {
namespace {

TEST(RateInterval, NoneOfManyIsBelowThreeInThem) {
    for (const int n : {1, 7, 100, 1'000'000}) {
        const RateInterval none = rate_interval(0, n), all = rate_interval(n, n);
        EXPECT_EQ(none.rate, 0);
        EXPECT_EQ(none.least, 0);
        EXPECT_NEAR(none.most / -std::expm1(std::log(0.05) / n), 1, 1e-12) << n;
        EXPECT_LT(none.most * n, 3) << n;
        EXPECT_EQ(all.most, 1);
        EXPECT_NEAR(all.least, 1 - none.most, 1e-12) << n;
    }
    EXPECT_NEAR(rate_interval(0, 1'000'000).most * 1e6, 2.9957, 1e-4);
}

// R's binom.test(7, 20) and binom.test(5, 10).
TEST(RateInterval, PublishedValues) {
    const RateInterval seven = rate_interval(7, 20), half = rate_interval(5, 10);
    EXPECT_DOUBLE_EQ(seven.rate, 0.35);
    EXPECT_NEAR(seven.least, 0.1539092, 1e-7);
    EXPECT_NEAR(seven.most, 0.5921885, 1e-7);
    EXPECT_NEAR(half.least, 0.1870860, 1e-7);
    EXPECT_NEAR(half.most, 0.8129140, 1e-7);
}

TEST(RateInterval, HoldsTheTrueRateInNineteenOfTwentyCases) {
    std::mt19937_64 engine(1);
    for (const double rate : {0.001, 0.03, 0.5}) {
        std::binomial_distribution<int> draw(200, rate);
        int held = 0;
        for (int i = 0; i < 2000; ++i) {
            const RateInterval found = rate_interval(draw(engine), 200);
            held += found.least <= rate && rate <= found.most ? 1 : 0;
        }
        EXPECT_GE(held, 1870) << rate;  // 1900 less three standard deviations, √(2000 · 0.05 · 0.95) = 9.7 each
    }
}

TEST(RateInterval, WrongCountsAreRefusedAndNoTrialsTellNothing) {
    EXPECT_THROW(rate_interval(3, 2), std::invalid_argument);
    EXPECT_THROW(rate_interval(-1, 2), std::invalid_argument);
    EXPECT_THROW(rate_interval(0, -1), std::invalid_argument);
    const RateInterval nothing = rate_interval(0, 0);
    EXPECT_TRUE(std::isnan(nothing.rate));
    EXPECT_EQ(nothing.least, 0);
    EXPECT_EQ(nothing.most, 1);
}

TEST(MostRate, AtTheBoundAsFewAreAsRareAsItSays) {
    EXPECT_NEAR(most_rate(0, 299, 0.95), 1 - std::pow(0.05, 1.0 / 299), 1e-14);
    EXPECT_LT(most_rate(0, 299, 0.95), 0.01);
    EXPECT_GT(most_rate(0, 298, 0.95), 0.01);
    // (1 − p)^n + n p (1 − p)^{n − 1} = 1 − c at the bound of one in n.
    const double p = most_rate(1, 473, 0.95);
    EXPECT_NEAR(std::pow(1 - p, 473) + 473 * p * std::pow(1 - p, 472), 0.05, 1e-12);
    EXPECT_EQ(most_rate(4, 4, 0.9), 1);
    EXPECT_EQ(most_rate(0, 0, 0.9), 1);
    EXPECT_THROW(most_rate(0, 3, 1), std::invalid_argument);
    EXPECT_THROW(most_rate(0, 3, std::nan("")), std::invalid_argument);
    EXPECT_THROW(most_rate(4, 3, 0.95), std::invalid_argument);
}

}  // namespace
}  // namespace swirl::analysis
