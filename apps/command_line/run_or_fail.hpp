// Every way in which a command may fail, as one line and an exit code.
#pragma once

#include <functional>
#include <string>

namespace swirl::apps {

struct Failure {
    int code;             ///< docs/command-line.md, "Exit codes"
    std::string line;     ///< without an end, whatever a library put into its message
    bool is_of_printing;  ///< what was written on standard output could not be
};

/// What `run` gives, or where it throws the exit code of that failure, of which `tell` is told first.
int run_or_fail(const std::function<int()>& run, const std::function<void(const Failure&)>& tell);

}  // namespace swirl::apps
