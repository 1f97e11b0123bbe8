// Where a branch begins: near a point, at a record's cycle, or at what a start settles on.
#pragma once

#include "apps/continue/continue_command.hpp"
#include "apps/studies/cycles/near_orbit.hpp"

#include <string>
#include <vector>

namespace swirl::apps::continuation {

struct Beginning {
    Scene<double> scene;
    int period = 1;
    std::vector<SectionPoint<double>> points;  ///< all of a record's cycle, else one beside it; none: why_none
    std::string from;                          ///< the first, as --from takes it
    std::string why_none;                      ///< what a start settled on that is no cycle
};

/// @throws BadInput unless one way is given, and for what is none
Beginning beginning_of(ContinueOptions& options);

}  // namespace swirl::apps::continuation
