// Discs that hold the eigenvalues of a matrix of balls.
#pragma once

#include "map/intervals/krawczyk.hpp"

#include <vector>

namespace swirl::intervals {

/// |z − (re + i im)| ≤ radius.
struct Disc {
    double re = 0, im = 0, radius = 0;
    /// Bounds of |z|.
    double least_modulus() const;
    double largest_modulus() const;
};

/// n discs for the n eigenvalues, by falling modulus: as many discs as are connected with each other hold as many
/// eigenvalues together, and are written as one disc about all of them, as often as it counts. Gershgorin's theorem for
/// R⁻¹ A R, R the approximate eigenvectors. One disc about 0 for all of them where that fails.
///   matrix  n rows of n balls
std::vector<Disc> eigenvalue_discs(const std::vector<BallVector>& matrix);

/// By Arb's own enclosures (acb_mat_eig_multiple; van der Hoeven & Mourrain 2017, Rump 2010), of which a cluster has
/// the same one for each of its members. Empty where they cannot be found.
std::vector<Disc> eigenvalue_discs_by_arb(const std::vector<BallVector>& matrix);

}  // namespace swirl::intervals
