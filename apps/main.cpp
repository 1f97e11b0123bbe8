// The `swirl` command: parses, runs one subcommand, and turns every way of failing into one line and an exit code.
#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/program.hpp"
#include "apps/command_line/run_or_fail.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/commands.hpp"
#include "apps/json/json_writer.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace swirl::apps {
namespace {

/// One line of it. Whoever closed a pipe that is printed into wants no more, not even a message.
void tell(const Failure& failure) {
    const bool is_silent = failure.is_of_printing && std::ferror(stdout) != 0 && reader_of_output_has_gone();
    if (!is_silent) report("swirl: " + failure.line);
}

const char* const swirl_in_words =
    "Swirl follows a rigid polygon or disk in a swirled circular container exactly from one collision to the next, and "
    "names its mode.";

/// Under --help.
const char* const path_through_commands =
    R"(Where to begin:
  simulate -> classify -> sweep    one orbit; its mode; the modes over parameters
  orbits -> continue -> bifurcate  cycles; their branches over a parameter; attractors and branches
  plot, animate, notebook          the figure, film or notebook of any record (-o FILE.h5)
  explore                          a page of a sweep or a diagram, in which the map runs
`swirl COMMAND --help` (or `swirl help COMMAND`) ends with an example that runs. `swirl tour` names the modes of built-in
scenes.)";

/// Runs of a sweep take and free a megabyte each. glibc would return it to the system every time, which then clears it
/// page by page for the next: a sixth of a sweep's time.
void keep_freed_memory() {
#if defined(__GLIBC__)
    ::mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes; the most that glibc takes: longer blocks go back as they did
    ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
    ::mallopt(M_TOP_PAD, 16 << 20);
#endif
}

int run_command(Program& program, int argc, char** argv) {
    const int code = program.called(argc, argv)();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) throw JsonError("cannot write to standard output");
    return code;
}

int run(int argc, char** argv) {
    Program program(swirl_in_words, fmt::format("swirl {} ({})", version(), instruction_set()), path_through_commands);
    add_commands(program);
    const int code = run_or_fail([&] { return run_command(program, argc, argv); }, tell);
    if (is_interrupted()) {  // pieces of work may still be running: what they use stays until the end
        std::fflush(nullptr);
        std::_Exit(code);
    }
    return code;
}

// What nohup has set is asked before the constructors of shared libraries run: one may take SIGHUP for itself, as that
// of UCX does (findings/hangup_of_ucx.sh). Sanitizers are not ready that early.
#if !defined(SWIRL_SANITIZED)
[[gnu::section(".preinit_array"), gnu::used]] void (*asked_first)() = keep_ignored_hangup;
#endif

}  // namespace
}  // namespace swirl::apps

int main(int argc, char** argv) {
    swirl::apps::keep_freed_memory();
    swirl::apps::prepare_standard_streams();
    swirl::apps::exit_when_interrupted();
    return swirl::apps::run(argc, argv);
}
