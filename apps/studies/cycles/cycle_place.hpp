// A cycle of a scene by its points.
#pragma once

#include "map/model/scene.hpp"
#include "map/model/section.hpp"

#include <cstddef>
#include <vector>

namespace swirl::studies::cycles {

/// Where a cycle is said to be, in its own scene.
struct CyclePlace {
    Scene<double> scene;
    std::vector<SectionPoint<double>> points;
    std::size_t number = 1;  ///< of the record's row, from 1
};

}  // namespace swirl::studies::cycles
