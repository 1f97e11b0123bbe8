// Predictor and corrector on curves that are known in closed form, without a map.
#include "analysis/boundaries/plane_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl::analysis {
namespace {

using Eigen::Vector2d;

/// The corrector ends where a step is rounding: 10⁻¹⁴, or less than 10⁻⁹ and no more than halved.
constexpr double exact = 1e-14;

/// x² + y² − 1 and its gradient; the itinerary tells the sign of x.
ShootingResidual circle_at(const Eigen::VectorXd& y) {
    ShootingResidual at;
    at.alive = true;
    at.gap = Eigen::VectorXd::Constant(1, y.squaredNorm() - 1);
    at.jacobian = 2 * y.transpose();
    at.itinerary = {y[0] > 0 ? 1 : 0};
    return at;
}

CurveProblem circle() {
    return augmented_problem(Vector2d(1, 1), circle_at);
}

CurvePoint point_near(const CurveProblem& problem, const Vector2d& guess, const Vector2d& along) {
    CurvePoint point;
    EXPECT_TRUE(find_point(problem, guess, along, 0.1, point));
    return point;
}

PlaneCurve followed(const CurveProblem& problem, PlaneCurveOptions options) {
    options.low = {-2, -2};
    options.high = {2, 2};
    return follow_plane_curve(problem, point_near(problem, {0, 1}, {1, 0}), options);
}

TEST(Curve, ACircleClosesWithTangentsThatTurnByFourteenDegreesAtMost) {
    CurveProblem problem = circle();
    problem.keeps_itinerary = false;
    PlaneCurveOptions options;
    options.steps.longest = 1;
    const PlaneCurve curve = followed(problem, options);
    EXPECT_EQ(curve.begin.why, CurveEnd::closed);
    EXPECT_EQ(curve.end.why, CurveEnd::closed);
    double least = 1;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
        EXPECT_NEAR(curve.points[i].y.norm(), 1, exact);
        least = std::min(least, curve.points[i].tangent.dot(curve.points[i - 1].tangent));
    }
    EXPECT_GT(least, std::cos(14.1 * M_PI / 180));
    EXPECT_LT(least, 0.99);  // and longer steps than such of 8 degrees were tried
}

TEST(Curve, AStepAcrossAChangeOfTheWordEndsWhereTheWordIsKept) {
    const CurveProblem problem = circle();
    const PlaneCurve curve = followed(problem, {});
    EXPECT_EQ(curve.end.why, CurveEnd::not_converged);
    for (const CurvePoint& point : curve.points)
        EXPECT_EQ(point.shooting.itinerary, curve.points.front().shooting.itinerary);
    const CurvePoint base = point_near(problem, {-0.1, 1}, {1, 0});
    CurvePoint next;
    EXPECT_EQ(correct(problem, base, 0.3, next), Correction::itinerary_changed);
    EXPECT_GT(next.y[0], 0);
}

TEST(Curve, PointsThatAreRefusedEndItAtTheLastThatWasNot) {
    CurveProblem problem = circle();
    problem.keeps_itinerary = false;
    PlaneCurveOptions options;
    options.accepts = [](const CurvePoint& at) { return at.y[0] > 0.5 ? "fence" : ""; };
    const PlaneCurve curve = followed(problem, options);
    EXPECT_EQ(name_of(curve.begin), "fence");
    EXPECT_EQ(name_of(curve.end), "fence");
    for (const CurvePoint& last : {curve.points.front(), curve.points.back()}) {
        EXPECT_LE(last.y[0], 0.5);
        EXPECT_NEAR(last.y[0], 0.5, 2 * options.steps.shortest);
    }
}

TEST(Curve, ZerosAreLocatedAndPolesAreNot) {
    const CurveProblem problem = circle();
    const CurvePoint base = point_near(problem, {0.1, 1}, {1, 0});
    CurvePoint end, found;
    ASSERT_EQ(correct(problem, base, 0.3, end), Correction::converged);
    const auto zero = [](const CurvePoint& at) { return at.y[0] - 0.3; };
    ASSERT_TRUE(locate(problem, base, 0.3, zero(base), zero(end), zero, found));
    EXPECT_NEAR(found.y[0], 0.3, exact);
    EXPECT_NEAR(found.y[1], std::sqrt(1 - 0.09), exact);
    const auto pole = [](const CurvePoint& at) { return 1 / (at.y[0] - 0.3); };
    EXPECT_FALSE(locate(problem, base, 0.3, pole(base), pole(end), pole, found));
    EXPECT_FALSE(locate(problem, base, 0.1, zero(base), zero(base), zero, found));
}

TEST(Curve, IsFoundBySurfacesWhereItsEquationsEndBesideIt) {
    CurveProblem problem = circle();
    problem.newton = {};  // judged by |H|, to what rounding leaves
    problem.newton.accept = 1e-14;
    const CurvePoint base = point_near(problem, {0.1, 1}, {1, 0});
    problem.equations = [](const Eigen::VectorXd& y) {
        ShootingResidual at = circle_at(y);
        at.alive = std::abs(at.gap[0]) < 1e-12;
        at.rounding = Eigen::VectorXd::Constant(1, 1e-15);
        return at;
    };
    CurvePoint next;
    EXPECT_EQ(correct(problem, base, 0.2, next), Correction::map_ended);
    problem.equations_from_surface = circle_at;
    ASSERT_EQ(correct(problem, base, 0.2, next), Correction::converged);
    EXPECT_NEAR(next.y.norm(), 1, exact);
    EXPECT_NEAR(problem.product(base.tangent, next.y - base.y), 0.2, exact);
}

}  // namespace
}  // namespace swirl::analysis
