// Families are distinguished from isolated cycles in every choice of the coordinates' units.
#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/multi_shooting.hpp"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <cmath>
#include <cstddef>

namespace swirl::analysis {
namespace {

/// A fixed point at 0 with DF = U⁻¹ A U, U diagonal: A in units that differ by up to 10¹⁰.
ShootingMap in_units(const Eigen::MatrixXd& a) {
    ShootingMap map;
    map.dimension = static_cast<int>(a.rows());
    map.angle_periods.assign(static_cast<std::size_t>(a.rows()), 0);
    Eigen::VectorXd units(a.rows());
    for (Eigen::Index i = 0; i < a.rows(); ++i) units[i] = std::pow(10.0, 10.0 * static_cast<double>(i) / 3 - 5);
    const Eigen::MatrixXd derivative = units.cwiseInverse().asDiagonal() * a * units.asDiagonal();
    map.step = [derivative](const Eigen::VectorXd& z, double) {
        ShootingStep step;
        step.alive = true;
        step.state = derivative * z;
        step.by_state = derivative;
        return step;
    };
    return map;
}

Eigen::MatrixXd with_first_multiplier(double multiplier) {
    Eigen::Matrix4d basis{{1, 0.5, 0.2, -0.3}, {-0.4, 1, 0.6, 0.1}, {0.3, -0.2, 1, 0.7}, {0.1, 0.8, -0.5, 1}};
    const Eigen::Vector4d multipliers(multiplier, -470, 0.7, 1e-4);
    return basis * multipliers.asDiagonal() * basis.inverse();
}

Eigen::Index family_of(const Eigen::MatrixXd& a, int k) {
    const ShootingMap map = in_units(a);
    const CyclePoints points(static_cast<std::size_t>(k), Eigen::VectorXd::Zero(a.rows()));
    return family_directions(shooting_residual(map, points, 0), map.dimension).cols();
}

TEST(NullSpace, AFamilyHasAMultiplierOne) {
    for (const int k : {1, 2, 3}) {
        EXPECT_EQ(family_of(with_first_multiplier(1), k), 1) << "k = " << k;
        EXPECT_EQ(family_of(with_first_multiplier(0.9), k), 0) << "k = " << k;
        EXPECT_EQ(family_of(with_first_multiplier(1 - 1e-5), k), 0) << "k = " << k;
    }
    EXPECT_EQ(family_of(with_first_multiplier(-1), 2), 1);
    EXPECT_EQ(family_of(with_first_multiplier(-1), 1), 0);
}

TEST(NullSpace, OfAMatrixInMixedUnits) {
    Eigen::MatrixXd matrix = with_first_multiplier(0);
    Eigen::VectorXd rows(4), columns(4);
    rows << 1e-8, 1, 1e6, 1e3;
    columns << 1e5, 1e-7, 1, 1e2;
    matrix = rows.asDiagonal() * matrix * columns.asDiagonal();
    const Eigen::MatrixXd null = null_vectors(matrix);
    ASSERT_EQ(null.cols(), 1);
    const Eigen::VectorXd left = (matrix * null).cwiseAbs();
    const Eigen::VectorXd size = matrix.cwiseAbs() * null.cwiseAbs();
    EXPECT_LE((left.array() / size.array()).maxCoeff(), 1e-13);
}

TEST(NullSpace, EquilibratedRowsAndColumnsAreOfOneSize) {
    Eigen::MatrixXd matrix{{1e8, 3, 0}, {0, 1e-6, 2e-9}, {0, 0, 0}};
    equilibrate(matrix);
    EXPECT_TRUE(matrix.allFinite());
    for (int i = 0; i < 2; ++i) EXPECT_NEAR(matrix.row(i).cwiseAbs().maxCoeff(), 1, 0.05);
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(matrix.col(j).cwiseAbs().maxCoeff(), 1, 0.05);
}

}  // namespace
}  // namespace swirl::analysis
