// `swirl tour`: the main job of ./quickstart, the modes of Sun 2019 (docs/references.md) on a built-in set of scenes.
#pragma once

#include "apps/command_line/output_options.hpp"

namespace swirl::apps::tour {

struct TourOptions {
    OutputOptions output;
    bool verbose = false;     ///< the table has why, and the evidence
    bool exhaustive = false;  ///< all impacts, whatever the verdict needs

    void add_to(Flags& command);
};

extern const char* const tour_details;

int tour(TourOptions& options);

}  // namespace swirl::apps::tour
