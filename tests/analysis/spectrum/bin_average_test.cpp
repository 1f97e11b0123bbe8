#include "analysis/spectrum/bin_average.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

using swirl::analysis::bin_averages;
using swirl::analysis::BinAverager;

constexpr double eps = std::numeric_limits<double>::epsilon();

TEST(BinAverage, TwoPiecesOverThreeBinsByHand) {
    // 1 on [0, 1), 4 on [1, 3): bins of length 1.
    const std::vector<double> times = {0, 1, 3};
    const std::vector<double> values = {1, 4};
    EXPECT_EQ(bin_averages(times, values, 3).values, (std::vector<double>{1, 4, 4}));
    // Bins of length 1.5: (1 + 4/2)/1.5 = 2 and 4.
    const auto halves = bin_averages(times, values, 2);
    EXPECT_EQ(halves.values, (std::vector<double>{2, 4}));
    EXPECT_EQ(halves.start, 0.75);
    EXPECT_EQ(halves.spacing, 1.5);
}

TEST(BinAverage, TheMeanOfTheBinsIsTheMeanOfTheSignal) {
    std::mt19937_64 random(7);
    std::exponential_distribution<double> duration(1.0);
    std::normal_distribution<double> value;
    std::vector<double> times = {10.0};
    std::vector<double> values;
    double integral = 0;
    for (int i = 0; i < 5000; ++i) {
        const double tau = duration(random);
        values.push_back(value(random));
        times.push_back(times.back() + tau);
        integral += values.back() * (times.back() - times[times.size() - 2]);
    }
    for (const std::size_t bins : {1UL, 7UL, 1000UL, 40000UL}) {
        const auto series = bin_averages(times, values, bins);
        ASSERT_EQ(series.values.size(), bins);
        double sum = 0;
        for (const double x : series.values) sum += x * series.spacing;
        // 45,000 roundings of times of size 5,000, each multiplied by a value of size 1, adding up at random.
        EXPECT_NEAR(sum, integral, 200 * eps * 5000);
    }
}

TEST(BinAverage, AConstantSignalStaysConstant) {
    std::vector<double> times = {0};
    for (int i = 1; i <= 100; ++i) times.push_back(times.back() + 0.1 + 0.01 * i);
    const std::vector<double> values(100, 0.3);
    for (const double x : bin_averages(times, values, 997).values) EXPECT_NEAR(x, 0.3, 2 * eps);
}

TEST(BinAverage, MergedBinsAreTheBinsOfTwiceTheWidth) {
    BinAverager<double> bounded(0, 0.25, 8);
    BinAverager<double> wide(0, 1.0);
    for (int i = 0; i < 27; ++i) {
        bounded.add_constant(0.3 * (i + 1), std::sin(i));
        wide.add_constant(0.3 * (i + 1), std::sin(i));
    }
    // 8.1 time units: 8 bins of ¼ fill at t = 2, of ½ at 4, of 1 at 8; then 4 of width 2.
    ASSERT_EQ(bounded.width(), 2.0);
    const std::vector<double> merged = bounded.averages();
    const std::vector<double> fine = wide.averages();
    ASSERT_EQ(merged.size(), 4U);
    for (std::size_t i = 0; i < merged.size(); ++i) {
        EXPECT_NEAR(merged[i], (fine[2 * i] + fine[2 * i + 1]) / 2, 8 * eps);
    }
    EXPECT_NEAR(bounded.mean(), wide.mean(), 8 * eps);
}

TEST(BinAverage, AnyPieceIsAveragedByItsIntegral) {
    BinAverager<double> averager(0, 0.5);
    averager.add(2, [](double a, double b) { return std::cos(a) - std::cos(b); });
    const auto bins = averager.averages();
    ASSERT_EQ(bins.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const double a = 0.5 * static_cast<double>(i);
        EXPECT_NEAR(bins[i], (std::cos(a) - std::cos(a + 0.5)) / 0.5, 4 * eps);
    }
}

TEST(BinAverage, MeanSquareIsThatOfTheSignalNotOfTheBins) {
    BinAverager<double> averager(0, 2);
    for (int i = 1; i <= 8; ++i) averager.add_constant(i, i % 2 == 0 ? 1 : -1);
    EXPECT_EQ(averager.mean(), 0);
    EXPECT_EQ(averager.mean_square(), 1);
    EXPECT_EQ(averager.averages(), std::vector<double>(4, 0.0));
}

TEST(BinAverage, RefusesWhatIsNotASignal) {
    const std::vector<double> values = {1, 2};
    EXPECT_THROW(bin_averages(std::vector<double>{0, 1}, values, 3), std::invalid_argument);
    EXPECT_THROW(bin_averages(std::vector<double>{0, 2, 1}, values, 3), std::invalid_argument);
    EXPECT_THROW(bin_averages(std::vector<double>{0, 0, 0}, values, 3), std::invalid_argument);
    EXPECT_THROW(bin_averages(std::vector<double>{0, 1, NAN}, values, 3), std::invalid_argument);
    EXPECT_THROW(bin_averages(std::vector<double>{0, 1, 2}, values, 0), std::invalid_argument);
    EXPECT_THROW(bin_averages(std::vector<double>{0, 1, 2}, std::vector<double>{1, NAN}, 3), std::invalid_argument);
    EXPECT_THROW(BinAverager<double>(0, -1), std::invalid_argument);
    EXPECT_THROW(BinAverager<double>(0, 1, 3), std::invalid_argument);
    BinAverager<double> too_fine(0, 1e-10);
    EXPECT_THROW(too_fine.add_constant(1e9, 1), std::invalid_argument);
}

}  // namespace
