// The cycle that an orbit settles on.
#pragma once

#include "apps/command_line/accuracy.hpp"
#include "apps/command_line/start_options.hpp"
#include "map/model/section.hpp"

#include <functional>
#include <optional>
#include <string>

namespace swirl::apps {

struct SettledCycle {
    std::optional<SectionPoint<double>> point;  ///< of the cycle; none: the orbit settles on no cycle, or was stopped
    int period = 1;
    std::string mode;  ///< what it settles on, in words; empty: stopped
};

/// Follows a start as `classify` does by default. @throws std::invalid_argument for a scene or start out of range
SettledCycle settled_cycle(const Scene<double>& scene, const Start<double>& start, Accuracy accuracy,
                           const std::function<bool()>& stop);

/// The line that says why nothing goes on from there.
std::string no_cycle_in_words(const SettledCycle& settled);

}  // namespace swirl::apps
