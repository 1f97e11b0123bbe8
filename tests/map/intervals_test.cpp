// Balls: decimals are exact, operations enclose, comparisons are certain; Krawczyk's operator; discs for eigenvalues.
#include "map/intervals/dual.hpp"
#include "map/intervals/eigenvalue_discs.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

}  // namespace
}  // namespace swirl::intervals
