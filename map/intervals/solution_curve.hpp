// A curve of zeros of n equations in n + 1 unknowns, enclosed piece by piece: Krawczyk's operator with one of the
// unknowns as a parameter.
//
// On a piece one unknown, the running one, goes from `low` to `high`, s = s₀ + half·e, |e| ≤ 1. With the parabola
// x_c(e) = middle + slope e + curvature e² of the others and any matrix C(e), if
//
//     |C G(x_c)| + |I − C ∂_x G(x_c ± domain)| domain < domain      for all e
//
// there is for each s exactly one zero with |x − x_c| ≤ domain, continuous in s (Krawczyk, Computing 4 (1969) 187, for
// each s by itself; with parameters: Neumaier, Interval Methods for Systems of Equations, 1990, ch. 5). It lies within
// the left side, `near`. C is G′⁻¹ to second order in e, so that a piece's length is limited by terms of third order.
// Any unknown can be the running one, so that a curve goes on through its folds. (Validated continuation: van den Berg,
// Lessard & Mischaikow, Math. Comp. 79 (2010) 1565.)
#pragma once

#include "map/intervals/curved.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::intervals {

/// A number that depends on the running unknown, to second order.
using Running = Curved<1>;

/// n values, and their derivatives by all n + 1 unknowns, row by row as (column, entry); what is not listed is zero.
struct CurveLinearisation {
    std::vector<Running> values;
    std::vector<std::vector<std::pair<std::size_t, Running>>> rows;
};
using CurveSystem = std::function<CurveLinearisation(const std::vector<Running>& unknowns)>;

struct CurvePiece {
    std::size_t running = 0;
    double low = 0, high = 0;                      ///< of the running unknown; the same: a point of the curve
    std::vector<double> middle, slope, curvature;  ///< of all unknowns, in e
    std::vector<double> domain, near;              ///< of all unknowns; those of the running one have no meaning
};

/// x_c(e) ± width, unknown by unknown.
std::vector<Running> tube(const CurvePiece& piece, const std::vector<double>& width);
/// x_c(e).
std::vector<Running> centre_of(const CurvePiece& piece);

/// The piece of the curve near a point, which Newton's method corrects at the piece's middle; nothing where Newton's
/// method or Krawczyk's operator fails. Cost: some ten evaluations.
std::optional<CurvePiece> curve_piece(const CurveSystem& system, const std::vector<double>& start, std::size_t running,
                                      double low, double high);

/// The direction of the curve at a point, as dx/ds; empty where no derivative can be inverted.
std::vector<double> direction_at(const CurveSystem& system, const std::vector<double>& point, std::size_t running);

/// A point of the curve (low = high) that lies on the piece: within its range and, for that value of the running
/// unknown, where the zero is alone. Two pieces on which one point lies are pieces of one curve.
bool lies_on(const CurvePiece& piece, const CurvePiece& point);

/// A point that was enclosed by other means, to be asked whether it lies on a piece.
CurvePiece as_point(const std::vector<Ball>& unknowns, std::size_t running);

/// No less than |x|, whatever e.
double largest(const Running& x);

}  // namespace swirl::intervals
