// Modes of series alone: one oracle per regime, without and with 1 % of noise; nothing is guessed.
#include "analysis/classification/classify_series.hpp"

#include "tests/analysis/maps/angle.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace swirl::analysis;
using Series = std::vector<double>;

constexpr int n = 2000;

/// `noise` times the standard deviation of the signal is added.
Series made(const std::function<double(int)>& signal, double noise = 0, int count = n) {
    Series x(static_cast<std::size_t>(count));
    double mean = 0, squares = 0;
    for (int i = 0; i < count; ++i) x[static_cast<std::size_t>(i)] = signal(i);
    for (const double v : x) mean += v / count;
    for (const double v : x) squares += (v - mean) * (v - mean) / count;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    for (double& v : x) v += noise * std::sqrt(squares) * normal(random);
    return x;
}

std::function<double(int)> logistic(double r, double start = 0.4) {
    return [r, x = start](int) mutable { return x = r * x * (1 - x); };
}

/// After 20,000 steps: on its cycle to rounding.
std::function<double(int)> settled_logistic(double r) {
    auto next = logistic(r);
    for (int i = 0; i < 20000; ++i) next(i);
    return next;
}

class WithNoise : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(ClassifySeries, WithNoise, testing::Values(0.0, 0.01));

TEST_P(WithNoise, ACycleHasItsPeriod) {
    for (const int k : {2, 3, 7}) {
        const auto found = classify_series(made([k](int i) { return std::cos(2.0 * (i % k) * (i % k)); }, GetParam()));
        EXPECT_EQ(found.mode, Mode::quasi_steady);
        EXPECT_EQ(found.kind, Kind::cycle);
        EXPECT_EQ(found.period, k);
    }
}

// Doubled, a period leaves a small, structured residual at its half.
TEST_P(WithNoise, ADoubledCycleHasItsWholePeriod) {
    const auto doubled = [](int i) { return (i % 2 == 0 ? 1.0 : -1.0) + (i % 4 < 2 ? 0.05 : -0.05); };
    for (const int count : {200, 1000}) {
        const auto found = classify_series(made(doubled, GetParam(), count));
        EXPECT_EQ(found.mode, Mode::quasi_steady);
        EXPECT_EQ(found.kind, Kind::cycle);
        EXPECT_EQ(found.period, 4);
    }
    for (const auto& [r, period] : {std::pair(3.46, 4), {3.545, 8}, {3.55, 8}, {3.566, 16}, {3.845, 6}}) {
        const auto found = classify_series(made(settled_logistic(r), GetParam(), 1000));
        EXPECT_EQ(found.kind, Kind::cycle) << r;
        EXPECT_EQ(found.period, period) << r;
    }
}

TEST(ClassifySeries, TheEvidenceNamesThePeriodThatIsStructured) {
    const auto says = [](const Series& x) { return classify_series(x).evidence.at(2).says; };
    EXPECT_EQ(says(made(settled_logistic(3.55))), "the series repeats within the noise (structured at period 4)");
    EXPECT_EQ(says(made(logistic(3.58))), "the residual is small, but structured at period 4, so it is no noise");
}

TEST_P(WithNoise, ARotationIsATorus) {
    const auto found =
        classify_series(made([](int i) { return std::cos(maps::two_pi * maps::golden_mean * i); }, GetParam()));
    EXPECT_EQ(found.mode, Mode::quasi_steady);
    EXPECT_EQ(found.kind, Kind::quasi_periodic);
    EXPECT_TRUE(std::isnan(found.largest_exponent));
}

TEST_P(WithNoise, ChaosHasItsExponent) {
    const auto found = classify_series(made(logistic(4), GetParam()));
    EXPECT_EQ(found.mode, Mode::chaotic);
    // ln 2; 1 % of noise lowers what is seen of the rise.
    EXPECT_NEAR(found.largest_exponent, std::log(2), GetParam() > 0 ? 0.12 : 0.02);
}

TEST_P(WithNoise, ChaosOnNarrowBandsIsNoTorusAndNoCycle) {
    const auto found = classify_series(made(logistic(3.58), GetParam()));
    EXPECT_TRUE(found.mode == Mode::undecided || found.mode == Mode::chaotic) << name_of(found.mode);
}

TEST_P(WithNoise, ChaosInBandsIsNoCycleHoweverFewSamplesThereAre) {
    for (const int count : {64, 100})
        for (const double r : {3.575, 3.58, 3.59, 3.6, 3.64})
            for (int s = 0; s < 40; ++s) {
                const auto found = classify_series(made(logistic(r, 0.05 + 0.0225 * s), GetParam(), count));
                EXPECT_NE(found.kind, Kind::cycle) << r << ", start " << s << ", period " << found.period;
            }
}

TEST_P(WithNoise, ShortCyclesKeepTheirPeriod) {
    for (const int k : {2, 4, 8, 24}) {
        const auto cycle = [k](int i) { return std::cos(2.0 * (i % k) * (i % k)); };
        const auto found = classify_series(made(cycle, GetParam(), 16 * std::max(k, 4)));
        EXPECT_EQ(found.kind, Kind::cycle) << k;
        EXPECT_EQ(found.period, k);
    }
}

TEST(ClassifySeries, EightRepetitionsAreEnoughOnlyIfExact) {
    const auto cycle = [](int i) { return std::cos(2.0 * (i % 12) * (i % 12)); };
    EXPECT_EQ(classify_series(made(cycle, 0, 100)).period, 12);
    EXPECT_EQ(classify_series(made(cycle, 0.01, 100)).period, 0);
}

TEST_P(WithNoise, WhatStillSettlesIsATransient) {
    for (const double time : {100.0, 600.0}) {
        const auto found = classify_series(made([time](int i) { return std::exp(-i / time); }, GetParam()));
        EXPECT_EQ(found.mode, Mode::undecided);
        EXPECT_EQ(found.kind, Kind::transient);
    }
}

TEST(ClassifySeries, WhatIsUndecidedForWantOfEvidenceIsNoTransient) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    double last = 0;
    const auto white = [&](int) { return normal(random); };
    const auto reddened = [&](int) { return last = 0.5 * last + normal(random); };
    for (const auto& found : {classify_series(made(white)), classify_series(made(reddened)),
                              classify_series(made(white, 0, 64)), classify_series(made(logistic(4), 0, 64))}) {
        EXPECT_EQ(found.mode, Mode::undecided);
        EXPECT_EQ(found.kind, Kind::none) << name_of(found.kind);
    }
}

TEST(ClassifySeries, AConstantIsSteady) {
    const auto found = classify_series(Series(100, 0.25));
    EXPECT_EQ(found.mode, Mode::steady);
    EXPECT_EQ(found.period, 1);
}

TEST(ClassifySeries, ALargeOffsetHidesNothing) {
    const auto on_offset = [](Series x) {
        for (double& v : x) v += 1e9;
        return classify_series(x);
    };
    const auto torus = on_offset(made([](int i) { return std::cos(maps::two_pi * maps::golden_mean * i); }));
    EXPECT_EQ(torus.kind, Kind::quasi_periodic);
    const auto chaos = on_offset(made([z = std::pair(0.1, 0.1)](int) mutable {
        z = {1 - 1.4 * z.first * z.first + z.second, 0.3 * z.first};
        return z.first;
    }));
    EXPECT_EQ(chaos.mode, Mode::chaotic);
    EXPECT_NEAR(chaos.largest_exponent, 0.41922, 0.02);
    EXPECT_EQ(on_offset(Series(100, 0.25)).mode, Mode::steady);
    EXPECT_EQ(classify_series(Series(100'000, 0.1)).mode, Mode::steady);
}

// The classical traps: noise that a correlation dimension or an exponent alone takes for chaos.
void check_linear_noise(long full) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    int chaotic = 0;
    const long cases = swirl::tests::sample_count(full);
    for (long i = 0; i < cases; ++i)
        for (const auto& [a, b] : {std::pair(0.0, 0.0), std::pair(0.95, 0.0), std::pair(1.8, -0.97)}) {
            double last = 0, before = 0;
            const auto found = classify_series(made(
                [&, a = a, b = b](int) {
                    const double next = a * last + b * before + normal(random);
                    before = last;
                    return last = next;
                },
                0, 1000));
            chaotic += found.mode == Mode::undecided ? 0 : 1;
        }
    EXPECT_EQ(chaotic, 0) << "of " << 3 * cases;
}

TEST(ClassifySeries, LinearNoiseIsNeverChaotic) {
    check_linear_noise(6);
}

TEST(ClassifySeriesNightly, LinearNoiseIsNeverChaoticInSixtySeries) {
    check_linear_noise(20);
}

TEST(ClassifySeries, AFlowsLinesAreQuasiSteadyWithoutAPeriodInSamples) {
    ClassifySeriesOptions options;
    options.sampled_flow = true;
    const auto found =
        classify_series(made([](int i) { return std::sin(0.37 * i) + 0.3 * std::sin(0.74 * i); }), options);
    EXPECT_EQ(found.mode, Mode::quasi_steady);
    EXPECT_EQ(found.kind, Kind::none);
    EXPECT_EQ(found.period, 0);
}

TEST(ClassifySeries, InvalidInputIsRefused) {
    EXPECT_THROW(classify_series(Series(63, 1.0)), std::invalid_argument);
    Series gap(100, 1.0);
    gap[5] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(classify_series(gap), std::invalid_argument);
    ClassifySeriesOptions options;
    options.noise = -1;
    EXPECT_THROW(classify_series(Series(100, 1.0), options), std::invalid_argument);
}

}  // namespace
