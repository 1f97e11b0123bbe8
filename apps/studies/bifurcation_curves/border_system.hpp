// The equations of a cycle on a border of the map.
#pragma once

#include "apps/studies/bifurcation_curves/border_curve.hpp"
#include "apps/studies/bifurcation_curves/border_cycle.hpp"

#include <string>

namespace swirl::studies::bifurcation_curves {

// When a cycle that is given by its itinerary has a multiplier 1 or −1, as a number that is regular on borders of the
// map.

/// ∂(z⁺(z_i, τ_i) − z_{i+1}, g(z_i, τ_i))/∂(Z, τ), the closing block times λ; what touches is left out. At a multiplier
/// λ its null vector is the cycle's eigenvector, with the changes of the flights' times. Cost: k steps.
Eigen::MatrixXd itinerary_matrix(const ItineraryMap& map, const BorderCycle& cycle, double multiplier);

/// Its determinant: up to sign det(DFᵏ − λI) Π g′(τ_i), which is bounded and smooth where an impact vanishes and DFᵏ is
/// not. Cost: k steps and an LU of k(D + 1) unknowns.
double itinerary_determinant(const ItineraryMap& map, const BorderCycle& cycle, double multiplier);

/// The cycle with one more impact, which vanishes: that of the vertex that grazes, `earlier` before it does (so that it
/// approaches). Its flights are numbered from the same one; what touches is left as it is.
BorderCycle with_impact(const ItineraryMap& map, const BorderCycle& grazing, double earlier);

/// itinerary_determinant() of the grazing cycle with its vanishing impact, as that vanishes.
double grazing_determinant(const ItineraryMap& map, const BorderCycle& grazing, double multiplier);

/// Where the unknowns of a cycle of k points in D coordinates stand in y.
struct BorderLayout {
    Eigen::Index dimension, period;

    Eigen::Index parameters() const { return dimension * period; }
    Eigen::Index time(Eigen::Index flight) const { return parameters() + 2 + flight; }
    Eigen::Index touch_time() const { return time(period); }
};

BorderLayout layout_of(const ItineraryMap& map, const BorderCycle& cycle);

/// The parts of the equations. The cycle: k(D + 1) rows, each impact leads to the next point and its vertex is on the
/// wall. What touches: the row after them (and one more of grazing). The approach of the vertex that strikes first, in
/// place of that: g′(τ_1).
void add_cycle(const ItineraryMap& map, const BorderCycle& like, const BorderLayout& layout, const Eigen::VectorXd& y,
               analysis::ShootingResidual& at);
void add_touch(const ItineraryMap& map, const BorderCycle& like, const BorderLayout& layout, const Eigen::VectorXd& y,
               analysis::ShootingResidual& at);
void add_approach(const ItineraryMap& map, const BorderCycle& like, const BorderLayout& layout,
                  const Eigen::VectorXd& y, analysis::ShootingResidual& at);
/// Of both parameters: Newton's method may lead elsewhere.
bool is_in_range(const Plane& plane, const Eigen::Vector2d& p);

analysis::CurveProblem border_problem(const ItineraryMap& map, const Plane& plane, const BorderCycle& like);

/// The cycle with the numbers of y.
BorderCycle border_cycle_at(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y);
Eigen::VectorXd unknowns_of(const ItineraryMap& map, const BorderCycle& cycle);

/// D(Fᵏ) on the side on which nothing touches, or on which there is more slip: DF_i = ∂z′ − ∂_τ z′ ∂_z g/g′.
Eigen::MatrixXd monodromy_of(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y);

/// Why y, which solves the equations, is no cycle on this border; empty: it is one.
std::string refusal_of(const ItineraryMap& map, const BorderCycle& like, const Eigen::VectorXd& y);

}  // namespace swirl::studies::bifurcation_curves
