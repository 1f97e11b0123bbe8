// Published bifurcation values, reproduced by continuation.
#include "analysis/continuation/switch_branch.hpp"
#include "tests/analysis/continuation/families.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace swirl::analysis {
namespace {

const SpecialPoint* first_of(const Branch& branch, SpecialKind kind) {
    for (const auto& special : branch.special)
        if (special.kind == kind) return &special;
    return nullptr;
}

// [Feigenbaum, J. Stat. Phys. 19 (1978) 25; tests/references/README.md] Period doublings of the logistic map, through
// five switches.
TEST(Continue, LogisticCascadeThroughFiveSwitches) {
    constexpr double published[] = {
        3, 3.449489742783178, 3.544090359551923, 3.564407266095433, 3.568759419543826, 3.569691609801397};
    const ShootingMap map = maps::logistic_family();
    ContinuationOptions options = range(2.5, 3.5699);
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Constant(1, 1 - 1 / 2.8)}, 2.8, options, branch));
    EXPECT_EQ(branch.end, CurveEnd::range);
    double found[6] = {};
    for (int i = 0; i < 6; ++i) {
        const SpecialPoint* flip = first_of(branch, SpecialKind::flip);
        ASSERT_NE(flip, nullptr) << "doubling " << i;
        found[i] = flip->cycle.at.p();
        EXPECT_NEAR(found[i], published[i], 1e-9) << "doubling " << i;
        if (i == 5) break;
        options.first_step = std::min(1e-3, 0.02 * (published[i + 1] - published[i]));
        options.longest_step = 20 * options.first_step;
        Branch next;
        ASSERT_TRUE(switch_branch(map, *flip, options, next)) << "doubling " << i;
        EXPECT_EQ(next.period(), 2 * branch.period());
        branch = next;
    }
    const double delta = (found[4] - found[3]) / (found[5] - found[4]);
    std::printf("delta %.6f\n", delta);
    EXPECT_NEAR(delta, 4.669201609, 5e-3);  // three digits
}

TEST(Continue, LogisticThreeCycleBeginsAtItsFold) {
    const ShootingMap map = maps::logistic_family();
    CyclePoints cycle;
    double x = 0.5;
    for (int i = 0; i < 3000; ++i) x = 3.835 * x * (1 - x);  // attracting there
    for (int i = 0; i < 3; ++i, x = 3.835 * x * (1 - x)) cycle.push_back(Eigen::VectorXd::Constant(1, x));
    Branch branch;
    ASSERT_TRUE(continue_branch(map, cycle, 3.835, range(3.8, 3.9), branch));
    const SpecialPoint* fold = first_of(branch, SpecialKind::fold);
    ASSERT_NE(fold, nullptr);
    EXPECT_NEAR(fold->cycle.at.p(), 1 + std::sqrt(8.0), 1e-9);
    for (const double value : {0.1599288184462564, 0.5143552770619905, 0.9563178419736238}) {
        double nearest = 1;
        for (const auto& z : fold->cycle.at.points()) nearest = std::min(nearest, std::abs(z[0] - value));
        EXPECT_LE(nearest, 1e-9);  // at a fold the cycle moves as the root of the parameter's error
    }
}

// [tests/references/README.md] Hénon, b = 0.3: saddle-node −0.1225, doubling 0.3675, 2 → 4 at 0.9125.
TEST(Continue, HenonFoldAndDoublings) {
    const ShootingMap map = maps::henon_family();
    Branch branch;
    const double a = 0.2, x = (-0.7 + std::sqrt(0.49 + 4 * a)) / (2 * a);
    ASSERT_TRUE(continue_branch(map, {Eigen::Vector2d(x, 0.3 * x)}, a, range(-0.5, 1.2), branch));
    const SpecialPoint* fold = first_of(branch, SpecialKind::fold);
    const SpecialPoint* flip = first_of(branch, SpecialKind::flip);
    ASSERT_TRUE(fold != nullptr && flip != nullptr);
    EXPECT_NEAR(fold->cycle.at.p(), -0.1225, 1e-9);
    EXPECT_NEAR(flip->cycle.at.p(), 0.3675, 1e-9);
    Branch doubled;
    ASSERT_TRUE(switch_branch(map, *flip, range(0.3, 1.0), doubled));
    const SpecialPoint* next = first_of(doubled, SpecialKind::flip);
    ASSERT_NE(next, nullptr);
    EXPECT_NEAR(next->cycle.at.p(), 0.9125, 1e-9);
}

// [tests/references/README.md, Holmes 1982] n = 1: saddle-node γ = 2π(1 − α),
// doubling γ² = 4(1 + α)² + (2π(1 − α))².
TEST(Continue, BouncingBallSaddleNodeAndDoubling) {
    const double alpha = 0.8, node = 2 * M_PI * (1 - alpha);
    const ShootingMap map = maps::bouncing_ball_family(alpha);
    // v = 2π, cos φ = −node/γ; the stable one has sin φ < 0.
    const double gamma = 2, phase = -std::acos(-node / gamma);
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::Vector2d(phase, 2 * M_PI)}, gamma, range(0.5, 5), branch));
    const SpecialPoint* fold = first_of(branch, SpecialKind::fold);
    const SpecialPoint* flip = first_of(branch, SpecialKind::flip);
    ASSERT_TRUE(fold != nullptr && flip != nullptr);
    EXPECT_NEAR(fold->cycle.at.p(), node, 1e-9);
    EXPECT_NEAR(flip->cycle.at.p(), 3.813021991, 1e-9);
    EXPECT_NEAR(flip->cycle.at.p(), std::sqrt(4 * 1.8 * 1.8 + node * node), 1e-9);
}

}  // namespace
}  // namespace swirl::analysis
