// Columns found through tiles against the rule itself (pair_key), bit for bit.
#include "analysis/recurrence/tiled_columns.hpp"
#include "analysis/recurrence/column_finder.hpp"
#include "tests/analysis/only_targets.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

// A walk of `dimension` coordinates in steps of 1/10 of its scale, on a grid so that distances tie with thresholds, or
// not.
Points walk(std::mt19937_64& random, std::size_t n, int dimension, double offset, bool on_grid, double period) {
    std::normal_distribution<double> step(0, 0.1);
    std::vector<double> flat(n * static_cast<std::size_t>(dimension));
    for (int m = 0; m < dimension; ++m) {
        double x = 0;
        for (std::size_t i = 0; i < n; ++i) {
            x += step(random);
            flat[i * static_cast<std::size_t>(dimension) + static_cast<std::size_t>(m)] =
                offset + (on_grid ? std::round(10 * x) / 10 : x);
        }
    }
    return section_points(flat, dimension, std::vector<double>(static_cast<std::size_t>(dimension), period));
}

void expect_the_rule(const Points& rows, const Points& columns, Norm norm, const std::vector<double>& bounds,
                     const std::string& what) {
    const detail::TiledMatrix matrix = detail::tiled_matrix(rows, columns, norm, bounds);
    detail::TileScratch scratch;
    for (std::size_t c = 0; c < columns.count; ++c) {
        const std::size_t offset = (columns.count - 1 - c) % 130;
        std::vector<std::vector<std::uint64_t>> frames(bounds.size(),
                                                       std::vector<std::uint64_t>((rows.count + 130) / 64 + 2, 0));
        std::vector<std::uint64_t*> pointers;
        pointers.reserve(frames.size());
        for (auto& frame : frames) pointers.push_back(frame.data());
        detail::fill_column_by_tiles(matrix, c, offset, pointers, scratch);
        for (std::size_t q = 0; q < bounds.size(); ++q)
            for (std::size_t bit = 0; bit < frames[q].size() * 64; ++bit) {
                const bool is_row = bit >= offset && bit < offset + rows.count;
                const bool expected = is_row && pair_key(rows, bit - offset, columns, c, norm) <= bounds[q];
                ASSERT_EQ((frames[q][bit >> 6] >> (bit & 63)) & 1, std::uint64_t{expected})
                    << what << ": column " << c << ", bit " << bit << ", bound " << bounds[q];
            }
    }
}

TEST(TiledColumns, HoldTheBitsThatTheRuleGives) {
    std::mt19937_64 random(1);
    const std::vector<std::size_t> sizes{1, 7, 8, 9, 63, 64, 65, 130, 200, 515};
    for (long trial = 0; trial < tests::sample_count(150); ++trial) {
        const int dimension = 1 + static_cast<int>(random() % 5);
        const auto norm = static_cast<Norm>(random() % 3);
        // Far from 0 the margin of single precision grows until it is of no use.
        const double offset = std::array{0.0, 1.0, 30.0, 1e3, 1e9}[random() % 5],
                     period = random() % 4 == 0 ? 2.5 : 0.0;
        const bool on_grid = random() % 2 == 0;
        const Points rows = walk(random, sizes[random() % sizes.size()], dimension, offset, on_grid, period);
        const Points columns = walk(random, sizes[random() % sizes.size()], dimension, offset, on_grid, period);
        std::vector<double> bounds;
        for (const double threshold : {0.3, 1.0, 0.0, 0.7})
            if (bounds.empty() || random() % 2 == 0)
                bounds.push_back(key_bound(threshold, norm, random() % 2 == 0, dimension));
        expect_the_rule(rows, random() % 2 == 0 ? rows : columns, norm, bounds, "trial " + std::to_string(trial));
        if (HasFatalFailure()) return;
    }
}

// All pairs lie within a few rounding errors of the threshold: single precision may decide none of them.
TEST(TiledColumns, AreRightWhereEveryDistanceTiesWithTheThreshold) {
    const std::size_t n = 200;
    std::vector<double> flat;
    std::mt19937_64 random(2);
    for (std::size_t i = 0; i < n; ++i)
        for (const double x : {3.0, 7.0, 11.0})
            flat.push_back(x + (i % 2 == 0 ? 0.1 : 0) + std::ldexp(static_cast<double>(random() % 5), -50));
    const Points points = section_points(flat, 3);
    for (const Norm norm : {Norm::euclidean, Norm::maximum, Norm::manhattan}) {
        const double distance = norm == Norm::maximum ? 0.1 : norm == Norm::manhattan ? 0.3 : 0.1 * std::sqrt(3.0);
        for (const bool strict : {false, true})
            expect_the_rule(points, points, norm, {key_bound(distance, norm, strict, 3)}, "ties");
    }
}

TEST(TiledColumns, AreTheSameOnAllInstructionSets) {
    std::mt19937_64 random(3);
    for (const int dimension : {2, 3, 4}) {
        const Points points = walk(random, 203, dimension, 0.0, true, 0.0);
        for (const std::int64_t target : tests::all_targets()) {
            const tests::OnlyTargets only(target);
            expect_the_rule(points, points, Norm::euclidean, {key_bound(0.5, Norm::euclidean, false, dimension)},
                            hwy::TargetName(target));
        }
    }
}

// A smooth trajectory is found through tiles, noise through sorted rows; a series of one coordinate is sorted.
TEST(ColumnFinder, ChoosesTilesForSmoothTrajectories) {
    std::vector<double> smooth, noise;
    std::mt19937_64 random(4);
    for (int i = 0; i < 4000; ++i) {
        smooth.push_back(std::sin(0.1 * i) + std::sin(0.0618 * i));
        noise.push_back(std::uniform_real_distribution<double>(-2, 2)(random));
    }
    const std::vector<double> bounds{key_bound(0.3, Norm::euclidean, false, 3)};
    const auto by_tiles = [&](const Points& points) {
        return detail::find_columns(points, points, Norm::euclidean, bounds).by_tiles;
    };
    EXPECT_TRUE(by_tiles(embed_series(smooth, 3, 6)));
    EXPECT_FALSE(by_tiles(embed_series(noise, 3, 6)));
    EXPECT_FALSE(by_tiles(embed_series(smooth)));
    EXPECT_TRUE(by_tiles(embed_series(smooth, 6, 6)));
    EXPECT_FALSE(by_tiles(embed_series(noise, 6, 6)));
}

}  // namespace
}  // namespace swirl::analysis::recurrence
