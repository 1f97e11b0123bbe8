// `swirl plot`: a figure of a record.
#pragma once

#include "apps/command_line/flags.hpp"

#include <string>

namespace swirl::apps::plot {

struct PlotOptions {
    std::string record;
    std::string figure;
    std::string kind;  ///< empty: the record's default
    bool json = false;
    bool quiet = false;
    bool force = false;

    void add_to(Flags& command);
};

extern const char* const plot_details;

/// Checks what it can, then becomes the Python script that draws; of a record without a checksum it runs it in a child
/// process. @return the child's exit code @throws BadInput
int plot(PlotOptions& options);

}  // namespace swirl::apps::plot
