// The fast line counter against the plain definition (brute_force.hpp), bit for bit, over random cases.
#include "tests/analysis/recurrence/brute_force.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

using tests::as_map;

struct Case {
    std::vector<std::vector<double>> points;
    std::vector<double> periods;
};

// Values on a coarse grid tie often, so that < and <= and equal distances are really tried; walks give long lines.
Case random_case(std::mt19937_64& random, std::size_t n, int dimension) {
    std::uniform_int_distribution<int> pick(0, 3);
    const int kind = pick(random);
    Case c{std::vector<std::vector<double>>(n, std::vector<double>(static_cast<std::size_t>(dimension))), {}};
    for (int m = 0; m < dimension; ++m) c.periods.push_back(pick(random) == 0 ? 2.0 : 0.0);
    std::uniform_real_distribution<double> uniform(-3, 3);
    for (int m = 0; m < dimension; ++m) {
        double walk = 0;
        for (std::size_t i = 0; i < n; ++i) {
            walk += 0.1 * uniform(random);
            const double u = uniform(random);
            c.points[i][static_cast<std::size_t>(m)] = kind == 0 ? std::round(4 * u) / 4 : kind == 1 ? walk : u;
        }
    }
    return c;
}

Points as_points(const Case& c) {
    std::vector<double> flat;
    for (const auto& p : c.points) flat.insert(flat.end(), p.begin(), p.end());
    return section_points(flat, static_cast<int>(c.periods.size()), c.periods);
}

void expect_equal(const LineHistograms& fast, const tests::Lines& plain, const std::string& what) {
    EXPECT_EQ(fast.points, plain.points) << what;
    EXPECT_EQ(fast.points_outside_window, plain.points_outside) << what;
    EXPECT_EQ(as_map(fast.diagonal), plain.diagonal) << what;
    EXPECT_EQ(as_map(fast.vertical), plain.vertical) << what;
    EXPECT_EQ(as_map(fast.recurrence_time), plain.time) << what;
    EXPECT_EQ(as_map(fast.diagonal_points), plain.diagonal_points) << what;
}

const std::vector<std::size_t> sizes{1, 2, 3, 5, 31, 63, 64, 65, 100, 127, 129, 192, 300};

// All of them, or the small ones only: with few candidates the columns are filled by another path than with many.
std::vector<double> some_thresholds(std::mt19937_64& random) {
    const std::vector<double> all{0.25, 0.0, 0.05, 0.7, 2.0, 9.0};
    return {all.begin(), all.begin() + 1 + static_cast<std::ptrdiff_t>(random() % all.size())};
}

TEST(LineCounter, EqualsBruteForceForOneTrajectoryWithEveryOption) {
    std::mt19937_64 random(1);
    for (long trial = 0; trial < tests::sample_count(400); ++trial) {
        const std::size_t n = sizes[static_cast<std::size_t>(trial) % sizes.size()];
        const Case c = random_case(random, n, 1 + static_cast<int>(random() % 6));
        const Settings s = tests::random_settings(random);
        const auto thresholds = some_thresholds(random);
        const auto fast = count_lines(as_points(c), thresholds, s);
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            const auto matrix = tests::recurrence_matrix(c.points, c.points, c.periods, thresholds[k], s);
            expect_equal(fast[k], tests::lines_of(matrix, true, s),
                         "trial " + std::to_string(trial) + " threshold " + std::to_string(thresholds[k]));
        }
        ASSERT_FALSE(HasFailure());
    }
}

TEST(LineCounter, EqualsBruteForceForCrossRecurrence) {
    std::mt19937_64 random(2);
    for (long trial = 0; trial < tests::sample_count(300); ++trial) {
        const int dimension = 1 + static_cast<int>(random() % 5);
        const Case x = random_case(random, sizes[random() % sizes.size()], dimension);
        Case y = random_case(random, sizes[random() % sizes.size()], dimension);
        y.periods = x.periods;
        const Settings s = tests::random_settings(random);
        const auto thresholds = some_thresholds(random);
        const auto fast = count_cross_lines(as_points(x), as_points(y), thresholds, s);
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            const auto matrix = tests::recurrence_matrix(x.points, y.points, x.periods, thresholds[k], s);
            expect_equal(fast[k], tests::lines_of(matrix, false, s),
                         "trial " + std::to_string(trial) + " threshold " + std::to_string(thresholds[k]));
        }
        ASSERT_FALSE(HasFailure());
    }
}

TEST(LineCounter, EqualsBruteForceForAGivenMatrix) {
    std::mt19937_64 random(3);
    for (long trial = 0; trial < tests::sample_count(200); ++trial) {
        const std::size_t rows = sizes[random() % sizes.size()], columns = sizes[random() % sizes.size()];
        const unsigned density = 1 + static_cast<unsigned>(random() % 16);
        BinaryMatrix given{rows, columns, std::vector<std::uint8_t>(rows * columns)};
        tests::Matrix plain(rows, std::vector<int>(columns));
        for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t j = 0; j < columns; ++j) {
                plain[i][j] = random() % 16 < density;
                given.entries[i * columns + j] = static_cast<std::uint8_t>(plain[i][j]);
            }
        const Settings s = tests::random_settings(random);
        expect_equal(count_lines(given, s), tests::lines_of(plain, false, s), "trial " + std::to_string(trial));
        ASSERT_FALSE(HasFailure());
    }
}

// Lines that cross blocks of columns (256 columns and more): a smooth series has long ones.
TEST(LineCounter, JoinsLinesAcrossBlocks) {
    std::mt19937_64 random(4);
    for (const std::size_t n : {777u, 1024u, 1500u}) {
        std::vector<std::vector<double>> x(n);
        std::vector<double> series;
        for (std::size_t i = 0; i < n; ++i)
            series.push_back(std::sin(0.1 * static_cast<double>(i)) + (i % 97 == 0 ? 0.3 : 0));
        for (std::size_t i = 0; i < n; ++i) x[i] = {series[i]};
        for (int trial = 0; trial < 4; ++trial) {
            const Settings s = tests::random_settings(random);
            const auto plain = tests::lines_of(tests::recurrence_matrix(x, x, {0.0}, 0.1, s), true, s);
            expect_equal(count_lines(embed_series(series), 0.1, s), plain, "n " + std::to_string(n));
        }
    }
}

// Enough points that they are sorted into several slabs, with the cut of an angle through either sorting coordinate.
TEST(LineCounter, EqualsBruteForceWithSeveralSlabs) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const auto& periods : {std::vector<double>{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2}}) {
        Case c{std::vector<std::vector<double>>(1100, std::vector<double>(periods.size())), periods};
        for (auto& point : c.points)
            for (double& v : point) v = uniform(random);
        for (const Norm norm : {Norm::euclidean, Norm::maximum}) {
            Settings s;
            s.norm = norm;
            for (const double threshold : {0.05, 0.4}) {
                const auto plain = tests::recurrence_matrix(c.points, c.points, periods, threshold, s);
                expect_equal(count_lines(as_points(c), threshold, s), tests::lines_of(plain, true, s), "slabs");
            }
        }
    }
}

// Lines longer than the private tables: a point that never moves has two lines of every length, both ways.
TEST(LineCounter, CountsEveryLengthOfAFixedPoint) {
    const std::size_t n = 5000;
    const std::vector<double> still(2 * n, 0.5);
    std::vector<std::uint64_t> two(n, 2);
    two[0] = 0;
    for (const Points& points : {section_points(still, 2), embed_series(std::span(still).first(n))}) {
        const LineHistograms lines = count_lines(points, 0.1);
        EXPECT_EQ(lines.points, n * n);
        EXPECT_EQ(lines.points_outside_window, n * (n - 1));
        EXPECT_EQ(lines.diagonal, two);
        EXPECT_EQ(lines.vertical, two);
        // floor(c / 2) + floor((4999 - c) / 2) + 1 in every column but the first and the last
        EXPECT_EQ(as_map(lines.recurrence_time), (tests::Histogram{{2500, n - 2}}));
    }
}

TEST(LineCounter, EmbeddingEqualsItsDelayVectors) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<double> series(400);
    double walk = 0;
    for (double& v : series) v = walk += 0.3 * uniform(random);
    for (const Norm norm : {Norm::euclidean, Norm::maximum, Norm::manhattan})
        for (const int dimension : {2, 3, 7})
            for (const int delay : {1, 6}) {
                Settings s;
                s.norm = norm;
                const std::size_t n = series.size() - static_cast<std::size_t>((dimension - 1) * delay);
                std::vector<std::vector<double>> x(n);
                for (std::size_t i = 0; i < n; ++i)
                    for (int m = 0; m < dimension; ++m) x[i].push_back(series[i + static_cast<std::size_t>(m * delay)]);
                const std::vector<double> plain_axes(static_cast<std::size_t>(dimension), 0.0);
                const auto plain = tests::lines_of(tests::recurrence_matrix(x, x, plain_axes, 0.5, s), true, s);
                expect_equal(count_lines(embed_series(series, dimension, delay), 0.5, s), plain, "embedding");
            }
}

// A threshold that is itself a distance: sqrt-free comparison must decide as the rounded square root does.
TEST(LineCounter, EuclideanThresholdEqualToADistanceDecidesAsTheSquareRoot) {
    std::mt19937_64 random(6);
    const Case c = random_case(random, 60, 3);
    const Points points = as_points(c);
    for (int trial = 0; trial < 300; ++trial) {
        Settings s;
        s.strict = trial % 2 == 1;
        const double d = tests::distance(c.points[random() % 60], c.points[random() % 60], c.periods, s.norm);
        const double bound = key_bound(d, s.norm, s.strict, 3);
        for (std::size_t i = 0; i < 60; ++i)
            for (std::size_t j = 0; j < 60; ++j) {
                const double other = tests::distance(c.points[i], c.points[j], c.periods, s.norm);
                ASSERT_EQ(pair_key(points, i, points, j, s.norm) <= bound, s.strict ? other < d : other <= d);
            }
    }
}

TEST(LineCounter, SameBitsWithOneAndTwoThreads) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> series(3000);
    for (double& v : series) v = uniform(random);
    const auto with_threads = [&](int threads, int dimension) {
        tbb::task_arena arena(threads);
        return arena.execute([&] { return count_lines(embed_series(series, dimension, 2), 0.1); });
    };
    for (const int dimension : {1, 3}) {
        const LineHistograms one = with_threads(1, dimension), two = with_threads(2, dimension);
        EXPECT_EQ(one.points, two.points);
        EXPECT_EQ(one.diagonal, two.diagonal);
        EXPECT_EQ(one.vertical, two.vertical);
        EXPECT_EQ(one.recurrence_time, two.recurrence_time);
        EXPECT_EQ(one.diagonal_points, two.diagonal_points);
    }
}

}  // namespace
}  // namespace swirl::analysis::recurrence
