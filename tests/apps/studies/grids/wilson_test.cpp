#include "apps/studies/grids/run_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swirl::studies::grids {
namespace {

/// At the interval's ends p the share is z standard deviations √(p(1 − p)/n) from p: its definition.
TEST(WilsonInterval, EndsWhereTheShareIsTwoStandardDeviationsAway) {
    constexpr double z = 1.959963984540054;
    for (const double n : {1.0, 2.0, 8.0, 100.0})
        for (double k = 0; k <= n; ++k) {
            const double share = k / n;
            const Interval interval = wilson_interval(share, n);
            EXPECT_TRUE(0 <= interval.low && interval.low <= share && share <= interval.high && interval.high <= 1);
            for (const double p : {interval.low, interval.high})
                EXPECT_NEAR((share - p) * (share - p), z * z * p * (1 - p) / n, 1e-12) << k << " of " << n;
        }
}

/// 0 of 8: (Brown, Cai, DasGupta, Statist. Sci. 16 (2001) 101) z²/(n + z²).
TEST(WilsonInterval, OfNoneIsClosedForm) {
    const Interval none = wilson_interval(0, 8);
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, 3.8414588206941254 / (8 + 3.8414588206941254), 1e-15);
}

}  // namespace
}  // namespace swirl::studies::grids
