// An orbit ends where its verdict can't change any more, and not before.
#include "analysis/classification/classify_followed.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

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
        StepBudget budget;
        EXPECT_EQ(classification_detail::linear_part_rules(map, window, at_zero, budget), rules) << away;
    }
}

/// z′ = q z in a time that falls with z, as impacts that accumulate. The coordinate is 1 + z, so that small returns are
/// rounded.
struct Accumulates {
    static constexpr int dimension = 1;
    double q, time_at_zero;
    Advance<1> advance(const Vector<1>& z) const {
        const double left = z[0] - 1;
        return {Vector<1>(1 + q * left), time_at_zero + left, 0, true};
    }
    Linearised<1> linearise(const Vector<1>& z) const {
        const Advance<1> step = advance(z);
        return {step.state, step.duration, 0, true, Matrix<1>{q}};
    }
    static double angle_period(int) { return 0; }
};

constexpr std::array factors{0.5, 0.9, 0.97, 0.98, 0.985, 0.99, 0.995, 0.999};
constexpr std::array distances{1.0, 1e-3, 1e-6, 1e-9, 1e-12};

/// Steps of ever less time lead to no fixed point, though the states converge: they are over in a finite time. In steps
/// that last they do.
TEST(Settled, ImpactsThatAccumulateLeadToNoCycle) {
    for (const double q : factors)
        for (const double begin : distances) {
            const auto period = [&](double time_at_zero) {
                // As many impacts as take z from `begin` to where rounding holds it up.
                const double end = 1e-14 / (1 - q);
                const auto lasts = static_cast<std::int64_t>(std::log(std::min(end / begin, 1.0)) / std::log(q));
                const Accumulates map{q, time_at_zero};
                return follow_until_settled(map, Vector<1>{1 + begin}, 0, lasts, PeriodOptions{}, true).cycle.period;
            };
            EXPECT_EQ(period(0), 0) << q << ' ' << begin;
        }
    const auto lasting = [](double q) {
        return follow_until_settled(Accumulates{q, 1}, Vector<1>{2}, 1000, 1000, PeriodOptions{}, true).cycle.period;
    };
    for (const double q : {0.5, 0.9, 0.97}) EXPECT_EQ(lasting(q), 1) << q;
}

/// z′ = z + 10⁻¹³.
struct Creeps {
    static constexpr int dimension = 1;
    double time;
    Advance<1> advance(const Vector<1>& z) const { return {Vector<1>(z[0] + 1e-13), time, 0, true}; }
    Linearised<1> linearise(const Vector<1>& z) const { return {advance(z).state, time, 0, true, Matrix<1>{0.98}}; }
    static double angle_period(int) { return 0; }
};

/// Nor does a state that hardly moves because hardly any time passes: 10⁻¹³ in 10⁻¹³.
TEST(Settled, AStateThatHasNoTimeToMoveIsOnNoCycle) {
    const auto period = [](double time) {
        return find_period(Creeps{time}, follow_tail(Creeps{time}, Vector<1>{1}, 0, 100)).period;
    };
    EXPECT_EQ(period(1e-13), 0);
    EXPECT_EQ(period(1), 1);
}

/// Nor where all steps are looked at: the returns of the last 60 close to 10⁻⁹ all along.
TEST(Settled, ImpactsThatAccumulateLeadToNoCycleInATailThatClosesEither) {
    const auto period = [](double q, double begin, double time_at_zero) {
        const Accumulates map{q, time_at_zero};
        return find_period(map, follow_tail(map, Vector<1>{1 + begin}, 0, 60)).period;
    };
    for (const double q : factors) {
        EXPECT_EQ(period(q, 1e-10, 0), 0) << q;
        EXPECT_EQ(period(q, 1e-10, 1), 1) << q;
    }
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
