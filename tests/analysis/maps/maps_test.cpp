// The test maps against the literature: derivatives, fixed points, cycles and bifurcation values. Published values from
// tests/references/README.md, "Maps".
#include "analysis/lyapunov/cycle_exponents.hpp"
#include "tests/analysis/maps/bouncing_ball.hpp"
#include "tests/analysis/maps/circle_map.hpp"
#include "tests/analysis/maps/henon.hpp"
#include "tests/analysis/maps/linear_map.hpp"
#include "tests/analysis/maps/logistic.hpp"
#include "tests/analysis/maps/normal_forms.hpp"
#include "tests/analysis/maps/standard_map.hpp"
#include "tests/analysis/maps/torus.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace swirl::analysis;
using namespace swirl::analysis::maps;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// DF against central differences of F, angles compared as angles; and the same F bit for bit.
template <SectionMap M>
void expect_derivative(const M& map, const Vector<M::dimension>& z) {
    constexpr int D = M::dimension;
    constexpr double h = 1e-6;  // truncation h² and rounding ε/h are both near 1e-10
    const Linearised<D> exact = map.linearise(z);
    EXPECT_EQ(exact.state, map.advance(z).state);
    for (int j = 0; j < D; ++j) {
        Vector<D> plus = z;
        Vector<D> minus = z;
        plus[j] += h;
        minus[j] -= h;
        const Vector<D> difference = map.advance(plus).state - map.advance(minus).state;
        for (int i = 0; i < D; ++i) {
            const double period = map.angle_period(i);
            const double change = period > 0 ? std::remainder(difference[i], period) : difference[i];
            EXPECT_NEAR(exact.derivative(i, j), change / (2 * h), 1e-8) << i << "," << j;
        }
    }
}

TEST(Maps, DerivativesAreThoseOfTheMap) {
    expect_derivative(Logistic{3.7}, Vector<1>{0.3});
    expect_derivative(Henon{}, Vector<2>{0.4, -0.2});
    expect_derivative(StandardMap{}, Vector<2>{1.2, 5.9});
    expect_derivative(ConjugatedRotation{}, Vector<1>{2.2});
    expect_derivative(ArnoldCircleMap{}, Vector<1>{2.2});
    expect_derivative(BouncingBall{}, Vector<2>{0.7, 5.1});
    expect_derivative(DrivenTorus{}, Vector<2>{0.7, 1.1});
    expect_derivative(FlipNormalForm{0.1}, Vector<1>{0.2});
    expect_derivative(NeimarkSackerNormalForm{0.1}, Vector<2>{0.15, -0.2});
    LinearMap<3> linear;
    linear.A << 1, 2, 3, 4, 5, 6, 7, 8, 10;
    expect_derivative(linear, Vector<3>{1, -1, 0.5});
}

/// Newton on Fᵏ(z) − z in one dimension.
Vector<1> logistic_cycle_point(const Logistic& map, int k, double guess) {
    Vector<1> z{guess};
    for (int iteration = 0; iteration < 50; ++iteration) {
        Vector<1> image = z;
        double derivative = 1;
        for (int i = 0; i < k; ++i) {
            const auto step = map.linearise(image);
            derivative *= step.derivative(0, 0);
            image = step.state;
        }
        z[0] -= (image[0] - z[0]) / (derivative - 1);
    }
    return z;
}

TEST(Maps, LogisticPeriodDoublingsHaveMultiplierMinusOne) {
    constexpr std::array<double, 6> doublings = {
        3, 3.449489742783178, 3.544090359551923, 3.564407266095433, 3.568759419543826, 3.569691609801397};
    int k = 1;
    double sensitivity = 20;  // |d multiplier/dr|: about 1 at the first, growing by δ = 4.67 at each
    for (const double r : doublings) {
        const Logistic map{r};
        // A point near the critical one, after a long attraction by the nearly neutral cycle.
        Vector<1> z{0.5};
        for (int i = 0; i < 32 * 4000; ++i) z = map.advance(z).state;
        z = logistic_cycle_point(map, k, z[0]);
        const CycleExponents cycle = cycle_exponents(map, z, k);
        EXPECT_LT(cycle.closure, 1e-14 * k);
        EXPECT_NEAR(cycle.multipliers[0].real(), -1, sensitivity * 1e-15 * 100) << r;
        k *= 2;
        sensitivity *= 4.67;
    }
}

TEST(Maps, LogisticTangentThreeCycleHasMultiplierOne) {
    const Logistic map{1 + std::sqrt(8.0)};
    constexpr std::array<double, 3> published = {0.1599288184462564, 0.5143552770619905, 0.9563178419736238};
    Vector<1> z{published[0]};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(z[0], published[i], 4 * eps);
        z = map.advance(z).state;
    }
    // Points rounded to ε, d²F³/dx² of order 100.
    EXPECT_NEAR(cycle_exponents(map, Vector<1>{published[0]}, 3).multipliers[0].real(), 1, 1e-13);
}

TEST(Maps, HenonFixedPointsAndMultipliers) {
    const Henon map;
    const double right = map.fixed_point(+1);
    const double left = map.fixed_point(-1);
    EXPECT_NEAR(right, 0.6313544770895047, 2 * eps);
    EXPECT_NEAR(left, -1.1313544770895047, 4 * eps);
    const CycleExponents at_right = cycle_exponents(map, Vector<2>{right, 0.3 * right}, 1);
    const CycleExponents at_left = cycle_exponents(map, Vector<2>{left, 0.3 * left}, 1);
    EXPECT_LT(at_right.closure, 4 * eps);
    EXPECT_NEAR(at_right.multipliers[0].real(), -1.92373886, 5e-9);  // the printed digits
    EXPECT_NEAR(at_right.multipliers[1].real(), 0.15594632, 5e-9);
    EXPECT_NEAR(at_left.multipliers[0].real(), 3.25982210, 5e-9);
    EXPECT_NEAR(at_left.multipliers[1].real(), -0.09202956, 5e-9);
}

/// The 2-cycle: x₁ + x₂ = (1 − b)/a, x₁ x₂ = (1 − b)²/a² − 1/a.
Vector<2> henon_two_cycle(const Henon& map) {
    const double sum = (1 - map.b) / map.a;
    const double product = sum * sum - 1 / map.a;
    const double x = (sum + std::sqrt(sum * sum - 4 * product)) / 2;
    return {x, map.b * (sum - x)};
}

TEST(Maps, HenonTwoCycle) {
    const Henon map;
    const Vector<2> z = henon_two_cycle(map);
    EXPECT_NEAR(z[0], 0.975800051, 5e-10);
    EXPECT_NEAR(map.advance(z).state[0], -0.475800051, 5e-10);
    const CycleExponents cycle = cycle_exponents(map, z, 2);
    EXPECT_LT(cycle.closure, 8 * eps);
    EXPECT_NEAR(cycle.multipliers[0].real(), -3.01010067, 5e-9);
    EXPECT_NEAR(cycle.multipliers[1].real(), -0.02989933, 5e-9);
}

TEST(Maps, HenonBifurcations) {
    // Saddle-node: at the double root the error of x is √ε, and so is that of the multiplier.
    Henon map{-0.1225, 0.3};
    const double fold = -(1 - map.b) / (2 * map.a);
    EXPECT_NEAR(cycle_exponents(map, Vector<2>{fold, 0.3 * fold}, 1).multipliers[0].real(), 1, 1e-12);
    map.a = 0.3675;
    const double flip = map.fixed_point(+1);
    EXPECT_NEAR(cycle_exponents(map, Vector<2>{flip, 0.3 * flip}, 1).multipliers[0].real(), -1, 1e-14);
    map.a = 0.9125;
    EXPECT_NEAR(cycle_exponents(map, henon_two_cycle(map), 2).multipliers[0].real(), -1, 1e-13);
}

TEST(Maps, StandardMapCyclesOfTheLiterature) {
    // ChaosTools.jl prints four decimals; the closure of a rounded point is at most the rounding times |DFᵏ| ≈ 10.
    const StandardMap map;
    const Vector<2> a{1.3346, 2.6693};
    const Vector<2> b = map.advance(a).state;
    EXPECT_NEAR(b[0], 4.9486, 2e-4);
    EXPECT_NEAR(b[1], 3.6139, 2e-4);
    EXPECT_LT(cycle_exponents(map, a, 2).closure, 5e-4);
    EXPECT_LT(cycle_exponents(map, Vector<2>{0.8121, 1.6243}, 3).closure, 1e-3);
    EXPECT_GT(cycle_exponents(map, a, 1).closure, 0.1);
    EXPECT_GT(cycle_exponents(map, Vector<2>{0.8121, 1.6243}, 1).closure, 0.1);
}

/// The fixed point with v = 2π and sin φ ≥ 0.
Vector<2> ball_fixed_point(const BouncingBall& map) {
    return {std::acos(-two_pi * (1 - map.alpha) / map.gamma), two_pi};
}

TEST(Maps, BouncingBallBifurcations) {
    BouncingBall map;
    map.gamma = two_pi * (1 - map.alpha);
    // At the fold cos φ = −1 and the multipliers are 1 and α; φ is good to √ε there.
    const CycleExponents fold = cycle_exponents(map, Vector<2>{std::numbers::pi, two_pi}, 1);
    EXPECT_LT(fold.closure, 1e-15 * 8);
    EXPECT_NEAR(fold.multipliers[0].real(), 1, 1e-12);
    EXPECT_NEAR(fold.multipliers[1].real(), 0.8, 1e-12);
    const double doubling = std::sqrt(4 * 1.8 * 1.8 + two_pi * two_pi * 0.2 * 0.2);
    EXPECT_NEAR(doubling, 3.813021991, 5e-10);
    map.gamma = doubling;
    // sin φ < 0 on the branch that loses stability by doubling: tr DF = 1 + α + γ sin φ = −(1 + α).
    Vector<2> z = ball_fixed_point(map);
    z[0] = two_pi - z[0];
    const CycleExponents flip = cycle_exponents(map, z, 1);
    EXPECT_LT(flip.closure, 1e-14);
    EXPECT_NEAR(flip.multipliers[0].real(), -1, 1e-13);
    EXPECT_NEAR(flip.multipliers[1].real(), -0.8, 1e-13);
}

TEST(Maps, TheDrivenTorusIsInvariant) {
    const DrivenTorus map{golden_mean, 0.5, 0};
    Vector<2> z = map.on_circle(0.4);
    for (int i = 0; i < 100; ++i) {
        z = map.advance(z).state;
        EXPECT_NEAR(z[1], map.on_circle(z[0])[1], 1e-14);
    }
}

TEST(Maps, NormalFormsBifurcateAtZero) {
    EXPECT_EQ(cycle_exponents(FlipNormalForm{}, Vector<1>{0}, 1).multipliers[0].real(), -1);
    const CycleExponents turning = cycle_exponents(NeimarkSackerNormalForm{}, Vector<2>{0, 0}, 1);
    EXPECT_NEAR(std::abs(turning.multipliers[0]), 1, 2 * eps);
    EXPECT_NEAR(std::abs(std::arg(turning.multipliers[0])), 0.1, 2 * eps);
}

}  // namespace
