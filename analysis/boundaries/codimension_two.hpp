// Functions along a boundary whose zeros are its points of codimension 2.
#pragma once

#include "analysis/boundaries/augmented_system.hpp"

#include <functional>
#include <vector>

namespace swirl::analysis {

/// One kind of point, with its function of A = D(Fᵏ) and its multipliers m:
///   cusp              −∂_Z g · q = Σ p_i D²F(q_i, q_i), with the borders of the step
///   generalised flip  b Σ_i det_i(A + I) det(A − I), det_i the principal minors without row i: b has poles at 1:2 and
///                     fold–flip, the product has not
///   Chenciner         Re b/|b|
///   1:1, 1:2 on a fold, a flip          Σ_i det_i(A ∓ I), the product of m ∓ 1 over the other multipliers
///   1:1 … 1:4 on a Neimark–Sacker curve  cos θ − 1, + 1, + ½, 0
///   fold–flip         det(A + I) on a fold, det(A − I) on a flip
///   with a pair       Π (m_i m_j − 1) over pairs without the critical multipliers; kept if it is complex
///   on Neimark–Sacker det(A ∓ I)/(2 ∓ 2 cos θ): a multiplier ±1 beside the pair
struct CodimensionTest {
    CodimensionTwo kind;
    std::function<double(const CurvePoint&)> value;
    /// Its value from what a point of the curve says already, the coefficient in double; empty: by `value`.
    std::function<double(const BoundaryPoint&)> seen = {};
    double noise = 1e-9;  ///< a change of sign between values that are both below is rounding
};

/// The tests of the system's kind.
///   forms  as of BoundaryOptions; empty: differences in double
std::vector<CodimensionTest> tests_of(
    const AugmentedSystem& system,
    const std::function<HigherForms(const CyclePoints&, const Eigen::Vector2d&)>& forms = {});

/// Does the point have what its test says? Of points with a second pair: is the pair complex?
bool is_what_it_seems(const AugmentedSystem& system, CodimensionTwo kind, const CurvePoint& point);

/// Does the curve's coefficient exist at such a point? It has poles where another multiplier is what the elimination of
/// lower terms divides by (1: fold–flip, fold–Neimark–Sacker; e^{−iθ} = e^{2iθ}: 1:3), and none at a double multiplier.
bool has_coefficient(BoundaryKind curve, CodimensionTwo kind);

/// Multipliers and coefficient of a point. Cost: some 10 to 20 derivatives of Fᵏ.
BoundaryPoint boundary_point_at(
    const AugmentedSystem& system, const CurvePoint& at,
    const std::function<HigherForms(const CyclePoints&, const Eigen::Vector2d&)>& forms = {});

}  // namespace swirl::analysis
