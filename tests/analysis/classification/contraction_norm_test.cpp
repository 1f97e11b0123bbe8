// The norm in which a matrix of spectral radius below 1 contracts at once.
#include "analysis/linear_algebra/contraction_norm.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swirl::analysis {
namespace {

TEST(ContractionNorm, OfADefectiveMatrixIsTheSumOfItsPowers) {
    Eigen::Matrix2d a;
    a << 0.5, 10, 0, 0.5;  // grows by 10 first, and contracts all the same
    const auto norm = contraction_norm(a);
    ASSERT_TRUE(norm.has_value());
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero(), power = Eigen::Matrix2d::Identity();
    for (int j = 0; j < 200; ++j) {
        sum += power.transpose() * power;
        power = (a * power).eval();
    }
    const Eigen::Matrix2d p = norm->root.transpose() * norm->root;
    EXPECT_LT((p - sum).norm(), 1e-12 * sum.norm());
    for (const double angle : {0.0, 0.4, 1.3, 2.2}) {
        const Eigen::Vector2d x(std::cos(angle), std::sin(angle));
        EXPECT_LE(norm->of(a * x), norm->rate * norm->of(x) * (1 + 1e-12));
        EXPECT_NEAR(norm->of(norm->axis(1, 3)), 3, 1e-12);
    }
}

TEST(ContractionNorm, IsThereForWhatContractsOnly) {
    EXPECT_FALSE(contraction_norm(Eigen::Matrix2d::Identity()).has_value());
    EXPECT_FALSE(contraction_norm(2 * Eigen::Matrix2d::Identity()).has_value());
    const auto nilpotent = contraction_norm(Eigen::Matrix2d::Zero());
    ASSERT_TRUE(nilpotent.has_value());
    EXPECT_EQ(nilpotent->rate, 0);
}

}  // namespace
}  // namespace swirl::analysis
