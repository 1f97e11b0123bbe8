// An orbit ends where its verdict can't change any more, and not before.
#include "analysis/classification/classify_followed.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace swirl::analysis {
namespace {

using maps::Logistic;

TEST(ContractionNorm, OfADefectiveMatrixIsTheSumOfItsPowers) {
    Eigen::Matrix2d a;
    a << 0.5, 10, 0, 0.5;  // grows by 10 first, and contracts all the same
    const auto norm = contraction_norm(a);
    ASSERT_TRUE(norm.has_value());
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero(), power = Eigen::Matrix2d::Identity();
    for (int j = 0; j < 200; ++j) {
        sum += power.transpose() * power;
        power = (a * power).eval();
    }
    const Eigen::Matrix2d p = norm->root.transpose() * norm->root;
    EXPECT_LT((p - sum).norm(), 1e-12 * sum.norm());
    for (const double angle : {0.0, 0.4, 1.3, 2.2}) {
        const Eigen::Vector2d x(std::cos(angle), std::sin(angle));
        EXPECT_LE(norm->of(a * x), norm->rate * norm->of(x) * (1 + 1e-12));
        EXPECT_NEAR(norm->of(norm->axis(1, 3)), 3, 1e-12);
    }
}

TEST(ContractionNorm, IsThereForWhatContractsOnly) {
    EXPECT_FALSE(contraction_norm(Eigen::Matrix2d::Identity()).has_value());
    EXPECT_FALSE(contraction_norm(2 * Eigen::Matrix2d::Identity()).has_value());
    const auto nilpotent = contraction_norm(Eigen::Matrix2d::Zero());
    ASSERT_TRUE(nilpotent.has_value());
    EXPECT_EQ(nilpotent->rate, 0);
}

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

/// The logistic map, whose steps and derivatives cost as much as is said.
struct Costly {
    static constexpr int dimension = 1;
    Logistic map;
    double step = 1, derivative = 2;
    Advance<1> advance(const Vector<1>& z) const {
        auto taken = map.advance(z);
        taken.effort = step;
        return taken;
    }
    Linearised<1> linearise(const Vector<1>& z) const {
        auto taken = map.linearise(z);
        taken.effort = derivative;
        return taken;
    }
    static double angle_period(int) { return 0; }
};

const Evidence* evidence_of(const Classification& verdict, const std::string& name) {
    const auto found = std::find_if(verdict.evidence.begin(), verdict.evidence.end(),
                                    [&](const Evidence& evidence) { return evidence.name == name; });
    return found == verdict.evidence.end() ? nullptr : &*found;
}

TEST(Settled, StepsThatCostMuchAreCutShortAndSaidToBe) {
    const auto verdict = classify_sequentially(Costly{Logistic{4}, 1e3, 2e3}, Vector<1>{0.3}, 0);
    EXPECT_EQ(verdict.mode, Mode::chaotic);
    EXPECT_EQ(verdict.steps, 4000);  // 2·10⁶ of either part
    const Evidence* judged = evidence_of(verdict, "impacts judged");
    ASSERT_NE(judged, nullptr);
    EXPECT_EQ(judged->value, 2000);
    EXPECT_EQ(judged->threshold, 10'000);
    EXPECT_EQ(evidence_of(classify_sequentially(Costly{Logistic{4}}, Vector<1>{0.3}, 0), "impacts judged"), nullptr);
}

/// A multiplier of −0.9999: only Newton's method finds the fixed point within 20,000 steps.
TEST(Settled, ASearchThatCostsTooMuchIsGivenUpAndSaidToBe) {
    const auto found = classify_sequentially(Costly{Logistic{2.9999}}, Vector<1>{0.3}, 0);
    EXPECT_EQ(found.kind, Kind::fixed_point);
    const auto given_up = classify_sequentially(Costly{Logistic{2.9999}, 1, 1e6}, Vector<1>{0.3}, 0);
    EXPECT_EQ(given_up.mode, Mode::undecided);
    const Evidence* search = evidence_of(given_up, "search for a cycle");
    ASSERT_NE(search, nullptr);
    EXPECT_GE(search->value, search->threshold);
    EXPECT_LE(search->value, search->threshold + 1e6);
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
