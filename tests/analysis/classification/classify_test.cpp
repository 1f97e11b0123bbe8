// One oracle per regime for the naming of modes: fixed, periodic, quasi-periodic, chaotic, transient, ended.
#include "analysis/classification/classify.hpp"
#include "analysis/classification/classify_followed.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"
#include "tests/analysis/maps/normal_forms.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace swirl::analysis {
namespace {

using maps::Logistic;

TEST(Classify, AnAttractingFixedPointIsSteady) {
    const auto verdict = classify(Logistic{2.8}, Vector<1>{0.3}, 0);
    EXPECT_EQ(verdict.mode, Mode::steady);
    EXPECT_EQ(verdict.kind, Kind::fixed_point);
    EXPECT_EQ(verdict.period, 1);
    EXPECT_NEAR(verdict.mean, 1 - 1 / 2.8, 1e-12);
    EXPECT_NEAR(verdict.largest_exponent, std::log(0.8), 1e-9);  // multiplier 2 − r
    EXPECT_EQ(verdict.recurrence_rate, 1);
}

TEST(Classify, AnAttractingCycleIsQuasiSteadyWithItsMinimalPeriod) {
    for (const auto& [r, period] : {std::pair(3.2, 2), std::pair(3.5, 4), std::pair(3.55, 8), std::pair(3.832, 3)}) {
        const auto verdict = classify(Logistic{r}, Vector<1>{0.3}, 0);
        EXPECT_EQ(verdict.mode, Mode::quasi_steady) << r;
        EXPECT_EQ(verdict.kind, Kind::cycle) << r;
        EXPECT_EQ(verdict.period, period) << r;
        // k equally visited values: RC = 1/k; 10,000 states are not a multiple of 3, so visits differ by one.
        EXPECT_NEAR(verdict.recurrence_rate, 1.0 / period, period * 1e-8) << r;
    }
}

TEST(Classify, ChaosIsNamedByItsExponent) {
    const auto logistic = classify(Logistic{4}, Vector<1>{0.3}, 0);
    EXPECT_EQ(logistic.mode, Mode::chaotic);
    EXPECT_NEAR(logistic.largest_exponent, std::log(2), 5 * logistic.largest_exponent_error);
    const auto henon = classify(maps::Henon{}, Vector<2>{0.1, 0.1}, 0);
    EXPECT_EQ(henon.mode, Mode::chaotic);
    EXPECT_NEAR(henon.largest_exponent, 0.41922, 5 * henon.largest_exponent_error);
    EXPECT_EQ(henon.period, 0);
}

TEST(Classify, AnIrrationalRotationIsQuasiPeriodic) {
    const auto verdict = classify(maps::ConjugatedRotation{}, Vector<1>{0.3}, 0);
    EXPECT_EQ(verdict.mode, Mode::quasi_steady);
    EXPECT_EQ(verdict.kind, Kind::quasi_periodic);
    const double rotation = verdict.rotation - std::floor(verdict.rotation);
    EXPECT_NEAR(rotation, maps::golden_mean - std::floor(maps::golden_mean), 1e-9);
}

/// r = 3: the multiplier is −1 and the approach falls off as n^(−1/2); after any finite number of steps it is not on
/// the cycle, and no cycle attracts exponentially.
TEST(Classify, AnAlgebraicTransientIsNotGivenAName) {
    ClassifyOptions options;
    options.transient = 1000;
    options.collisions = 1000;
    const auto verdict = classify(Logistic{3}, Vector<1>{0.3}, 0, options);
    EXPECT_EQ(verdict.mode, Mode::undecided);
    EXPECT_EQ(verdict.kind, Kind::transient);
}

/// Multiplier −0.999: after 1,200 steps the orbit is still 10⁻² … 10⁻¹ of its start away; Newton's method finds the
/// fixed point.
TEST(Classify, AnOrbitStillApproachingIsNamedAfterTheCycleItApproaches) {
    ClassifyOptions options;
    options.transient = 600;
    options.collisions = 600;
    const double r = 2.999;
    const auto verdict = classify(Logistic{r}, Vector<1>{0.66}, 0, options);
    EXPECT_EQ(verdict.mode, Mode::steady);
    EXPECT_EQ(verdict.period, 1);
    ASSERT_EQ(verdict.point.size(), 1u);
    EXPECT_NEAR(verdict.point[0], 1 - 1 / r, 1e-12);
    EXPECT_NEAR(verdict.mean, 1 - 1 / r, 1e-12);
}

/// A rotation whose derivative vanishes on [0, w), which it maps to 0.3: the cycle is superstable (DFᵏ = 0), and every
/// orbit is periodic once it has been there.
struct Superstable {
    static constexpr int dimension = 1;
    static constexpr double width = 7e-5;
    Advance<1> advance(const Vector<1>& z) const {
        const double turned = z[0] + 0.6180339887498949;
        return {Vector<1>{z[0] < width ? 0.3 : turned - std::floor(turned)}, 1, 0, true};
    }
    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, 1, 0, true, Matrix<1>{z[0] < width ? 0.0 : 1.0}};
    }
    static double angle_period(int) { return 0; }
};

/// Its period may be longer than half the tail: the map is deterministic, so one exact return proves periodicity.
TEST(Classify, ASuperstableOrbitNeedsOneReturn) {
    const Superstable map;
    Vector<1> z{0.3};
    std::int64_t period = 0;
    do {
        z = map.advance(z).state;
        ++period;
    } while (z[0] != 0.3);
    ASSERT_GT(period, 5'000);
    ASSERT_LT(period, 9'900);
    const auto verdict = classify(map, Vector<1>{0.3}, 0);
    EXPECT_EQ(verdict.mode, Mode::quasi_steady);
    EXPECT_EQ(verdict.period, period);
}

/// Chaos, the logistic map at r = 4, that maps all of [0, width): from there it leads to 0.3.
struct ForgetfulChaos {
    static constexpr int dimension = 1;
    double width;
    double cost = 1;  ///< of a step; of a derivative twenty times that
    Advance<1> advance(const Vector<1>& z) const {
        const bool derivative_is_zero = z[0] < width;
        return {Vector<1>{derivative_is_zero ? 0.3 : 4 * z[0] * (1 - z[0])}, 1, 0, true, 0, cost, derivative_is_zero};
    }
    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, 1, 0, true, Matrix<1>{z[0] < width ? 0.0 : 4 - 8 * z[0]}, 0, 20 * cost};
    }
    static double angle_period(int) { return 0; }
    /// How many of 10,000 steps after 10,000 forget.
    int times(double start) const {
        Vector<1> z{start};
        int count = 0;
        for (int i = 0; i < 20'000; ++i) {
            const auto step = advance(z);
            count += i >= 10'000 && step.derivative_is_zero;
            z = step.state;
        }
        return count;
    }
};

/// Sooner or later all orbits are on one superstable cycle, which is too long to be seen: no chaos, though the exponent
/// of parts of the orbit is ln 2.
TEST(Classify, ChaosThatForgetsIsNotCalledChaosByPartsOfTheOrbit) {
    const ForgetfulChaos once{1e-8}, never{1e-12};
    ASSERT_EQ(once.times(0.3), 1);
    ASSERT_EQ(never.times(0.3), 0);
    for (const auto& verdict : {classify(once, Vector<1>{0.3}, 0), classify_sequentially(once, Vector<1>{0.3}, 0)}) {
        EXPECT_EQ(verdict.mode, Mode::undecided);
        EXPECT_EQ(verdict.period, 0);
        EXPECT_EQ(verdict.largest_exponent, -std::numeric_limits<double>::infinity());
    }
    for (const auto& verdict : {classify(never, Vector<1>{0.3}, 0), classify_sequentially(never, Vector<1>{0.3}, 0)})
        EXPECT_EQ(verdict.mode, Mode::chaotic);
}

/// Nor where derivatives are so dear that they are taken of the tail's first steps only.
TEST(Classify, ChaosThatForgetsIsNotCalledChaosWhereDerivativesAreDear) {
    const ForgetfulChaos once{1e-8, 100};
    ASSERT_EQ(once.times(0.32), 1);
    const auto verdict = classify_sequentially(once, Vector<1>{0.32}, 0);
    EXPECT_EQ(verdict.mode, Mode::undecided);
    EXPECT_EQ(verdict.largest_exponent, -std::numeric_limits<double>::infinity());
}

/// In polar coordinates r′ = r (1 + a (r² − c²)(d² − r²)): the focus attracts, by 1 − a c² d² a step, within the
/// unstable circle c only; the circle d attracts beyond.
struct FocusInsideCircles {
    static constexpr int dimension = 2;
    static constexpr double a = 2e8, c2 = 4e-6, d2 = 2.5e-5, turn = 2.1;
    static Matrix<2> rotation() { return Eigen::Rotation2Dd(turn).toRotationMatrix(); }
    static double factor(double r2) { return 1 + a * (r2 - c2) * (d2 - r2); }
    Advance<2> advance(const Vector<2>& z) const {
        return {Vector<2>(rotation() * z * factor(z.squaredNorm())), 1, 0, true};
    }
    Linearised<2> linearise(const Vector<2>& z) const {
        const double r2 = z.squaredNorm();
        const double slope = a * (d2 + c2 - 2 * r2);  // of `factor` by r²
        const Matrix<2> derivative = rotation() * (factor(r2) * Matrix<2>::Identity() + 2 * slope * z * z.transpose());
        return {advance(z).state, 1, 0, true, derivative};
    }
    static double angle_period(int) { return 0; }
};

/// The whole circle lies within the distance that counts as a near return, and Newton's method converges to the focus,
/// which attracts; but the orbit on the circle does not approach it.
TEST(Classify, ATorusRoundAnAttractingFocusIsNotTheFocus) {
    const FocusInsideCircles map;
    const auto circle = classify(map, Vector<2>(0.005, 0), 0);
    EXPECT_EQ(circle.mode, Mode::quasi_steady);
    EXPECT_EQ(circle.kind, Kind::quasi_periodic);
    const auto focus = classify(map, Vector<2>(0.0015, 0), 0);
    EXPECT_EQ(focus.mode, Mode::steady);
}

TEST(Classify, AMapThatEndsIsNotNamed) {
    const auto verdict = classify(Logistic{4.5}, Vector<1>{0.3}, 0);
    EXPECT_TRUE(verdict.ended);
    EXPECT_EQ(verdict.mode, Mode::undecided);
    EXPECT_EQ(verdict.kind, Kind::none);
    EXPECT_TRUE(std::isnan(verdict.mean));
}

TEST(Classify, EveryVerdictListsItsEvidence) {
    for (const double r : {2.8, 3.2, 4.0}) {
        const auto verdict = classify(Logistic{r}, Vector<1>{0.3}, 0);
        EXPECT_GE(verdict.evidence.size(), 3u);
        for (const auto& evidence : verdict.evidence) EXPECT_FALSE(evidence.says.empty());
    }
}

}  // namespace
}  // namespace swirl::analysis
