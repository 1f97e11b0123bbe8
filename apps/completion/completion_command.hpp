// `swirl completion`: what a shell needs to complete swirl's words, made from the commands' own definitions.
#pragma once

#include "apps/command_line/flags.hpp"

#include <string>

namespace swirl::apps::completion {

struct CompletionOptions {
    CLI::App* program = nullptr;
    std::string shell;

    void add_to(Flags& command);
};

extern const char* const completion_details;

/// @return the exit code @throws BadInput for a shell that is none of those known
int completion(CompletionOptions& options);

}  // namespace swirl::apps::completion
