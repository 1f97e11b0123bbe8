// `swirl manual`: the pages of the manual, made from the commands' own definitions.
#pragma once

#include "apps/command_line/flags.hpp"

#include <string>

namespace swirl::apps::manual {

struct ManualOptions {
    CLI::App* program = nullptr;
    std::string page;          ///< the command whose page is printed; empty: the program's
    std::string form = "man";  ///< or "markdown"
    std::string folder;        ///< all pages are written into it

    void add_to(Flags& command);
};

extern const char* const manual_details;

/// @return the exit code @throws BadInput for an unknown command or form, or a folder that can't take the pages
int manual(ManualOptions& options);

}  // namespace swirl::apps::manual
