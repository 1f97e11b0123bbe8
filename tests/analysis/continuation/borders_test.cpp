// Borders, and the other ends of branches, on maps whose branches are known in closed form.
#include "analysis/continuation/switch_branch.hpp"
#include "tests/analysis/continuation/families.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace swirl::analysis {
namespace {

ShootingMap one_dimensional(std::function<ShootingStep(double x, double p)> step) {
    ShootingMap map;
    map.dimension = 1;
    map.has_parameter = true;
    map.angle_periods = {0};
    map.step = [step](const Eigen::VectorXd& z, double p) { return step(z[0], p); };
    return map;
}

ShootingStep step_to(double x, double by_x, double by_p) {
    ShootingStep step;
    step.alive = true;
    step.state = Eigen::VectorXd::Constant(1, x);
    step.by_state = Eigen::MatrixXd::Constant(1, 1, by_x);
    step.by_parameter = Eigen::VectorXd::Constant(1, by_p);
    return step;
}

/// x′ = p + s x with s = a on the left and b on the right of 0: fixed points p/(1 − s) where they have that sign.
ShootingMap border_collision(double a, double b, double longer_on_the_right = 0) {
    return one_dimensional([=](double x, double p) {
        const double slope = x < 0 ? a : b;
        ShootingStep step = step_to(p + slope * x, slope, 1);
        step.letter = x < 0 ? 0 : 1;
        step.duration = x < 0 ? 1 : 1 + longer_on_the_right;
        return step;
    });
}

using Word = std::vector<std::int64_t>;

// From either side: the itineraries are in the order of the branch, which is that of growing p.
TEST(Borders, ABranchGoesOnAcrossAKink) {
    const ShootingMap map = border_collision(0.5, -0.5);
    for (const double p : {-0.4, 0.4}) {
        Branch branch;
        ASSERT_TRUE(
            continue_branch(map, {Eigen::VectorXd::Constant(1, p < 0 ? 2 * p : p / 1.5)}, p, range(-1, 1), branch));
        EXPECT_EQ(branch.points.front().at.p(), -1);
        EXPECT_EQ(branch.points.back().at.p(), 1);
        ASSERT_EQ(branch.special.size(), 1U);
        const SpecialPoint& border = branch.special.front();
        EXPECT_EQ(border.kind, SpecialKind::border);
        EXPECT_TRUE(border.goes_on);
        EXPECT_NEAR(border.cycle.at.p(), 0, 1e-10);
        EXPECT_EQ(border.itinerary_before, Word{0}) << "from p = " << p;
        EXPECT_EQ(border.itinerary_after, Word{1}) << "from p = " << p;
    }
}

TEST(Borders, ABranchTurnsBackWithoutATangent) {
    const ShootingMap map = border_collision(0.5, 2);  // x = 2p and x = −p, both for p < 0
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, -0.8)}, -0.4, range(-1, 1), branch));
    ASSERT_EQ(branch.special.size(), 1U);
    EXPECT_NEAR(branch.special.front().cycle.at.p(), 0, 1e-10);
    EXPECT_TRUE(branch.special.front().goes_on);
    EXPECT_EQ(branch.points.front().at.p(), -1);
    EXPECT_EQ(branch.points.back().at.p(), -1);
    EXPECT_NEAR(branch.points.front().at.points()[0][0] * branch.points.back().at.points()[0][0], -2, 1e-11);
}

TEST(Borders, WhatTakesAnotherTimeIsAnotherBranch) {
    Branch branch;
    ASSERT_TRUE(continue_branch(border_collision(0.5, -0.5, 0.4), {Eigen::VectorXd::Constant(1, -0.8)}, -0.4,
                                range(-1, 1), branch));
    EXPECT_EQ(branch.end, CurveEnd::border);
    ASSERT_EQ(branch.special.size(), 1U);
    EXPECT_FALSE(branch.special.front().goes_on);
    EXPECT_LE(branch.points.back().at.p(), 0);
}

// Fixed points x = p + p², with the map ending where its margin sin x has fallen to 10⁻⁶.
TEST(Borders, WhereAMarginVanishesIsExtrapolated) {
    ShootingMap map = one_dimensional([](double x, double p) {
        ShootingStep step = step_to(x + 0.5 * (p + p * p - x), 0.5, 0.5 * (1 + 2 * p));
        step.margin = std::sin(x);
        step.alive = step.margin > 1e-6;
        return step;
    });
    map.least_margin = 1e-6;
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 0.24)}, 0.2, range(-0.4, 0.5), branch));
    EXPECT_EQ(branch.begin, CurveEnd::border);
    ASSERT_EQ(branch.special.size(), 1U);
    // The square of what is extrapolated, and the 10⁻¹² to which the end of the map is found.
    EXPECT_NEAR(branch.special.front().cycle.at.p(), 0, 1e-11);
}

// x′ = x + (x² + p² − 0.04)/10.
TEST(BranchEnds, ACircleCloses) {
    const ShootingMap map = one_dimensional(
        [](double x, double p) { return step_to(x + 0.1 * (x * x + p * p - 0.04), 1 + 0.2 * x, 0.2 * p); });
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 0.2)}, 0, range(-1, 1), branch));
    EXPECT_EQ(branch.begin, CurveEnd::closed);
    EXPECT_EQ(branch.end, CurveEnd::closed);
    int folds = 0;
    for (const auto& special : branch.special) folds += special.kind == SpecialKind::fold ? 1 : 0;
    EXPECT_EQ(folds, 2);
    for (const auto& point : branch.points) EXPECT_NEAR(std::hypot(point.at.p(), point.at.points()[0][0]), 0.2, 1e-11);
}

TEST(BranchEnds, ADoubledCycleIsHalvedWhereItsBranchBegan) {
    const double r = 3.2, root = std::sqrt((r - 3) * (r + 1));
    Branch branch;
    ASSERT_TRUE(continue_branch(maps::logistic_family(),
                                {Eigen::VectorXd::Constant(1, (r + 1 - root) / (2 * r)),
                                 Eigen::VectorXd::Constant(1, (r + 1 + root) / (2 * r))},
                                r, range(2.8, 3.4), branch));
    EXPECT_EQ(branch.begin, CurveEnd::halved);
    EXPECT_NEAR(branch.points.front().at.p(), 3, 1e-3);
    EXPECT_EQ(branch.end, CurveEnd::range);
}

ShootingStep plane_step(const Eigen::Vector2d& image, const Eigen::Matrix2d& by_state, const Eigen::Vector2d& by_p) {
    ShootingStep step;
    step.alive = true;
    step.state = image;
    step.by_state = by_state;
    step.by_parameter = by_p;
    return step;
}

ShootingMap plane_map(std::function<ShootingStep(const Eigen::VectorXd& z, double p)> step) {
    ShootingMap map;
    map.dimension = 2;
    map.has_parameter = true;
    map.angle_periods = {0, 0};
    map.step = std::move(step);
    return map;
}

// x is free whatever p is: solutions fill a plane, and no curve through it is a branch.
TEST(BranchEnds, AMemberOfAFamilyIsNoBeginning) {
    const ShootingMap map = plane_map([](const Eigen::VectorXd& z, double) {
        return plane_step({z[0], 0.5 * z[1]}, Eigen::Matrix2d{{1, 0}, {0, 0.5}}, {0, 0});
    });
    Branch branch;
    EXPECT_FALSE(continue_branch(map, {Eigen::Vector2d(0.3, 0)}, 0.5, range(0, 1), branch));
}

// y = 1 for p ≠ 0, any y at p = 0: the branch crosses the family, and the family is not followed over the parameter.
TEST(BranchEnds, AFamilyAtOneValueIsNotWalked) {
    const ShootingMap map = plane_map([](const Eigen::VectorXd& z, double p) {
        return plane_step({0.5 * z[0], z[1] + p * (1 - z[1])}, Eigen::Matrix2d{{0.5, 0}, {0, 1 - p}}, {0, 1 - z[1]});
    });
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::Vector2d(0, 1)}, 0.37, range(-0.5, 0.5), branch));
    EXPECT_EQ(branch.points.front().at.p(), -0.5);
    EXPECT_EQ(branch.points.back().at.p(), 0.5);
    ASSERT_EQ(branch.special.size(), 1U);
    EXPECT_EQ(branch.special.front().kind, SpecialKind::branch_point);
    Branch across;
    ASSERT_TRUE(switch_branch(map, branch.special.front(), range(-0.5, 0.5), across));
    EXPECT_EQ(across.begin, CurveEnd::family);
    EXPECT_EQ(across.end, CurveEnd::family);
    EXPECT_LE(across.points.size(), 4U);
}

TEST(BranchEnds, AKnownBranchIsNotSwitchedTo) {
    const ShootingMap map = maps::pitchfork_family();
    Branch trivial, arms;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 0)}, -0.3, range(-0.5, 0.5), trivial));
    ASSERT_EQ(trivial.special.size(), 1U);
    int asked = 0;
    const auto known = [&](const CurvePoint& start) {
        ++asked;
        return start.points()[0][0] > 0;
    };
    ASSERT_TRUE(switch_branch(map, trivial.special.front(), range(-0.5, 0.5), arms, known));
    EXPECT_EQ(asked, 2);
    for (const auto& point : arms.points) EXPECT_LT(point.at.points()[0][0], 0);
    EXPECT_FALSE(switch_branch(map, trivial.special.front(), range(-0.5, 0.5), arms, [](const auto&) { return true; }));
}

}  // namespace
}  // namespace swirl::analysis
