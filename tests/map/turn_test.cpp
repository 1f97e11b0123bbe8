// Rotations, tabled and by series, against long double.
#include "map/first_contact/circle_path.hpp"
#include "map/first_contact/vertices.hpp"
#include "map/numbers/turn_table.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace swirl {
namespace {

using tests::Random;

Vec2<long double> exact_turn(long double angle) {
    const long double half = std::sin(angle / 2);
    return {-2 * half * half, std::sin(angle)};
}

TEST(Turn, TabledMomentsComeWithWhatRoundingLeftOut) {
    double worst = 0;
    for (double time = 1.0 / 16; time < 7.98; time += 1.0 / 64) {
        const auto near = detail::moment_near(time + 1.0 / 200);
        EXPECT_EQ(near.time, time);
        const Vec2<long double> exact = exact_turn(time);
        const long double x = static_cast<long double>(near.turn.x) + near.rest.x - exact.x;
        const long double y = static_cast<long double>(near.turn.y) + near.rest.y - exact.y;
        worst = std::max(worst, static_cast<double>(std::fabs(x) + std::fabs(y)));
    }
    std::printf("largest error of a tabled moment %.1e\n", worst);
    EXPECT_LE(worst, 2e-18);
}

TEST(Turn, IsRightToAnUlpAfterATabledMoment) {
    Random random(5);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto near = detail::moment_near(random.between(0.04, 7.9));
        const double later = random.between(-0.1, 0.1);
        const Vec2<double> turn = detail::turn_after(near, later);
        const Vec2<long double> exact = exact_turn(static_cast<long double>(near.time) + later);
        worst = std::max({worst, std::fabs(static_cast<double>(turn.x - exact.x)),
                          std::fabs(static_cast<double>(turn.y - exact.y))});
    }
    std::printf("largest error of cis t - 1 %.1e\n", worst);
    EXPECT_LE(worst, 0x1p-52);  // of values up to 2
}

TEST(Turn, MomentsThatAreNotTabledStayWhereTheyAre) {
    for (const double time : {1e-300, 1e-9, 0.03, 7.995, 16.0}) {
        const auto near = detail::moment_near(time);
        EXPECT_EQ(near.time, time);
        EXPECT_NEAR(near.turn.y, std::sin(time), 1e-16 * std::max(time, 1.0));
    }
}

TEST(Turn, RoughAnglesNumberVertices) {
    double worst = 0;
    for (double angle = -3.14; angle < 3.14; angle += 1e-4)
        worst = std::max(worst, std::fabs(detail::rough_angle(3 * std::sin(angle), 3 * std::cos(angle)) - angle));
    EXPECT_LE(worst, 3e-6);
}

/// sin about a moment: the series gives its root to rounding, and is accepted while |d|¹¹/11! is below it.
TEST(GapSeries, FindsTheRootNearItsMoment) {
    for (const double away : {-0.2, -0.09, -0.02, -1e-3, 0.0, 1e-6, 0.05, 0.09, 0.2}) {
        detail::GapSeries<double> g;
        double factorial = 1;
        for (int k = 0; k < 11; ++k) {
            factorial *= k > 1 ? k : 1;
            const double c = std::cos(away), s = std::sin(away);
            g.c[k] = std::array{s, c, -s, -c}[static_cast<std::size_t>(k % 4)] / factorial;
        }
        const auto root = detail::root_of(g);
        EXPECT_EQ(detail::is_converged(root, 1.0, 1.0), std::fabs(away) < 0.095) << away;
        if (std::fabs(away) > 0.095) continue;
        EXPECT_NEAR(root.first + root.second, -away, 1e-16) << away;
        EXPECT_NEAR(detail::gap_at(g, root).rate, 1, 1e-12) << away;
    }
}

}  // namespace
}  // namespace swirl
