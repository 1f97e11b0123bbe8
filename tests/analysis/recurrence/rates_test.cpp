// RC by sorting against the pairs themselves, and thresholds from deviations and rates.
#include "analysis/recurrence/rates.hpp"
#include "analysis/recurrence/lines.hpp"
#include "analysis/recurrence/measures.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

std::vector<double> random_series(std::mt19937_64& random, std::size_t n, bool on_a_grid) {
    std::uniform_real_distribution<double> uniform(-3, 3);
    std::vector<double> series(n);
    for (double& v : series) v = on_a_grid ? std::round(4 * uniform(random)) / 4 : uniform(random);
    return series;
}

std::vector<double> sorted_distances(const Points& points, Norm norm, std::size_t window) {
    std::vector<double> distances;
    for (std::size_t i = 0; i < points.count; ++i)
        for (std::size_t j = 0; j < points.count; ++j)
            if ((i > j ? i - j : j - i) >= window)
                distances.push_back(distance_of_key(pair_key(points, i, points, j, norm), norm, points.dimension));
    std::sort(distances.begin(), distances.end());
    return distances;
}

TEST(RecurrenceRate, BySortingEqualsThePairsForValuesAndAngles) {
    std::mt19937_64 random(1);
    for (long trial = 0; trial < tests::sample_count(200); ++trial) {
        const std::size_t n = 1 + random() % 150;
        const double period = trial % 3 == 0 ? 2.0 : trial % 3 == 1 ? 2 * M_PI : 0.0;
        const Points points = embed_series(random_series(random, n, trial % 2 == 0), 1, 1, period);
        Settings s;
        s.strict = trial % 5 == 0;
        s.theiler = 0;
        const std::vector<double> thresholds{0.0, 1e-6, 0.25, 0.5, 0.99, 1.0, 1.5, 3.0, 7.0};
        const auto rates = recurrence_rates(points, thresholds, s);
        const auto lines = count_lines(points, thresholds, s);
        for (std::size_t k = 0; k < thresholds.size(); ++k) {
            EXPECT_EQ(rates[k].points, lines[k].points) << "trial " << trial << " threshold " << thresholds[k];
            EXPECT_DOUBLE_EQ(rates[k].with_diagonal(), measures(lines[k], s).RR);
        }
    }
}

TEST(RecurrenceRate, OfManyCoordinatesEqualsThePairs) {
    std::mt19937_64 random(2);
    for (const Norm norm : {Norm::euclidean, Norm::maximum, Norm::manhattan}) {
        const std::vector<double> periods{0, 2, 0, 0, 1};
        const Points points = section_points(random_series(random, 5 * 333, false), 5, periods);
        Settings s;
        s.norm = norm;
        s.theiler = 0;
        for (const double threshold : {0.0, 1.0, 3.0, 20.0})
            EXPECT_EQ(recurrence_rate(points, threshold, s).points, count_lines(points, threshold, s).points);
    }
}

TEST(RecurrenceRate, WithAndWithoutTheDiagonal) {
    const RecurrenceRate r = recurrence_rate(embed_series(std::vector<double>{0, 1, 0, 1}), 0.1);
    EXPECT_DOUBLE_EQ(r.with_diagonal(), 8.0 / 16);
    EXPECT_DOUBLE_EQ(r.without_diagonal(), 4.0 / 12);
}

TEST(ThresholdOfRate, IsTheOrderStatisticOfTheDistances) {
    std::mt19937_64 random(3);
    for (long trial = 0; trial < tests::sample_count(60); ++trial) {
        const std::size_t n = 3 + random() % 60;
        const int dimension = 1 + static_cast<int>(random() % 4);
        const auto d = static_cast<std::size_t>(dimension);
        const std::vector<double> periods(d, trial % 4 == 0 ? 2.5 : 0.0);
        const Points points = section_points(random_series(random, n * d, trial % 3 == 0), dimension, periods);
        Settings s;
        s.norm = static_cast<Norm>(trial % 3);
        s.theiler = static_cast<int>(random() % 3);
        const std::vector<double> distances = sorted_distances(points, s.norm, static_cast<std::size_t>(*s.theiler));
        for (const double rate : {1e-9, 0.01, 0.1, 0.5, 0.9, 1.0}) {
            // the first distance d with #{<= d} / #pairs >= rate
            std::size_t k = 0;
            while (static_cast<double>(k + 1) / static_cast<double>(distances.size()) < rate) ++k;
            EXPECT_EQ(threshold_of_rate(points, rate, s), distances[k]) << "trial " << trial << " rate " << rate;
            s.strict = true;
            EXPECT_EQ(threshold_of_rate(points, rate, s), std::nextafter(distances[k], 1e9));
            s.strict = false;
        }
    }
}

// Large enough that the interval is first guessed from a sample of the points.
TEST(ThresholdOfRate, OfManyPointsGivesTheRate) {
    std::mt19937_64 random(4);
    const Points points = embed_series(random_series(random, 2200, false), 3, 2);
    for (const Norm norm : {Norm::euclidean, Norm::maximum}) {
        Settings s;
        s.norm = norm;
        s.theiler = 4;
        std::vector<double> distances = sorted_distances(points, norm, 4);
        for (const double rate : {1e-5, 0.01, 0.3}) {
            const auto k = static_cast<std::size_t>(std::ceil(rate * static_cast<double>(distances.size()))) - 1;
            EXPECT_EQ(threshold_of_rate(points, rate, s), distances[k]) << rate;
        }
    }
}

TEST(ThresholdOfDeviation, OfASeriesIsItsStandardDeviation) {
    const std::vector<double> series{2, 4, 4, 4, 5, 5, 7, 9};  // mean 5, squares 32
    EXPECT_DOUBLE_EQ(threshold_of_deviation(embed_series(series), 0.1, Deviation::population), 0.2);
    EXPECT_DOUBLE_EQ(threshold_of_deviation(embed_series(series), 1), std::sqrt(32.0 / 7));
    EXPECT_DOUBLE_EQ(threshold_of_deviation(embed_series(series, 3, 2), 1), std::sqrt(32.0 / 7));  // the whole series
}

TEST(ThresholdOfDeviation, OfAnAngleDoesNotSeeItsCut) {
    const std::vector<double> values{-0.1, 0.0, 0.1, 0.2};
    std::vector<double> across_cut;
    for (double v : values) across_cut.push_back(std::remainder(v + M_PI, 2 * M_PI));
    // Both are the same numbers up to the rounding of pi: a few ulp of pi relative to a spread of 0.1.
    EXPECT_NEAR(threshold_of_deviation(embed_series(across_cut, 1, 1, 2 * M_PI), 1),
                threshold_of_deviation(embed_series(values), 1), 1e-14);
}

}  // namespace
}  // namespace swirl::analysis::recurrence
