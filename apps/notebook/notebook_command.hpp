// `swirl notebook`: a notebook of a record, executed.
#pragma once

#include "apps/scripts/script_command.hpp"

namespace swirl::apps::notebook {

struct NotebookOptions {
    scripts::ScriptFiles files;

    void add_to(Flags& command);
};

extern const char* const notebook_details;

/// notebook_of_record.py. @return its exit code @throws BadInput
int notebook(NotebookOptions& options);

}  // namespace swirl::apps::notebook
