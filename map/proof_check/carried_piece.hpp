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

/// The image of a piece: middle + Σ slopes_j e_j + Σ curves_{jk} e_j e_k (j ≤ k, in lexicographic order), |e_j| ≤ 1, of
/// the chart's coordinates. `middle` holds what is of third order.
struct Carried {
    std::string open;  ///< what is not shown; then the image has no meaning
    Balls middle;
    BallRows slopes, curves;
    std::vector<double> effects;  ///< of each direction on the next point, roughly; empty where nothing is known
    Eigen::VectorXd found;        ///< next point and time of the middle; empty where none was found
};

Carried carried(const CheckedChaos& chaos, const StatedSet& set, const StatedCovering& covering,
                const CarriedPiece& piece);

/// A⁻¹ over balls; empty if there is none for certain.
BallRows inverse_of(const StatedSet& set);

}  // namespace swirl::proof_check
