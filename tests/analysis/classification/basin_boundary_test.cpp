// Boundaries of basins followed to their saddles: the Hénon map, whose attractor's basin ends on the stable set of its
// outer fixed point (Grebogi, Ott, Yorke 1983), and a map with a jump.
#include "analysis/classification/basin_boundary.hpp"
#include "tests/analysis/maps/henon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace swirl::analysis {
namespace {

using Points = std::vector<Vector<2>>;

/// Does the orbit stay?
std::optional<bool> stays(const maps::Henon& map, Vector<2> z) {
    for (int i = 0; i < 200; ++i) {
        const auto step = map.advance(z);
        if (!goes_on(map, step)) return false;
        z = step.state;
    }
    return true;
}

TEST(BasinBoundary, OfTheHenonAttractorLeadsToTheOuterFixedPoint) {
    const maps::Henon map;
    const double x = map.fixed_point(-1);
    const Vector<2> saddle(x, map.b * x);
    for (const double angle : {0.3, 1.5, 2.5, 4.0, 5.5}) {
        const Vector<2> inside(0.1, 0.1), outside = inside + 6 * Vector<2>(std::cos(angle), std::sin(angle));
        ASSERT_EQ(stays(map, inside), true);
        ASSERT_EQ(stays(map, outside), false);
        double nearest = 1;
        const auto is_enough = [&](const Points& orbit) {
            nearest = std::min(nearest, (orbit.back() - saddle).norm());
            return nearest < 1e-6;
        };
        const auto end = follow_basin_boundary(
            map, inside, outside, [&](const Vector<2>& z) { return stays(map, z); }, is_enough);
        EXPECT_EQ(end, StraddleEnd::found) << angle << ": " << nearest;
    }
}

/// To the right of 0 everything goes to 1, to the left to −1, and 0 is no fixed point: the map jumps there.
struct Jump {
    static constexpr int dimension = 1;
    Advance<1> advance(const Vector<1>& z) const { return {Vector<1>(0.5 * z[0] + (z[0] >= 0 ? 0.5 : -0.5))}; }
    Linearised<1> linearise(const Vector<1>& z) const {
        return {advance(z).state, 1, 0, true, Matrix<1>::Constant(0.5)};
    }
    static double angle_period(int) { return 0; }
};
static_assert(SectionMap<Jump>);

TEST(BasinBoundary, EndsWhereTheMapJumps) {
    const auto end = follow_basin_boundary(
        Jump{}, Vector<1>(0.7), Vector<1>(-0.9), [](const Vector<1>& z) -> std::optional<bool> { return z[0] >= 0; },
        [](const std::vector<Vector<1>>&) { return false; });
    EXPECT_EQ(end, StraddleEnd::border);
}

TEST(BasinBoundary, EndsWhereNobodyKnowsAndWhereItIsStopped) {
    const maps::Henon map;
    const Vector<2> inside(0.1, 0.1), outside(5, 5);
    const auto never = [](const Points&) { return false; };
    const auto unknown = [](const Vector<2>&) -> std::optional<bool> { return {}; };
    EXPECT_EQ(follow_basin_boundary(map, inside, outside, unknown, never), StraddleEnd::undecided);
    const auto known = [&](const Vector<2>& z) { return stays(map, z); };
    EXPECT_EQ(follow_basin_boundary(map, inside, outside, known, never, {}, [] { return true; }),
              StraddleEnd::not_found);
    // Inside is what it was for the first 60 questions only: the end that is asked for again has lost its side.
    int asked = 0;
    const auto forgets = [&](const Vector<2>& z) -> std::optional<bool> { return ++asked <= 60 && *stays(map, z); };
    EXPECT_EQ(follow_basin_boundary(map, inside, outside, forgets, never), StraddleEnd::rounding);
    StraddleOptions few;
    few.most_questions = 100;  // 43 halve the first time
    EXPECT_EQ(follow_basin_boundary(map, inside, outside, known, never, few), StraddleEnd::not_found);
}

}  // namespace
}  // namespace swirl::analysis
