// `swirl plot`: a figure of a record.
#pragma once

#include "apps/command_line/cli_names.hpp"

#include <string>

namespace swirl::apps::plot {

struct PlotOptions {
    std::string record;
    std::string figure;
    std::string kind;  ///< empty: the record's default
    bool json = false;
    bool quiet = false;

    void add_to(CLI::App& command);
};

extern const char* const plot_details;

/// Checks what it can, then becomes the Python script that draws. Returns only by throwing BadInput.
int plot(PlotOptions& options);

}  // namespace swirl::apps::plot
