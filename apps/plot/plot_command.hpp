// `swirl plot`: a figure of records.
#pragma once

#include "apps/scripts/script_command.hpp"

#include <string>

namespace swirl::apps::plot {

struct PlotOptions {
    scripts::ScriptFiles files;
    std::string kind;  ///< empty: the record's default
    std::string width, font_size, xlim, ylim, log, of, over, x, y, units;
    std::string caption;  ///< a file for what the figure shows, in words; empty: none
    bool no_title = false;

    void add_to(Flags& command);
};

extern const char* const plot_details;

/// plot_record.py. @return its exit code @throws BadInput
int plot(PlotOptions& options);

}  // namespace swirl::apps::plot
