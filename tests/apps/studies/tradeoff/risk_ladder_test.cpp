// What a risk saves, on runs whose truth is known.
#include "apps/studies/tradeoff/risk_ladder.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::studies::tradeoff {
namespace {

constexpr std::int64_t look = 2187, limits = 20'000;  // impacts

/// Runs that are chaotic at the look with one exponent, of which every `each`-th is steady at the limits; 0: none.
std::vector<RunAtBoth> runs_of(std::size_t count, std::size_t each) {
    std::vector<RunAtBoth> runs(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool stays = each == 0 || i % each != 0;
        runs[i].at_look = {false, true, 0.5, 0.01};
        runs[i].at_limits = {!stays, stays, 0.5, 0.01};
        runs[i].impacts_to_look = look;
        runs[i].impacts_to_limits = limits;
    }
    return runs;
}

// All are looked at, 72 candidates twice are the least sample of P = 0.05 (ln 0.025 / ln 0.95 = 71.9); it draws 5 %
// more than it wants. The sample alone goes to the limits.
TEST(RiskLadder, WhereChaosStaysAllButTheSampleIsCalled) {
    const auto runs = runs_of(1000, 0);
    const auto rows = risk_rows(runs, {0.001, 0.05}, 1, look, 1e-6);
    ASSERT_EQ(rows.size(), 3U);
    for (const RiskRow& row : {rows[0], rows[1]}) {  // at 0.001 the sample would be more than a third
        EXPECT_EQ(row.impacts, 1000 * limits);
        EXPECT_EQ(row.runs_called, 0);
        EXPECT_DOUBLE_EQ(row.seconds, 20.0);
    }
    const RiskRow& row = rows[2];
    const std::int64_t sample = 1000 - row.runs_called;
    EXPECT_GE(sample, 144);
    EXPECT_LE(sample, 1.05 * 144 + 2);
    EXPECT_EQ(row.impacts, 1000 * look + sample * limits);
    EXPECT_EQ(row.changed, 0);
    EXPECT_LT(row.bound, 0.05);
    EXPECT_EQ(recommended_risk(rows), 0.05);
}

// One run in three leaves: no risk below a third is kept. A few hundred looks say so at 0.2, and the other runs are not
// looked at: they cost what the limits do.
TEST(RiskLadder, WhereChaosEndsNothingIsCalledAndNoneIsRecommended) {
    const auto runs = runs_of(1000, 3);
    const auto rows = risk_rows(runs, {0.05, 0.2}, 1, look, 1e-6);
    for (const RiskRow& row : rows) EXPECT_EQ(row.runs_called, 0) << row.risk;
    const std::int64_t looks = rows.back().impacts - 1000 * limits;
    EXPECT_EQ(looks % look, 0);
    EXPECT_GT(looks, 0);
    EXPECT_LT(looks, 300 * look);
    EXPECT_EQ(recommended_risk(rows), 0);
}

// One in a hundred leaves: at 0.1 some are called that the limits do not call, and they are counted.
TEST(RiskLadder, WhatIsCalledWronglyIsCounted) {
    const auto runs = runs_of(2000, 100);
    const auto rows = risk_rows(runs, {0.1}, 1, look, 1e-6);
    EXPECT_GT(rows[1].runs_called, 1000);
    EXPECT_GT(rows[1].changed, 0);
    EXPECT_LT(static_cast<double>(rows[1].changed), 0.1 * static_cast<double>(rows[1].runs_called));
    EXPECT_DOUBLE_EQ(rows[1].share_that_differs, static_cast<double>(rows[1].changed) / 2000);
}

RiskRow row_of(double risk, std::int64_t impacts) {
    RiskRow row;
    row.risk = risk;
    row.impacts = impacts;
    return row;
}

TEST(RiskLadder, TheSmallestThatSavesHalfOfWhatAnySavesIsRecommended) {
    EXPECT_EQ(recommended_risk({row_of(0, 1000), row_of(0.01, 900), row_of(0.05, 590), row_of(0.1, 200)}), 0.05);
    EXPECT_EQ(recommended_risk({row_of(0, 1000), row_of(0.01, 1100), row_of(0.05, 910)}), 0);
    EXPECT_EQ(recommended_risk({}), 0);
}

}  // namespace
}  // namespace swirl::studies::tradeoff
