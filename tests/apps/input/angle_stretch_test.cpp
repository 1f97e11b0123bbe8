// The part of a measured angle that can be followed: unwrapped, short gaps bridged, at even times.
#include "apps/input/angle_stretch.hpp"
#include "apps/command_line/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace {

using namespace swirl::apps;

constexpr double turn = 2 * std::numbers::pi;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// θ = rate t, wrapped, at 30 rows a unit of time.
MeasuredAngle film(std::size_t count, double rate, double period = turn) {
    MeasuredAngle angle;
    angle.period = period;
    for (std::size_t i = 0; i < count; ++i) {
        angle.times.push_back(static_cast<double>(i) / 30);
        angle.values.push_back(std::remainder(rate * angle.times.back(), period));
    }
    return angle;
}

TEST(AngleStretch, UnwrapsWithoutAddingUpRoundings) {
    const auto angle = film(60'000, -13.7);
    const auto stretch = longest_stretch(angle);
    ASSERT_EQ(stretch.angles.size(), 60'000u);
    EXPECT_EQ(stretch.bridged, 0u);
    EXPECT_NEAR(stretch.spacing, 1 / 30.0, 1e-13);
    for (std::size_t i = 0; i < 60'000; ++i)  // rate · t is rounded once, at 27,000 radians to 4e-12
        ASSERT_NEAR(stretch.angles[i], -13.7 * angle.times[i], 8e-12);
}

TEST(AngleStretch, BridgesFewLostRowsAndNoMore) {
    auto angle = film(1000, 20);
    for (const std::size_t lost : {100UL, 250UL, 251UL, 252UL, 800UL, 801UL, 802UL, 803UL})
        angle.values[lost] = missing;
    const auto stretch = longest_stretch(angle);
    EXPECT_EQ(stretch.first, 0u);
    EXPECT_EQ(stretch.angles.size(), 800u);  // four at a time end it
    EXPECT_EQ(stretch.bridged, 4u);
    for (std::size_t i = 0; i < 800; ++i) ASSERT_NEAR(stretch.angles[i], 20 * angle.times[i], 1e-11);
}

TEST(AngleStretch, DoesNotGuessTheTurnAcrossAGap) {
    // Turns of 0.1 ± 0.08 of half a period: two may deviate by 0.16. Of 0 ± 0.6: by 1.2, which looks like -0.8.
    for (const bool wild : {false, true}) {
        const double period = turn / 6;
        auto angle = film(1000, 0, period);
        for (std::size_t i = 1; i < 1000; ++i) {
            const double share = wild ? (i % 2 == 0 ? -0.6 : 0.6) : (i % 2 == 0 ? 0.02 : 0.18);
            angle.values[i] = std::remainder(angle.values[i - 1] + share * period / 2, period);
        }
        angle.values[600] = missing;
        EXPECT_EQ(longest_stretch(angle).angles.size(), wild ? 600u : 1000u);
    }
}

TEST(AngleStretch, TooManyLostRowsAreNotMadeUp) {
    auto angle = film(1000, 20);
    for (std::size_t i = 0; i < 1000; i += 10) angle.values[i + 5] = missing;
    const auto stretch = longest_stretch(angle);
    EXPECT_EQ(stretch.angles.size(), 9u);
    EXPECT_EQ(stretch.bridged, 0u);
}

TEST(AngleStretch, RoundedTimesAndAnUnevenClockAreToldApart) {
    const double rate = -6.2;
    auto rounded = film(600, rate), uneven = film(600, rate);
    for (std::size_t i = 0; i < 600; ++i) {
        rounded.times[i] = std::round(rounded.times[i] * 100) / 100;  // the frames were even
        uneven.times[i] += 0.005 * std::sin(static_cast<double>(i * i));
        uneven.values[i] = std::remainder(rate * uneven.times[i], turn);  // the clock is right
    }
    for (const auto* angle : {&rounded, &uneven}) {
        const auto stretch = longest_stretch(*angle);
        EXPECT_TRUE(stretch.is_even());
        EXPECT_GT(stretch.largest_deviation, 0.1);
        for (std::size_t i = 2; i < 600; ++i)
            ASSERT_NEAR(stretch.angles[i] - 2 * stretch.angles[i - 1] + stretch.angles[i - 2], 0, 5e-5) << i;
    }
}

TEST(AngleStretch, NeedsTwoRowsInSuccession) {
    auto angle = film(5, 1);
    angle.values[1] = angle.values[3] = missing;
    EXPECT_THROW(longest_stretch(angle), BadInput);
}

}  // namespace
