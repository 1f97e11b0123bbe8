// Maps with two parameters whose curves of bifurcations are known in closed form.
#pragma once

#include "analysis/boundaries/follow_boundary.hpp"

#include <ceres/jet.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace swirl::analysis::planes {

/// A plane map of a formula that is a template of the number type: F(z, p) with D coordinates, differentiated by Jets.
template <int D, class Formula>
PlaneMap plane_map(const Formula& formula) {
    PlaneMap map;
    map.dimension = D;
    map.angle_periods.assign(D, 0);
    map.step = [formula](const Eigen::VectorXd& z, const Eigen::Vector2d& p) {
        using Jet = ceres::Jet<double, D + 2>;
        std::array<Jet, D> jets;
        for (int i = 0; i < D; ++i) jets[static_cast<std::size_t>(i)] = Jet(z[i], i);
        const auto image = formula(jets, std::array<Jet, 2>{Jet(p[0], D), Jet(p[1], D + 1)});
        ShootingStep step;
        step.alive = z.allFinite() && z.norm() < 1e3;
        step.state.resize(D);
        step.by_state.resize(D, D);
        step.by_parameter.resize(D, 2);
        for (int i = 0; i < D; ++i) {
            const Jet& value = image[static_cast<std::size_t>(i)];
            step.state[i] = value.a;
            step.by_state.row(i) = value.v.template head<D>().transpose();
            step.by_parameter.row(i) = value.v.template tail<2>().transpose();
        }
        return step;
    };
    return map;
}

/// Its higher derivatives by differences in long double: the second to 10⁻¹², the third to 10⁻⁹ or so.
template <int D, class Formula>
HigherForms forms_of(const Formula& formula, const CyclePoints& points, const Eigen::Vector2d& p) {
    using Real = long double;
    using Square = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
    const std::size_t k = points.size();
    return difference_forms<Real>(
        [formula, p, k](const Eigen::Matrix<Real, Eigen::Dynamic, 1>& from, const Real&, Square& product) {
            using Jet = ceres::Jet<Real, D>;
            Eigen::Matrix<Real, Eigen::Dynamic, 1> z = from;
            product = Square::Identity(D, D);
            for (std::size_t round = 0; round < k; ++round) {
                std::array<Jet, D> jets;
                for (int i = 0; i < D; ++i) jets[static_cast<std::size_t>(i)] = Jet(z[i], i);
                const auto image = formula(jets, std::array<Jet, 2>{Jet(Real(p[0])), Jet(Real(p[1]))});
                Square step(D, D);
                for (int i = 0; i < D; ++i) {
                    step.row(i) = image[static_cast<std::size_t>(i)].v.transpose();
                    z[i] = image[static_cast<std::size_t>(i)].a;
                }
                product = (step * product).eval();
            }
            return true;
        },
        points.front(), 0, 1e-6, 3e-5);
}

template <int D, class Formula>
BoundaryOptions options_of(const Formula& formula, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
    BoundaryOptions options;
    options.low = low;
    options.high = high;
    options.forms = [formula](const CyclePoints& points, const Eigen::Vector2d& p) {
        return forms_of<D>(formula, points, p);
    };
    return options;
}

/// x′ = a − x² + b y, y′ = x over (a, b). Fixed points x² + (1 − b)x = a: fold a = −(1 − b)²/4, flip a = 3(1 − b)²/4,
/// Neimark–Sacker b = −1 with cos θ = −x. The 2-cycle x₁ + x₂ = 1 − b, x₁x₂ = (1 − b)² − a has trace 4x₁x₂ + 2b and
/// determinant b²: flip a = (1 − b)² + (1 + b)²/4, Neimark–Sacker also on b = 1 with cos θ = 1 − 2a.
struct Henon {
    template <class T>
    std::array<T, 2> operator()(const std::array<T, 2>& z, const std::array<T, 2>& p) const {
        return {p[0] - z[0] * z[0] + p[1] * z[1], z[0]};
    }
};

/// x′ = a + b x − x³ over (a, b): fold a = −2x³, b = 1 + 3x² (cusp at x = 0), flip a = 2x − 2x³, b = 3x² − 1, whose
/// coefficient f′′²/4 + f′′′/6 = 9x² − 1 is zero at x = ±1/3.
struct Cubic {
    template <class T>
    std::array<T, 1> operator()(const std::array<T, 1>& z, const std::array<T, 2>& p) const {
        return {p[0] + p[1] * z[0] - z[0] * z[0] * z[0]};
    }
};

/// x′ = r x(1 − y − s x), y′ = x over (r, s), the delayed logistic map for s = 0: Neimark–Sacker on r = 2 + s with
/// cos θ = (1 − s)/2. At s = 0, with q = (λ, 1)/2, λ = e^{iπ/3}: b = −1/(1 − λ) = −e^{iπ/3}.
struct DelayedLogistic {
    template <class T>
    std::array<T, 2> operator()(const std::array<T, 2>& z, const std::array<T, 2>& p) const {
        return {p[0] * z[0] * (T(1) - z[1] - p[1] * z[0]), z[0]};
    }
};

/// z′ = z e^{i}(1 + p + (q + i/2)|z|²) of a complex z, and x′ = p₁ + x − x² or −(1 + p₁)x + x³ beside it, coupled by
/// terms that vanish at z = 0.
template <int sign>
struct PairBeside {
    template <class T>
    std::array<T, 3> operator()(const std::array<T, 3>& z, const std::array<T, 2>& p) const {
        const T square = z[0] * z[0] + z[1] * z[1];
        const T grow = T(1) + p[1] + T(0.2) * z[2] * p[0] - square, turn = T(0.5) * square;
        const T x = grow * z[0] - turn * z[1], y = grow * z[1] + turn * z[0];
        const T c = T(std::cos(1.0)), s = T(std::sin(1.0));
        const T beside = sign > 0 ? T(p[0] + z[2] - z[2] * z[2]) : T(-(T(1) + p[0]) * z[2] + z[2] * z[2] * z[2]);
        return {c * x - s * y, s * x + c * y, beside + T(0.3) * square};
    }
};

/// z′ = z e^{i}(1 + p + (q + i/2)|z|²) over (p, q): Neimark–Sacker on p = 0 with coefficient q + i/2, Chenciner at q =
/// 0.
struct Chenciner {
    template <class T>
    std::array<T, 2> operator()(const std::array<T, 2>& z, const std::array<T, 2>& p) const {
        const T square = z[0] * z[0] + z[1] * z[1];
        const T grow = T(1) + p[0] + p[1] * square - square * square, turn = T(0.5) * square;
        const T x = grow * z[0] - turn * z[1], y = grow * z[1] + turn * z[0];
        const T c = T(std::cos(1.0)), s = T(std::sin(1.0));
        return {c * x - s * y, s * x + c * y};
    }
};

/// x′ = p₁ + x − x², y′ = −(1 + p₂)y + y³ + x y: fold on p₁ = 0 (x = 0), flip of y = 0 on x = p₂, p₁ = p₂².
struct FoldBesideFlip {
    template <class T>
    std::array<T, 2> operator()(const std::array<T, 2>& z, const std::array<T, 2>& p) const {
        return {p[0] + z[0] - z[0] * z[0], -(T(1) + p[1]) * z[1] + z[1] * z[1] * z[1] + z[0] * z[1]};
    }
};

}  // namespace swirl::analysis::planes
