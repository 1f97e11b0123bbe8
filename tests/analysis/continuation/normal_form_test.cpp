// Normal-form coefficients come back.
#include "analysis/continuation/normal_form.hpp"
#include "analysis/continuation/continue_branch.hpp"

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <complex>

namespace swirl::analysis {
namespace {

using Wide = boost::multiprecision::cpp_bin_float_quad;
using WideState = Eigen::Matrix<Wide, Eigen::Dynamic, 1>;
using WideMatrix = Eigen::Matrix<Wide, Eigen::Dynamic, Eigen::Dynamic>;

template <class T>
Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> flip_derivative(const T& u, const T& p) {
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> d(1, 1);
    d(0, 0) = T(-1) + T(0.456) * p + T(3) * T(-1.234) * u * u;
    return d;
}

/// u′ = (−1 + 0.456 p)u − 1.234 u³.
ShootingMap flip_family() {
    ShootingMap map;
    map.dimension = 1;
    map.has_parameter = true;
    map.angle_periods = {0};
    map.step = [](const Eigen::VectorXd& z, double p) {
        ShootingStep step;
        step.alive = true;
        step.state = Eigen::VectorXd::Constant(1, (-1 + 0.456 * p) * z[0] - 1.234 * z[0] * z[0] * z[0]);
        step.by_state = flip_derivative<double>(z[0], p);
        step.by_parameter = Eigen::VectorXd::Constant(1, 0.456 * z[0]);
        return step;
    };
    return map;
}

/// The real Jacobian of z′ = z e^{0.1 i}(1 + 1.123 p + (−6.789 − 0.456 i)|z|²).
template <class T>
Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> turn_derivative(const T& x, const T& y, const T& p) {
    const T c = T(std::cos(0.1)), s = T(std::sin(0.1)), re = T(-6.789), im = T(-0.456);
    const T r = x * x + y * y, grow = T(1) + T(1.123) * p + re * r, turn = im * r;
    // w = z (grow + i turn) = (x grow − y turn) + i (y grow + x turn), then turned by 0.1.
    const T wxx = grow + T(2) * x * (x * re - y * im), wxy = -turn + T(2) * y * (x * re - y * im);
    const T wyx = turn + T(2) * x * (y * re + x * im), wyy = grow + T(2) * y * (y * re + x * im);
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> d(2, 2);
    d << c * wxx - s * wyx, c * wxy - s * wyy, s * wxx + c * wyx, s * wxy + c * wyy;
    return d;
}

ShootingMap turn_family() {
    ShootingMap map;
    map.dimension = 2;
    map.has_parameter = true;
    map.angle_periods = {0, 0};
    map.step = [](const Eigen::VectorXd& u, double p) {
        const std::complex<double> z(u[0], u[1]), turn = std::polar(1.0, 0.1);
        const std::complex<double> next =
            z * turn * (1 + 1.123 * p + std::complex<double>(-6.789, -0.456) * std::norm(z));
        const std::complex<double> slope = z * turn * 1.123;
        ShootingStep step;
        step.alive = true;
        step.state = Eigen::Vector2d(next.real(), next.imag());
        step.by_state = turn_derivative<double>(u[0], u[1], p);
        step.by_parameter = Eigen::Vector2d(slope.real(), slope.imag());
        return step;
    };
    return map;
}

// [tests/references/README.md, BifurcationKit.jl] The coefficients must come back.
TEST(NormalForm, OfADoubling) {
    const ShootingMap map = flip_family();
    ContinuationOptions options;
    options.low = -0.5;
    options.high = 0.7;
    options.forms = [](const CyclePoints& points, double p) {
        return difference_forms<Wide>(
            [](const WideState& z, const Wide& q, WideMatrix& d) {
                d = flip_derivative<Wide>(z[0], q);
                return true;
            },
            points.front(), p);
    };
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Zero(1)}, 0.3, options, branch));
    ASSERT_EQ(branch.special.size(), 1U);
    const SpecialPoint& flip = branch.special.front();
    EXPECT_EQ(flip.kind, SpecialKind::flip);
    EXPECT_NEAR(flip.cycle.at.p(), 0, 1e-12);
    ASSERT_TRUE(flip.normal_form.has_value());
    EXPECT_NEAR(flip.normal_form->parameter.real(), 0.456, 1e-6);
    EXPECT_NEAR(flip.normal_form->nonlinear.real(), -1.234, 1e-6);
    EXPECT_FALSE(flip.normal_form->supercritical);
}

TEST(NormalForm, OfANeimarkSackerPoint) {
    const ShootingMap map = turn_family();
    ContinuationOptions options;
    options.low = -0.3;
    options.high = 0.3;
    options.forms = [](const CyclePoints& points, double p) {
        return difference_forms<Wide>(
            [](const WideState& z, const Wide& q, WideMatrix& d) {
                d = turn_derivative<Wide>(z[0], z[1], q);
                return true;
            },
            points.front(), p);
    };
    Branch branch;
    ASSERT_TRUE(continue_branch(map, {Eigen::VectorXd::Zero(2)}, 0.2, options, branch));
    ASSERT_EQ(branch.special.size(), 1U);
    const SpecialPoint& special = branch.special.front();
    EXPECT_EQ(special.kind, SpecialKind::neimark_sacker);
    EXPECT_NEAR(special.cycle.at.p(), 0, 1e-12);
    ASSERT_TRUE(special.normal_form.has_value());
    EXPECT_NEAR(special.normal_form->angle, 0.1, 1e-6);
    EXPECT_NEAR(std::abs(special.normal_form->parameter - std::complex<double>(1.123, 0)), 0, 1e-6);
    EXPECT_NEAR(std::abs(special.normal_form->nonlinear - std::complex<double>(-6.789, -0.456)), 0, 1e-6);
    EXPECT_TRUE(special.normal_form->supercritical);
}

}  // namespace
}  // namespace swirl::analysis
