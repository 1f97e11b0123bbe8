// The cycle that an orbit settles on.
#pragma once

#include "apps/studies/modes/name_mode.hpp"

#include <optional>

namespace swirl::studies {

struct SettledCycle {
    std::optional<SectionPoint<double>> point;  ///< of the cycle; none: the orbit settles on no cycle, or was stopped
    int period = 1;
    NamedMode named;  ///< what it settles on; `finished` false: stopped
};

/// Follows a start as `name_mode` does by default. @throws std::invalid_argument for a scene or start out of range
SettledCycle settled_cycle(const Scene<double>& scene, const Start<double>& start, Accuracy accuracy,
                           const analysis::Stop& stop);

}  // namespace swirl::studies
