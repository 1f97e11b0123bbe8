// Where branches cross: found on either of them, and switched at.
#include "analysis/continuation/switch_branch.hpp"
#include "tests/analysis/continuation/families.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace swirl::analysis {
namespace {

std::vector<const SpecialPoint*> all_of(const Branch& branch, SpecialKind kind) {
    std::vector<const SpecialPoint*> found;
    for (const auto& special : branch.special)
        if (special.kind == kind) found.push_back(&special);
    return found;
}

// x′ = x + p x − x³: x = 0 and x² = p.
TEST(BranchPoints, OfAPitchforkFromItsTrivialBranch) {
    const ShootingMap map = maps::pitchfork_family();
    Branch trivial;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 0)}, -0.3, range(-0.5, 0.5), trivial));
    const auto crossings = all_of(trivial, SpecialKind::branch_point);
    ASSERT_EQ(crossings.size(), 1U);
    EXPECT_TRUE(crossings[0]->located);
    EXPECT_NEAR(crossings[0]->cycle.at.p(), 0, 1e-10);
    Branch arms;
    ASSERT_TRUE(switch_branch(map, *crossings[0], range(-0.5, 0.5), arms));
    EXPECT_NEAR(arms.points.front().at.p(), 0.5, 1e-12);
    EXPECT_NEAR(arms.points.back().at.p(), 0.5, 1e-12);
    EXPECT_NEAR(arms.points.front().at.points()[0][0] + arms.points.back().at.points()[0][0], 0, 1e-12);
    for (const auto& point : arms.points) EXPECT_NEAR(std::pow(point.at.points()[0][0], 2), point.at.p(), 1e-11);
}

TEST(BranchPoints, OfAPitchforkFromOneOfItsArms) {
    const ShootingMap map = maps::pitchfork_family();
    Branch arms;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 0.5)}, 0.25, range(-0.5, 0.5), arms));
    EXPECT_NEAR(arms.points.front().at.p(), 0.5, 1e-12);
    EXPECT_NEAR(arms.points.back().at.p(), 0.5, 1e-12);
    const auto crossings = all_of(arms, SpecialKind::branch_point);
    ASSERT_EQ(crossings.size(), 1U);
    // Here the plane of the corrector holds the trivial branch: x(p − x²) = 10⁻¹⁴ leaves p open where x is small.
    EXPECT_NEAR(crossings[0]->cycle.at.p(), 0, 1e-5);
    const auto folds = all_of(arms, SpecialKind::fold);
    ASSERT_EQ(folds.size(), 1U);
    EXPECT_NEAR(folds[0]->cycle.at.p(), 0, 1e-9);
}

// x′ = x + p x − x²: two lines that cross and exchange their stability.
TEST(BranchPoints, OfATranscriticalBifurcation) {
    const ShootingMap map = maps::transcritical_family();
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 0.2)}, 0.2, range(-0.5, 0.5), branch));
    const auto crossings = all_of(branch, SpecialKind::branch_point);
    ASSERT_EQ(crossings.size(), 1U);
    EXPECT_NEAR(crossings[0]->cycle.at.p(), 0, 1e-10);
    Branch other;
    ASSERT_TRUE(switch_branch(map, *crossings[0], range(-0.5, 0.5), other));
    for (const auto& point : other.points) EXPECT_NEAR(point.at.points()[0][0], 0, 1e-12);
}

// A branch that ends where its map does not must not report a border.
TEST(BranchEnds, WithoutACycleToGoOnAreNotCalledBorders) {
    ShootingMap map = maps::logistic_family();
    map.step = [](const Eigen::VectorXd& z, double p) {
        ShootingStep step;
        step.alive = true;
        const double aside = z[0] - 0.5;
        // Cycles on a curve until p = 0.3, from where on noise hides every one.
        const double noise = p > 0.3 ? 1e-6 * std::sin(1e9 * (z[0] + p)) + 1e-5 : 0.0;
        step.state = Eigen::VectorXd::Constant(1, z[0] - 0.5 * aside + noise);
        step.by_state = Eigen::MatrixXd::Constant(1, 1, 0.5);
        step.by_parameter = Eigen::VectorXd::Constant(1, 0);
        return step;
    };
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 0.5)}, 0.2, range(0, 1), branch));
    EXPECT_EQ(branch.begin, CurveEnd::range);
    EXPECT_EQ(branch.end, CurveEnd::not_converged);
    EXPECT_TRUE(branch.special.empty());
    EXPECT_NEAR(branch.points.back().at.p(), 0.3, 1e-6);
}

}  // namespace
}  // namespace swirl::analysis
