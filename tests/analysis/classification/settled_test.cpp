// An orbit ends where its verdict can't change any more, and not before.
#include "analysis/classification/classify_followed.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swirl::analysis {
namespace {

using maps::Logistic;

TEST(Settled, ACycleEndsTheOrbitWithTheSameVerdict) {
    for (const auto& [r, period] : {std::pair(2.8, 1), std::pair(3.2, 2), std::pair(3.5, 4), std::pair(3.832, 3)}) {
        const auto few = classify_sequentially(Logistic{r}, Vector<1>{0.3}, 0);
        const auto all = classify(Logistic{r}, Vector<1>{0.3}, 0);
        EXPECT_EQ(few.mode, all.mode) << r;
        EXPECT_EQ(few.period, period) << r;
        EXPECT_LE(few.steps, 500) << r;
        EXPECT_NEAR(few.mean, all.mean, 1e-12) << r;
        EXPECT_NEAR(few.largest_exponent, all.largest_exponent, 1e-3) << r;
        EXPECT_NEAR(few.recurrence_rate, 1.0 / period, 1e-15) << r;
    }
}

/// A multiplier of −0.99: the orbit must be followed until it is within the ball, which is some 10⁻³ wide.
TEST(Settled, ASlowMultiplierTakesLonger) {
    const auto verdict = classify_sequentially(Logistic{2.99}, Vector<1>{0.3}, 0);
    EXPECT_EQ(verdict.kind, Kind::fixed_point);
    EXPECT_GT(verdict.steps, 300);
    EXPECT_LT(verdict.steps, 5000);
    EXPECT_NEAR(verdict.largest_exponent, std::log(0.99), 1e-12);
}

TEST(Settled, ChaosIsFollowedToTheEndAndItsExponentMeasuredOnFewSteps) {
    const auto few = classify_sequentially(maps::Henon{}, Vector<2>{0.1, 0.1}, 0);
    const auto all = classify(maps::Henon{}, Vector<2>{0.1, 0.1}, 0);
    EXPECT_EQ(few.mode, Mode::chaotic);
    EXPECT_EQ(few.steps, all.steps);
    EXPECT_EQ(few.mean, all.mean);
    EXPECT_EQ(few.recurrence_rate, all.recurrence_rate);
    EXPECT_NEAR(few.largest_exponent, 0.41922, 5 * few.largest_exponent_error);
    EXPECT_GT(few.largest_exponent, 5 * few.largest_exponent_error);
    EXPECT_GT(few.largest_exponent_error, all.largest_exponent_error);
}

TEST(Settled, ATorusAndAnAlgebraicTransientAreNot) {
    const auto torus = classify_sequentially(maps::ConjugatedRotation{}, Vector<1>{0.3}, 0);
    EXPECT_EQ(torus.kind, Kind::quasi_periodic);
    EXPECT_EQ(torus.steps, 20'000);
    const auto algebraic = classify_sequentially(Logistic{3}, Vector<1>{0.3}, 0);
    EXPECT_EQ(algebraic.mode, Mode::undecided);
    EXPECT_EQ(algebraic.steps, 20'000);
}

/// z′ = ½z within |z| < 10⁻⁴ and a jump beyond: a border of the map that no derivative at the cycle tells of.
struct JumpsBeyond {
    static constexpr int dimension = 1;
    double border = 1e-4;
    Advance<1> advance(const Vector<1>& z) const {
        return {std::abs(z[0]) < border ? Vector<1>(0.5 * z) : Vector<1>(0.5 * z + Vector<1>{1}), 1, 0, true};
    }
    Linearised<1> linearise(const Vector<1>& z) const {
        const auto step = advance(z);
        return {step.state, 1, 0, true, Matrix<1>{0.5}};
    }
    static double angle_period(int) { return 0; }
};

TEST(Settled, ABorderWithinTheBallIsSeen) {
    const JumpsBeyond map;
    Tail<JumpsBeyond> window;
    for (const auto& [away, rules] : {std::pair(1e-5, true), std::pair(8e-5, false)}) {
        window.points = {Vector<1>{away}};
        FoundCycle<JumpsBeyond> at_zero;
        at_zero.period = 1;
        Effort effort;
        EXPECT_EQ(classification_detail::linear_part_rules(map, window, at_zero, effort), rules) << away;
    }
}

/// z′ = 0.9 z in a time that falls with z, as impacts that accumulate.
struct Accumulates {
    static constexpr int dimension = 1;
    double time_at_zero;
    Advance<1> advance(const Vector<1>& z) const { return {Vector<1>(0.9 * z), time_at_zero + z[0], 0, true}; }
    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, time_at_zero + z[0], 0, true, Matrix<1>{0.9}};
    }
    static double angle_period(int) { return 0; }
};

/// Steps of ever less time lead to no fixed point, though the states converge: they are over in a finite time. In steps
/// that last they do.
TEST(Settled, ImpactsThatAccumulateLeadToNoCycle) {
    const auto follow = [](double time_at_zero) {
        return follow_until_settled(Accumulates{time_at_zero}, Vector<1>{1}, 1000, 1000, PeriodOptions{}, true);
    };
    EXPECT_EQ(follow(0).cycle.period, 0);
    EXPECT_EQ(follow(1).cycle.period, 1);
}

/// Nor where all steps are looked at: the returns of the last 60 close to 10⁻⁹ all along.
TEST(Settled, ImpactsThatAccumulateLeadToNoCycleInATailThatClosesEither) {
    const auto period = [](double time_at_zero) {
        const Accumulates map{time_at_zero};
        return find_period(map, follow_tail(map, Vector<1>{1}, 200, 60)).period;
    };
    EXPECT_EQ(period(0), 0);
    EXPECT_EQ(period(1), 1);
}

TEST(Settled, WhatEndsIsTakenAsItEnds) {
    maps::LinearMap<2> map;
    map.A = 1.01 * Matrix<2>::Identity();
    map.lifetime = 5;
    const auto orbit = follow_until_settled(map, Vector<2>{0.01, 0.01}, 10'000, 10'000, PeriodOptions{}, true);
    const auto tail = follow_tail(map, Vector<2>{0.01, 0.01}, 10'000, 10'000);
    EXPECT_TRUE(orbit.tail.ended && tail.ended);
    EXPECT_EQ(orbit.tail.steps, tail.steps);
    EXPECT_EQ(orbit.tail.end, tail.end);
}

}  // namespace
}  // namespace swirl::analysis
