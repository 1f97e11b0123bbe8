// How far beyond a fold a slow change of the parameter is when the orbit leaves.
//
// Formula: beside a fold ξ′ = ξ + a δ + b ξ² (normal_form.hpp). With δ = v n, v the change of δ in a round,
// ξ = (a v/b²)^{1/3} x and n = (a b v)^{−1/3} s it is dx/ds = s + x² for small v, whose solution that comes along the
// stable branch is x = Ai′(−s)/Ai(−s). It leaves every neighbourhood at the first zero of Ai, s = Ω = 2.338107…:
//   δ = Ω v^{2/3} |a b|^{−1/3} (1 + O(v^{1/3})),
// and moves by more than a distance d in a round from where s + x² = d (|b|/(a v)²)^{1/3} on.
// Source: analysis/ramps/README.md, with references.
#pragma once

#include "analysis/special_values.hpp"

namespace swirl::analysis {

/// δ where ξ first moves by more than `leave` in a round, to first order; ∞: where it leaves everything. NaN where it
/// moves by more than that long before the fold.
///   a, b   of the fold's normal form
///   step   v, |change of the parameter| in one round of the cycle
double fold_delay(double a, double b, double step, double leave = infinity);

}  // namespace swirl::analysis
