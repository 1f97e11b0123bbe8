// How Newton's method ends, by the rule that it is given.
#include "analysis/curves/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace swirl::analysis {
namespace {

Eigen::VectorXd number(double x) {
    return Eigen::VectorXd::Constant(1, x);
}

/// f(x) = 0 by its derivative; ends where x is negative.
Equations equation(std::function<double(double)> f, std::function<double(double)> derivative) {
    return [f, derivative](const Eigen::VectorXd& x) {
        ShootingResidual at;
        at.alive = x[0] >= 0;
        at.gap = number(f(x[0]));
        at.jacobian = number(derivative(x[0]));
        return at;
    };
}

Equations square_root_of(double a) {
    return equation([a](double x) { return x * x - a; }, [](double x) { return 2 * x; });
}

/// Two equal equations of two unknowns, x + y = 2: a line of solutions.
ShootingResidual line_at(const Eigen::VectorXd& x) {
    ShootingResidual at;
    at.alive = true;
    at.gap = Eigen::VectorXd::Constant(2, x.sum() - 2);
    at.jacobian = Eigen::MatrixXd::Ones(2, 2);
    return at;
}

TEST(Newton, FindsTheRootToRounding) {
    Eigen::VectorXd x = number(1.4);
    EXPECT_LE(newton_of_least_norm(square_root_of(2), x, until_rounding(0)), 4.5e-16);  // one ulp of 2
    EXPECT_NEAR(x[0], std::sqrt(2.0), 2.3e-16);
}

TEST(Newton, LeadsToTheNearestMemberOfAFamily) {
    Eigen::VectorXd x = Eigen::Vector2d(3, 0);
    EXPECT_LE(newton_of_least_norm(line_at, x, until_rounding(1e-14)), 1e-14);
    EXPECT_NEAR(x[0], 2.5, 1e-14);
    EXPECT_NEAR(x[1], -0.5, 1e-14);
}

TEST(Newton, KeepsTheBestWhereThereIsNoRoot) {
    const Equations none =
        equation([](double x) { return (x - 1) * (x - 1) + 0.01; }, [](double x) { return 2 * (x - 1); });
    Eigen::VectorXd x = number(1.5);
    const double least = newton_of_least_norm(none, x, until_rounding(0));
    EXPECT_EQ(least, (x[0] - 1) * (x[0] - 1) + 0.01);
    EXPECT_GE(least, 0.01);
    EXPECT_LT(least, 0.26);  // of the start
}

TEST(Newton, ReachesNothingWhereTheMapEndsAtTheStart) {
    Eigen::VectorXd x = number(-1);
    EXPECT_EQ(newton_of_least_norm(square_root_of(2), x, until_rounding(0)), infinity);
    EXPECT_EQ(x[0], -1);
}

TEST(Newton, OfASquareSystemStaysNearItsStart) {
    const auto near = solve_square_system(square_root_of(2), number(1.4));
    ASSERT_TRUE(near.has_value());
    EXPECT_NEAR((*near)[0], std::sqrt(2.0), 2.3e-16);
    EXPECT_FALSE(solve_square_system(square_root_of(2), number(1.2)).has_value());  // 0.21 away
    EXPECT_FALSE(solve_square_system(square_root_of(2), number(-0.1)).has_value());
}

}  // namespace
}  // namespace swirl::analysis
