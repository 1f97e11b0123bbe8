// Products with constants of few digits: map/numbers/vec2.hpp.
#include "map/numbers/vec2.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace swirl {
namespace {

/// What α, 1/α, 1 − α and 1/(1 − α) are where α has one or two decimals.
constexpr double few_digits[] = {0.3, 0.4, 0.6, 0.75, 1 / 0.6, 1 / 0.7, 1 / 0.4, 1 / 0.75};

/// Errors of rounded products in units of the exact product's last place.
struct RoundingErrors {
    double mean = 0, largest = 0;
};

template <class Product>
RoundingErrors rounding_errors(double c, int count, Product product) {
    tests::Random random(7);
    RoundingErrors errors;
    for (int k = 0; k < count; ++k) {
        const double x = random.between(0.5, 1.0);
        const double rounded = product(x);
        const double high = c * x, low = std::fma(c, x, -high);  // together the exact product
        const double error = ((rounded - high) - low) / std::ldexp(1.0, std::ilogb(high) - 52);
        errors.mean += error / count;
        errors.largest = std::max(errors.largest, std::fabs(error));
    }
    return errors;
}

TEST(UnbiasedFactor, IsTheConstant) {
    tests::Random random(3);
    for (int k = 0; k < 1000; ++k) {
        const double c = std::exp(random.between(-300, 300));
        const UnbiasedFactor<double> factor = unbiased(c);
        EXPECT_EQ(factor.first + factor.second, c);
        EXPECT_EQ(c - factor.first, factor.second);
    }
}

TEST(UnbiasedFactor, GivesProductsToOneAndAHalfUlp) {
    for (const double c : few_digits) {
        const UnbiasedFactor<double> factor = unbiased(c);
        const RoundingErrors errors = rounding_errors(c, 100'000, [&](double x) { return factor * x; });
        // ½ for the sum, 1 for c₁x, whose last place may be the double, 2⁻¹⁰ for c₂x.
        EXPECT_LE(errors.largest, 1.51) << c;
    }
}

TEST(UnbiasedFactor, RoundsAsOftenUpAsDown) {
    constexpr int count = 1'000'000;
    double most_of_plain = 0;
    for (const double c : few_digits) {
        const UnbiasedFactor<double> factor = unbiased(c);
        const RoundingErrors spread_errors = rounding_errors(c, count, [&](double x) { return factor * x; });
        const RoundingErrors plain_errors = rounding_errors(c, count, [&](double x) { return c * x; });
        // The error's standard deviation is √(2/12) ulp: four standard deviations of the mean.
        EXPECT_LE(std::fabs(spread_errors.mean), 4 * 0.41 / std::sqrt(count)) << c;
        most_of_plain = std::max(most_of_plain, std::fabs(plain_errors.mean));
    }
    EXPECT_GE(most_of_plain, 0.01);  // why this exists
}

}  // namespace
}  // namespace swirl
