// The errors with which a command ends. Exit codes: docs/command-line.md, "Exit codes".
#pragma once

#include <stdexcept>
#include <string>

namespace swirl::apps {

enum ExitCode : int {
    exit_done = 0,
    exit_bad_input = 2,
    exit_numerical_ending = 3,
    exit_io_failed = 4,
    exit_interrupted = 130,
};

/// Bad arguments or input: one line that names what, its value and what is allowed. Exit 2.
class BadInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace swirl::apps
