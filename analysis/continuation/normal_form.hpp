// Normal forms at fold, flip and Neimark–Sacker points (Kuznetsov, Elements of Applied Bifurcation Theory, 5.4, 9.5).
#pragma once

#include "analysis/continuation/higher_forms.hpp"

#include <complex>
#include <optional>

namespace swirl::analysis {

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
