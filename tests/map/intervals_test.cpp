// Balls: decimals are exact, operations enclose, comparisons are certain; Krawczyk's operator; discs for eigenvalues.
#include "map/intervals/dual.hpp"
#include "map/intervals/eigenvalue_discs.hpp"
#include "map/intervals/sloped.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <stdexcept>
#include <vector>

namespace swirl::intervals {
namespace {

TEST(Balls, DecimalsAreWhatTheySayAndNotTheDoublesNextToThem) {
    const Ball tenths = decimal("0.1") * Ball(3) - decimal("0.3");
    EXPECT_TRUE(contains_zero(tenths));
    EXPECT_FALSE(contains_zero(Ball(0.1) * Ball(3) - Ball(0.3)));
    EXPECT_TRUE(contains_zero(decimal(0.4) * Ball(10) - Ball(4)));
    EXPECT_TRUE(contains_zero(decimal("1e-3") - Ball(1) / Ball(1000)));
    for (const char* text : {"", "nan", "inf", "0x1p3", "0.4 +/- 1", "[0.4]", "1e", "--1"})
        EXPECT_THROW((void)decimal(text), std::invalid_argument) << text;
}

TEST(Balls, ComparisonsAreCertain) {
    EXPECT_TRUE(is_positive(between(0.1, 2)));
    EXPECT_FALSE(is_positive(between(-0.1, 2)));
    EXPECT_FALSE(is_positive(Ball(1) / between(-1, 1)));  // nothing is known of it
    EXPECT_FALSE(is_negative(Ball(1) / between(-1, 1)));
    EXPECT_LE(lower(between(0.1, 0.3)), 0.1);
    EXPECT_GE(upper(between(0.1, 0.3)), 0.3);
    EXPECT_TRUE(contains(hull(Ball(-1), Ball(2)), Ball(1.5)));
}

TEST(Balls, DualsEncloseDerivatives) {
    using D = Dual<2>;
    const double x = 0.7, y = 1.3;
    const D a = D::variable(Ball(x), 0), b = D::variable(Ball(y), 1);
    const auto at = sine_cosine(a * b);
    const D f = at.sine / sqrt(b) + atan2(b, a);
    const double bx = std::cos(x * y) * y / std::sqrt(y) - y / (x * x + y * y);
    const double by =
        std::cos(x * y) * x / std::sqrt(y) - 0.5 * std::sin(x * y) * std::pow(y, -1.5) + x / (x * x + y * y);
    EXPECT_NEAR(middle(f.by[0]), bx, 1e-15);
    EXPECT_NEAR(middle(f.by[1]), by, 1e-15);
    EXPECT_LT(radius(f.by[0]), 1e-30);
}

TEST(Balls, KrawczykProvesTheZeroThatIsThereAndNoOther) {
    const BallSystem circle_and_line = [](const BallVector& at) {  // x² + y² = 2, x = y
        Linearisation result;
        result.values = {square(at[0]) + square(at[1]) - Ball(2), at[0] - at[1]};
        result.rows = {{{0, Ball(2) * at[0]}, {1, Ball(2) * at[1]}}, {{0, Ball(1)}, {1, Ball(-1)}}};
        return result;
    };
    const BallVector middle{Ball(1.001), Ball(0.999)};
    const Eigen::MatrixXd inverse = approximate_inverse(circle_and_line(middle));
    const BallVector wide = boxes(middle, {0.01, 0.01}), narrow = boxes(middle, {1e-4, 1e-4});
    EXPECT_TRUE(lies_inside(krawczyk_image(circle_and_line, middle, wide, inverse), wide));
    const BallVector missed = krawczyk_image(circle_and_line, middle, narrow, inverse);
    EXPECT_FALSE(overlap(missed[0], narrow[0]) && overlap(missed[1], narrow[1]));
    const BallVector zero = narrowed(circle_and_line, wide);
    EXPECT_TRUE(contains(zero[0], Ball(1)));
    EXPECT_LT(radius(zero[0]), 1e-30);
    const BallVector both = boxes({Ball(0), Ball(0)}, {1.5, 1.5});  // two zeros: (1, 1) and (−1, −1)
    EXPECT_FALSE(lies_inside(krawczyk_image(circle_and_line, middles(both), both, inverse), both));
}

TEST(Balls, KrawczyksOperatorStartsFromZeroAndFromNothingElse) {
    // x² + y² = 2, x = y, scaled; entries that are not listed are zero, and none stays from the call before.
    const auto system = [](double scale, bool dense) {
        return BallSystem([=](const BallVector& at) {
            const Ball s(scale);
            Linearisation result;
            result.values = {s * (square(at[0]) - Ball(4)), s * (at[1] - Ball(3))};
            result.rows = {{{0, s * Ball(2) * at[0]}}, {{1, s}}};
            if (dense) {
                result.rows[0].emplace_back(1, Ball(0));
                result.rows[1].emplace_back(0, Ball(0));
            }
            return result;
        });
    };
    const BallVector middle{Ball(2.001), Ball(2.999)}, box = boxes(middle, {0.01, 0.01});
    const Eigen::MatrixXd inverse = approximate_inverse(system(1, true)(middle));
    const BallVector dense = krawczyk_image(system(1, true), middle, box, inverse);
    (void)krawczyk_image(system(1e6, true), middle, box, inverse);
    const BallVector sparse = krawczyk_image(system(1, false), middle, box, inverse);
    ASSERT_EQ(dense.size(), sparse.size());
    for (std::size_t i = 0; i < dense.size(); ++i) {
        EXPECT_EQ(lower(dense[i]), lower(sparse[i]));
        EXPECT_EQ(upper(dense[i]), upper(sparse[i]));
    }
    EXPECT_TRUE(lies_inside(sparse, box));
}

TEST(Balls, ASystemOfFewerEquationsThanUnknownsProvesNothing) {
    const BallVector middle{Ball(2.001), Ball(2.999)}, box = boxes(middle, {0.01, 0.01});
    for (const bool with_rows : {true, false}) {
        const BallSystem system = [=](const BallVector& at) {
            Linearisation result;
            result.values = {square(at[0]) - Ball(4)};
            if (with_rows) result.rows = {{{0, Ball(2) * at[0]}}};
            return result;
        };
        EXPECT_FALSE(lies_inside(krawczyk_image(system, middle, box, Eigen::MatrixXd::Identity(2, 2)), box));
    }
}

std::vector<BallVector> matrix_of(const std::vector<std::vector<double>>& rows) {
    std::vector<BallVector> result;
    for (const auto& row : rows) {
        result.emplace_back();
        for (const double x : row) result.back().emplace_back(x);
    }
    return result;
}

TEST(Balls, DiscsHoldTheEigenvalues) {
    // Eigenvalues 0.5 ± 2i, 3 and 0.
    const auto matrix = matrix_of({{0.5, -2, 1, 4}, {2, 0.5, 0, 1}, {0, 0, 3, 7}, {0, 0, 0, 0}});
    for (const auto& discs : {eigenvalue_discs(matrix), eigenvalue_discs_by_arb(matrix)}) {
        ASSERT_EQ(discs.size(), 4U);
        const double expected[][2]{{3, 0}, {0.5, 2}, {0.5, -2}, {0, 0}};
        for (int i = 0; i < 4; ++i) {
            EXPECT_LE(std::hypot(discs[i].re - expected[i][0], discs[i].im - expected[i][1]), discs[i].radius) << i;
            EXPECT_LT(discs[i].radius, 1e-15) << i;
        }
    }
}

TEST(Balls, EigenvaluesThatCannotBeToldApartShareADisc) {
    const auto jordan = matrix_of({{1, 1, 0}, {0, 1, 0}, {0, 0, 0.5}});
    const auto discs = eigenvalue_discs(jordan);
    ASSERT_EQ(discs.size(), 3U);
    for (const double value : {1.0, 0.5}) {
        int holding = 0;
        for (const Disc& disc : discs) holding += std::hypot(disc.re - value, disc.im) <= disc.radius ? 1 : 0;
        EXPECT_GE(holding, value == 1.0 ? 2 : 1) << value;
    }
}

/// Draws of two numbers that depend on two others, and of those others; what an operation makes of them is compared
/// with 128 bits.
using Two = Sloped<2>;
void expect_encloses(const char* name, double low, double high,
                     const std::function<Two(const Two&, const Two&)>& sloped,
                     const std::function<Ball(const Ball&, const Ball&)>& exact) {
    std::mt19937 draw(7);
    const auto between_two = [&draw](double a, double b) { return std::uniform_real_distribution<double>(a, b)(draw); };
    int tight = 0;
    constexpr int count = 2000;
    for (int i = 0; i < count; ++i) {
        const double width = std::pow(10.0, between_two(-9, -1));
        std::array<Two, 2> x;
        for (Two& one : x) {
            one.mid = between_two(low, high);
            for (double& b : one.by) b = width * between_two(-1, 1);
        }
        const std::array<double, 2> e{between_two(-1, 1), between_two(-1, 1)};
        const auto at = [&e](const Two& f) {
            return Ball(f.mid) + Ball(f.by[0]) * Ball(e[0]) + Ball(f.by[1]) * Ball(e[1]);
        };
        const Two result = sloped(x[0], x[1]);
        const Ball off = abs(exact(at(x[0]), at(x[1])) - at(result));
        ASSERT_TRUE(lower(off) <= result.rest) << name << ' ' << x[0].mid << ' ' << x[1].mid << ' ' << width;
        tight += result.rest <= 1e3 * width * width + 1e-13 ? 1 : 0;  // of second order
    }
    EXPECT_EQ(tight, count) << name;
}

TEST(Sloped, OperationsHoldTheTrueValueToSecondOrder) {
    expect_encloses(
        "+", -2, 2, [](const Two& x, const Two& y) { return x + y; },
        [](const Ball& x, const Ball& y) { return x + y; });
    expect_encloses(
        "*", -2, 2, [](const Two& x, const Two& y) { return x * y; },
        [](const Ball& x, const Ball& y) { return x * y; });
    expect_encloses(
        "/", 0.5, 2, [](const Two& x, const Two& y) { return x / y; },
        [](const Ball& x, const Ball& y) { return x / y; });
    expect_encloses(
        "square", -2, 2, [](const Two& x, const Two&) { return square(x); },
        [](const Ball& x, const Ball&) { return square(x); });
    expect_encloses(
        "sqrt", 0.3, 2, [](const Two& x, const Two&) { return sqrt(x); },
        [](const Ball& x, const Ball&) { return sqrt(x); });
    expect_encloses(
        "sin", -7, 7, [](const Two& x, const Two&) { return sine_cosine(x).sine; },
        [](const Ball& x, const Ball&) { return sine_cosine(x).sine; });
    expect_encloses(
        "cos", -7, 7, [](const Two& x, const Two&) { return sine_cosine(x).cosine; },
        [](const Ball& x, const Ball&) { return sine_cosine(x).cosine; });
    expect_encloses(
        "atan2", 0.3, 2, [](const Two& x, const Two& y) { return atan2(x, y); },
        [](const Ball& x, const Ball& y) { return atan2(x, y); });
    expect_encloses(
        "asin", -0.7, 0.7, [](const Two& x, const Two&) { return asin(x); },
        [](const Ball& x, const Ball&) { return asin(x); });
    expect_encloses(
        "sinc", -0.5, 7, [](const Two& x, const Two&) { return sinc(x); },
        [](const Ball& x, const Ball&) { return sinc(x); });
    expect_encloses(
        "(1 - cos x)/x", 0.3, 7, [](const Two& x, const Two&) { return versine_rate(x); },
        [](const Ball& x, const Ball&) { return (Ball(1) - sine_cosine(x).cosine) / x; });
}

TEST(Sloped, NothingIsCertainOfWhatHasNoBounds) {
    const Two x = Two::variable(-1, 1, 0);
    for (const Two& y : {Two(1) / x, sqrt(x), Two(1) / x - Two(1) / x, sqrt(x) * Two(0)}) {
        EXPECT_FALSE(is_positive(y) || is_negative(y) || is_finite(y));
        EXPECT_TRUE(contains_zero(y));
    }
}

}  // namespace
}  // namespace swirl::intervals
