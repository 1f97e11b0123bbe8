#include "analysis/means/mean_error.hpp"

#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

using namespace swirl::analysis;

/// x′ = a x + √(1 − a²) ξ, from its own distribution: variance 1, and (1 + a)/(1 − a)/n of the mean.
std::vector<double> autoregression(double a, std::size_t count, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<double> values(count);
    double x = normal(random);
    for (double& value : values) {
        x = a * x + std::sqrt(1 - a * a) * normal(random);
        value = x;
    }
    return values;
}

double mean_of(const std::vector<double>& values) {
    double sum = 0;
    for (const double x : values) sum += x;
    return sum / static_cast<double>(values.size());
}

/// How often ± 2 errors hold a known mean, and the mean of error over true error.
struct Coverage {
    int sampled = 0, held = 0;
    double sizes = 0;
    void add(double off, double true_error, const MeanError& error) {
        if (error.outcome != SamplingOutcome::sampled) return;
        ++sampled;
        held += std::abs(off) <= 2 * error.standard_error;
        sizes += error.standard_error / true_error;
    }
    double share() const { return static_cast<double>(held) / sampled; }
    double size() const { return sizes / sampled; }
};

TEST(MeanError, HoldsTheMeanOfAutoregressionsAsOftenAsItSays) {
    std::mt19937_64 random(1);
    constexpr int series = 400;
    constexpr std::size_t n = 10'000;
    for (const double a : {-0.9, -0.5, 0.0, 0.5, 0.9}) {
        const double true_error = std::sqrt((1 + a) / (1 - a) / n);
        Coverage coverage;
        for (int i = 0; i < series; ++i) {
            const auto values = autoregression(a, n, random);
            coverage.add(mean_of(values), true_error, error_of_mean(values));
        }
        EXPECT_EQ(coverage.sampled, series) << a;
        // 95.4 % of a normal distribution; 400 series know it to 1.05 %: 2.3 of these on each side, and 0.8 for the
        // correlation that is not taken below 0, which makes errors wide by a few per cent.
        EXPECT_GE(coverage.share(), 0.92) << a;
        EXPECT_LE(coverage.share(), 0.986) << a;
        // 39 blocks are 19 pairs, which know r to 0.23; what is above 0 makes errors 1 + 0.23/√(2π) + 0.23²/4 = 1.105
        // times as large. One error scatters by 25 %, the mean of 400 by 1.3: 3 of these.
        EXPECT_NEAR(coverage.size(), 1.105, 0.04) << a;
    }
}

TEST(MeanError, GivesNoneWhereTheSeriesIsShorterThanAHundredMemories) {
    std::mt19937_64 random(2);
    const MeanError slow = error_of_mean(autoregression(0.995, 10'000, random));  // τ = 399: 25 of them
    EXPECT_EQ(slow.outcome, SamplingOutcome::too_short);
    EXPECT_TRUE(std::isnan(slow.standard_error));
    EXPECT_EQ(name_of(slow.outcome), "too-short");
    const MeanError longer = error_of_mean(autoregression(0.995, 400'000, random));  // 1,000 of them
    EXPECT_EQ(longer.outcome, SamplingOutcome::sampled);
    EXPECT_NEAR(longer.correlation_time, 399, 0.6 * 399);  // known to 20 %; 3 of these
    for (const std::size_t few : {0, 1, 20, 100})
        EXPECT_EQ(error_of_mean(autoregression(0, few, random)).outcome, SamplingOutcome::too_short) << few;
}

/// At r = 4 the mean of x is 1/2, and x_i − 1/2 = cos(2^i θ)/(−2) are uncorrelated with variance 1/8: τ = 1.
TEST(MeanError, OfTheLogisticMapIsThatOfIndependentValues) {
    const maps::Logistic map;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(0.05, 0.95);
    constexpr std::size_t n = 4000;
    const double true_error = std::sqrt(0.125 / n);
    Coverage coverage;
    for (int i = 0; i < 400; ++i) {
        Vector<1> z{uniform(random)};
        std::vector<double> values(n);
        for (double& x : values) {
            x = z[0];
            z = map.advance(z).state;
        }
        coverage.add(mean_of(values) - 0.5, true_error, error_of_mean(values));
    }
    EXPECT_EQ(coverage.sampled, 400);
    EXPECT_GE(coverage.share(), 0.92);
    EXPECT_LE(coverage.share(), 0.986);
    EXPECT_NEAR(coverage.size(), 1.08, 0.04);  // 62 blocks, 31 pairs
}

/// Times of 1 + x² with values x in them: R = Σ x (1 + x²)/Σ (1 + x²) has mean 0, x an autoregression. Its variance is
/// that of x + x³ over 2²: Σ_k of a^|k| (1 + 6 + 9) + 6 a^3|k|, for Cov(x_0³, x_k³) = 9 a^k + 6 a^3k, Cov(x_0, x_k³) =
/// 3 a^k.
TEST(MeanError, OfARatioCountsWhatAboveAndBelowHaveInCommon) {
    std::mt19937_64 random(4);
    constexpr double a = 0.6;
    constexpr std::size_t n = 8000;
    const double one = (1 + a) / (1 - a), three = (1 + a * a * a) / (1 - a * a * a);
    const double true_error = std::sqrt((16 * one + 6 * three) / 4 / n);
    Coverage coverage;
    for (int i = 0; i < 400; ++i) {
        const auto x = autoregression(a, n, random);
        std::vector<double> above(n), below(n);
        double sum_above = 0, sum_below = 0;
        for (std::size_t k = 0; k < n; ++k) {
            below[k] = 1 + x[k] * x[k];
            above[k] = x[k] * below[k];
            sum_above += above[k];
            sum_below += below[k];
        }
        coverage.add(sum_above / sum_below, true_error, error_of_ratio(above, below));
    }
    EXPECT_EQ(coverage.sampled, 400);
    EXPECT_GE(coverage.share(), 0.92);
    EXPECT_LE(coverage.share(), 0.986);
    EXPECT_NEAR(coverage.size(), 1.08, 0.04);  // 62 blocks, 31 pairs
}

TEST(MeanError, OfWhatDoesNotVaryIsZero) {
    const std::vector<double> values(1000, 0.25), times(1000, 1.0);
    EXPECT_EQ(error_of_mean(values).standard_error, 0);
    EXPECT_EQ(error_of_ratio(values, times).standard_error, 0);
}

/// Sums of an angle's sine stay bounded: blocks of any length show another τ, and there is no standard error. The bound
/// is the range of Σ_{k ≤ K} sin(2π ρ k), 1/sin(π ρ), over n, and up to once more for the mean that is taken off.
TEST(MeanError, OfATorusIsABoundAlone) {
    constexpr std::size_t n = 10'000;
    const double rho = (std::sqrt(5.0) - 1) / 2;
    std::vector<double> values(n);
    for (std::size_t k = 0; k < n; ++k) values[k] = std::sin(2 * std::numbers::pi * rho * static_cast<double>(k));
    EXPECT_EQ(error_of_mean(values).outcome, SamplingOutcome::too_short);
    const std::vector<double> ones(n, 1.0);
    const double range = 1 / std::sin(std::numbers::pi * rho);
    const double bound = bound_of_ratio(values, ones);
    EXPECT_GT(bound, 0.999 * range / n);  // over the first hundreds of points nothing of the mean is taken off yet
    EXPECT_LT(bound, 2 * range / n);
    EXPECT_LE(std::abs(mean_of(values)), bound);
}

TEST(MeanError, RefusesRatiosWithoutMeaning) {
    const std::vector<double> two{1, 1}, three{1, 1, 1}, none{0, 0};
    EXPECT_THROW(error_of_ratio(two, three), std::invalid_argument);
    EXPECT_THROW(error_of_ratio(two, none), std::invalid_argument);
    EXPECT_THROW(bound_of_ratio(two, three), std::invalid_argument);
}

}  // namespace
