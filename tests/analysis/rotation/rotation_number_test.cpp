#include "analysis/rotation/rotation_number.hpp"

#include "analysis/rotation/weighted_birkhoff.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/logistic.hpp"
#include "tests/analysis/maps/standard_map.hpp"
#include "tests/analysis/maps/torus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace swirl::analysis;
using namespace swirl::analysis::maps;

/// Coordinate `i` of n iterates.
template <SectionMap M>
std::vector<double> orbit(const M& map, Vector<M::dimension> z, int n, int i, int transient = 0) {
    std::vector<double> series;
    for (int j = -transient; j < n; ++j) {
        if (j >= 0) series.push_back(z[i]);
        z = map.advance(z).state;
    }
    return series;
}

double distance_of_turns(double a, double b) {
    return std::abs(std::remainder(a - b, 1.0));
}

TEST(WeightedBirkhoff, ConvergesFasterThanAnyPowerOnACircle) {
    // Space mean of 1/(2 + cos θ) is 1/√3.
    std::vector<double> samples;
    for (int j = 0; j < 4000; ++j) samples.push_back(1 / (2 + std::cos(two_pi * golden_mean * j)));
    const WeightedAverage mean = weighted_birkhoff_average(samples);
    EXPECT_NEAR(mean.average, 1 / std::sqrt(3.0), 1e-14);
    EXPECT_GT(mean.digits, 12);
}

TEST(WeightedBirkhoff, ConvergesSlowlyInChaos) {
    const WeightedAverage mean = weighted_birkhoff_average(orbit(Logistic{4}, Vector<1>{0.3}, 4000, 0));
    EXPECT_NEAR(mean.average, 0.5, 0.05);
    EXPECT_LT(mean.digits, 4);
    EXPECT_DOUBLE_EQ(weighted_birkhoff_average(std::vector<double>(100, 2.5)).average, 2.5);
    EXPECT_TRUE(std::isnan(weighted_birkhoff_average({}).average));
}

TEST(RotationNumber, SimplestFractions) {
    const auto fraction = [](double x, double tolerance, int q) {
        const Fraction f = simplest_fraction(x, tolerance, q);
        return std::pair(f.numerator, f.denominator);
    };
    EXPECT_EQ(fraction(0.5, 1e-12, 10), std::pair(1L, 2L));
    EXPECT_EQ(fraction(1.0 / 3, 1e-12, 10), std::pair(1L, 3L));
    EXPECT_EQ(fraction(-0.25, 1e-12, 10), std::pair(-1L, 4L));
    EXPECT_EQ(fraction(2 + 5.0 / 13, 1e-12, 20), std::pair(31L, 13L));
    EXPECT_EQ(fraction(0.999999999999999, 1e-12, 10), std::pair(1L, 1L));
    EXPECT_EQ(fraction(std::numbers::pi, 1e-2, 100), std::pair(22L, 7L));
    EXPECT_EQ(fraction(golden_mean, 1e-9, 1000).second, 0);
    EXPECT_EQ(fraction(1.0 / 257, 1e-12, 256).second, 0);
}

// Quasi-periodic: a circle map whose rotation number is known.
TEST(RotationNumber, OfACircleMapIsTheKnownOne) {
    for (const double rotation : {golden_mean, std::sqrt(2.0) - 1, std::numbers::pi - 3, 0.01 * std::numbers::e}) {
        const auto angles = orbit(ConjugatedRotation{rotation, 0.4}, Vector<1>{1}, 8000, 0);
        const RotationNumber found = rotation_number_of_angle(angles, two_pi);
        EXPECT_EQ(found.outcome, RotationOutcome::quasi_periodic) << rotation;
        EXPECT_LT(distance_of_turns(found.rotation, rotation), 1e-13) << rotation;
        EXPECT_GT(found.digits, 9);
    }
}

TEST(RotationNumber, OfABackwardRotationIsTakenModuloOne) {
    const auto angles = orbit(ConjugatedRotation{-0.1 * golden_mean, 0.4}, Vector<1>{1}, 8000, 0);
    EXPECT_LT(distance_of_turns(rotation_number_of_angle(angles, two_pi).rotation, -0.1 * golden_mean), 1e-13);
}

// Periodic: locked.
TEST(RotationNumber, OfALockedCircleMapIsAFraction) {
    const auto resting = orbit(ArnoldCircleMap{0.05, 0.8}, Vector<1>{1}, 2000, 0, 500);
    const RotationNumber tongue = rotation_number_of_angle(resting, two_pi);
    EXPECT_EQ(tongue.outcome, RotationOutcome::periodic);
    EXPECT_EQ(tongue.denominator, 1);
    const auto turning = orbit(ConjugatedRotation{0.4, 0.3}, Vector<1>{1}, 2000, 0);
    const RotationNumber fifth = rotation_number_of_angle(turning, two_pi);
    EXPECT_EQ(fifth.outcome, RotationOutcome::periodic);
    EXPECT_EQ(fifth.denominator, 5);
    EXPECT_NEAR(fifth.rotation, 0.4, 1e-12);
}

// Chaotic.
TEST(RotationNumber, OfChaosDoesNotConverge) {
    const RotationNumber wild = rotation_number_of_angle(orbit(StandardMap{6.9}, Vector<2>{0.5, 0.3}, 8000, 0), two_pi);
    EXPECT_EQ(wild.outcome, RotationOutcome::not_a_rotation);
    // Advances confined to half the circle, but chaotic.
    std::vector<double> angles = {0};
    double x = 0.3;
    for (int j = 0; j < 8000; ++j) {
        angles.push_back(std::fmod(angles.back() + 0.5 * x, 1.0));
        x = 4 * x * (1 - x);
    }
    const RotationNumber wandering = rotation_number_of_angle(angles, 1);
    EXPECT_EQ(wandering.outcome, RotationOutcome::not_converged);
    EXPECT_LT(wandering.digits, 4);
    EXPECT_LT(wandering.order, 2);
}

TEST(RotationNumber, StandardMapInnerCircleByDelayAndByFrequency) {
    // A small circle round the elliptic point θ = π, p = 0 at K = 0.5: rotation near arccos(1 − K/2)/2π, slower by the
    // pendulum's softening with amplitude. Two methods must agree to their digits.
    std::vector<double> theta;
    Vector<2> z{std::numbers::pi + 0.5, 0};
    for (int j = 0; j < 8000; ++j) {
        theta.push_back(z[0]);
        z = StandardMap{0.5}.advance(z).state;
    }
    const RotationNumber delay = rotation_number_by_delay(theta);
    const RotationNumber line = rotation_of_observable(theta);
    EXPECT_EQ(delay.outcome, RotationOutcome::quasi_periodic);
    EXPECT_EQ(line.outcome, RotationOutcome::quasi_periodic);
    EXPECT_EQ(line.method, "frequency");
    EXPECT_NEAR(line.rotation, delay.rotation, 1e-10);
    EXPECT_NEAR(line.rotation, std::acos(0.75) / two_pi, 0.01);
    EXPECT_LT(line.rotation, std::acos(0.75) / two_pi);
}

TEST(RotationNumber, OfAnObservableOfATorus) {
    // Rotation 1 − golden mean when folded into [0, ½].
    const auto x = orbit(DrivenTorus{golden_mean, 0.5, 0}, Vector<2>{0, 0}, 5000, 1, 200);
    std::vector<double> bent(x.size());
    for (std::size_t j = 0; j < x.size(); ++j) bent[j] = std::exp(x[j]);
    for (const auto& series : {x, bent}) {
        const RotationNumber found = rotation_of_observable(series);
        EXPECT_EQ(found.outcome, RotationOutcome::quasi_periodic);
        EXPECT_NEAR(found.rotation, 1 - golden_mean, 1e-11);
        EXPECT_GT(found.digits, 9);
        EXPECT_LT(found.residual, 1e-3);
    }
}

TEST(RotationNumber, OfATorusOfSeveralPieces) {
    // Three islands visited in turn: the strongest line is the locked 1/3, the torus shows in the next.
    std::vector<double> series;
    for (int j = 0; j < 6000; ++j) {
        series.push_back(5 * std::cos(two_pi * j / 3) + std::cos(two_pi * golden_mean * j / 3));
    }
    const RotationNumber found = rotation_of_observable(series);
    EXPECT_EQ(found.outcome, RotationOutcome::quasi_periodic);
    EXPECT_NEAR(found.rotation, golden_mean / 3, 1e-11);
}

TEST(RotationNumber, OfACycleIsItsPeriod) {
    const RotationNumber two = rotation_of_observable(orbit(Logistic{3.2}, Vector<1>{0.3}, 2000, 0, 500));
    EXPECT_EQ(two.outcome, RotationOutcome::periodic);
    EXPECT_EQ(two.denominator, 2);
    const RotationNumber four = rotation_of_observable(orbit(Logistic{3.5}, Vector<1>{0.3}, 2000, 0, 500));
    EXPECT_EQ(four.outcome, RotationOutcome::periodic);
    EXPECT_EQ(four.denominator, 4);
    const RotationNumber three = rotation_of_observable(orbit(Logistic{3.83}, Vector<1>{0.3}, 2000, 0, 5000));
    EXPECT_EQ(three.outcome, RotationOutcome::periodic);
    EXPECT_EQ(three.denominator, 3);
}

TEST(RotationNumber, OfAFixedPointIsConstant) {
    EXPECT_EQ(rotation_of_observable(std::vector<double>(1000, 0.3)).outcome, RotationOutcome::constant);
    EXPECT_EQ(rotation_number_by_delay(std::vector<double>(1000, 0.3)).outcome, RotationOutcome::constant);
    EXPECT_EQ(rotation_of_observable(std::vector<double>(10, 0.3)).outcome, RotationOutcome::too_short);
}

TEST(RotationNumber, OfChaoticObservablesDoesNotConverge) {
    for (const double r : {3.6, 3.7, 3.9, 4.0}) {
        const auto found = rotation_of_observable(orbit(Logistic{r}, Vector<1>{0.3}, 8000, 0, 500));
        EXPECT_EQ(found.outcome, RotationOutcome::not_converged) << r;
    }
    EXPECT_EQ(rotation_of_observable(orbit(Henon{}, Vector<2>{0.1, 0.1}, 8000, 0, 500)).outcome,
              RotationOutcome::not_converged);
}

TEST(RotationNumber, OfATransientDoesNotConverge) {
    // A spiral into a focus: it rotates, but its amplitude decays; the limit is no torus.
    std::vector<double> series;
    for (int j = 0; j < 4000; ++j) series.push_back(std::pow(0.99, j) * std::cos(two_pi * golden_mean * j));
    EXPECT_EQ(rotation_of_observable(series).outcome, RotationOutcome::not_converged);
}

TEST(RotationNumber, MeasuredWithOnePerCentNoise) {
    auto x = orbit(DrivenTorus{golden_mean, 0.5, 0}, Vector<2>{0, 0}, 4096, 1, 200);
    std::mt19937_64 random(29);
    std::normal_distribution<double> noise(0, 0.01);
    for (double& y : x) y += noise(random);
    const auto lines = fundamental_frequencies(x);
    ASSERT_FALSE(lines.empty());
    // Cramér–Rao √6/π · (σ/A) n^(−3/2) = 3e-8 for A ≈ 1; the bump uses about half of the samples.
    EXPECT_NEAR(lines[0].frequency, 1 - golden_mean, 5 * 3 * 3e-8);
    EXPECT_EQ(rotation_of_observable(x).outcome, RotationOutcome::quasi_periodic);
}

TEST(FundamentalFrequencies, FrequencyAmplitudeAndPhaseOfThreeLines) {
    std::vector<double> series;
    for (int j = 0; j < 5000; ++j) {
        const double t = two_pi * j;
        series.push_back(0.7 + 2 * std::cos(t * 0.1 * golden_mean + 0.5) + 0.3 * std::cos(t * 0.2345678 - 1) +
                         0.01 * std::cos(t * 0.41));
    }
    const auto lines = fundamental_frequencies(series);
    ASSERT_EQ(lines.size(), 3U);
    EXPECT_NEAR(lines[0].frequency, 0.1 * golden_mean, 1e-12);
    EXPECT_NEAR(lines[0].amplitude, 2, 1e-8);
    EXPECT_NEAR(lines[0].phase, 0.5, 1e-8);
    EXPECT_NEAR(lines[1].frequency, 0.2345678, 1e-11);
    EXPECT_NEAR(lines[1].phase, -1, 1e-7);
    EXPECT_NEAR(lines[2].frequency, 0.41, 1e-10);
    EXPECT_NEAR(lines[2].amplitude, 0.01, 1e-8);
}

TEST(RotationNumber, RefusesWhatIsNotASeries) {
    EXPECT_THROW(rotation_number_of_angle(std::vector<double>{1, 2}, 0), std::invalid_argument);
    EXPECT_THROW(rotation_number_of_angle(std::vector<double>{1, NAN}, 1), std::invalid_argument);
    EXPECT_THROW(rotation_of_observable(std::vector<double>{1, INFINITY}), std::invalid_argument);
    EXPECT_THROW(fundamental_frequencies(std::vector<double>{1, INFINITY}), std::invalid_argument);
}

}  // namespace
