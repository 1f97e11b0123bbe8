// Flags of the commands that name modes: how far orbits are followed, and how close is a recurrence.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/command_line/flags.hpp"

namespace swirl::apps {

/// --transient, --collisions, --exhaustive and --threshold; `settings` keeps what is not given.
void add_classify_flags(Flags& command, analysis::ClassifyOptions& settings);

}  // namespace swirl::apps
