// Points of codimension 2 where they are known in closed form: located to 10⁻⁸ or better.
#include "tests/analysis/boundaries/planes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <initializer_list>

namespace swirl::analysis {
namespace {

using Eigen::Vector2d;
using Complex = std::complex<double>;

constexpr double located = 1e-8;

CyclePoints fixed_point(std::initializer_list<double> coordinates) {
    Eigen::VectorXd z(static_cast<Eigen::Index>(coordinates.size()));
    Eigen::Index i = 0;
    for (const double c : coordinates) z[i++] = c;
    return {z};
}

/// The only special point of a kind, or none.
const BoundarySpecial* only(const Boundary& boundary, CodimensionTwo kind) {
    const BoundarySpecial* found = nullptr;
    for (const auto& special : boundary.special) {
        if (special.kind != kind) continue;
        EXPECT_EQ(found, nullptr) << "two points " << name_of(kind);
        found = &special;
    }
    return found;
}

void expect_at(const Boundary& boundary, CodimensionTwo kind, const Vector2d& p) {
    const BoundarySpecial* special = only(boundary, kind);
    ASSERT_NE(special, nullptr) << name_of(kind);
    const Vector2d there = parameters_of(boundary, special->cycle.at.y);
    EXPECT_NEAR(there[0], p[0], located) << name_of(kind);
    EXPECT_NEAR(there[1], p[1], located) << name_of(kind);
}

TEST(CodimensionTwo, CuspOfTheCubicMap) {
    const PlaneMap map = planes::plane_map<1>(planes::Cubic{});
    const BoundaryOptions options = planes::options_of<1>(planes::Cubic{}, {-1, -2}, {1, 3});
    Boundary fold;
    const double x = 0.4;
    ASSERT_TRUE(
        follow_boundary(map, BoundaryKind::fold, fixed_point({x}), {-2 * x * x * x, 1 + 3 * x * x}, 1, options, fold));
    EXPECT_EQ(fold.special.size(), 1U);
    expect_at(fold, CodimensionTwo::cusp, {0, 1});
    // Both arms: a = −2x³ leaves the plane at x = ±(1/2)^{1/3}.
    EXPECT_NEAR(parameters_of(fold, fold.points.front().at.y)[0] * parameters_of(fold, fold.points.back().at.y)[0], -1,
                1e-11);
}

TEST(CodimensionTwo, GeneralisedFlipsOfTheCubicMap) {
    const PlaneMap map = planes::plane_map<1>(planes::Cubic{});
    const BoundaryOptions options = planes::options_of<1>(planes::Cubic{}, {-0.7, -2}, {0.7, 1});
    Boundary flip;
    ASSERT_TRUE(
        follow_boundary(map, BoundaryKind::flip, fixed_point({0.1}), {0.2 - 2e-3, 0.03 - 1}, -1, options, flip));
    ASSERT_EQ(flip.special.size(), 2U);
    for (const auto& special : flip.special) {
        const Vector2d p = parameters_of(flip, special.cycle.at.y);
        EXPECT_EQ(special.kind, CodimensionTwo::generalised_flip);
        EXPECT_NEAR(std::abs(p[0]), 16.0 / 27, located);
        EXPECT_NEAR(p[1], -2.0 / 3, located);
    }
    for (const auto& point : flip.points) {
        const double x = point.at.y[0];
        EXPECT_NEAR(point.coefficient.real(), 9 * x * x - 1, 1e-5);  // third derivatives in double
    }
}

// A fold curve of 2-cycles begins at each: x′ = a + b x − x³ has 2-cycles with x + y = s, xy = s² − 1 − b.
TEST(CodimensionTwo, FoldOfDoubledCyclesEndsAtTheGeneralisedFlips) {
    const PlaneMap map = planes::plane_map<1>(planes::Cubic{});
    const BoundaryOptions options = planes::options_of<1>(planes::Cubic{}, {-0.7, -2}, {0.7, 1});
    // F∘F has the multiplier 1 where s² = 4(1 + b)/3 (x = y: the flip itself) and where s² = (2 + b)/3: the fold.
    const double b = -0.6, s = std::sqrt((2 + b) / 3), root = std::sqrt(s * s / 4 - (s * s - 1 - b));
    const double x = s / 2 + root, y = s / 2 - root;
    CyclePoints cycle = fixed_point({x});
    cycle.push_back(fixed_point({y}).front());
    Boundary fold;
    ASSERT_TRUE(follow_boundary(map, BoundaryKind::fold, cycle, {y - b * x + x * x * x, b}, 1, options, fold));
    EXPECT_TRUE(fold.begin.why == CurveEnd::halved || fold.end.why == CurveEnd::halved);
    const auto& last = fold.begin.why == CurveEnd::halved ? fold.points.front() : fold.points.back();
    const Vector2d p = parameters_of(fold, last.at.y);
    // The flip curve of the fixed point, run through twice, crosses there: the last point is one before.
    EXPECT_NEAR(std::abs(p[0]), 16.0 / 27, 1e-3);
    EXPECT_NEAR(p[1], -2.0 / 3, 1e-3);
}

TEST(CodimensionTwo, ChencinerPointOfANormalForm) {
    const PlaneMap map = planes::plane_map<2>(planes::Chenciner{});
    const BoundaryOptions options = planes::options_of<2>(planes::Chenciner{}, {-0.5, -1}, {0.5, 1});
    Boundary pair;
    ASSERT_TRUE(follow_boundary(map, BoundaryKind::neimark_sacker, fixed_point({0, 0}), {0, 0.3}, std::polar(1.0, 1.0),
                                options, pair));
    EXPECT_EQ(pair.special.size(), 1U);
    expect_at(pair, CodimensionTwo::chenciner, {0, 0});
    for (const auto& point : pair.points)
        EXPECT_LT(std::abs(point.coefficient - Complex(parameters_of(pair, point.at.y)[1], 0.5)), 1e-5);
}

// Hénon, b = −1: the fold and the flip curve pass the ends of the Neimark–Sacker segment.
TEST(CodimensionTwo, DoubleMultipliersOfHenon) {
    const PlaneMap map = planes::plane_map<2>(planes::Henon{});
    const BoundaryOptions options = planes::options_of<2>(planes::Henon{}, {-4, -2}, {6, 0.9});
    Boundary fold, flip;
    ASSERT_TRUE(follow_boundary(map, BoundaryKind::fold, fixed_point({-0.5, -0.5}), {-0.25, 0}, 1, options, fold));
    expect_at(fold, CodimensionTwo::one_to_one, {-1, -1});
    EXPECT_EQ(fold.special.size(), 1U);
    ASSERT_TRUE(follow_boundary(map, BoundaryKind::flip, fixed_point({0.5, 0.5}), {0.75, 0}, -1, options, flip));
    expect_at(flip, CodimensionTwo::one_to_two, {3, -1});
    EXPECT_EQ(flip.special.size(), 1U);
}

TEST(CodimensionTwo, FoldFlipSeenFromBothCurves) {
    const planes::FoldBesideFlip formula;
    const PlaneMap map = planes::plane_map<2>(formula);
    const BoundaryOptions options = planes::options_of<2>(formula, {-0.5, -0.5}, {0.5, 0.5});
    Boundary fold, flip;
    ASSERT_TRUE(follow_boundary(map, BoundaryKind::fold, fixed_point({0, 0}), {0, 0.2}, 1, options, fold));
    expect_at(fold, CodimensionTwo::fold_flip, {0, 0});
    ASSERT_TRUE(follow_boundary(map, BoundaryKind::flip, fixed_point({0.2, 0}), {0.04, 0.2}, -1, options, flip));
    expect_at(flip, CodimensionTwo::fold_flip, {0, 0});
}

TEST(CodimensionTwo, PairBesideARealMultiplierSeenFromBothCurves) {
    const planes::PairBeside<1> fold_formula;
    const PlaneMap with_fold = planes::plane_map<3>(fold_formula);
    BoundaryOptions options = planes::options_of<3>(fold_formula, {-0.5, -0.5}, {0.5, 0.5});
    Boundary fold, flip, pair;
    ASSERT_TRUE(follow_boundary(with_fold, BoundaryKind::fold, fixed_point({0, 0, 0}), {0, 0.2}, 1, options, fold));
    expect_at(fold, CodimensionTwo::fold_neimark_sacker, {0, 0});
    ASSERT_TRUE(follow_boundary(with_fold, BoundaryKind::neimark_sacker, fixed_point({0, 0, 0.5}), {0.25, -0.025},
                                std::polar(1.0, 1.0), options, pair));
    expect_at(pair, CodimensionTwo::fold_neimark_sacker, {0, 0});

    const planes::PairBeside<-1> flip_formula;
    const PlaneMap with_flip = planes::plane_map<3>(flip_formula);
    options = planes::options_of<3>(flip_formula, {-0.5, -0.5}, {0.5, 0.5});
    ASSERT_TRUE(follow_boundary(with_flip, BoundaryKind::flip, fixed_point({0, 0, 0}), {0, 0.2}, -1, options, flip));
    expect_at(flip, CodimensionTwo::flip_neimark_sacker, {0, 0});
    ASSERT_TRUE(follow_boundary(with_flip, BoundaryKind::neimark_sacker, fixed_point({0, 0, 0}), {0.2, 0},
                                std::polar(1.0, 1.0), options, pair));
    expect_at(pair, CodimensionTwo::flip_neimark_sacker, {0, 0});
}

}  // namespace
}  // namespace swirl::analysis
