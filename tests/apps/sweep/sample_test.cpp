// Points in place of a grid.
#include "apps/command_line/errors.hpp"
#include "apps/sweep/grid_options.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace swirl::apps::sweep {
namespace {

TEST(SweepSample, ALatinHypercubeHasOnePointInEachSlice) {
    const Sample sample = sample_from("latin:100");
    const auto points = unit_points(sample, 3, 7);
    for (const auto& axis : points) {
        std::vector<int> slices(100, 0);
        for (const double u : axis) {
            ASSERT_TRUE(u >= 0 && u < 1);
            ++slices[static_cast<std::size_t>(u * 100)];
        }
        EXPECT_EQ(std::count(slices.begin(), slices.end(), 1), 100);
    }
    EXPECT_NE(points[0], points[1]);
    EXPECT_EQ(unit_points(sample, 3, 7), points);
    EXPECT_NE(unit_points(sample, 3, 8), points);
}

/// Sobol's first points in two dimensions (GSL leaves out the origin): 1/2 1/2, 3/4 1/4, 1/4 3/4, …; and each of 16
/// squares has one of 16 points that begin at a multiple of 16.
TEST(SweepSample, SobolsSequenceIsTheKnownOne) {
    const auto points = unit_points(sample_from("sobol:31"), 2, 1);
    EXPECT_EQ(points[0][0], 0.5);
    EXPECT_EQ(points[1][0], 0.5);
    EXPECT_EQ(points[0][1] + points[1][1], 1);
    std::vector<int> squares(16, 0);
    for (std::size_t i = 15; i < 31; ++i)
        ++squares[static_cast<std::size_t>(points[0][i] * 4) * 4 + static_cast<std::size_t>(points[1][i] * 4)];
    EXPECT_EQ(std::count(squares.begin(), squares.end(), 1), 16);
}

TEST(SweepSample, PointsLieInTheBoxAndSidesAreWhole) {
    GridForm form{sample_from("latin:64"), 1, 0};
    const auto grid = grid_from({"alpha=0.2:0.6", "sides=3:6"}, form);
    EXPECT_EQ(cell_count(grid), 64u);
    std::vector<int> sides(7, 0);
    for (std::size_t c = 0; c < 64; ++c) {
        const auto point = cell_point(grid, c);
        EXPECT_TRUE(point[0] >= 0.2 && point[0] < 0.6);
        EXPECT_EQ(point[1], std::round(point[1]));
        ++sides[static_cast<std::size_t>(point[1])];
    }
    for (int n = 3; n <= 6; ++n) EXPECT_EQ(sides[static_cast<std::size_t>(n)], 16) << n;
    EXPECT_THROW(grid_from({"alpha=0.2:0.6:5"}, form), BadInput);
}

TEST(SweepSample, WhatIsNoSampleIsRefused) {
    for (const char* text :
         {"sobol", "sobol:", "sobol:0", "sobol:1000001", "halton:10", "latin:-3", "latin:1e3", "latin:5x"})
        EXPECT_THROW(sample_from(text), BadInput) << text;
}

TEST(SweepGrid, RefinedPointsAreThoseOfTheFinerGrid) {
    const auto fine = grid_from({"alpha=0.1:0.9:9"}), refined = grid_from({"alpha=0.1:0.9:3"}, {{}, 1, 2});
    EXPECT_EQ(fine[0].points, refined[0].points);
}

}  // namespace
}  // namespace swirl::apps::sweep
