// `swirl continue`: one-parameter branches of cycles.
#pragma once

#include "apps/branches/branches.hpp"
#include "apps/command_line/output_options.hpp"

#include <string>

namespace swirl::apps::continuation {

struct ContinueOptions {
    SceneOptions scene;
    OutputOptions output;
    std::string from;
    std::string along;
    int period = 1;
    int switches = 1;
    double longest_step = 0.02;

    void add_to(Flags& command);
};

extern const char* const continue_details;

int continue_orbit(ContinueOptions& options);

}  // namespace swirl::apps::continuation
