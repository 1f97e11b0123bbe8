// The image of a piece of a set of the section under F, enclosed with its derivative.
#pragma once

#include "map/intervals/krawczyk.hpp"
#include "map/proof/covering_claim.hpp"
#include "map/proof/step_in_balls.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::proof {

using intervals::BallVector;
using BallMatrix = std::vector<BallVector>;

/// A set as exact numbers, with A⁻¹.
struct BallSet {
    BallVector centre;
    BallMatrix matrix, inverse;
    bool invertible = false;

    std::size_t dimension() const { return centre.size(); }
};
BallSet ball_set(const SectionSet& set);

/// A box of q.
struct UnitPiece {
    std::vector<double> low, high;
};

/// What F is looked at over.
struct SectionFlights {
    BallScene scene;
    std::vector<std::size_t> chart;
    std::optional<double> jacobi;

    SectionFlights(const Scene<double>& of, const ChaosClaim& claim);
};

/// F of a piece, of the chart's coordinates: middle + Σ slopes_j e_j + Σ curves_{jk} e_j e_k (j ≤ k, in lexicographic
/// order) for the point whose q is that of the piece's middle and e_j, |e_j| ≤ 1, of its half-widths from there.
/// `middle` holds what is of third order.
struct SectionImage {
    std::string open;  ///< what is not certain; the rest has no meaning then
    BallVector middle;
    BallMatrix slopes, curves;
};

/// Encloses the time of the flight by Newton's method over intervals about a polynomial of e, for every point of the
/// piece; then asks the inequalities of the contact mode, and that no vertex is outside before. Numbers keep their
/// dependence on e to second order (curved.hpp).
///   time  of the flight, roughly
SectionImage image_of(const SectionFlights& flights, const BallSet& set, const UnitPiece& piece, const Branch& branch,
                      double time);

}  // namespace swirl::proof
