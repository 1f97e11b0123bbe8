// Curves of cycles on borders of the map, with the time of every impact as an unknown.
#pragma once

#include "analysis/boundaries/plane_curve.hpp"
#include "apps/studies/bifurcation_curves/border_cycle.hpp"
#include "apps/studies/bifurcation_curves/curves.hpp"

#include <complex>
#include <functional>
#include <optional>
#include <vector>

namespace swirl::studies::bifurcation_curves {

/// Unknowns y = (Z, p₁, p₂, τ_1 … τ_k, and t* of grazing); equations: each impact leads to the next point, the vertex
/// that strikes is on the wall (g = 0), and what touches (Touch). Regular where the map is not: DF grows as 1/u_n
/// towards a vanishing impact, the derivatives by z and τ stay bounded.
struct BorderCurve {
    BorderCycle like;  ///< the itinerary and what touches; its numbers are those of one cycle
    analysis::PlaneCurve arc;
};

struct BorderOptions {
    double longest_step = 0.02;
    std::function<bool()> stop;
};

/// Follows the curve through a cycle both ways. It ends where it is none any more: another vertex comes to the wall, an
/// impact vanishes, the touching is from outside. Special points: the cycle has a multiplier 1, −1 or a pair on the
/// circle there, seen from the side on which nothing touches (fold-…, flip-…, neimark-sacker-…): a curve of that kind
/// ends there on the border. Empty if no such cycle is near.
std::optional<BorderCurve> follow_border(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle,
                                         const BorderOptions& options);

/// A pair on the unit circle to 10⁻⁶, as a Neimark–Sacker point has (and a neutral saddle has not).
bool has_pair_on_circle(const std::vector<std::complex<double>>& multipliers);

/// The unknowns of a cycle near this one, solved on the border itself; none if there is none in the plane.
std::optional<Eigen::VectorXd> solved_on_border(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle);

/// Is the cycle on the curve?
///   solved  its unknowns (solved_on_border)
bool is_on(const ItineraryMap& map, const Plane& plane, const BorderCycle& cycle, const Eigen::VectorXd& solved,
           const BorderOptions& options, const BorderCurve& curve);

Curve curve_of(const ItineraryMap& map, const BorderCurve& curve);

}  // namespace swirl::studies::bifurcation_curves
