// Follows an orbit and hands on what happens.
#pragma once

#include "apps/simulate/sinks.hpp"

#include <cstdint>
#include <string>

namespace swirl::apps::simulate {

struct Ending {
    std::string outcome;
    std::int64_t impacts = 0;
    double time = 0;
    double mean_spin = 0;  ///< ∫S dt / t from the first impact to the last; of fewer than two: S of the last flight
};

/// Follows the start of a scene, in the precision asked for, to its collisions or its time or until it ends.
Ending follow_impacts(const SimulateOptions& options, Sinks& sinks);

}  // namespace swirl::apps::simulate
