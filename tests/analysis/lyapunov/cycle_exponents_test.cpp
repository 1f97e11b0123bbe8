#include "analysis/lyapunov/cycle_exponents.hpp"

#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <vector>

namespace {

using namespace swirl::analysis;
using namespace swirl::analysis::maps;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A cycle whose product is similar to diag(m)ᵏ: D_i = B_{i+1} diag(m) B_i⁻¹ with B_k = B_0.
std::vector<Eigen::MatrixXd> cycle_with(const Eigen::VectorXd& m, int k) {
    const auto basis = [&](int i) {
        Eigen::MatrixXd b = Eigen::MatrixXd::Identity(m.size(), m.size());
        for (int r = 0; r < m.size(); ++r) {
            for (int c = 0; c < m.size(); ++c) b(r, c) += 0.2 * std::sin(1.0 + (i % k) * 1.3 + 2.1 * r + 0.7 * c * c);
        }
        return b;
    };
    std::vector<Eigen::MatrixXd> derivatives;
    for (int i = 0; i < k; ++i) derivatives.push_back(basis(i + 1) * m.asDiagonal() * basis(i).inverse());
    return derivatives;
}

TEST(CycleExponents, MultipliersOfVeryDifferentSize) {
    // The product's multipliers are 2⁶⁰, 1 and 10⁻¹⁸⁰ᐟ³: a product in double would keep the first alone.
    const CycleExponents result = cycle_exponents(cycle_with(Eigen::Vector3d(2, 1, 0.1), 60));
    ASSERT_EQ(result.outcome, CycleOutcome::completed);
    EXPECT_NEAR(result.exponents[0], std::log(2.0), 1e-14);
    EXPECT_NEAR(result.exponents[1], 0, 1e-14);
    EXPECT_NEAR(result.exponents[2], std::log(0.1), 1e-13);
}

TEST(CycleExponents, BeyondTheirRangeTheyAreNotInvented) {
    const CycleExponents result = cycle_exponents(cycle_with(Eigen::Vector2d(2, 0.1), 80));
    EXPECT_EQ(result.outcome, CycleOutcome::unresolved);
    EXPECT_NEAR(result.exponents[0], std::log(2.0), 1e-14);
    EXPECT_TRUE(std::isnan(result.exponents[1]));
}

TEST(CycleExponents, ALostRankIsExactlyZero) {
    const CycleExponents result = cycle_exponents(cycle_with(Eigen::Vector3d(-1.5, 0.2, 0), 5));
    EXPECT_NEAR(result.multipliers[0].real(), -std::pow(1.5, 5), 1e-12);
    EXPECT_NEAR(result.exponents[1], std::log(0.2), 1e-13);
    EXPECT_EQ(result.multipliers[2], std::complex<double>(0, 0));
    EXPECT_EQ(result.exponents[2], -infinity);
}

TEST(CycleExponents, AComplexPair) {
    LinearMap<2> map;
    const std::complex<double> multiplier = std::polar(0.9, 0.7);
    map.A << multiplier.real(), 5 * multiplier.imag(), -multiplier.imag() / 5, multiplier.real();
    const CycleExponents result = cycle_exponents(map, Vector<2>{0, 0}, 1);
    EXPECT_NEAR(std::abs(result.multipliers[0].imag()), multiplier.imag(), 1e-15);
    EXPECT_EQ(result.multipliers[0], std::conj(result.multipliers[1]));
    EXPECT_NEAR(result.exponents[0], std::log(0.9), 1e-15);
    EXPECT_EQ(result.closure, 0);
    EXPECT_EQ(result.time, 1);
}

TEST(CycleExponents, TheSuperstableCycleIsMinusInfinity) {
    EXPECT_EQ(cycle_exponents(Logistic{2}, Vector<1>{0.5}, 1).exponents[0], -infinity);
}

TEST(CycleExponents, EndingsAndBadInput) {
    LinearMap<2> mortal;
    mortal.A << 2, 0, 0, 1;
    mortal.lifetime = 100;
    EXPECT_EQ(cycle_exponents(mortal, Vector<2>{1, 0}, 20).outcome, CycleOutcome::ended_early);
    std::vector<Eigen::MatrixXd> matrices;
    EXPECT_THROW(cycle_exponents(matrices), std::invalid_argument);
    matrices = {Eigen::MatrixXd::Identity(2, 2), Eigen::MatrixXd::Identity(3, 3)};
    EXPECT_THROW(cycle_exponents(matrices), std::invalid_argument);
    matrices = {Eigen::MatrixXd::Constant(2, 2, NAN)};
    EXPECT_EQ(cycle_exponents(matrices).outcome, CycleOutcome::not_finite);
}

}  // namespace
