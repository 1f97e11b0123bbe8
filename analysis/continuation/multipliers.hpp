// Multipliers on a branch, and the functions whose zeros are its special points.
#pragma once

#include "analysis/curves/curve.hpp"

#include <complex>
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

}  // namespace swirl::analysis
