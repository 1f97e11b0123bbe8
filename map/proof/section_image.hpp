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

/// F of the point in a piece's middle, and ∂F/∂x over the piece, of the chart's coordinates.
struct SectionImage {
    std::string open;       ///< what is not certain; the rest has no meaning then
    BallVector offset;      ///< q − middle
    BallVector of_middle;   ///< F
    BallMatrix derivative;  ///< dF/dq
};

/// Encloses the time of the flight by Newton's method over intervals, for every point of the piece; then asks the
/// inequalities of the contact mode, and that no vertex is outside before.
///   time  of the flight, roughly
SectionImage image_of(const SectionFlights& flights, const BallSet& set, const UnitPiece& piece, const Branch& branch,
                      double time);

}  // namespace swirl::proof
