// Runs grouped by the attractor that they settled on.
#include "apps/studies/modes/attractors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace swirl::studies {
namespace {

using analysis::Kind;
using analysis::Mode;

RunVerdict verdict(Mode mode, Kind kind, std::int64_t period, double mean) {
    RunVerdict run;
    run.mode = mode;
    run.kind = kind;
    run.period = period;
    run.mean_spin = run.mean_spin_per_impact = mean;
    run.recurrence_rate = run.largest_exponent = std::numeric_limits<double>::quiet_NaN();
    return run;
}

TEST(Attractors, CyclesAreToldApartByPeriodAndMeanAndTheMostSharedComesFirst) {
    const std::vector<RunVerdict> runs = {
        verdict(Mode::steady, Kind::fixed_point, 1, -0.5), verdict(Mode::quasi_steady, Kind::cycle, 2, -0.5),
        verdict(Mode::quasi_steady, Kind::cycle, 2, -0.5 + 1e-8),
        verdict(Mode::quasi_steady, Kind::cycle, 2, -0.5 + 1e-4), verdict(Mode::quasi_steady, Kind::cycle, 4, -0.5)};
    const auto found = attractors_of(runs);
    ASSERT_EQ(found.size(), 4u);
    EXPECT_EQ(found[0].runs, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(found[1].runs, (std::vector<std::size_t>{0}));
    EXPECT_EQ(found[2].runs, (std::vector<std::size_t>{3}));
    EXPECT_EQ(found[3].runs, (std::vector<std::size_t>{4}));
    EXPECT_NEAR(found[0].mean_spin, -0.5, 1e-8);
    EXPECT_TRUE(std::isnan(found[1].mean_spin_error));
    EXPECT_TRUE(std::isnan(found[0].largest_exponent));
}

TEST(Attractors, AContinuumAndChaosAreOneEachWhateverTheirMeans) {
    for (const Kind kind : {Kind::family, Kind::quasi_periodic, Kind::rolling_librating, Kind::chaotic}) {
        const std::vector<RunVerdict> runs = {verdict(Mode::steady, kind, 0, 0.1), verdict(Mode::steady, kind, 0, 0.3)};
        const auto found = attractors_of(runs);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_DOUBLE_EQ(found[0].mean_spin, 0.2);
        constexpr double student =
            12.706204736 / 1.959963985;  // 97.5 % quantiles: of one degree of freedom, and Gauss's
        EXPECT_NEAR(found[0].mean_spin_error, 0.1 * student, 1e-9);
    }
}

TEST(Attractors, WhatEndsOtherwiseIsAnother) {
    auto chaotic = verdict(Mode::undecided, Kind::none, 0, 0), rests = chaotic;
    rests.outcome = Outcome::no_contact;
    EXPECT_EQ(attractors_of(std::vector<RunVerdict>{chaotic, rests}).size(), 2u);
    EXPECT_TRUE(attractors_of({}).empty());
}

}  // namespace
}  // namespace swirl::studies
