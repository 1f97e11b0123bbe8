// The mode of one orbit of a scene: the verdict that `classify`, `sweep`, `bifurcate` and `tour` share.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/command_line/start_options.hpp"
#include "map/orbit/outcome.hpp"

namespace swirl::apps {

/// The verdict on one orbit, and how following it ended.
struct NamedMode {
    analysis::Classification verdict;
    Outcome outcome = Outcome::completed;
    long long impacts = 0;
};

/// Classifies one start of a scene. A pure function of its arguments.
/// @throws std::invalid_argument for a scene or start out of range
NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& settings);

}  // namespace swirl::apps
