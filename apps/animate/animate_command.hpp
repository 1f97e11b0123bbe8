// `swirl animate`: a film of the body in the swirled container.
#pragma once

#include "apps/scripts/script_command.hpp"

#include <string>

namespace swirl::apps::animate {

struct AnimateOptions {
    scripts::ScriptFiles files;
    std::string frame, fps, duration, from, to, orbit, units;  ///< empty: the script's default

    void add_to(Flags& command);
};

extern const char* const animate_details;

/// animate_record.py. @return its exit code @throws BadInput
int animate(AnimateOptions& options);

}  // namespace swirl::apps::animate
