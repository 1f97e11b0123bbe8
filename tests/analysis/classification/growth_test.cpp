// The exponent of growth on series whose law is known, and what is told from growth without bound.
#include "analysis/classification/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace swirl::analysis {
namespace {

/// x after each step, the first after `first` of them.
template <class F>
std::vector<double> series_of(double first, int count, const F& x) {
    std::vector<double> series;
    for (int i = 0; i < count; ++i) series.push_back(x(first + i + 0.5));
    return series;
}

constexpr double exponents[] = {-0.5, 0, 1.0 / 3, 0.5, 1, 2};

TEST(GrowthExponent, OfPowersOverFiveDecades) {
    for (const double gamma : exponents) {
        const auto found = growth_exponent(series_of(0, 1'000'000, [&](double n) { return std::pow(n, gamma); }), 0);
        EXPECT_NEAR(found.value, gamma, 1e-3);
        EXPECT_LE(found.low, found.value);
        EXPECT_LE(found.value, found.high);
    }
}

TEST(GrowthExponent, OfAStretchFarFromTheBegin) {
    for (const double gamma : exponents)
        for (const double first : {1e4, 1e6, 1e9}) {
            const auto found =
                growth_exponent(series_of(first, 10'000, [&](double n) { return std::pow(n, gamma); }), first);
            EXPECT_NEAR(found.value, gamma, 1e-3) << first;
        }
}

/// 95 % of the intervals have the exponent in them, of noise that is independent: 200 trials, 4.3 standard deviations.
TEST(GrowthExponent, IntervalCoversWithNoise) {
    std::mt19937_64 random(20261127);
    std::normal_distribution<double> normal;
    const int trials = 200;
    int covered = 0;
    for (int t = 0; t < trials; ++t) {
        const auto found = growth_exponent(
            series_of(0, 2000, [&](double n) { return std::cbrt(n) * std::exp(0.3 * normal(random)); }), 0);
        covered += found.low <= 1.0 / 3 && 1.0 / 3 <= found.high;
    }
    EXPECT_GE(covered, 177);
    EXPECT_LT(covered, trials);
}

TEST(GrowthExponent, WithNoiseOverFiveDecades) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    const auto found = growth_exponent(
        series_of(0, 1'000'000, [&](double n) { return std::cbrt(n) * std::exp(0.3 * normal(random)); }), 0);
    EXPECT_NEAR(found.value, 1.0 / 3, 0.01);
    EXPECT_LT(found.high - found.low, 0.05);
}

TEST(GrowthExponent, OfWhatSaturatesFallsToZero) {
    const auto x = [](double n) { return 1 - std::exp(-n / 1e4); };
    EXPECT_NEAR(growth_exponent(series_of(0, 1000, x), 0).value, 1, 0.05);
    EXPECT_NEAR(growth_exponent(series_of(1e5, 100'000, x), 1e5).value, 0, 1e-4);
}

TEST(GrowthExponent, IsNoneOfTooLittleOrOfWhatIsNotPositive) {
    const auto linear = [](double n) { return n; };
    EXPECT_TRUE(std::isnan(growth_exponent(series_of(0, 800, linear), 0).value));
    EXPECT_FALSE(std::isnan(growth_exponent(series_of(0, 1100, linear), 0).value));
    EXPECT_TRUE(std::isnan(growth_exponent(series_of(0, 2000, [](double) { return 0.0; }), 0).value));
    EXPECT_TRUE(std::isnan(growth_exponent({}, 0).value));
}

/// Newton's law multiplies the energy at every impact by a number of which the mean logarithm is positive.
TEST(GrowsGeometrically, WhatIsMultipliedAtEveryStep) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    double ln_energy = 0;
    std::vector<double> energies;
    for (int i = 0; i < 10'000; ++i) energies.push_back(std::exp(ln_energy += 0.005 + 0.05 * normal(random)));
    EXPECT_TRUE(grows_geometrically(energies));
}

TEST(GrowsGeometrically, NotAPowerNorWhatSaturates) {
    EXPECT_FALSE(grows_geometrically(series_of(1e4, 10'000, [](double n) { return std::cbrt(n); })));
    // Leaves a rest, and is there after a tenth of the stretch.
    EXPECT_FALSE(grows_geometrically(
        series_of(0, 10'000, [](double n) { return 1 / (1 + 1e6 * std::exp(-n / 50)) + 1e-3 * std::sin(n); })));
}

/// What wanders within bounds, however slowly: of 2,000 walks of the logarithm with a memory of 100 to 10,000 steps,
/// which span a factor of some e⁸, none.
TEST(GrowsGeometrically, NotWhatWandersWithinBounds) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    int mistaken = 0;
    for (int t = 0; t < 2000; ++t) {
        const double memory = std::pow(10, 2 + 2.0 * (t % 10) / 9), keep = std::exp(-16 / memory);
        double x = 2 * normal(random);
        std::vector<double> energies;
        for (int i = 0; i < 625; ++i) {
            x = keep * x + 2 * std::sqrt(1 - keep * keep) * normal(random);
            energies.push_back(std::exp(x));
        }
        mistaken += grows_geometrically(energies);
    }
    EXPECT_EQ(mistaken, 0);
}

}  // namespace
}  // namespace swirl::analysis
