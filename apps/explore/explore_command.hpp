// `swirl explore`: a page of a record that opens without a network, in which the map itself runs.
#pragma once

#include "apps/scripts/script_command.hpp"

namespace swirl::apps::explore {

struct ExploreOptions {
    scripts::ScriptFiles files;

    void add_to(Flags& command);
};

extern const char* const explore_details;

/// @return the exit code @throws BadInput
int explore(ExploreOptions& options);

}  // namespace swirl::apps::explore
