// Chao's estimator on draws from populations whose size is known.
#include "analysis/cycles/find_cycles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace swirl::analysis {
namespace {

/// How often each of those that were drawn was.
std::vector<std::int64_t> draws(std::mt19937_64& engine, const std::vector<double>& weights, int count) {
    std::discrete_distribution<std::size_t> draw(weights.begin(), weights.end());
    std::vector<std::int64_t> times(weights.size(), 0);
    for (int i = 0; i < count; ++i) ++times[draw(engine)];
    std::erase(times, 0);
    return times;
}

TEST(UnseenCycles, TheFormulaByHand) {
    const std::int64_t times[] = {1, 1, 1, 2, 5};
    const UnseenCycles unseen = unseen_cycles(times);
    EXPECT_EQ(unseen.samples, 10);
    EXPECT_EQ(unseen.found, 5);
    EXPECT_EQ(unseen.once, 3);
    EXPECT_EQ(unseen.twice, 1);
    EXPECT_DOUBLE_EQ(unseen.missed, 0.9 * 3 * 2 / (2 * 2));
}

TEST(UnseenCycles, NoneAreMissedWhereAllWereFoundOften) {
    for (const auto& times : {std::vector<std::int64_t>{}, {7, 9, 4}, {1, 80, 3}}) {
        const UnseenCycles unseen = unseen_cycles(times);
        EXPECT_EQ(unseen.missed, 0);
        EXPECT_FALSE(std::signbit(unseen.missed));
        EXPECT_EQ(unseen.most_missed, 0);
    }
}

// Equally easy to find: the mean of the estimate is the number missed, and 95 % of the intervals hold it.
TEST(UnseenCycles, HundredEqualOnesAreEstimatedFromFewDraws) {
    std::mt19937_64 engine(11);
    constexpr int trials = 2000;
    for (const int count : {80, 150}) {
        double sum = 0, square = 0;
        int held = 0;
        for (int i = 0; i < trials; ++i) {
            const UnseenCycles unseen = unseen_cycles(draws(engine, std::vector<double>(100, 1), count));
            const double error = static_cast<double>(unseen.found) + unseen.missed - 100;
            sum += error;
            square += error * error;
            const double missed = 100 - static_cast<double>(unseen.found);
            held += unseen.least_missed <= missed && missed <= unseen.most_missed ? 1 : 0;
        }
        const double spread = std::sqrt(square / trials);
        // The estimator's own bias is of second order in 1/n; five standard errors of the mean besides.
        EXPECT_LE(std::abs(sum / trials), 1.5 + 5 * spread / std::sqrt(trials)) << count;
        EXPECT_GE(held, 0.9 * trials) << count;
    }
}

// Some much harder to find: a lower bound, in the mean.
TEST(UnseenCycles, UnequalOnesAreAtLeastThatMany) {
    std::mt19937_64 engine(12);
    std::vector<double> weights(100, 1);
    for (std::size_t i = 0; i < 50; ++i) weights[i] = 0.05;
    double total = 0;
    constexpr int trials = 500;
    for (int i = 0; i < trials; ++i) {
        const UnseenCycles unseen = unseen_cycles(draws(engine, weights, 200));
        total += static_cast<double>(unseen.found) + unseen.missed;
    }
    EXPECT_LE(total / trials, 100);
    EXPECT_GE(total / trials, 55);
}

}  // namespace
}  // namespace swirl::analysis
