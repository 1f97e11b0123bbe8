// Krawczyk's operator: proves that a square system has exactly one zero in a box.
//
//     K = m − C G(m) + (I − C G′(box))(box − m),    C ≈ G′(m)⁻¹, any matrix
//
// If K lies in the interior of the box there is exactly one zero in the box, and it lies in K; a zero in the box always
// lies in K, so that where K and the box are disjoint there is none. G′(box) may be any matrix of balls that holds a
// slope between any two points of the box, so G may have kinks across which it is continuous if the derivatives of all
// pieces are in it. (Krawczyk, Computing 4 (1969) 187; Neumaier, Interval Methods for Systems of Equations, 1990.)
#pragma once

#include "map/intervals/ball.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace swirl::intervals {

using BallVector = std::vector<Ball>;

/// A system's values, and its derivatives row by row as (column, entry); what is not listed is zero.
struct Linearisation {
    BallVector values;
    std::vector<std::vector<std::pair<std::size_t, Ball>>> rows;
};

/// G and G′ over a box, enclosed.
using BallSystem = std::function<Linearisation(const BallVector& box)>;

/// The boxes' midpoints, exact.
BallVector middles(const BallVector& box);
/// Boxes about exact midpoints.
BallVector boxes(const BallVector& middle, const std::vector<double>& radii);

/// C ≈ G′(m)⁻¹ from the midpoints of G′; not finite where it is singular.
Eigen::MatrixXd approximate_inverse(const Linearisation& at);

/// K; without bounds of a system of another number of equations than unknowns. Cost: one evaluation at m, one over the
/// box, n times the entries of G′.
///   middle  exact points
BallVector krawczyk_image(const BallSystem& system, const BallVector& middle, const BallVector& box,
                          const Eigen::MatrixXd& inverse);

/// True if each entry lies in the interior of the box's.
bool lies_inside(const BallVector& inner, const BallVector& outer);

/// The zero that a box was proven to hold, alone, enclosed ever closer: K again and again, until it no longer narrows;
/// where it does so too early, a small box about the end of Newton's method, if K maps that into itself.
BallVector narrowed(const BallSystem& system, const BallVector& box);

}  // namespace swirl::intervals
