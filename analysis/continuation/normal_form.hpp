// Multipliers on a branch, the functions whose zeros are its special points, and normal forms there.
#pragma once

#include "analysis/curves/curve.hpp"

#include <Eigen/Core>

#include <complex>
#include <functional>
#include <optional>
#include <vector>

namespace swirl::analysis {

/// Eigenvalues of DFᵏ at a curve's point, by falling modulus.
std::vector<std::complex<double>> multipliers_at(const CurvePoint& point);

/// Π (1 + m_i): changes its sign where a multiplier passes −1.
double flip_function(const std::vector<std::complex<double>>& multipliers);

/// Π_{i<j} (m_i m_j − 1): changes its sign where a pair e^{±iθ} passes the unit circle, and where two real ones have
/// the product 1 (a neutral saddle, which is no bifurcation).
double neimark_sacker_function(const std::vector<std::complex<double>>& multipliers);

/// det ∂(G, arclength)/∂(Z, p): changes its sign where two branches cross, not at a fold.
double crossing_function(const CurveProblem& problem, const CurvePoint& point);

// Second and third derivatives of Fᵏ, as changes of its exact first derivative, by differences in extended precision.

/// Directional derivatives of A(z; p) = D(Fᵏ)(z; p) at one point. Empty where the map ends nearby.
struct HigherForms {
    /// d/dh A(z + h u; p + h q): B(u, v) = first(u, 0) v.
    std::function<std::optional<Eigen::MatrixXd>(const Eigen::VectorXd& u, double q)> first;
    /// ∂²/∂h∂l A(z + h u + l v; p): C(u, v, w) = second(u, v) w.
    std::function<std::optional<Eigen::MatrixXd>(const Eigen::VectorXd& u, const Eigen::VectorXd& v)> second;
};

/// Central differences in the number type T, with errors O(h²) and O(l²) relative to the next derivatives, plus T's
/// rounding over h and l²: with 113 bits and h = 10⁻¹⁰, l = 10⁻⁸ both are below 10⁻¹⁵.
///   derivative  A(z; p) in T; false where the map ends
template <class T>
HigherForms difference_forms(std::function<bool(const Eigen::Matrix<T, Eigen::Dynamic, 1>&, const T&,
                                                Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>&)>
                                 derivative,
                             const Eigen::VectorXd& z, double p, double h = 1e-10, double l = 1e-8) {
    using State = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Square = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    const State centre = z.template cast<T>();
    HigherForms forms;
    forms.first = [=](const Eigen::VectorXd& u, double q) -> std::optional<Eigen::MatrixXd> {
        const State step = u.template cast<T>() * T(h);
        Square above, below;
        if (!derivative(State(centre + step), T(p) + T(q) * T(h), above) ||
            !derivative(State(centre - step), T(p) - T(q) * T(h), below))
            return std::nullopt;
        return Square((above - below) / T(2 * T(h))).template cast<double>();
    };
    forms.second = [=](const Eigen::VectorXd& u, const Eigen::VectorXd& v) -> std::optional<Eigen::MatrixXd> {
        const State a = u.template cast<T>() * T(l), b = v.template cast<T>() * T(l);
        Square both, first, second, none;
        if (!derivative(State(centre + a + b), T(p), both) || !derivative(State(centre + a - b), T(p), first) ||
            !derivative(State(centre - a + b), T(p), second) || !derivative(State(centre - a - b), T(p), none))
            return std::nullopt;
        return Square((both - first - second + none) / T(4 * T(l) * T(l))).template cast<double>();
    };
    return forms;
}

// Normal forms at fold, flip and Neimark–Sacker points (Kuznetsov, Elements of Applied Bifurcation Theory, 5.4, 9.5).

/// With δ the distance of the parameter from the point and the cycle's branch taken as the origin:
///   fold            ξ′ = ξ + a δ + b ξ²           a = ⟨p, ∂F⟩, b = ½⟨p, B(q, q)⟩
///   flip            ξ′ = (−1 + a δ) ξ + b ξ³      b = ⅙⟨p, C(q, q, q) + 3 B(q, (I − A)⁻¹ B(q, q))⟩
///   Neimark–Sacker  ζ′ = ζ e^{iθ}(1 + a δ + b |ζ|²)
///                   b = ½e^{−iθ}⟨p, C(q, q, q̄) + 2 B(q, (I − A)⁻¹B(q, q̄)) + B(q̄, (e^{2iθ} − A)⁻¹B(q, q))⟩
/// q is the critical eigenvector, |q| = 1 for the real ones and z = z* + Re(2 ζ q), |q|² = ½, for the pair (so that |ζ|
/// is an amplitude); ⟨p, q⟩ = 1.
struct NormalForm {
    std::complex<double> parameter;  ///< a
    std::complex<double> nonlinear;  ///< b
    double angle = 0;                ///< θ, of a Neimark–Sacker point
    /// flip: b > 0; Neimark–Sacker: Re b < 0. What is born is then stable where the cycle is not, if the other
    /// multipliers lie inside the unit circle.
    bool supercritical = false;
};

/// What all three need: A = D(Fᵏ) at the point, ∂(Fᵏ)/∂p and dz/dp along the branch.
struct CriticalPoint {
    Eigen::MatrixXd derivative;
    Eigen::VectorXd by_parameter;
    Eigen::VectorXd branch_slope;
    HigherForms forms;
};

/// Empty where a derivative does not exist. Cost: some 10 to 20 derivatives of Fᵏ in extended precision.
std::optional<NormalForm> fold_form(const CriticalPoint& point);
std::optional<NormalForm> flip_form(const CriticalPoint& point);
/// `multiplier`: that of the pair with Im > 0.
std::optional<NormalForm> neimark_sacker_form(const CriticalPoint& point, std::complex<double> multiplier);

/// Unit vectors q and p with A q = m q, pᵀA = m pᵀ, ⟨p, q⟩ = 1.
struct EigenPair {
    Eigen::VectorXcd right, left;
};
EigenPair eigen_pair(const Eigen::MatrixXd& a, std::complex<double> m);

}  // namespace swirl::analysis
