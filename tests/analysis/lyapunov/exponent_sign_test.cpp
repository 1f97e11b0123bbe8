#include "analysis/lyapunov/exponent_sign.hpp"

#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"
#include "tests/analysis/maps/standard_map.hpp"
#include "tests/analysis/maps/torus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace {

using namespace swirl::analysis;
using namespace swirl::analysis::maps;

LyapunovOptions of_length(std::int64_t steps, std::int64_t transient = 1000) {
    LyapunovOptions options;
    options.steps = steps;
    options.transient = transient;
    return options;
}

/// Chaos in x with a conserved quantity c = y − h(x), so that one direction is exactly neutral in a chaotic orbit:
/// y′ = y + h(F(x)) − h(x).
struct ChaosWithInvariant {
    static constexpr int dimension = 2;

    static double h(double x) { return std::sin(3 * x); }
    static double dh(double x) { return 3 * std::cos(3 * x); }

    Advance<2> advance(const Vector<2>& z) const {
        const double x = 3.9 * z[0] * (1 - z[0]);
        return {Vector<2>(x, z[1] + h(x) - h(z[0])), 1, 0, true};
    }
    Linearised<2> linearise(const Vector<2>& z) const {
        const auto step = advance(z);
        const double slope = 3.9 * (1 - 2 * z[0]);
        Matrix<2> derivative;
        derivative << slope, 0, dh(step.state[0]) * slope - dh(z[0]), 1;
        return {step.state, 1, 0, true, derivative};
    }
    static double angle_period(int) { return 0; }
};

/// ln R = ±0.1 by the side on which a chaotic x falls: mean zero by symmetry, but the sum wanders.
struct Walk {
    static constexpr int dimension = 1;
    Advance<1> advance(const Vector<1>& z) const { return {Vector<1>{4 * z[0] * (1 - z[0])}, 1, 0, true}; }
    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, 1, 0, true, Matrix<1>{std::exp(z[0] < 0.5 ? 0.1 : -0.1)}};
    }
    static double angle_period(int) { return 0; }
};

/// ln R of a chaotic x with slope 4's map: `drift` and a difference h(F(x)) − h(x), which sums to a bounded quantity.
struct SlowDrift {
    static constexpr int dimension = 1;
    double drift = 0;
    Advance<1> advance(const Vector<1>& z) const { return {Vector<1>{4 * z[0] * (1 - z[0])}, 1, 0, true}; }
    Linearised<1> linearise(const Vector<1>& z) const {
        const double next = advance(z).state[0];
        return {Vector<1>{next}, 1, 0, true, Matrix<1>{std::exp(drift + 0.5 * (next - z[0]))}};
    }
    static double angle_period(int) { return 0; }
};

/// Growth by e²⁰⁰ in bursts that are rare: x > 1 − ε has probability 2√ε/π.
struct Bursts {
    static constexpr int dimension = 1;
    Advance<1> advance(const Vector<1>& z) const { return {Vector<1>{4 * z[0] * (1 - z[0])}, 1, 0, true}; }
    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, 1, 0, true, Matrix<1>{z[0] > 1 - 1e-5 ? std::exp(200) : 1.0}};
    }
    static double angle_period(int) { return 0; }
};

TEST(ExponentSign, EachRegime) {
    const auto sign_of = [](const LyapunovSpectrum& spectrum, std::size_t i) { return judge_sign(spectrum, i).sign; };
    // Fixed.
    LinearMap<2> stable;
    stable.A << 0.9, 1, 0, -0.3;
    const auto fixed = lyapunov_spectrum(stable, Vector<2>{1, 1}, of_length(2000));
    EXPECT_EQ(sign_of(fixed, 0), ExponentSign::negative);
    EXPECT_EQ(sign_of(fixed, 1), ExponentSign::negative);
    // Periodic.
    const auto cycle = lyapunov_spectrum(Logistic{3.5}, Vector<1>{0.3}, of_length(2000));
    EXPECT_EQ(sign_of(cycle, 0), ExponentSign::negative);
    // Quasi-periodic.
    const auto circle = lyapunov_spectrum(ConjugatedRotation{}, Vector<1>{0}, of_length(2000));
    EXPECT_EQ(sign_of(circle, 0), ExponentSign::neutral);
    const auto torus = lyapunov_spectrum(DrivenTorus{}, Vector<2>{0, 0}, of_length(2000));
    EXPECT_EQ(sign_of(torus, 0), ExponentSign::neutral);
    EXPECT_EQ(sign_of(torus, 1), ExponentSign::negative);
    // Chaotic.
    const auto chaos = lyapunov_spectrum(Henon{}, Vector<2>{0.1, 0.1}, of_length(20000));
    EXPECT_EQ(sign_of(chaos, 0), ExponentSign::positive);
    EXPECT_EQ(sign_of(chaos, 1), ExponentSign::negative);
    // −∞.
    stable.A(1, 1) = 0;
    EXPECT_EQ(sign_of(lyapunov_spectrum(stable, Vector<2>{1, 1}, of_length(100)), 1), ExponentSign::negative);
    EXPECT_THROW(judge_sign(circle, 1), std::invalid_argument);
}

TEST(ExponentSign, AShearedFamilyIsNeutralInBothDirections) {
    // K = 0: p is conserved, θ turns at a rate p. DFⁿ grows as n, both exponents as (ln n)/n.
    const auto shear = lyapunov_spectrum(StandardMap{0}, Vector<2>{0.3, 1.7}, of_length(20000));
    for (std::size_t i = 0; i < 2; ++i) {
        const SignEvidence evidence = judge_sign(shear, i);
        EXPECT_EQ(evidence.sign, ExponentSign::neutral) << evidence.growth_order;
        EXPECT_LE(std::abs(evidence.exponent), evidence.shrinking_bound);
    }
}

TEST(ExponentSign, AConservedQuantityInChaosIsNeutral) {
    const auto spectrum = lyapunov_spectrum(ChaosWithInvariant{}, Vector<2>{0.3, 0}, of_length(50000));
    EXPECT_EQ(judge_sign(spectrum, 0).sign, ExponentSign::positive);
    const SignEvidence neutral = judge_sign(spectrum, 1);
    EXPECT_EQ(neutral.sign, ExponentSign::neutral);
    EXPECT_LT(neutral.growth_order, 0.25);
}

TEST(ExponentSign, ARandomWalkIsUndecided) {
    const SignEvidence walk = judge_sign(lyapunov_spectrum(Walk{}, Vector<1>{0.3}, of_length(60000)), 0);
    EXPECT_EQ(walk.sign, ExponentSign::undecided);
    EXPECT_NEAR(walk.growth_order, 0.5, 0.25);
}

TEST(ExponentSign, AWeakDriftUnderABoundedSumIsPositive) {
    // Σ = 25 over 10,000 steps beneath swings of ±½, within the bound for a neutral direction. Without it: neutral.
    const SignEvidence weak = judge_sign(lyapunov_spectrum(SlowDrift{0.0025}, Vector<1>{0.3}, of_length(10'000)), 0);
    EXPECT_LE(weak.exponent, weak.shrinking_bound);
    EXPECT_EQ(weak.sign, ExponentSign::positive);
    EXPECT_EQ(judge_sign(lyapunov_spectrum(SlowDrift{0}, Vector<1>{0.3}, of_length(10'000)), 0).sign,
              ExponentSign::neutral);
}

TEST(ExponentSign, GrowthInBurstsThatGoesOnIsPositive) {
    const auto spectrum = lyapunov_spectrum(Bursts{}, Vector<1>{0.3}, of_length(10'000));
    const SignEvidence bursts = judge_sign(spectrum, 0);
    EXPECT_LT(bursts.exponent, 5 * bursts.standard_error);
    EXPECT_EQ(bursts.sign, ExponentSign::positive) << bursts.exponent << " +- " << bursts.standard_error;
}

TEST(Settling, ATransientIsSeenInTheRecord) {
    // From near the unstable origin of the logistic map at r = 2.8 (ln 2.8 = 1.03 there) to its fixed point (ln 0.8).
    const Logistic map{2.8};
    const auto early = lyapunov_spectrum(map, Vector<1>{1e-40}, of_length(400, 0));
    const Settling moving = judge_settling(early, 0);
    EXPECT_FALSE(moving.settled);
    EXPECT_NEAR(moving.early, std::log(2.8), 0.3);
    EXPECT_NEAR(moving.late, std::log(0.8), 1e-2);
    EXPECT_GT(moving.last_change, 0.1);
    EXPECT_TRUE(judge_settling(lyapunov_spectrum(map, Vector<1>{1e-40}, of_length(400, 1000)), 0).settled);
    EXPECT_TRUE(judge_settling(lyapunov_spectrum(Henon{}, Vector<2>{0.1, 0.1}, of_length(20000)), 0).settled);
    EXPECT_TRUE(judge_settling(lyapunov_spectrum(ConjugatedRotation{}, Vector<1>{0}, of_length(20000)), 0).settled);
    EXPECT_FALSE(judge_settling(lyapunov_spectrum(Henon{}, Vector<2>{0.1, 0.1}, of_length(10)), 0).settled);
}

TEST(GradientInvariance, OfAConservedQuantityAndOfAnother) {
    const ChaosWithInvariant map;
    const auto right = [](const Vector<2>& z) { return Vector<2>(-ChaosWithInvariant::dh(z[0]), 1); };
    const auto wrong = [](const Vector<2>& z) { return Vector<2>(1, z[0]); };
    const auto invariant = gradient_invariance(map, Vector<2>{0.3, 0}, right, 1000);
    EXPECT_EQ(invariant.outcome, LyapunovOutcome::completed);
    EXPECT_EQ(invariant.steps, 1000);
    EXPECT_LT(invariant.largest_residual, 1e-15);
    EXPECT_GT(gradient_invariance(map, Vector<2>{0.3, 0}, wrong, 1000).largest_residual, 0.1);
    LinearMap<2> mortal;
    mortal.A << 2, 0, 0, 1;
    mortal.lifetime = 100;
    const auto ended = gradient_invariance(
        mortal, Vector<2>{1, 0}, [](const auto&) { return Vector<2>(0, 1); }, 1000);
    EXPECT_EQ(ended.outcome, LyapunovOutcome::ended_early);
    EXPECT_EQ(ended.steps, 6);
}

}  // namespace
