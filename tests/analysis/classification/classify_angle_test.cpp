// The verdict on an angle with a camera's noise: what S does is known by construction.
#include "analysis/classification/classify_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <stdexcept>
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

/// To multiples of the unit, as a camera's software prints them.
std::vector<double> rounded(std::vector<double> angle, double unit) {
    for (double& value : angle) value = unit * std::round(value / unit);
    return angle;
}

TEST(ClassifyAngle, AConstantSpinIsSteadyHoweverTheAngleIsRounded) {
    for (const double unit : {0.0, 0.01 * degree, 0.1 * degree, degree})
        for (const std::size_t count : {600UL, 3600UL}) {
            const auto exact = angle_of(count, 0, constant);
            const auto found = classify_angle(unit > 0 ? rounded(exact, unit) : exact, spacing, {}, unit);
            EXPECT_EQ(found.mode, Mode::steady) << unit << " " << count;
            EXPECT_NEAR(found.mean, -0.98, 1e-12 + unit / (spacing * static_cast<double>(count)));
        }
    std::vector<double> itself;  // an angle that is the time: what is left is the rounding of a sum
    for (int i = 0; i < 1800; ++i) itself.push_back(i / 30.0);
    EXPECT_EQ(classify_angle(itself, 1 / 30.0).mode, Mode::steady);
}

TEST(ClassifyAngle, RoundingThatNoiseDoesNotHideGivesNoWrongVerdict) {
    int undecided = 0;
    const auto expect = [&](Mode found, Mode right, double noise) {
        undecided += found == Mode::undecided ? 1 : 0;
        EXPECT_TRUE(found == right || found == Mode::undecided) << noise;
    };
    for (const double noise : {0.01, 0.03, 0.1, 0.3, 1.0, 3.0})  // of the unit
        for (unsigned seed = 1; seed <= 5; ++seed) {
            const double unit = 0.5 * degree;
            const auto verdict = [&](auto spin) {
                return classify_angle(rounded(angle_of(1800, noise * unit, spin, seed), unit), spacing, {}, unit).mode;
            };
            expect(verdict(constant), Mode::steady, noise);
            expect(verdict(cycle), Mode::quasi_steady, noise);
            expect(verdict(torus), Mode::quasi_steady, noise);
            expect(verdict(chaos), Mode::chaotic, noise);
        }
    EXPECT_LE(undecided, 6) << "of 120";
}

TEST(ClassifyAngle, AWeakContinuumBesideLinesIsNotQuasiSteady) {
    const auto weak = [](double n) { return cycle(n) + 0.1 * chaos(n); };  // 1 % of the variance
    for (const std::size_t count : {1800UL, 9000UL}) {
        const auto found = classify_angle(angle_of(count, 0.05 * degree, weak), spacing);
        EXPECT_EQ(found.mode, Mode::undecided) << count;
        EXPECT_EQ(found.evidence.back().name, "share of the continuum in S");
        EXPECT_NEAR(found.evidence.back().value, 0.01, 0.005);
    }
}

TEST(ClassifyAngle, ANoiseThatIsGivenIsCheckedAgainstTheAngle) {
    const auto verdict = [](auto spin, double noise, double given) {
        analysis::ClassifySeriesOptions options;
        options.noise = given * degree;
        return classify_angle(angle_of(1800, noise * degree, spin), spacing, options);
    };
    EXPECT_EQ(verdict(constant, 2, 0.01).mode, Mode::steady);  // white noise is no continuum, whatever was said of it
    EXPECT_EQ(verdict(torus, 2, 2).mode, Mode::quasi_steady);
    const auto hidden = verdict(torus, 0.1, 60);  // noise that would hide all there is, but is not there
    EXPECT_EQ(hidden.mode, Mode::undecided);
    EXPECT_EQ(hidden.evidence.back().name, "noise given in radians");
    EXPECT_EQ(verdict(chaos, 0.1, 0.2).mode, Mode::chaotic);
}

TEST(ClassifyAngle, WhatDriftsIsATransient) {
    const auto slowing = [](double n) { return -1 + std::exp(-n / 300); };
    const auto found = classify_angle(angle_of(3000, 0.5 * degree, slowing), spacing);
    EXPECT_EQ(found.mode, Mode::undecided);
    EXPECT_EQ(found.kind, Kind::transient);
}

/// A swing of S that dies away is no motion that lasts, however much noise there is. The later part alone is steady; so
/// is the whole where the taper, small at either end, leaves nothing of a swing that is soon gone.
TEST(ClassifyAngle, LinesThatDieOutAreATransient) {
    for (const double life : {100.0, 300.0, 500.0})
        for (const double noise : {0.1, 0.5}) {
            const auto dying = [life](double n) { return -0.5 + 0.6 * std::exp(-n / life) * std::sin(1.3 * n); };
            const auto angle = angle_of(9000, noise * degree, dying);
            const auto found = classify_angle(angle, spacing);
            const bool soon_gone = life < 300 && found.mode == Mode::steady;
            EXPECT_TRUE(soon_gone || found.mode == Mode::undecided) << life << ' ' << noise;
            EXPECT_TRUE(soon_gone || found.kind == Kind::transient) << life << ' ' << noise;
            if (life > 100) continue;
            EXPECT_EQ(classify_angle(std::span(angle).last(4500), spacing).mode, Mode::steady) << noise;
        }
}

/// Two lines whose sum swells and falls once in 60 flights: it lasts, whatever halves it is looked at in.
TEST(ClassifyAngle, LinesThatBeatLast) {
    for (const double phase : {0.0, 0.7, 1.4, 2.1, 2.8}) {
        const auto beating = [phase](double n) {
            return -0.5 + 0.2 * std::cos(1.3 * n) + 0.2 * std::cos((1.3 + 2 * std::numbers::pi / 60) * n + phase);
        };
        for (const std::size_t count : {3000UL, 9000UL})
            EXPECT_EQ(classify_angle(angle_of(count, 0.5 * degree, beating), spacing).mode, Mode::quasi_steady)
                << phase << ' ' << count;
    }
}

TEST(ClassifyAngle, RefusesWhatIsTooShortOrNotFinite) {
    std::vector<double> angle(512, 0.0);
    EXPECT_NO_THROW(classify_angle(angle, spacing));
    angle[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(classify_angle(angle, spacing), std::invalid_argument);
    angle.resize(511);
    EXPECT_THROW(classify_angle(angle, spacing), std::invalid_argument);
    angle.assign(512, 0.0);
    EXPECT_THROW(classify_angle(angle, spacing, {}, -1), std::invalid_argument);
}

}  // namespace
}  // namespace swirl::tests
