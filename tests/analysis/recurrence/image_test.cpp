// The down-sampled recurrence plot against the matrix.
#include "analysis/recurrence/image.hpp"
#include "tests/analysis/recurrence/brute_force.hpp"

#include <gtest/gtest.h>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

TEST(Image, EveryCellIsTheShareOfItsPairs) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<std::vector<double>> x(203), y(130);
    std::vector<double> flat_x, flat_y;
    for (auto& p : x) flat_x.push_back((p = {uniform(random)})[0]);
    for (auto& p : y) flat_y.push_back((p = {uniform(random)})[0]);
    const Settings s;
    const auto matrix = tests::recurrence_matrix(x, y, {0.0}, 0.2, s);
    for (const std::size_t m : {1u, 7u, 64u, 130u}) {
        const Image image = cross_recurrence_image(embed_series(flat_x), embed_series(flat_y), 0.2, m, s);
        for (std::size_t a = 0; a < m; ++a)
            for (std::size_t b = 0; b < m; ++b) {
                double points = 0, pairs = 0;
                for (std::size_t i = 203 * a / m; i < 203 * (a + 1) / m; ++i)
                    for (std::size_t j = 130 * b / m; j < 130 * (b + 1) / m; ++j, ++pairs) points += matrix[i][j];
                ASSERT_DOUBLE_EQ(image.density[a * m + b], points / pairs);
            }
    }
}

TEST(Image, OfOneTrajectoryIsSymmetricWithAFullDiagonalAtFullResolution) {
    const std::vector<double> series{0, 3, 0.1, 5, 3.05};
    const Image image = recurrence_image(embed_series(series), 0.2, 5);
    for (std::size_t a = 0; a < 5; ++a) {
        EXPECT_EQ(image.density[a * 5 + a], 1);
        for (std::size_t b = 0; b < 5; ++b) EXPECT_EQ(image.density[a * 5 + b], image.density[b * 5 + a]);
    }
    EXPECT_THROW(recurrence_image(embed_series(series), 0.2, 6), std::invalid_argument);
    EXPECT_THROW(recurrence_image(embed_series(series), 0.2, 0), std::invalid_argument);
}

}  // namespace
}  // namespace swirl::analysis::recurrence
