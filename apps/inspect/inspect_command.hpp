// `swirl inspect`: what a measured file is taken for, before anything is analysed.
#pragma once

#include "apps/command_line/output_options.hpp"
#include "apps/input/series_choice.hpp"

#include <string>

namespace swirl::apps::inspect {

struct InspectOptions {
    SeriesChoice series;
    std::string angle, swirl_rate;  ///< of the series, as other commands have them with their starts and scenes
    bool json = false, quiet = false;

    void add_to(Flags& command);
};

extern const char* const inspect_details;

/// @return the exit code. @throws BadInput for a file that can't be read as a table
int inspect(InspectOptions& options);

}  // namespace swirl::apps::inspect
