// Steps along a curve of cycles: boxes that overlap, each with exactly one cycle for every value of its running
// unknown.
#pragma once

#include "map/proof/box_standing.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace swirl::proof {

/// The claimed cycle as a point of the curve of solutions, and what distances along it are measured in.
struct BranchStart {
    BranchSystem system;
    double low = 0, high = 0;       ///< of the parameter
    intervals::CurvePiece point;    ///< the parameter is its running unknown, unless the curve turns there
    std::vector<double> scales;     ///< max(1, |x|), of the parameter the range
    std::vector<double> direction;  ///< along the curve, of length 1 in those scales
};

struct Walked {
    std::vector<BranchBox> boxes;
    BranchEnd end;
};

/// The boxes from the start on, in its direction or against it.
Walked walk(const BranchStart& start, bool forward, const std::function<bool()>& stop);

/// The unit vector along the curve in units of `scales`; empty where there is none.
std::vector<double> unit_direction(const BranchSystem& system, const std::vector<double>& point, std::size_t running,
                                   const std::vector<double>& scales);

/// The unknown that changes most along the curve, the parameter if it does by a tenth of that.
std::size_t running_unknown(const std::vector<double>& direction);

}  // namespace swirl::proof
