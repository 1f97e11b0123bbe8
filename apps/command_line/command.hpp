// A subcommand: its flags, and what it does once they are parsed.
#pragma once

#include "apps/command_line/flags.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>

namespace swirl::apps {

/// Adds subcommand `name` whose options live in an `Options` with `void add_to(Flags&)`; `run(options)` gives the
/// exit code. `example` is a command line that runs, shown under --help.
template <class Options, class Run>
std::pair<CLI::App*, std::function<int()>> add_command(CLI::App& app, const std::string& name, const std::string& does,
                                                       const std::string& details, Run run) {
    auto* command = app.add_subcommand(name, does);
    const auto options = std::make_shared<Options>();
    Flags flags(*command);
    options->add_to(flags);
    command->footer(details);
    return {command, [options, run] { return run(*options); }};
}

}  // namespace swirl::apps
