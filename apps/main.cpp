// The `swirl` command: parses, runs one subcommand, and turns every way of failing into one line and an exit code.
#include "apps/command_line/documents.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/program.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/commands.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/record/record_error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace swirl::apps {
namespace {

int fail(int code, const std::string& message) {
    // One line, whatever a library put into its message.
    std::string line = message;
    for (char& c : line)
        if (c == '\n') c = ' ';
    report("swirl: " + line);
    return code;
}

/// What could not be printed. Whoever closed a pipe that is printed into wants no more, not even a message.
int fail_to_print(const std::string& message) {
    const bool is_silent = std::ferror(stdout) != 0 && reader_of_output_has_gone();
    return is_silent ? exit_io_failed : fail(exit_io_failed, message);
}

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
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return fail_to_print("cannot write to standard output");
    return code;
}

/// Runs the command that was called; every way of failing becomes one line and an exit code.
int run_or_fail(Program& program, int argc, char** argv) {
    try {
        return run_command(program, argc, argv);
    } catch (const BadInput& error) {
        return fail(exit_bad_input, error.what());
    } catch (const std::invalid_argument& error) {
        return fail(exit_bad_input, error.what());
    } catch (const RecordError& error) {
        return fail(exit_io_failed, error.what());
    } catch (const JsonError& error) {
        return fail_to_print(error.what());
    } catch (const std::system_error& error) {  // fmt, when a line can't be printed
        return fail_to_print(error.what());
    } catch (const std::bad_alloc&) {
        return fail(exit_io_failed, "out of memory");
    } catch (const std::exception& error) {  // an error of a library that no command expects
        return fail(exit_numerical_ending, fmt::format("unexpected: {}", error.what()));
    }
}

int run(int argc, char** argv) {
    Program program(
        "Swirl follows a rigid polygon or disk in a swirled circular container exactly from one collision to the "
        "next, and names its mode.",
        fmt::format("swirl {} ({})", version(), instruction_set()), path_through_commands);
    add_commands(program);
    const int code = run_or_fail(program, argc, argv);
    if (is_interrupted()) {  // pieces of work may still be running: what they use stays until the end
        std::fflush(nullptr);
        std::_Exit(code);
    }
    return code;
}

}  // namespace
}  // namespace swirl::apps

int main(int argc, char** argv) {
    swirl::apps::keep_freed_memory();
    swirl::apps::prepare_standard_streams();
    swirl::apps::exit_when_interrupted();
    return swirl::apps::run(argc, argv);
}
