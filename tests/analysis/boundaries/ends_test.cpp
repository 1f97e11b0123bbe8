// Why curves end: closed ones, ones that only seem to be, and corrector failures beside cycles of half the period.
#include "tests/analysis/boundaries/planes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>

namespace swirl::analysis {
namespace {

using Eigen::Vector2d;

constexpr double radius = 0.3;

/// x′ = x + p₁² + p₂² − r² − x²: folds where x = 0 on a circle.
struct Circle {
    template <class T>
    std::array<T, 1> operator()(const std::array<T, 1>& z, const std::array<T, 2>& p) const {
        return {z[0] + p[0] * p[0] + p[1] * p[1] - T(radius * radius) - z[0] * z[0]};
    }
};

/// (u, x): u settles where φ = u/0.001 is the angle of p, x′ = x + |p| − (0.3 + 0.002 φ) − x²: folds on a spiral, which
/// passes 0.014 from where it was a turn before, in the same direction.
struct Spiral {
    template <class T>
    std::array<T, 2> operator()(const std::array<T, 2>& z, const std::array<T, 2>& p) const {
        using std::cos;
        using std::sin;
        using std::sqrt;
        const T angle = z[0] / T(scale);
        const T off = p[0] * sin(angle) - p[1] * cos(angle);
        return {z[0] - T(scale) * off,
                z[1] + sqrt(p[0] * p[0] + p[1] * p[1]) - T(radius) - T(0.002) * angle - z[1] * z[1]};
    }
    static constexpr double scale = 1e-3;
};

/// x′ = −x(1 + 10⁸((x² − δ²)² + q)), δ = 0.005: the fold of its 2-cycles ±δ is q = 0, here p₁ = |p₂| with a corner at
/// 0.
struct Corner {
    static constexpr double side = 0.005;
    template <class T>
    std::array<T, 1> operator()(const std::array<T, 1>& z, const std::array<T, 2>& p) const {
        const T off = z[0] * z[0] - T(side * side);
        const T q = p[0] - (p[1] < T(0) ? T(-p[1]) : p[1]);
        return {-z[0] * (T(1) + T(1e8) * off * off + q)};
    }
};

CyclePoints at(std::initializer_list<double> coordinates) {
    Eigen::VectorXd z(static_cast<Eigen::Index>(coordinates.size()));
    Eigen::Index i = 0;
    for (const double c : coordinates) z[i++] = c;
    return {z};
}

/// The angle that p turns through along the curve.
double turned_through(const Boundary& boundary) {
    double sum = 0;
    for (std::size_t i = 1; i < boundary.points.size(); ++i) {
        const Vector2d a = parameters_of(boundary, boundary.points[i - 1].at.y),
                       b = parameters_of(boundary, boundary.points[i].at.y);
        sum += std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
    }
    return sum;
}

TEST(Ends, AClosedCurveEndsWhereItBegan) {
    const BoundaryOptions options = planes::options_of<1>(Circle{}, {-1, -1}, {1, 1});
    Boundary fold;
    ASSERT_TRUE(
        follow_boundary(planes::plane_map<1>(Circle{}), BoundaryKind::fold, at({0}), {0, radius}, 1, options, fold));
    EXPECT_EQ(fold.begin.why, CurveEnd::closed);
    EXPECT_EQ(fold.end.why, CurveEnd::closed);
    EXPECT_EQ(fold.points.front().at.y, fold.points.back().at.y);
    EXPECT_NEAR(std::abs(turned_through(fold)), 2 * std::acos(-1.0), 1e-12);
    for (const auto& point : fold.points) EXPECT_NEAR(parameters_of(fold, point.at.y).norm(), radius, 1e-12);
}

TEST(Ends, ACurveBeginsOnThePlanesEdgeThoughRoundedBeyondIt) {
    constexpr double edge = 0.18;  // the circle is there at 0.24
    const BoundaryOptions options = planes::options_of<1>(Circle{}, {-1, -1}, {1, edge});
    const auto begins = [&](double second, Boundary& fold) {
        return follow_boundary(planes::plane_map<1>(Circle{}), BoundaryKind::fold, at({0}),
                               {std::sqrt(radius * radius - second * second), second}, 1, options, fold);
    };
    Boundary fold;
    ASSERT_TRUE(begins(edge + 4 * std::numeric_limits<double>::epsilon() * edge, fold));
    EXPECT_EQ(fold.begin.why, CurveEnd::plane);
    EXPECT_EQ(fold.end.why, CurveEnd::plane);
    EXPECT_NEAR(std::abs(turned_through(fold)), std::acos(-1.0) + 2 * std::asin(edge / radius), 1e-12);
    EXPECT_FALSE(begins(edge + 1e-9, fold));
}

TEST(Ends, ACurveThatPassesNearItsStartIsNotClosed) {
    BoundaryOptions options = planes::options_of<2>(Spiral{}, {-0.35, -0.35}, {0.35, 0.35});
    options.most_points = 300;  // inwards it goes on for two dozen turns
    Boundary fold;
    ASSERT_TRUE(
        follow_boundary(planes::plane_map<2>(Spiral{}), BoundaryKind::fold, at({0, 0}), {radius, 0}, 1, options, fold));
    EXPECT_NE(fold.begin.why, CurveEnd::closed);
    EXPECT_NE(fold.end.why, CurveEnd::closed);
    EXPECT_GT(std::abs(turned_through(fold)), 6 * std::acos(-1.0));
}

TEST(Ends, ACornerBesideNearHalvesIsNoHalvedCycle) {
    BoundaryOptions options = planes::options_of<1>(Corner{}, {-0.1, -0.1}, {0.1, 0.1});
    CyclePoints cycle = at({Corner::side});
    cycle.push_back(at({-Corner::side}).front());
    Boundary fold;
    ASSERT_TRUE(
        follow_boundary(planes::plane_map<1>(Corner{}), BoundaryKind::fold, cycle, {0.05, 0.05}, 1, options, fold));
    const CurveEnd at_corner = fold.begin.why == CurveEnd::plane ? fold.end.why : fold.begin.why;
    EXPECT_EQ(at_corner, CurveEnd::not_converged);
}

}  // namespace
}  // namespace swirl::analysis
