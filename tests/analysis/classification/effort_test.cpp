// Steps and derivatives that cost much: a verdict's work is bounded, and what was cut short is said.
#include "analysis/classification/classify_followed.hpp"
#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

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

TEST(Effort, StepsThatCostMuchAreCutShortAndSaidToBe) {
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
TEST(Effort, ASearchThatCostsTooMuchIsGivenUpAndSaidToBe) {
    const auto found = classify_sequentially(Costly{Logistic{2.9999}}, Vector<1>{0.3}, 0);
    EXPECT_EQ(found.kind, Kind::fixed_point);
    const auto given_up = classify_sequentially(Costly{Logistic{2.9999}, 1, 1e6}, Vector<1>{0.3}, 0);
    EXPECT_EQ(given_up.mode, Mode::undecided);
    const Evidence* search = evidence_of(given_up, "search for a cycle");
    ASSERT_NE(search, nullptr);
    EXPECT_GE(search->value, search->threshold);
    EXPECT_LE(search->value, search->threshold + 1e6);
}

}  // namespace
}  // namespace swirl::analysis
