// The verdict on an angle with a camera's noise: what S does is known by construction.
#include "analysis/classification/classify_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace swirl::tests {
namespace {

using analysis::classify_angle;
using analysis::Kind;
using analysis::Mode;

constexpr double spacing = 0.2;  // some five rows a flight
constexpr double degree = std::numbers::pi / 180;

/// θ with S held from one of the times 1, 2, … to the next.
template <class Spin>
std::vector<double> angle_of(std::size_t count, double noise, const Spin& spin, unsigned seed = 1) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> error(0, 1);
    std::vector<double> angle;
    double turned = 0, flight = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = spacing * static_cast<double>(i);
        for (; flight + 1 <= t; ++flight) turned += spin(flight);
        angle.push_back(turned + spin(flight) * (t - flight) + noise * error(random));
    }
    return angle;
}

double constant(double) {
    return -0.98;
}
double cycle(double n) {
    return std::vector<double>{-1.1, -0.4, -0.9, -0.3}[static_cast<std::size_t>(n) % 4];
}
double torus(double n) {
    return -0.7 + 0.3 * std::cos(2 * std::numbers::pi * (std::numbers::phi - 1) * n);
}
/// The logistic map at r = 4, white in n, made anew from x = sin² so that no state is kept.
double chaos(double n) {
    static const std::vector<double> values = [] {
        std::vector<double> x{0.4};
        while (x.size() < 20'000) x.push_back(4 * x.back() * (1 - x.back()));
        return x;
    }();
    return -1 + values[static_cast<std::size_t>(n)];
}

TEST(ClassifyAngle, NamesEachRegimeThroughTwoDegreesOfNoise) {
    for (const double noise : {0.1 * degree, 2 * degree})
        for (const std::size_t count : {1800UL, 9000UL}) {
            const auto mode = [&](auto spin) { return classify_angle(angle_of(count, noise, spin), spacing).mode; };
            EXPECT_EQ(mode(constant), Mode::steady) << noise << " " << count;
            EXPECT_EQ(mode(cycle), Mode::quasi_steady) << noise << " " << count;
            EXPECT_EQ(mode(torus), Mode::quasi_steady) << noise << " " << count;
            EXPECT_EQ(mode(chaos), Mode::chaotic) << noise << " " << count;
        }
}

TEST(ClassifyAngle, NoiseAloneIsNotTakenForMotion) {
    int wrong = 0;
    for (unsigned seed = 1; seed <= 100; ++seed)
        wrong += classify_angle(angle_of(2000, degree, constant, seed), spacing).mode == Mode::steady ? 0 : 1;
    EXPECT_EQ(wrong, 0);  // one block of 64 bins in 10^8 looks like a continuum, one bin in e^25 like a line
}

TEST(ClassifyAngle, MeasuresTheRateAndTheNoise) {
    const auto angle = angle_of(9000, degree, constant);
    const auto found = analysis::spectrum_of_angle(angle, spacing);
    // The slope's standard error, σ √12 / (Δt n^1.5).
    EXPECT_NEAR(found.rate, -0.98, 5 * degree * std::sqrt(12.0) / (spacing * std::pow(9000.0, 1.5)));
    EXPECT_NEAR(found.noise / degree, 1, 0.05);  // 1500 bins, two of them independent a taper: 2 %
    EXPECT_EQ(found.lines + found.blocks, 0);
    EXPECT_EQ(classify_angle(angle, spacing).mean, found.rate);
}

TEST(ClassifyAngle, TheVarianceInLinesIsThatOfS) {
    const auto angle = angle_of(9000, 0.1 * degree, torus);
    const auto found = analysis::spectrum_of_angle(angle, spacing);
    EXPECT_NEAR(found.in_lines, 0.3 * 0.3 / 2, 0.003);  // sampled five times a flight: |1 - e^iw|/dt for w
    EXPECT_LT(found.continuum_share(), 0.02);
}

TEST(ClassifyAngle, WhatDriftsIsATransient) {
    const auto slowing = [](double n) { return -1 + std::exp(-n / 300); };
    const auto found = classify_angle(angle_of(3000, 0.5 * degree, slowing), spacing);
    EXPECT_EQ(found.mode, Mode::undecided);
    EXPECT_EQ(found.kind, Kind::transient);
}

TEST(ClassifyAngle, RefusesWhatIsTooShortOrNotFinite) {
    std::vector<double> angle(512, 0.0);
    EXPECT_NO_THROW(classify_angle(angle, spacing));
    angle[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(classify_angle(angle, spacing), std::invalid_argument);
    angle.resize(511);
    EXPECT_THROW(classify_angle(angle, spacing), std::invalid_argument);
}

}  // namespace
}  // namespace swirl::tests
