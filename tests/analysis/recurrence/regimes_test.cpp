// One oracle per regime: recurrence quantification of motions that are known exactly.
#include "analysis/recurrence/measures.hpp"
#include "analysis/recurrence/rates.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

const double golden = (std::sqrt(5.0) - 1) / 2;

std::vector<double> rotation(std::size_t n) {  // theta += golden, period 1
    std::vector<double> angles(n);
    for (std::size_t i = 0; i < n; ++i) angles[i] = std::fmod(golden * static_cast<double>(i), 1.0);
    return angles;
}

std::vector<double> logistic(std::size_t n) {
    std::vector<double> series(n);
    double x = 0.3;
    for (double& v : series) v = x = 4 * x * (1 - x);
    return series;
}

TEST(Regime, FixedPointHasRcOne) {
    const std::vector<double> constant(500, 0.7);
    const Points points = embed_series(constant);
    EXPECT_EQ(recurrence_rate(points, 1e-6).with_diagonal(), 1);
    EXPECT_EQ(recurrence_rate(points, 1e-6).without_diagonal(), 1);
    const Measures m = measures(count_lines(points, 1e-6));
    EXPECT_EQ(m.RR, 1);
    EXPECT_EQ(m.Lmax, 499);
    EXPECT_EQ(m.LAM, (500.0 * 499 - 2) / (500 * 499));  // columns 1 and 498 keep a line of one point each
}

TEST(Regime, CycleOfKHasRcOneOverKAndDetOne) {
    for (const std::size_t k : {2u, 3u, 7u}) {
        std::vector<double> series;
        for (std::size_t i = 0; i < 60 * k; ++i) series.push_back(std::cos(static_cast<double>(i % k)));
        const Points points = embed_series(series);
        EXPECT_EQ(recurrence_rate(points, 1e-6).with_diagonal(), 1.0 / static_cast<double>(k));
        const Measures m = measures(count_lines(points, 1e-6));
        EXPECT_EQ(m.DET, 1) << k;
        EXPECT_EQ(m.Lmax, static_cast<double>(59 * k));
        EXPECT_EQ(m.LAM, 0);
    }
}

TEST(Regime, CycleReturnsAfterItsPeriod) {
    std::vector<double> series;
    for (std::size_t i = 0; i < 350; ++i) series.push_back(std::cos(static_cast<double>(i % 7)));
    Settings s;
    s.theiler = 0;
    s.recurrence_time = RecurrenceTime::line_starts;
    const Measures m = measures(count_lines(embed_series(series), 1e-6, s), s);
    EXPECT_EQ(m.MRT, 7);
    EXPECT_EQ(m.RTE, 0);
}

// A rotation is isometric: its recurrence plot consists of full diagonals. The points fill the circle evenly: the share
// in any arc is its length up to the discrepancy, at most (3 + (1/ln(1/golden) + 1/ln 2) ln n) / n for the golden mean
// (Kuipers & Niederreiter, Uniform Distribution of Sequences, theorem 2.3.4), and so is RC, a mean of such shares.
TEST(Regime, GoldenRotationHasRrTwiceTheThreshold) {
    const std::size_t n = 40000;
    const double delta = 0.03;
    const double discrepancy =
        (3 + (1 / -std::log(golden) + 1 / std::log(2.0)) * std::log(static_cast<double>(n))) / static_cast<double>(n);
    EXPECT_LT(discrepancy, 0.02 * 2 * delta);
    EXPECT_NEAR(recurrence_rate(embed_series(rotation(n), 1, 1, 1.0), delta).with_diagonal(), 2 * delta, discrepancy);
    const Measures m = measures(count_lines(embed_series(rotation(4000), 1, 1, 1.0), delta));
    EXPECT_EQ(m.DET, 1);
    EXPECT_EQ(m.LAM, 0);
}

// Slater's three gap theorem: the times between returns to an interval take at most three values, the largest the sum
// of the other two. (Interval of length 2 delta: the column of one point.)
TEST(Regime, GoldenRotationHasThreeReturnTimes) {
    Settings s;
    s.theiler = 0;
    s.recurrence_time = RecurrenceTime::line_starts;
    const LineHistograms lines = count_lines(embed_series(rotation(5000), 1, 1, 1.0), 0.0301, s);
    std::vector<std::size_t> times;
    for (std::size_t t = 1; t < lines.recurrence_time.size(); ++t)
        if (lines.recurrence_time[t] != 0) times.push_back(t);
    ASSERT_EQ(times.size(), 3u);
    EXPECT_EQ(times[0] + times[1], times[2]);
}

// Logistic map at r = 4: invariant density 1 / (pi sqrt(x (1 - x))), so with x = sin^2(pi u / 2), u uniform,
// RR(delta) is an integral over two independent u. Sampling error from 8 blocks of one orbit, 5 standard errors.
TEST(Regime, ChaoticLogisticMapHasTheRateOfItsInvariantDensity) {
    const double delta = 0.05;
    const int grid = 2000;
    double expected = 0;
    for (int a = 0; a < grid; ++a) {
        const double x = std::pow(std::sin(M_PI * (a + 0.5) / (2 * grid)), 2);
        const auto u = [](double v) { return 2 / M_PI * std::asin(std::sqrt(std::clamp(v, 0.0, 1.0))); };
        expected += (u(x + delta) - u(x - delta)) / grid;
    }
    const std::vector<double> orbit = logistic(80000);
    double mean = 0, square = 0;
    for (std::size_t b = 0; b < 8; ++b) {
        const std::span<const double> block(orbit.data() + 10000 * b, 10000);
        const double rate = recurrence_rate(embed_series(block), delta).without_diagonal();
        mean += rate / 8;
        square += rate * rate / 8;
    }
    const double standard_error = std::sqrt((square - mean * mean) / 7);
    EXPECT_NEAR(mean, expected, 5 * standard_error);
    EXPECT_LT(standard_error, 0.01 * expected);
}

// The number of diagonal lines of a chaotic orbit falls with their length at the rate of its entropy: with nearby
// points separating by a factor 2 per step on average, lines of l points are about exp(-l ln 2) frequent. (Thiel et
// al., Chaos 14 (2004) 234.)
TEST(Regime, ChaoticLogisticMapLosesHalfOfItsLinesPerStep) {
    const LineHistograms lines = count_lines(embed_series(logistic(8000)), 1e-3);
    double longer_4 = 0, longer_9 = 0;  // lines of at least 4, at least 9 points
    for (std::size_t l = 4; l < lines.diagonal.size(); ++l) longer_4 += static_cast<double>(lines.diagonal[l]);
    for (std::size_t l = 9; l < lines.diagonal.size(); ++l) longer_9 += static_cast<double>(lines.diagonal[l]);
    // Over 20 other starting points the ratio to ln 2 has mean 0.998 and standard deviation 0.018: three of it.
    EXPECT_NEAR(std::log(longer_4 / longer_9) / 5, std::log(2.0), 3 * 0.018 * std::log(2.0));
}

// A cycle of three seen with 1 % noise: at a threshold far below the noise RC no longer reads the period; at one above
// it, it does, with the same lines as the clean cycle.
TEST(Regime, CycleWithNoiseIsReadAtAThresholdAboveTheNoise) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0, 0.01);
    std::vector<double> series;
    for (std::size_t i = 0; i < 3000; ++i) series.push_back(static_cast<double>(i % 3) + noise(random));
    const Points points = embed_series(series);
    EXPECT_LT(recurrence_rate(points, 1e-6).without_diagonal(), 1e-3);
    EXPECT_EQ(recurrence_rate(points, 0.2).with_diagonal(), 1.0 / 3);
    const Measures m = measures(count_lines(points, 0.2));
    EXPECT_EQ(m.DET, 1);
    EXPECT_EQ(m.Lmax, 2997);
}

}  // namespace
}  // namespace swirl::analysis::recurrence
