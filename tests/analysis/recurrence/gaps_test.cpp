// Points with gaps between them: what is counted against the plain definition on each pair of stretches, bit for bit.
#include "analysis/recurrence/image.hpp"
#include "analysis/recurrence/measures.hpp"
#include "analysis/recurrence/rates.hpp"
#include "tests/analysis/recurrence/brute_force.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

using tests::Histogram;

/// Points at some of the rows; values on a grid or along a walk, which has long lines.
struct Holed {
    std::vector<std::vector<double>> points;
    std::vector<std::size_t> row_numbers;
    std::size_t rows() const { return row_numbers.back() - row_numbers.front() + 1; }
    bool has(std::size_t row) const {
        return std::find(row_numbers.begin(), row_numbers.end(), row_numbers.front() + row) != row_numbers.end();
    }
};

Holed holed_series(std::mt19937_64& random, std::size_t rows, int dimension) {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const bool walks = random() % 2 == 0, in_runs = random() % 2 == 0;
    const unsigned seldom = 2 + static_cast<unsigned>(random() % 20);
    Holed holed;
    std::vector<double> at(static_cast<std::size_t>(dimension), 0.0);
    bool lost = false;
    for (std::size_t i = 0; i < rows || holed.row_numbers.empty(); ++i) {
        for (double& x : at) {
            const double step = uniform(random);
            x = walks ? x + 0.1 * step : std::round(4 * step) / 4;
        }
        const bool change = random() % seldom == 0;
        lost = in_runs ? lost != change : change;
        if (lost) continue;
        holed.row_numbers.push_back(i + 3);  // the first row is any
        holed.points.push_back(at);
    }
    return holed;
}

Points as_points(const Holed& holed, int dimension) {
    std::vector<double> flat;
    for (const auto& p : holed.points) flat.insert(flat.end(), p.begin(), p.end());
    return at_rows(section_points(flat, dimension), holed.row_numbers);
}

constexpr int lost = -1;

/// The matrix over all rows, with `lost` where a point is missing.
tests::Matrix matrix_of(const Holed& x, const Holed& y, double threshold, const Settings& settings) {
    const tests::Matrix dense =
        tests::recurrence_matrix(x.points, y.points, std::vector<double>(x.points[0].size(), 0.0), threshold, settings);
    tests::Matrix matrix(x.rows(), std::vector<int>(y.rows(), lost));
    for (std::size_t i = 0; i < x.row_numbers.size(); ++i)
        for (std::size_t j = 0; j < y.row_numbers.size(); ++j)
            matrix[x.row_numbers[i] - x.row_numbers[0]][y.row_numbers[j] - y.row_numbers[0]] = dense[i][j];
    return matrix;
}

/// The parts of a sequence between what is lost.
std::vector<std::vector<int>> parts_of(const std::vector<int>& sequence) {
    std::vector<std::vector<int>> parts(1);
    for (const int entry : sequence) {
        if (entry != lost)
            parts.back().push_back(entry);
        else if (!parts.back().empty())
            parts.emplace_back();
    }
    if (parts.back().empty()) parts.pop_back();
    return parts;
}

/// As brute_force.hpp, but for the window, which leaves what is lost.
tests::Matrix outside_window(tests::Matrix matrix, int window) {
    for (std::size_t i = 0; i < matrix.size(); ++i)
        for (std::size_t j = 0; j < matrix[i].size(); ++j)
            if (std::abs(static_cast<long>(i) - static_cast<long>(j)) < window && matrix[i][j] != lost)
                matrix[i][j] = 0;
    return matrix;
}

Histogram diagonals_of(const tests::Matrix& matrix, bool one_triangle, bool discard) {
    Histogram lines;
    const long rows = static_cast<long>(matrix.size()), columns = static_cast<long>(matrix[0].size());
    for (long k = one_triangle ? 0 : -(columns - 1); k < rows; ++k) {
        std::vector<int> sequence;
        for (long j = std::max(0L, -k); j < columns && j + k < rows; ++j)
            sequence.push_back(matrix[static_cast<std::size_t>(j + k)][static_cast<std::size_t>(j)]);
        for (const auto& part : parts_of(sequence)) tests::add_runs(part, discard, lines);
    }
    return lines;
}

void expect_plain(const LineHistograms& fast, const tests::Matrix& matrix, bool symmetric, const Settings& s,
                  const std::string& what) {
    const tests::Matrix outside = outside_window(matrix, theiler_window(s, !symmetric));
    const bool discard = s.border_lines == BorderLines::discarded;
    EXPECT_EQ(tests::as_map(fast.diagonal), diagonals_of(outside, symmetric && s.triangles == Triangles::one, discard))
        << what;
    Histogram vertical, times;
    const tests::Matrix& for_vertical = s.window_on_vertical ? outside : matrix;
    for (std::size_t j = 0; j < matrix[0].size(); ++j) {
        std::vector<int> column;
        for (const auto& row : for_vertical) column.push_back(row[j]);
        for (const auto& part : parts_of(column)) {
            tests::add_runs(part, discard, vertical);
            tests::add_times(part, s, times);
        }
    }
    EXPECT_EQ(tests::as_map(fast.vertical), vertical) << what;
    EXPECT_EQ(tests::as_map(fast.recurrence_time), times) << what;
    std::uint64_t points = 0, points_outside = 0, pairs = 0, pairs_outside = 0;
    const long window = theiler_window(s, !symmetric), square = std::min<long>(matrix.size(), matrix[0].size());
    Histogram diagonal_points, diagonal_pairs;
    for (long i = 0; i < static_cast<long>(matrix.size()); ++i)
        for (long j = 0; j < static_cast<long>(matrix[0].size()); ++j) {
            const int entry = matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            if (entry == lost) continue;
            const bool is_outside = std::labs(i - j) >= window;
            ++pairs, pairs_outside += is_outside;
            points += entry == 1, points_outside += entry == 1 && is_outside;
            if (i >= square || j >= square) continue;
            ++diagonal_pairs[static_cast<std::size_t>(std::labs(i - j))];
            if (entry == 1 && is_outside) ++diagonal_points[static_cast<std::size_t>(std::labs(i - j))];
        }
    EXPECT_EQ(fast.points, points) << what;
    EXPECT_EQ(fast.points_outside_window, points_outside) << what;
    EXPECT_EQ(tests::as_map(fast.diagonal_points), diagonal_points) << what;
    if (fast.diagonal_pairs.empty()) return;  // by chance nothing is lost
    EXPECT_EQ(fast.pairs, pairs) << what;
    EXPECT_EQ(fast.pairs_outside_window, pairs_outside) << what;
    EXPECT_EQ(tests::as_map(fast.diagonal_pairs), diagonal_pairs) << what;
}

Settings some_settings(std::mt19937_64& random) {
    Settings s;
    s.strict = random() % 2 == 0;
    s.theiler = std::array{0, 1, 5, 70}[random() % 4];
    s.window_on_vertical = random() % 3 != 0;
    s.triangles = random() % 3 == 0 ? Triangles::one : Triangles::both;
    s.border_lines = random() % 3 == 0 ? BorderLines::discarded : BorderLines::counted;
    s.recurrence_time = static_cast<RecurrenceTime>(random() % 3);
    s.border_white_lines = s.recurrence_time == RecurrenceTime::white_lines && random() % 2 == 0;
    return s;
}

TEST(Gaps, LinesAreThoseOfEachPairOfStretches) {
    std::mt19937_64 random(11);
    for (long trial = 0; trial < tests::sample_count(120); ++trial) {
        const int dimension = 1 + static_cast<int>(random() % 3);
        const std::size_t rows = 1 + random() % 300;
        const Holed x = holed_series(random, rows, dimension);
        const std::size_t other = 1 + random() % 300;
        const Holed y = holed_series(random, other, dimension);
        const Settings s = some_settings(random);
        const std::vector<double> thresholds{0.25, 0.0, 0.7};
        const auto own = count_lines(as_points(x, dimension), thresholds, s);
        const auto cross = count_cross_lines(as_points(x, dimension), as_points(y, dimension), thresholds, s);
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            const std::string what = "trial " + std::to_string(trial) + " threshold " + std::to_string(k);
            expect_plain(own[k], matrix_of(x, x, thresholds[k], s), true, s, what);
            expect_plain(cross[k], matrix_of(x, y, thresholds[k], s), false, s, what + " cross");
        }
        ASSERT_FALSE(HasFailure());
    }
}

TEST(Gaps, LinesCrossBlocksOfColumnsAndEndAtGaps) {
    std::vector<double> x;
    std::vector<std::size_t> row_numbers;
    for (std::size_t i = 0; i < 4000; ++i) {
        if (i >= 1500 && i < 1520) continue;
        x.push_back(std::sin(2 * std::numbers::pi * static_cast<double>(i % 20) / 20));
        row_numbers.push_back(i);
    }
    const auto lines = count_lines(at_rows(embed_series(x), row_numbers), 0.01);
    // At lag 20 of the longer stretch, 2480 rows; joined it would be the 3980 rows less 20.
    EXPECT_EQ(lines.diagonal.size() - 1, 2460U);
    EXPECT_EQ(count_lines(embed_series(x), 0.01).diagonal.size() - 1, 3980U - 20U);
    EXPECT_NEAR(measures(lines).RR, 0.095, 0.001);  // of twenty rows nine values are taken twice, +-1 once: 38/400
}

TEST(Gaps, ARateLeavesOutThePairsOfTheWindowInRows) {
    std::mt19937_64 random(5);
    for (long trial = 0; trial < tests::sample_count(60); ++trial) {
        const int dimension = 1 + static_cast<int>(random() % 2);
        const Holed x = holed_series(random, 120, dimension);
        if (x.row_numbers.size() < 30) continue;
        Settings s;
        s.theiler = 4;
        const Points points = as_points(x, dimension);
        const double threshold = threshold_of_rate(points, 0.2, s);
        const LineHistograms lines = count_lines(points, threshold, s);
        EXPECT_GE(measures(lines, s).RR, 0.2);
        if (threshold > 0) {
            const LineHistograms fewer = count_lines(points, std::nextafter(threshold, -1), s);
            EXPECT_LT(measures(fewer, s).RR, 0.2);
        }
    }
}

TEST(Gaps, AnImageKeepsTheirRoom) {
    const Points points = at_rows(embed_series(std::vector<double>{1, 1, 1, 1}), std::vector<std::size_t>{0, 1, 6, 7});
    const Image image = recurrence_image(points, 0.1, 4);
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < 4; ++b) {
            const bool empty = a == 1 || a == 2 || b == 1 || b == 2;
            EXPECT_EQ(std::isnan(image.density[a * 4 + b]), empty);
            if (!empty) {
                EXPECT_EQ(image.density[a * 4 + b], 1);
            }
        }
}

TEST(Gaps, PlacesMustFitAndRise) {
    const Points points = embed_series(std::vector<double>{1, 2, 3});
    EXPECT_THROW(at_rows(points, std::vector<std::size_t>{0, 1}), std::invalid_argument);
    EXPECT_THROW(at_rows(points, std::vector<std::size_t>{0, 1, 1}), std::invalid_argument);
    EXPECT_TRUE(at_rows(points, std::vector<std::size_t>{4, 5, 6}).row_numbers.empty());
}

}  // namespace
}  // namespace swirl::analysis::recurrence
