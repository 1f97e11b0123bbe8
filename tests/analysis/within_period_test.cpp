// A number less whole periods has the bits of std::remainder, wherever it lies.
#include "analysis/within_period.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace swirl::analysis {
namespace {

void expect_remainder(double x, double period) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(within_period(x, period)),
              std::bit_cast<std::uint64_t>(std::remainder(x, period)))
        << x << " with period " << period;
}

TEST(WithinPeriod, HasTheBitsOfTheRemainderAtEveryFraction) {
    for (const double period : {2 * M_PI, M_PI / 3, 1.0, 1e-3, 360.0})
        for (int quarters = -12; quarters <= 12; ++quarters)
            for (const double aside : {-1e300, 0.0, 1e300}) {
                double x = 0.25 * quarters * period;
                for (int ulps = 0; ulps < 3; ++ulps) {
                    expect_remainder(x, period);
                    x = std::nextafter(x, aside);
                }
            }
    expect_remainder(-0.0, 1);
    expect_remainder(-1.0, 1);  // −0, as the remainder of a negative number
}

TEST(WithinPeriod, HasTheBitsOfTheRemainderOfRandomNumbers) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> draw(-3, 3), exponent(-10, 10);
    for (int i = 0; i < 100'000; ++i) {
        const double periods = draw(random), size = exponent(random);
        expect_remainder(periods * 2 * M_PI, 2 * M_PI);
        expect_remainder(periods * std::pow(10.0, size), 2 * M_PI);
    }
}

TEST(WithinPeriod, LeavesPlainNumbersAndWhatIsNoNumber) {
    EXPECT_EQ(within_period(123.5, 0), 123.5);
    EXPECT_TRUE(std::isnan(within_period(std::numeric_limits<double>::quiet_NaN(), 1)));
    EXPECT_TRUE(std::isnan(within_period(std::numeric_limits<double>::infinity(), 1)));
}

}  // namespace
}  // namespace swirl::analysis
