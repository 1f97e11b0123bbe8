// Curves of folds, flips and Neimark–Sacker points where they are known in closed form.
#include "tests/analysis/boundaries/planes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace swirl::analysis {
namespace {

using Eigen::Vector2d;
using Complex = std::complex<double>;

/// Newton's last step is rounding; the curves' equations are of size 1.
constexpr double exact = 1e-12;

CyclePoints at(std::initializer_list<double> coordinates) {
    Eigen::VectorXd z(static_cast<Eigen::Index>(coordinates.size()));
    Eigen::Index i = 0;
    for (const double c : coordinates) z[i++] = c;
    return {z};
}

/// The largest |f(a, b)| along a curve.
template <class F>
double largest(const Boundary& boundary, const F& f) {
    double most = 0;
    for (const auto& point : boundary.points) {
        const Vector2d p = parameters_of(boundary, point.at.y);
        most = std::max(most, std::abs(f(p[0], p[1])));
    }
    return most;
}

double lowest(const Boundary& boundary, int axis) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& point : boundary.points) least = std::min(least, parameters_of(boundary, point.at.y)[axis]);
    return least;
}

double highest(const Boundary& boundary, int axis) {
    double most = -std::numeric_limits<double>::infinity();
    for (const auto& point : boundary.points) most = std::max(most, parameters_of(boundary, point.at.y)[axis]);
    return most;
}

struct HenonPlane {
    PlaneMap map = planes::plane_map<2>(planes::Henon{});
    BoundaryOptions options = planes::options_of<2>(planes::Henon{}, {-2, -0.999}, {5, 0.999});
};

TEST(Boundaries, FoldOfHenonIsAParabola) {
    const HenonPlane plane;
    Boundary fold;
    const double b = 0.3, x = -(1 - b) / 2;
    ASSERT_TRUE(follow_boundary(plane.map, BoundaryKind::fold, at({x, x}), {-(1 - b) * (1 - b) / 4, b}, 1,
                                plane.options, fold));
    EXPECT_LT(largest(fold, [](double p, double q) { return p + (1 - q) * (1 - q) / 4; }), exact);
    EXPECT_NEAR(lowest(fold, 1), -0.999, exact);
    EXPECT_NEAR(highest(fold, 1), 0.999, exact);
    EXPECT_EQ(fold.begin.why, CurveEnd::plane);
    EXPECT_EQ(fold.end.why, CurveEnd::plane);
    for (const auto& point : fold.points)
        EXPECT_LT(std::abs(point.multipliers.front() - 1.0), 1e-7);  // a multiplier 1 moves as the root of rounding
}

TEST(Boundaries, FlipOfHenonIsAParabola) {
    const HenonPlane plane;
    Boundary flip;
    const double b = 0.3, x = (1 - b) / 2;
    ASSERT_TRUE(follow_boundary(plane.map, BoundaryKind::flip, at({x, x}), {3 * (1 - b) * (1 - b) / 4, b}, -1,
                                plane.options, flip));
    EXPECT_LT(largest(flip, [](double p, double q) { return p - 3 * (1 - q) * (1 - q) / 4; }), exact);
    EXPECT_NEAR(lowest(flip, 1), -0.999, exact);
    EXPECT_NEAR(highest(flip, 1), 0.999, exact);
    EXPECT_TRUE(flip.special.empty());
}

TEST(Boundaries, FlipOfHenonsTwoCycle) {
    const HenonPlane plane;
    const double b = 0.3, a = (1 - b) * (1 - b) + (1 + b) * (1 + b) / 4, product = (1 - b) * (1 - b) - a;
    const double root = std::sqrt((1 - b) * (1 - b) / 4 - product), x = (1 - b) / 2 + root, y = (1 - b) / 2 - root;
    CyclePoints cycle = at({x, y});
    cycle.push_back(at({y, x}).front());
    Boundary flip;
    ASSERT_TRUE(follow_boundary(plane.map, BoundaryKind::flip, cycle, {a, b}, -1, plane.options, flip));
    const auto off = [](double p, double q) { return p - (1 - q) * (1 - q) - (1 + q) * (1 + q) / 4; };
    EXPECT_LT(largest(flip, off), exact);
    EXPECT_NEAR(lowest(flip, 1), -0.999, exact);
    EXPECT_NEAR(highest(flip, 1), 0.999, exact);
    // Begun from the cycle's other point it is the same curve; the fixed point's flip is another.
    const std::vector<Boundary> known{flip};
    std::swap(cycle[0], cycle[1]);
    EXPECT_TRUE(is_on_boundary(plane.map, BoundaryKind::flip, cycle, {a, b}, -1, plane.options, known));
    EXPECT_FALSE(
        is_on_boundary(plane.map, BoundaryKind::flip, at({0.35, 0.35}), {3 * 0.49 / 4, b}, -1, plane.options, known));
}

// The map is conservative there: the segment goes from 1:1 to 1:2.
TEST(Boundaries, NeimarkSackerSegmentOfHenonHasItsFourResonances) {
    HenonPlane plane;
    plane.options.low = {-4, -1.5};
    Boundary pair;
    const double x = -0.3;
    ASSERT_TRUE(follow_boundary(plane.map, BoundaryKind::neimark_sacker, at({x, x}), {x * x + 2 * x, -1},
                                Complex(-x, std::sqrt(1 - x * x)), plane.options, pair));
    EXPECT_LT(largest(pair, [](double, double b) { return b + 1; }), exact);
    ASSERT_EQ(pair.special.size(), 4U);
    std::vector<std::pair<std::string, double>> seen;
    for (const auto& special : pair.special)
        seen.emplace_back(name_of(special.kind), parameters_of(pair, special.cycle.at.y)[0]);
    if (seen.front().first == "1:2") std::reverse(seen.begin(), seen.end());
    const std::vector<std::pair<std::string, double>> expected{{"1:1", -1}, {"1:4", 0}, {"1:3", 1.25}, {"1:2", 3}};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(seen[i].first, expected[i].first);
        EXPECT_NEAR(seen[i].second, expected[i].second, exact);
    }
    const auto [begin, end] = std::minmax(pair.begin.why, pair.end.why);
    EXPECT_EQ(begin, CurveEnd::one_to_one);
    EXPECT_EQ(end, CurveEnd::one_to_two);
}

TEST(Boundaries, NeimarkSackerOfHenonsTwoCycle) {
    HenonPlane plane;
    plane.options.high = {5, 1.5};
    const double a = 0.4, x = std::sqrt(a);
    CyclePoints cycle = at({x, -x});
    cycle.push_back(at({-x, x}).front());
    Boundary pair;
    ASSERT_TRUE(follow_boundary(plane.map, BoundaryKind::neimark_sacker, cycle, {a, 1},
                                std::polar(1.0, std::acos(1 - 2 * a)), plane.options, pair));
    EXPECT_NEAR(highest(pair, 0), 1, exact);
    // At a = 0 it is the fixed point 0, run through twice, with A = 1: M has two null vectors, the equations end there.
    const auto [first, last] = std::minmax(pair.begin.why, pair.end.why);
    EXPECT_EQ(first, CurveEnd::one_to_two);
    EXPECT_NE(last, CurveEnd::plane);
    EXPECT_LT(lowest(pair, 0), 1e-3);
    EXPECT_LT(largest(pair, [](double p, double q) { return p > 1e-3 ? q - 1 : 0; }), exact);
}

TEST(Boundaries, NeimarkSackerOfTheDelayedLogisticMapWithItsCoefficient) {
    const PlaneMap map = planes::plane_map<2>(planes::DelayedLogistic{});
    const BoundaryOptions options = planes::options_of<2>(planes::DelayedLogistic{}, {1.5, -0.5}, {2.5, 0.5});
    Boundary pair;
    ASSERT_TRUE(follow_boundary(map, BoundaryKind::neimark_sacker, at({0.5, 0.5}), {2, 0},
                                std::polar(1.0, std::acos(0.5)), options, pair));
    EXPECT_LT(largest(pair, [](double r, double s) { return r - 2 - s; }), exact);
    Complex found = 0;
    double nearest = 1;
    for (const auto& point : pair.points)
        if (const double s = parameters_of(pair, point.at.y)[1]; std::abs(s) < nearest) {
            nearest = std::abs(s);
            found = point.coefficient;
        }
    EXPECT_EQ(nearest, 0);                                               // the curve began there
    EXPECT_LT(std::abs(found + std::polar(1.0, std::acos(0.5))), 1e-6);  // third derivatives in double
}

}  // namespace
}  // namespace swirl::analysis
