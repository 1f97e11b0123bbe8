// Lines followed diagonal by diagonal against the plain definition (brute_force.hpp), and against lines counted column
// by column.
#include "analysis/recurrence/smooth_lines.hpp"
#include "analysis/recurrence/column_finder.hpp"
#include "analysis/recurrence/line_counter.hpp"
#include "tests/analysis/only_targets.hpp"
#include "tests/analysis/recurrence/brute_force.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

using tests::as_map;

enum Kind { smooth, walk, noise, constant, ties };

// n points of `dimension` coordinates, point after point. Ties: on a grid whose distances are thresholds.
std::vector<double> coordinates(std::mt19937_64& random, Kind kind, std::size_t n, std::size_t dimension) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> flat(n * dimension);
    const double turn = 0.05 + 0.04 * uniform(random), second = 0.03 + 0.02 * uniform(random);
    for (std::size_t m = 0; m < dimension; ++m) {
        double x = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double phase = turn * static_cast<double>(i) + static_cast<double>(m);
            x += 0.1 * uniform(random);
            const double along = std::sin(phase) + std::sin(second * static_cast<double>(i));
            const std::array<double, 5> of_kind{along, x, uniform(random), 0.3, std::round(4 * along) / 4};
            flat[i * dimension + m] = of_kind[kind];
        }
    }
    return flat;
}

LineHistograms followed(const Points& points, double threshold, const Settings& settings) {
    const double bound = key_bound(threshold, settings.norm, settings.strict, points.dimension);
    const detail::TiledMatrix matrix = detail::tiled_matrix(points, points, settings.norm, {&bound, 1});
    EXPECT_TRUE(detail::can_follow_diagonals(matrix));
    return detail::count_smooth_lines(matrix, 0, theiler_window(settings, false), settings);
}

void expect_same(const LineHistograms& a, const LineHistograms& b, const std::string& what) {
    EXPECT_EQ(a.points, b.points) << what;
    EXPECT_EQ(a.points_outside_window, b.points_outside_window) << what;
    EXPECT_EQ(a.diagonal, b.diagonal) << what;
    EXPECT_EQ(a.vertical, b.vertical) << what;
    EXPECT_EQ(a.recurrence_time, b.recurrence_time) << what;
    EXPECT_EQ(a.diagonal_points, b.diagonal_points) << what;
}

TEST(SmoothLines, EqualBruteForceWithEveryOption) {
    std::mt19937_64 random(1);
    const std::vector<std::size_t> sizes{1, 2, 8, 9, 63, 64, 65, 129, 255, 256, 257, 320};
    for (long trial = 0; trial < tests::sample_count(300); ++trial) {
        const std::size_t n = sizes[static_cast<std::size_t>(trial) % sizes.size()], dimension = 2 + random() % 2;
        const auto kind = static_cast<Kind>(random() % 5);
        const std::vector<double> flat = coordinates(random, kind, n, dimension);
        std::vector<std::vector<double>> list;
        for (std::size_t i = 0; i < n; ++i)
            list.emplace_back(flat.begin() + static_cast<std::ptrdiff_t>(i * dimension),
                              flat.begin() + static_cast<std::ptrdiff_t>((i + 1) * dimension));
        const Settings s = tests::random_settings(random);
        const double threshold = std::array{0.1, 0.25, 0.5, 1.0, 9.0}[random() % 5];
        const auto matrix = tests::recurrence_matrix(list, list, std::vector<double>(dimension), threshold, s);
        const tests::Lines plain = tests::lines_of(matrix, true, s);
        const LineHistograms fast = followed(section_points(flat, static_cast<int>(dimension)), threshold, s);
        const std::string what = "trial " + std::to_string(trial);
        EXPECT_EQ(fast.points, plain.points) << what;
        EXPECT_EQ(fast.points_outside_window, plain.points_outside) << what;
        EXPECT_EQ(as_map(fast.diagonal), plain.diagonal) << what;
        EXPECT_EQ(as_map(fast.vertical), plain.vertical) << what;
        EXPECT_EQ(as_map(fast.recurrence_time), plain.time) << what;
        EXPECT_EQ(as_map(fast.diagonal_points), plain.diagonal_points) << what;
        ASSERT_FALSE(HasFailure());
    }
}

// Several chunks of columns and bands of diagonals, on several threads; delay vectors share one copy of their series.
TEST(SmoothLines, EqualThoseOfColumnsOnAnyThreads) {
    std::mt19937_64 random(2);
    for (const std::size_t n : {511, 513, 1700, 3001})
        for (const Kind kind : {smooth, walk, constant, ties})
            for (const int threads : {1, 2, 5}) {
                const Points points = embed_series(coordinates(random, kind, n + 12, 1), 3, 6);
                const Settings s = tests::random_settings(random);
                const double bound = key_bound(0.5, s.norm, s.strict, 3);
                const detail::ColumnFinder finder = detail::find_columns(points, points, s.norm, {&bound, 1});
                const detail::Shape shape{n, n, true, theiler_window(s, false)};
                const auto columns =
                    detail::count_all_lines(shape, 1, s, [&] { return detail::source_of(finder); }).front();
                LineHistograms fast;
                tbb::task_arena(threads).execute([&] { fast = followed(points, 0.5, s); });
                expect_same(fast, columns, std::to_string(n) + " points of kind " + std::to_string(kind));
                ASSERT_FALSE(HasFailure());
            }
}

// All pairs lie within a few rounding errors of the threshold: single precision may decide none of them.
TEST(SmoothLines, AreRightWhereEveryDistanceTiesWithTheThreshold) {
    std::mt19937_64 random(3);
    std::vector<double> flat;
    for (std::size_t i = 0; i < 300; ++i)
        for (const double x : {3.0, 7.0})
            flat.push_back(x + (i % 2 == 0 ? 0.1 : 0) + std::ldexp(static_cast<double>(random() % 5), -50));
    const Points points = section_points(flat, 2);
    for (const bool strict : {false, true}) {
        Settings s;
        s.strict = strict;
        const double bound = key_bound(0.1 * std::sqrt(2.0), s.norm, strict, 2);
        std::uint64_t expected = 0;
        for (std::size_t i = 0; i < points.count; ++i)
            for (std::size_t j = 0; j < points.count; ++j)
                expected += pair_key(points, i, points, j, s.norm) <= bound ? 1 : 0;
        EXPECT_EQ(followed(points, 0.1 * std::sqrt(2.0), s).points, expected);
        EXPECT_GT(expected, points.count * points.count / 2);
        EXPECT_LT(expected, points.count * points.count);
    }
}

TEST(SmoothLines, AreTheSameOnAllInstructionSets) {
    std::mt19937_64 random(4);
    for (const std::size_t dimension : {2, 3}) {
        const Points points = section_points(coordinates(random, smooth, 700, dimension), static_cast<int>(dimension));
        for (const Norm norm : {Norm::euclidean, Norm::maximum, Norm::manhattan}) {
            Settings s;
            s.norm = norm;
            const LineHistograms best = followed(points, 0.3, s);
            for (const std::int64_t target : tests::all_targets()) {
                const tests::OnlyTargets only(target);
                expect_same(followed(points, 0.3, s), best, hwy::TargetName(target));
            }
        }
    }
}

}  // namespace
}  // namespace swirl::analysis::recurrence
