// The curves in the plane of (τ, χ) on which a contact ends without slip and with the law's restitution.
//
// Q of the flight is Q of the impact: (1 − cos τ)/τ = G(χ) = s/((s² + δc²) R). The left side rises and falls once
// between two multiples of 2π, G is cut where it turns: on each pair of such pieces χ is a function of τ.
#pragma once

#include "map/steady/steady_equations.hpp"

#include <vector>

namespace swirl::steady {

/// One piece of a curve, over an interval of τ. Its contacts have χ ≠ 0.
struct StickingCurve {
    SteadyBranch branch = SteadyBranch::plus;
    double from = 0, to = 0;           ///< τ
    double chi_low = 0, chi_high = 0;  ///< between which χ lies, on one side of 0
};

/// The largest |χ| that the neighbouring vertices, the swirl's radius (|sin χ| ≤ β) and sticking (|tan χ| ≤ μ) allow.
double widest_sticking_chi(const Scene<double>& scene);

/// All pieces with 0 < τ ≤ longest. Turns of G closer than a hundredth of the range of χ (or, towards χ = 0, of its
/// size) are not seen. Cost: some thousand values of G.
std::vector<StickingCurve> sticking_curves(const Scene<double>& scene, double longest);

/// χ of a curve at τ, bracketed to rounding.
double chi_at(const Scene<double>& scene, const StickingCurve& curve, double tau);

}  // namespace swirl::steady
