// Steps and derivatives that cost much: a verdict's work is bounded, and what was cut short is said.
#include "analysis/classification/classify_followed.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace swirl::analysis {
namespace {

using maps::Logistic;

/// The logistic map, whose steps and derivatives cost as much as is said.
struct Costly {
    static constexpr int dimension = 1;
    Logistic map;
    double step = 1, derivative = 2;
    Advance<1> advance(const Vector<1>& z) const {
        auto taken = map.advance(z);
        taken.cost = step;
        return taken;
    }
    Linearised<1> linearise(const Vector<1>& z) const {
        auto taken = map.linearise(z);
        taken.cost = derivative;
        return taken;
    }
    static double angle_period(int) { return 0; }
};

const Evidence* evidence_of(const Classification& verdict, const std::string& name) {
    const auto found = std::find_if(verdict.evidence.begin(), verdict.evidence.end(),
                                    [&](const Evidence& evidence) { return evidence.name == name; });
    return found == verdict.evidence.end() ? nullptr : &*found;
}

TEST(StepBudget, StepsThatCostMuchAreCutShortAndSaidToBe) {
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
TEST(StepBudget, ASearchThatCostsTooMuchIsGivenUpAndSaidToBe) {
    const auto found = classify_sequentially(Costly{Logistic{2.9999}}, Vector<1>{0.3}, 0);
    EXPECT_EQ(found.kind, Kind::fixed_point);
    const auto given_up = classify_sequentially(Costly{Logistic{2.9999}, 1, 1e6}, Vector<1>{0.3}, 0);
    EXPECT_EQ(given_up.mode, Mode::undecided);
    const Evidence* search = evidence_of(given_up, "search for a cycle");
    ASSERT_NE(search, nullptr);
    EXPECT_GE(search->value, search->threshold);
    EXPECT_LE(search->value, search->threshold + 1e6);
}

/// z′ = m R z: turns by a golden part and shrinks.
maps::LinearMap<2> turning(double m) {
    const double angle = 2 * std::numbers::pi / std::numbers::phi;
    maps::LinearMap<2> map;
    map.A << m * std::cos(angle), -m * std::sin(angle), m * std::sin(angle), m * std::cos(angle);
    return map;
}

/// A circle returns near to itself after each Fibonacci number of steps, and no nearer from window to window: Newton's
/// method is not asked, but where they are smaller by chance. What comes nearer, by 1 % along the tail, is found by it.
TEST(StepBudget, NewtonsMethodIsAskedOfReturnsThatShrinkOnly) {
    const auto found = [](double m) {
        StepBudget budget;
        const auto map = turning(m);
        const auto cycle = find_period(map, follow_tail(map, Vector<2>{0.05, 0}, 0, 10'000), PeriodOptions{}, budget);
        return std::pair(cycle.period, budget.spent);
    };
    EXPECT_EQ(found(1), std::pair(std::int64_t{0}, 0.0));
    for (const double slow : {1.1e-6, 2e-6, 5e-6, 1e-5, 1e-4}) EXPECT_EQ(found(1 - slow).first, 1) << slow;
}

TEST(StepBudget, OnlyTheNearestReturnsAreTried) {
    classification_detail::NearestReturns near(2, 0.5), none(0, 0.5);
    for (const auto& [returned, k] : {std::pair(0.4, 1), {0.6, 2}, {0.3, 3}, {0.4, 4}, {0.1, 5}}) {
        near.add(returned, k);
        none.add(returned, k);
    }
    const std::vector<std::pair<double, std::int64_t>> nearest{{0.1, 5}, {0.3, 3}};
    EXPECT_EQ(near.all(), nearest);
    EXPECT_EQ(near.farthest(), 0.3);
    EXPECT_TRUE(none.all().empty());
    EXPECT_EQ(none.farthest(), 0.5);
}

}  // namespace
}  // namespace swirl::analysis
