#include "analysis/ramps/fold_delay.hpp"
#include "analysis/ramps/kept_period.hpp"

#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using namespace swirl::analysis;

/// How far beyond the fold of ξ′ = ξ + a δ + b ξ² an orbit is that came along the stable branch, as |ξ| passes `gone`.
double delay_of(double a, double b, double step, double gone) {
    const double begin = -30 * std::cbrt(step * step);
    double delta = begin;
    double xi = (b > 0 ? -1 : 1) * std::sqrt(-a * delta / b);
    for (std::int64_t n = 0; n < 100'000'000; ++n) {
        delta = begin + static_cast<double>(n) * step;
        xi += a * delta + b * xi * xi;
        if (std::abs(xi) > gone && (xi > 0) == (b > 0)) break;
    }
    return delta;
}

TEST(FoldDelay, IsThatOfTheNormalFormUpToTheNextOrder) {
    for (const double b : {1.0, -3.0}) {
        const double a = b > 0 ? 2 : -2;
        double last = 1;
        for (const double step : {1e-6, 1e-8, 1e-10}) {
            const double measured = delay_of(a, b, step, 1);
            // The next order: what is left from |xi| = 1 on, and the steps' own, some rounds of (a b step)^{-1/3}.
            const double error = std::abs(measured / fold_delay(a, b, step) - 1);
            EXPECT_LT(error, 3 * std::cbrt(std::abs(a * b) * step)) << b << " " << step;
            EXPECT_LT(error, 0.5 * last);
            last = error;
        }
    }
}

TEST(FoldDelay, IsSeenEarlierByTheStepThatCounts) {
    const double a = 2, b = 1, leave = 1e-3;
    for (const double step : {1e-8, 1e-9}) {
        double delta = -1e-2, xi = -std::sqrt(-a * delta / b), last = xi;
        for (std::int64_t n = 0; n < 100'000'000; ++n) {
            delta = -1e-2 + static_cast<double>(n) * step;
            last = xi;
            xi += a * delta + b * xi * xi;
            if (delta > -1e-3 && std::abs(xi - last) > leave) break;
        }
        EXPECT_NEAR(delta / fold_delay(a, b, step, leave), 1, 5 * std::cbrt(a * b * step));
        EXPECT_LT(fold_delay(a, b, step, leave), fold_delay(a, b, step));
    }
    EXPECT_TRUE(std::isnan(fold_delay(a, b, 1e-2, 1e-9)));
}

using Map = maps::Logistic;

/// Of x ↦ r x (1 − x): the r at which a period is kept, and left, as r rises from 2.8 to 4 at that rate.
struct Change {
    PeriodEvent event;
    int period;
    double r;
};
std::vector<Change> changes_of(double rate, const KeptPeriodOptions& options) {
    std::vector<Change> changes;
    Map map;
    KeptPeriod<Map> kept(options);
    Vector<1> x{0.64};
    for (map.r = 2.8; map.r < 3.6; map.r += rate) {
        x = map.advance(x).state;
        const int before = kept.period();
        const PeriodEvent event = kept.add(map, x);
        if (event != PeriodEvent::none)
            changes.push_back({event, event == PeriodEvent::left ? before : kept.period(), map.r});
    }
    return changes;
}

TEST(KeptPeriod, FollowsTheDoublingsOfTheLogisticMap) {
    KeptPeriodOptions options;
    options.longest = 8;
    options.tolerance = 1e-3;
    const std::vector<Change> changes = changes_of(1e-6, options);
    ASSERT_GE(changes.size(), 6U);
    const int periods[] = {1, 1, 2, 2, 4, 4};
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(changes[i].event, i % 2 == 0 ? PeriodEvent::kept : PeriodEvent::left);
        EXPECT_EQ(changes[i].period, periods[i]) << i;
    }
    // Beyond the doublings r = 3 and 1 + sqrt 6, by no more than a slow passage (its instability grows from rounding:
    // sum of ln|multiplier| over some 10^4 steps) takes.
    EXPECT_GT(changes[1].r, 3);
    EXPECT_LT(changes[1].r, 3.02);
    EXPECT_GT(changes[3].r, 1 + std::sqrt(6.0));
    EXPECT_LT(changes[3].r, 1 + std::sqrt(6.0) + 0.02);
}

TEST(KeptPeriod, ChaosKeepsNone) {
    Map map;
    map.r = 3.99;
    KeptPeriod<Map> kept({});
    Vector<1> x{0.2};
    for (int i = 0; i < 100'000; ++i) {
        x = map.advance(x).state;
        EXPECT_EQ(kept.add(map, x), PeriodEvent::none);
    }
}

TEST(KeptPeriod, GivesTheLastRound) {
    Map map;
    map.r = 3.2;
    KeptPeriod<Map> kept({});
    Vector<1> x{0.3};
    for (int i = 0; i < 1000; ++i) {
        x = map.advance(x).state;
        kept.add(map, x);
    }
    ASSERT_EQ(kept.period(), 2);
    const auto points = kept.last_period();
    ASSERT_EQ(points.size(), 2U);
    EXPECT_EQ(points[1], x);
    EXPECT_NEAR(map.advance(points[1]).state[0], points[0][0], 1e-12);
}

}  // namespace
