// One command in the interpreter's process: the words of its command line, and what it gives.
#pragma once

#include "apps/command_line/definitions.hpp"

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace swirl::python {

struct CommandResult {
    int code = 0;                       ///< docs/command-line.md, "Exit codes"
    std::vector<std::string> text;      ///< that the command prints on standard output, in pieces
    std::vector<std::string> messages;  ///< and on standard error
    std::string failure;                ///< its one line; empty: none
    std::exception_ptr raised;          ///< by a signal's handler or by `look`, which stopped it; none: nothing
};

/// Told the task at hand, its total and how much of it is done. May throw, which stops the command.
using Look = std::function<void(const std::string& task, double total, double done)>;

/// Runs `swirl WORDS…`. Called with the interpreter's lock, which others have meanwhile. A signal whose handler throws,
/// as Ctrl-C's does, stops it, and it comes back within half a second with what is finished.
CommandResult run_command(const std::vector<std::string>& words, const Look& look);

/// All commands with their flags.
apps::ProgramDefinition definition();

}  // namespace swirl::python
