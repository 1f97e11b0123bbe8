// When a cycle that is given by its word has a multiplier 1 or −1, as a number that is regular on borders of the map.
#pragma once

#include "apps/studies/bifurcation_curves/border_cycle.hpp"

namespace swirl::studies::bifurcation_curves {

/// ∂(z⁺(z_i, τ_i) − z_{i+1}, g(z_i, τ_i))/∂(Z, τ), the closing block times λ; what touches is left out. At a multiplier
/// λ its null vector is the cycle's eigenvector, with the changes of the flights' times. Cost: k steps.
Eigen::MatrixXd word_matrix(const WordMap& map, const BorderCycle& cycle, double multiplier);

/// Its determinant: up to sign det(DFᵏ − λI) Π g′(τ_i), which is bounded and smooth where an impact vanishes and DFᵏ is
/// not. Cost: k steps and an LU of k(D + 1) unknowns.
double word_determinant(const WordMap& map, const BorderCycle& cycle, double multiplier);

/// The cycle with one more impact, which vanishes: that of the vertex that grazes, `earlier` before it does (so that it
/// approaches). Its flights are numbered from the same one; what touches is left as it is.
BorderCycle with_impact(const WordMap& map, const BorderCycle& grazing, double earlier);

/// word_determinant() of the grazing cycle with its vanishing impact, as that vanishes.
double grazing_determinant(const WordMap& map, const BorderCycle& grazing, double multiplier);

}  // namespace swirl::studies::bifurcation_curves
