#include "analysis/lyapunov/lyapunov_spectrum.hpp"

#include "analysis/lyapunov/cycle_exponents.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"
#include "tests/analysis/maps/standard_map.hpp"
#include "tests/analysis/maps/torus.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace {

using namespace swirl::analysis;
using namespace swirl::analysis::maps;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Logistic in x; the second direction is annihilated only when x passes 0.99.
struct Sticking {
    static constexpr int dimension = 2;
    Advance<2> advance(const Vector<2>& z) const { return {linearise(z).state, 1, 0, true}; }
    Linearised<2> linearise(const Vector<2>& z) const {
        const double keep = z[0] > 0.99 ? 0 : 0.5;
        Matrix<2> derivative;
        derivative << 4 - 8 * z[0], 0, 1, keep;
        return {Vector<2>(4 * z[0] * (1 - z[0]), z[0] + keep * z[1]), 1, keep == 0 ? 1 : 0, true, derivative};
    }
    static double angle_period(int) { return 0; }
};
/// The logistic map at r = 4 with steps that last 2.5.
struct SlowLogistic {
    static constexpr int dimension = 1;
    Advance<1> advance(const Vector<1>& z) const {
        auto step = Logistic{4}.advance(z);
        step.duration = 2.5;
        return step;
    }
    Linearised<1> linearise(const Vector<1>& z) const {
        auto step = Logistic{4}.linearise(z);
        step.duration = 2.5;
        return step;
    }
    static double angle_period(int) { return 0; }
};

LyapunovOptions of_length(std::int64_t steps, std::int64_t transient = 1000) {
    LyapunovOptions options;
    options.steps = steps;
    options.transient = transient;
    return options;
}

// Chaotic. λ(r = 4) = ln 2 [tests/references/README.md].
TEST(Lyapunov, LogisticAtFourIsLnTwo) {
    const LyapunovSpectrum result = lyapunov_spectrum(Logistic{4}, Vector<1>{0.3}, of_length(1'000'000));
    ASSERT_EQ(result.outcome, LyapunovOutcome::completed);
    EXPECT_NEAR(result.exponents[0], std::numbers::ln2, 5 * result.standard_errors[0]);
    // ln|4 − 8x| = ln 2 + a coboundary: the mean converges as 1/n, far faster than independent terms would.
    EXPECT_LT(result.standard_errors[0], 1e-4);
    EXPECT_NEAR(result.exponents[0], std::numbers::ln2, 5e-5);
}

// Chaotic. λ₁ = 0.41922, λ₁ + λ₂ = ln 0.3 [tests/references/README.md].
TEST(Lyapunov, Henon) {
    const LyapunovSpectrum result = lyapunov_spectrum(Henon{}, Vector<2>{0.1, 0.1}, of_length(2'000'000));
    ASSERT_EQ(result.outcome, LyapunovOutcome::completed);
    EXPECT_LT(result.standard_errors[0], 5e-4);
    EXPECT_NEAR(result.exponents[0], 0.41922, 4 * result.standard_errors[0] + 5e-6);
    // det DF = −b at every point: the sum is exact up to the rounding of 2·10⁶ logarithms.
    EXPECT_NEAR(result.exponents[0] + result.exponents[1], std::log(0.3), 1e-14);
    EXPECT_EQ(result.per_time, result.exponents);
    EXPECT_EQ(result.lost_ranks, (std::vector<std::int64_t>{0, 0}));
    const LyapunovSpectrum largest = largest_exponent(Henon{}, Vector<2>{0.1, 0.1}, of_length(2'000'000));
    ASSERT_EQ(largest.exponents.size(), 1U);
    // One orbit, another tangent vector: the growths differ by a bounded amount.
    EXPECT_NEAR(largest.exponents[0], result.exponents[0], 1e-5);
}

TEST(Lyapunov, TheStandardErrorIsTheScatterOfRepeatedRuns) {
    // 40 segments of one Hénon orbit, end to end. The scatter of 40 values is itself known to 11 %, the mean of 40
    // errors from 32 to 64 blocks each to 2 %: five of these.
    double sum = 0;
    double squares = 0;
    double predicted = 0;
    for (int i = 0; i < 40; ++i) {
        const LyapunovSpectrum run = lyapunov_spectrum(Henon{}, Vector<2>{0.1, 0.1}, of_length(8192, 1000 + 8192 * i));
        sum += run.exponents[0];
        squares += run.exponents[0] * run.exponents[0];
        predicted += run.standard_errors[0] / 40;
    }
    const double scatter = std::sqrt((squares - sum * sum / 40) / 39);
    EXPECT_NEAR(predicted / scatter, 1, 0.55);
}

// Hamiltonian: the exponents of an area-preserving map pair to zero.
TEST(Lyapunov, StandardMapPairsToZero) {
    const LyapunovSpectrum result = lyapunov_spectrum(StandardMap{20}, Vector<2>{0.5, 0.3}, of_length(200'000));
    EXPECT_NEAR(result.exponents[0] + result.exponents[1], 0, 1e-13);
    // λ = ln(K/2) + 1/(K² − 4) + O(K⁻⁴) [Tomsovic & Lakshminarayan, Phys. Rev. E 76 (2007) 036207].
    EXPECT_NEAR(result.exponents[0], std::log(10.0) + 1.0 / 396, 5 * result.standard_errors[0]);
    EXPECT_LT(result.standard_errors[0], 5e-3);
}

// Fixed: a triangular map, whose exponents are the logarithms of its diagonal.
TEST(Lyapunov, FixedPoint) {
    LinearMap<3> map;
    map.A << 0.5, 1, 0, 0, -0.25, 2, 0, 0, 0.125;
    const LyapunovSpectrum result = lyapunov_spectrum(map, Vector<3>{1, 1, 1}, of_length(5000));
    EXPECT_NEAR(result.exponents[0], std::log(0.5), 1e-14);
    EXPECT_NEAR(result.exponents[1], std::log(0.25), 1e-14);
    EXPECT_NEAR(result.exponents[2], std::log(0.125), 1e-14);
    EXPECT_LT(result.standard_errors[0], 1e-14);
}

TEST(Lyapunov, AComplexPairConvergesInTheWeightedMean) {
    LinearMap<2> map;
    const std::complex<double> multiplier = std::polar(0.9, 0.7);
    map.A << multiplier.real(), 5 * multiplier.imag(), -multiplier.imag() / 5, multiplier.real();
    const LyapunovSpectrum result = lyapunov_spectrum(map, Vector<2>{0, 0}, of_length(20000));
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(result.exponents[i], std::log(0.9), 2 * std::log(5.0) / 20000);
        EXPECT_NEAR(result.weighted_exponents[i], std::log(0.9), 1e-12);
        EXPECT_LT(result.weighted_half_difference[i], 1e-10);
    }
}

// Periodic: the exponents are ln|multiplier|/k.
TEST(Lyapunov, PeriodicOrbitHasItsMultipliersExponents) {
    const Henon map{0.95, 0.3};  // a stable 4-cycle
    Vector<2> z{0.1, 0.1};
    for (int i = 0; i < 20000; ++i) z = map.advance(z).state;
    const CycleExponents exact = cycle_exponents(map, z, 4);
    ASSERT_LT(exact.closure, 1e-14);
    ASSERT_LT(exact.exponents[0], 0);
    const LyapunovSpectrum result = lyapunov_spectrum(map, z, of_length(40000));
    for (int i = 0; i < 2; ++i) {
        EXPECT_NEAR(result.exponents[i], exact.exponents[i], 1e-6);
        EXPECT_NEAR(result.weighted_exponents[i], exact.exponents[i], 1e-11);
    }
}

// Quasi-periodic: 0 and ln a; the circle map's exponent is 0.
TEST(Lyapunov, QuasiPeriodic) {
    const DrivenTorus map{golden_mean, 0.5, 0.3};
    const LyapunovSpectrum torus = lyapunov_spectrum(map, Vector<2>{0, 0}, of_length(20000));
    EXPECT_NEAR(torus.weighted_exponents[0], 0, 1e-12);
    EXPECT_NEAR(torus.exponents[1], std::log(0.5), 1e-3);
    EXPECT_NEAR(torus.weighted_exponents[1], std::log(0.5), 1e-12);
    // Steps last 1 + τ cos θ, of mean 1 up to O(1/n).
    EXPECT_NEAR(torus.per_time[1], std::log(0.5), 1e-3);
    EXPECT_NEAR(torus.time, 20000, 1);
    const LyapunovSpectrum circle = lyapunov_spectrum(ConjugatedRotation{}, Vector<1>{0}, of_length(20000));
    EXPECT_NEAR(circle.weighted_exponents[0], 0, 1e-12);
    EXPECT_NEAR(circle.exponents[0], 0, 2 * std::log(1.4 / 0.6) / 20000);
}

TEST(Lyapunov, PerTimeDividesByTheDurationOfTheSteps) {
    const LyapunovSpectrum result = lyapunov_spectrum(SlowLogistic{}, Vector<1>{0.3}, of_length(10000));
    EXPECT_NEAR(result.per_time[0], result.exponents[0] / 2.5, 1e-15);
    EXPECT_NEAR(result.per_time_standard_errors[0], result.standard_errors[0] / 2.5, 1e-12);
}

TEST(Lyapunov, ALostRankIsMinusInfinityAndTheRestGoesOn) {
    // Singular with exactly zero and with rounded entries: A = B diag(2, 0.5, 0) B⁻¹.
    LinearMap<3> exact;
    exact.A << 2, 1, 3, 0, 0.5, 1, 0, 0, 0;
    LinearMap<3> rounded;
    Matrix<3> basis;
    basis << 0.3, 0.7, -0.2, 0.1, -0.4, 0.9, 0.8, 0.2, 0.35;
    rounded.A = basis * Vector<3>{2, 0.5, 0}.asDiagonal() * basis.inverse();
    for (const LinearMap<3>& map : {exact, rounded}) {
        const LyapunovSpectrum result = lyapunov_spectrum(map, Vector<3>{0, 0, 0}, of_length(1000));
        EXPECT_NEAR(result.exponents[0], std::log(2.0), 1e-14);
        EXPECT_NEAR(result.exponents[1], std::log(0.5), 1e-14);
        EXPECT_EQ(result.exponents[2], -infinity);
        EXPECT_EQ(result.per_time[2], -infinity);
        EXPECT_TRUE(std::isnan(result.standard_errors[2]));
        EXPECT_EQ(result.lost_ranks[2], 1000);
        EXPECT_EQ(result.lost_ranks[1], 0);
        EXPECT_EQ(result.without_losses[1], result.exponents[1]);
        EXPECT_TRUE(std::isnan(result.without_losses[2]));  // no step did not
        ASSERT_EQ(result.annihilations.size(), 1U);
        EXPECT_EQ(result.annihilations[0].directions, 1);
        EXPECT_EQ(result.annihilations[0].steps, 1000);
        EXPECT_EQ(result.annihilations[0].first, 1);
        EXPECT_EQ(result.annihilations[0].last, 1000);
    }
}

TEST(Lyapunov, ANilpotentPartLosesAllItsDirections) {
    LinearMap<3> map;
    map.A << 3, 1, 1, 0, 0, 1, 0, 0, 0;
    const LyapunovSpectrum result = lyapunov_spectrum(map, Vector<3>{0, 0, 0}, of_length(100));
    EXPECT_NEAR(result.exponents[0], std::log(3.0), 1e-14);
    EXPECT_EQ(result.exponents[1], -infinity);
    EXPECT_EQ(result.exponents[2], -infinity);
    map.A.setZero();
    EXPECT_EQ(largest_exponent(map, Vector<3>{0, 0, 0}, of_length(100)).exponents[0], -infinity);
}

TEST(Lyapunov, SaysWhichStepsAnnihilatedHowManyDirectionsAndWhatTheOthersHave) {
    LyapunovOptions options;
    options.steps = 1000;
    ExponentAccumulator accumulator(3, options);
    for (int step = 1; step <= 1000; ++step) {
        const bool one = step % 100 == 0, two = step == 700;
        accumulator.add(std::vector<double>{0.5, two ? -infinity : -0.25, one || two ? -infinity : -2}, 1);
    }
    const LyapunovSpectrum found = accumulator.finish(LyapunovOutcome::completed);
    EXPECT_EQ(found.exponents[1], -infinity);
    EXPECT_NEAR(found.without_losses[0], 0.5, 1e-14);
    EXPECT_NEAR(found.without_losses[1], -0.25, 1e-14);
    EXPECT_NEAR(found.without_losses[2], -2, 1e-14);
    ASSERT_EQ(found.annihilations.size(), 2U);
    EXPECT_EQ(found.annihilations[0].directions, 1);
    EXPECT_EQ(found.annihilations[0].steps, 9);
    EXPECT_EQ(found.annihilations[0].first, 100);
    EXPECT_EQ(found.annihilations[0].last, 1000);
    EXPECT_EQ(found.annihilations[1].directions, 2);
    EXPECT_EQ(found.annihilations[1].first, 700);
}

TEST(Lyapunov, ARankLostOnceInAWhileIsStillMinusInfinity) {
    const LyapunovSpectrum result = lyapunov_spectrum(Sticking{}, Vector<2>{0.3, 0}, of_length(20000));
    EXPECT_NEAR(result.exponents[0], std::numbers::ln2, 5e-3);
    EXPECT_EQ(result.exponents[1], -infinity);
    // x > 0.99 with probability 1 − (2/π) asin √0.99 = 0.0638.
    EXPECT_NEAR(static_cast<double>(result.lost_ranks[1]) / 20000, 0.0638, 0.005);
}

TEST(Lyapunov, AnEarlyEndingKeepsWhatWasReached) {
    LinearMap<2> map;
    map.A << 2, 0, 0, 0.5;
    map.lifetime = 1e6;
    const LyapunovSpectrum result = lyapunov_spectrum(map, Vector<2>{1, 1}, of_length(1000, 4));
    EXPECT_EQ(result.outcome, LyapunovOutcome::ended_early);
    EXPECT_EQ(result.steps, 15);  // 2¹⁹ < 10⁶ < 2²⁰, four of them transient
    EXPECT_NEAR(result.exponents[0], std::log(2.0), 1e-2);
    EXPECT_TRUE(std::isnan(result.weighted_exponents[0]));
    EXPECT_EQ(result.record.back().step, 15);
    const LyapunovSpectrum none = lyapunov_spectrum(map, Vector<2>{1, 1}, of_length(1000, 100));
    EXPECT_EQ(none.outcome, LyapunovOutcome::ended_in_transient);
    EXPECT_EQ(none.steps, 0);
    EXPECT_TRUE(std::isnan(none.exponents[0]));
    EXPECT_EQ(largest_exponent(map, Vector<2>{1, 1}, of_length(1000, 4)).steps, 15);
    map.lifetime = -1;
    EXPECT_EQ(lyapunov_spectrum(map, Vector<2>{1, 1}, of_length(5000)).outcome, LyapunovOutcome::not_finite);
}

TEST(Lyapunov, TheRecordRunsFromTheFirstStepToTheLast) {
    LyapunovOptions options = of_length(10000);
    const LyapunovSpectrum geometric = lyapunov_spectrum(Logistic{4}, Vector<1>{0.3}, options);
    EXPECT_EQ(geometric.record.front().step, 1);
    EXPECT_EQ(geometric.record.back().step, 10000);
    EXPECT_EQ(geometric.record.back().exponents, geometric.exponents);
    EXPECT_GE(geometric.record.size(), 40U);
    EXPECT_LE(geometric.record.size(), 120U);
    options.spacing = CheckpointSpacing::even;
    options.checkpoints = 10;
    const LyapunovSpectrum even = lyapunov_spectrum(Logistic{4}, Vector<1>{0.3}, options);
    ASSERT_EQ(even.record.size(), 10U);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(even.record[i].step, 1000 * (i + 1));
}

TEST(Lyapunov, TheSameCallGivesTheSameBits) {
    const LyapunovSpectrum a = lyapunov_spectrum(Henon{}, Vector<2>{0.1, 0.1}, of_length(5000));
    const LyapunovSpectrum b = lyapunov_spectrum(Henon{}, Vector<2>{0.1, 0.1}, of_length(5000));
    EXPECT_EQ(a.exponents, b.exponents);
    EXPECT_EQ(a.standard_errors, b.standard_errors);
    EXPECT_EQ(a.weighted_exponents, b.weighted_exponents);
}

TEST(Lyapunov, RefusesOptionsOutOfRange) {
    EXPECT_THROW(lyapunov_spectrum(Henon{}, Vector<2>{0, 0}, of_length(0)), std::invalid_argument);
    EXPECT_THROW(lyapunov_spectrum(Henon{}, Vector<2>{0, 0}, of_length(10, -1)), std::invalid_argument);
    LyapunovOptions options;
    options.checkpoints = 0;
    EXPECT_THROW(lyapunov_spectrum(Henon{}, Vector<2>{0, 0}, options), std::invalid_argument);
    options = {};
    options.rank_tolerance = NAN;
    EXPECT_THROW(lyapunov_spectrum(Henon{}, Vector<2>{0, 0}, options), std::invalid_argument);
}

}  // namespace
