// The image of a piece of a stated set, by the equations between two neighbouring points.
#pragma once

#include "map/proof_check/checked_system.hpp"
#include "map/proof_check/stated_chaos.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::proof_check {

using BallRows = std::vector<Balls>;

/// Which coordinates a set has, and which of the next point are unknowns beside the time.
struct CheckedChaos {
    StatedScene scene;
    std::vector<std::size_t> chart, kept;
    std::optional<double> jacobi;
};
/// @throws std::invalid_argument where the numbers of sets do not go with the scene
CheckedChaos checked_chaos(const StatedChaos& chaos);

/// A box of q, with the next point and the time of its middle, roughly.
struct CarriedPiece {
    std::vector<double> low, high;
    Eigen::VectorXd guess;
};

struct Carried {
    std::string open;        ///< what is not shown; then the rest has no meaning
    Balls of_middle;         ///< the image of the piece's middle, chart coordinates
    BallRows slopes;         ///< its derivative by q over the piece
    Balls offset;            ///< q − middle
    Eigen::VectorXd middle;  ///< next point and time of the middle
};

/// `carried.middle` is set where it could be found, so that halves begin there.
Carried carried(const CheckedChaos& chaos, const StatedSet& set, const StatedCovering& covering,
                const CarriedPiece& piece);

/// A⁻¹ over balls; empty if there is none for certain.
BallRows inverse_of(const StatedSet& set);

}  // namespace swirl::proof_check
