// A fold, flip or Neimark–Sacker point of a cycle along a parameter, enclosed: the cycle's equations together with a
// vector that its linearised map takes to λ times itself, λ = 1, −1 or e^{iθ}.
//
// G(x, p) = 0 are a cycle's equations, step by step, and M(λ) = ∂_x G with those entries times λ through which the last
// step reads the first point ("closing"): M(λ) is singular if and only if λ is a multiplier. The extended system
//
//     G(x, p) = 0,   M(λ) q = 0,   l·q = 1                in x, p, q (and θ; q, l complex, M as real and imaginary
//     part)
//
// is square, and Krawczyk's operator on it proves that it has one zero in a box and that its derivative there has an
// inverse. Besides, over the box, [[M(λ), ∂_λ M q], [l, 0]] and, but at a fold, ∂_x G are shown to have inverses. Then
//   - λ is a simple multiplier, and with it no other vector;
//   - fold: the curve of cycles turns with d²p/ds² ≠ 0 (the quadratic coefficient is not 0), and the multiplier crosses
//     1 with dλ/ds ≠ 0;
//   - flip: dλ/dp ≠ 0 along the branch; Neimark–Sacker: d|λ|/dp ≠ 0, 0 < θ < π.
// For d(λ)/dp is, by Cramer's rule, the quotient of the determinants of the extended system by (x, p, q) and by
// (x, q, λ), both of which are not 0. (Folds: Moore & Spence, SIAM J. Numer. Anal. 17 (1980) 567; all three: Kuznetsov,
// Elements of Applied Bifurcation Theory, ch. 10; Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria,
// SIAM 2000.) Nothing is said of the cubic coefficients that tell which side what is born lies on, nor of other
// multipliers.
#pragma once

#include "map/intervals/krawczyk.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::intervals {

enum class BifurcationKind { fold, flip, neimark_sacker };

/// An entry of ∂G, and its own derivatives by (column, entry); what is not listed is zero.
struct DependentEntry {
    std::size_t column = 0;
    bool closing = false;  ///< the last step's, by the first point
    Ball value;
    std::vector<std::pair<std::size_t, Ball>> by;
};

/// n values; of their derivatives by all n + 1 unknowns, p the last, row by row the entries, which add up.
struct SecondOrder {
    BallVector values;
    std::vector<std::vector<DependentEntry>> rows;
};
using SecondOrderSystem = std::function<SecondOrder(const BallVector& unknowns)>;

struct BifurcationPoint {
    BallVector unknowns;  ///< x, then p
    Ball angle;           ///< θ of a Neimark–Sacker point, in (0, π)
};

/// The point of this kind near a cycle; nothing where Newton's method or one of the proofs fails.
///   near  x, then p
/// Cost: some ten evaluations, and 10 to 100 ns times n³.
std::optional<BifurcationPoint> bifurcation_point(const SecondOrderSystem& system, BifurcationKind kind,
                                                  const std::vector<double>& near);

}  // namespace swirl::intervals
