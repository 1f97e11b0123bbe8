// What is recommended from ladders that are made up: how few impacts are enough, which arithmetic is the knee, what is
// said.
#include "apps/studies/tradeoff/tradeoff.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace swirl::studies::tradeoff {
namespace {

EvidenceRow verdicts(std::int64_t collisions, std::int64_t changed, std::int64_t runs) {
    EvidenceRow row;
    row.collisions = collisions;
    row.changed = changed;
    row.runs = runs;
    row.changed_rate = analysis::rate_interval(changed, runs);
    row.seconds = 0.01;
    return row;
}

/// Ten thousand flights, none missed, errors up to so many times ε c.
ArithmeticRow measured(const Arithmetic& arithmetic, double seconds, double in_condition) {
    ArithmeticRow row;
    row.arithmetic = &arithmetic;
    row.time.median = seconds;
    row.orbit = ArithmeticOrbit{};
    row.verdict_differs = false;
    row.flights = FlightComparison{};
    row.flights->flights = 10'000;
    row.flights->missed_rate = row.flights->misordered_rate = analysis::rate_interval(0, 10'000);
    row.flights->largest_in_condition = in_condition;
    row.flights->one.largest = 1e-15;
    return row;
}

void set_missed(ArithmeticRow& row, std::int64_t missed, std::int64_t misordered) {
    row.flights->missed = missed;
    row.flights->misordered = misordered;
    row.flights->missed_rate = analysis::rate_interval(missed, row.flights->flights);
    row.flights->misordered_rate = analysis::rate_interval(misordered, row.flights->flights);
}

/// double, another search in double, and quad.
class Recommendation : public testing::Test {
protected:
    static constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Arithmetic in_double{"double", "", true, epsilon, nullptr, nullptr},
        other{"other", "", false, epsilon, nullptr, nullptr}, quad{"quad", "", true, 0x1p-112, nullptr, nullptr};

    Tradeoff of(std::vector<EvidenceRow> evidence) {
        Tradeoff found;
        found.arithmetics = {measured(in_double, 2e-7, 2), measured(other, 1e-6, 2), measured(quad, 5e-5, 2)};
        found.arithmetics.back().flights.reset();
        found.arithmetics.back().verdict_differs.reset();
        found.evidence.rows = std::move(evidence);
        found.drawn.flights.resize(1);
        found.compared = 10'000;
        return found;
    }
    static std::int64_t enough_of(Tradeoff found) {
        recommend(found);
        return found.enough_collisions;
    }
};

TEST_F(Recommendation, FewerImpactsAreNotEnoughWhereMeanSDiffers) {
    auto off = verdicts(100, 0, 64), near = verdicts(300, 0, 64);
    off.mean_spin_differs = 0.6;
    near.mean_spin_differs = 0.04;
    EXPECT_EQ(enough_of(of({off, near, verdicts(1000, 0, 64)})), 300);
    Tradeoff none = of({off, verdicts(300, 0, 64)});
    recommend(none);
    EXPECT_EQ(none.enough_collisions, 0);
    EXPECT_NE(none.advice.find("After 100 + 100 impacts mean S differs by 0.6; below 0.05 would do"), std::string::npos)
        << none.advice;
}

TEST_F(Recommendation, FewerImpactsAreEnoughWhereLessThanATenthOfTheStartsChangesAtNinetyFivePercent) {
    EXPECT_EQ(enough_of(of({verdicts(100, 9, 64), verdicts(300, 1, 64), verdicts(1000, 0, 64)})), 300);
    EXPECT_EQ(enough_of(of({verdicts(100, 0, 64), verdicts(300, 2, 64), verdicts(1000, 0, 64)})), 0);  // up to 10.8 %
    EXPECT_EQ(enough_of(of({verdicts(100, 0, 29), verdicts(300, 0, 29)})), 100);                       // up to 9.8 %
    EXPECT_EQ(enough_of(of({verdicts(100, 0, 28), verdicts(300, 0, 28)})), 0);                         // up to 10.1 %
}

TEST_F(Recommendation, EightStartsOfWhichNoneChangesDoNotTellThatFewerImpactsAreEnough) {
    Tradeoff found = of({verdicts(100, 0, 8), verdicts(300, 0, 8)});
    recommend(found);
    EXPECT_EQ(found.enough_collisions, 0);
    EXPECT_NE(found.advice.find("with 300 + 300 impacts"), std::string::npos) << found.advice;
    EXPECT_NE(found.advice.find("After 100 + 100 impacts none of 8 starts has another mode, 31 % at most"),
              std::string::npos)
        << found.advice;
}

TEST_F(Recommendation, MoreImpactsAreAskedForWhereTheBudgetEndedBeforeTheMostWereJudged) {
    Tradeoff found = of({verdicts(100, 0, 8)});
    found.evidence.judged_most = false;
    recommend(found);
    EXPECT_NE(found.advice.find("with at least 100 + 100 impacts"), std::string::npos) << found.advice;
    EXPECT_NE(found.advice.find("The budget ended before more were judged: give a larger --budget"), std::string::npos)
        << found.advice;
}

TEST_F(Recommendation, NoFlightsOfAnOrbitThatGoesOnAreForWantOfABudget) {
    Tradeoff found = of({});
    found.drawn.flights.clear();
    found.drawn.outcome = Outcome::completed;
    recommend(found);
    EXPECT_EQ(found.recommended, nullptr);
    EXPECT_EQ(found.reason, "the budget was spent before flights were drawn: give a larger --budget");
}

TEST_F(Recommendation, WhatALargerNumberDoesNotShowASmallerOneDoesNotEither) {
    const auto rows = {verdicts(100, 0, 64), verdicts(300, 12, 64), verdicts(1000, 0, 64), verdicts(3000, 9, 64),
                       verdicts(10000, 0, 64)};
    EXPECT_EQ(enough_of(of(rows)), 0);
}

TEST_F(Recommendation, NumbersThatWereNotMeasuredAreNotEnough) {
    EXPECT_EQ(enough_of(of({})), 0);
    EXPECT_EQ(enough_of(of({verdicts(100, 0, 64)})), 0);
}

TEST_F(Recommendation, AContactOutOfOrderIsAnObjectionAsAMissedOneIs) {
    for (const auto& [missed, misordered] : {std::pair(1, 0), std::pair(0, 1)}) {
        Tradeoff found = of({});
        set_missed(found.arithmetics[0], missed, misordered);
        recommend(found);
        EXPECT_EQ(found.recommended, &quad);
        EXPECT_NE(
            found.reason.find("missed " + std::to_string(missed) + " and misordered " + std::to_string(misordered)),
            std::string::npos)
            << found.reason;
        EXPECT_EQ(found.knee, &other);
    }
}

TEST_F(Recommendation, TheKneeIsTheCheapestArithmeticThatIsRightToFiftyRoundings) {
    const auto knee_of = [this](double time, double in_condition) {
        Tradeoff found = of({});
        found.arithmetics[1] = measured(other, time, in_condition);
        recommend(found);
        EXPECT_EQ(found.recommended, &in_double) << "searches to compare with are not recommended";
        return found.knee;
    };
    EXPECT_EQ(knee_of(1e-6, 2), &in_double);
    EXPECT_EQ(knee_of(1e-7, 49), &other);
    EXPECT_EQ(knee_of(1e-7, 51), &in_double);
}

TEST_F(Recommendation, ThereIsNoKneeWhereNothingWasComparedOrTimed) {
    Tradeoff none = of({});
    none.compared = 0;
    recommend(none);
    EXPECT_EQ(none.knee, nullptr);
    EXPECT_EQ(none.recommended, nullptr);
    Tradeoff untimed = of({});
    for (ArithmeticRow& row : untimed.arithmetics) row.time.median = std::nan("");
    recommend(untimed);
    EXPECT_EQ(untimed.knee, nullptr);
}

TEST_F(Recommendation, AVerdictThatWasNotComparedIsNoObjectionAndIsSaid) {
    Tradeoff found = of({});
    found.arithmetics.back().orbit.reset();
    for (ArithmeticRow& row : found.arithmetics) row.verdict_differs.reset();
    recommend(found);
    EXPECT_EQ(found.recommended, &in_double);
    EXPECT_NE(found.reason.find("the budget was spent before its verdict was compared with that of quad"),
              std::string::npos)
        << found.reason;
}

TEST_F(Recommendation, MoreDigitsAreOfferedForOrbitsThatKeepThemAndNotForCycles) {
    Tradeoff found = of({});
    recommend(found);
    const std::string cycle = found.advice.substr(found.advice.find("For a cycle"));
    EXPECT_EQ(cycle.find("For a cycle use double: one step is off by at most 1e-15. orbits and continue round"), 0u)
        << cycle;
    EXPECT_NE(cycle.find("simulate, recurrence and spectrum keep those of quad, at 250 times the time"),
              std::string::npos)
        << cycle;
}

}  // namespace
}  // namespace swirl::studies::tradeoff
