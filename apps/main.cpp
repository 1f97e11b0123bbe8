// The `swirl` command: parses, runs one subcommand, and turns every way of failing into one line and an exit code.
#include "apps/animate/animate_command.hpp"
#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/boundaries/boundaries_command.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/classify/classify_command.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/program.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/completion/completion_command.hpp"
#include "apps/continue/continue_command.hpp"
#include "apps/describe/describe_command.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/lyapunov/lyapunov_command.hpp"
#include "apps/manual/manual_command.hpp"
#include "apps/notebook/notebook_command.hpp"
#include "apps/orbits/orbits_command.hpp"
#include "apps/plot/plot_command.hpp"
#include "apps/record/record_error.hpp"
#include "apps/recurrence/recurrence_command.hpp"
#include "apps/simulate/simulate.hpp"
#include "apps/spectrum/spectrum_command.hpp"
#include "apps/sweep/sweep_command.hpp"
#include "apps/tour/tour.hpp"
#include "apps/tradeoff/tradeoff_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <system_error>

namespace swirl::apps {
namespace {

int fail(int code, const std::string& message) {
    // One line, whatever a library put into its message.
    std::string line = message;
    for (char& c : line)
        if (c == '\n') c = ' ';
    tell("swirl: " + line);
    return code;
}

/// Under --help.
const char* const path_through_commands =
    R"(The path:  simulate -> classify -> sweep         one orbit; its mode; the modes over parameters
           orbits -> continue -> bifurcate      cycles; their branches over a parameter; attractors and branches
           plot, animate, notebook              the figure, film or notebook of any record (-o FILE.h5)
`swirl COMMAND --help` ends with an example that runs:  swirl tour  names the modes of built-in scenes.)";

void add_commands(Program& program) {
    const std::string classify_text =
        fmt::format("{}\n\n{}", classify::classify_series_details, classify::classify_details);
    const std::string recurrence_text = fmt::format("{}\n{}", input_details, recurrence::recurrence_details);
    const std::string spectrum_text = fmt::format("{}\n{}", input_details, spectrum::spectrum_details);
    program.add_command<simulate::SimulateOptions>("simulate", "follow one orbit, impact by impact",
                                                   simulate::simulate_details, simulate::simulate);
    program.add_command<classify::ClassifyCommandOptions>("classify", "name the mode of a scene, with its evidence",
                                                          classify_text, classify::classify_scene);
    program.add_command<recurrence::RecurrenceOptions>("recurrence",
                                                       "quantify the recurrences of an orbit or a measured series",
                                                       recurrence_text, recurrence::quantify_recurrence);
    program.add_command<spectrum::SpectrumOptions>("spectrum", "the power spectrum of an orbit or a measured series",
                                                   spectrum_text, spectrum::find_spectrum);
    program.add_command<lyapunov::LyapunovCommandOptions>("lyapunov", "the whole Lyapunov spectrum of an orbit",
                                                          lyapunov::lyapunov_details, lyapunov::lyapunov);
    program.add_command<orbits::OrbitsOptions>("orbits", "fixed points and cycles, stable and unstable",
                                               orbits::orbits_details, orbits::orbits);
    program.add_command<continuation::ContinueOptions>("continue", "branches of a cycle over one parameter",
                                                       continuation::continue_details, continuation::continue_orbit);
    program.add_command<bifurcate::BifurcateOptions>(
        "bifurcate", "what orbits settle on over one parameter, and the branches beneath", bifurcate::bifurcate_details,
        bifurcate::bifurcate);
    program.add_command<boundaries::BoundariesOptions>("boundaries",
                                                       "curves in two parameters on which cycles bifurcate",
                                                       boundaries::boundaries_details, boundaries::boundaries);
    program.add_command<sweep::SweepOptions>("sweep", "the modes across parameters", sweep::sweep_details,
                                             sweep::sweep);
    program.add_command<tradeoff::TradeoffOptions>("tradeoff", "accuracy against cost, measured on a scene",
                                                   tradeoff::tradeoff_details, tradeoff::tradeoff);
    program.add_command<sweep::JoinOptions>("join", "one record of the shards of a sweep", sweep::join_details,
                                            sweep::join);
    program.add_command<describe::DescribeOptions>("describe", "what is known of a scene in closed form",
                                                   describe::describe_details, describe::describe);
    program.add_command<certify::CertifyOptions>("certify", "prove cycles by interval arithmetic",
                                                 certify::certify_details, certify::certify);
    program.add_command<plot::PlotOptions>("plot", "a figure of a record", plot::plot_details, plot::plot);
    program.add_command<animate::AnimateOptions>("animate", "a film of an orbit", animate::animate_details,
                                                 animate::animate);
    program.add_command<notebook::NotebookOptions>("notebook", "a notebook of a record, executed",
                                                   notebook::notebook_details, notebook::notebook);
    program.add_command<tour::TourOptions>("tour", "name the modes of a built-in set of scenes", tour::tour_details,
                                           tour::tour);
    program.add_command<manual::ManualOptions>("manual", "a page of the manual", manual::manual_details,
                                               manual::manual);
    program.add_command<completion::CompletionOptions>("completion", "the script by which a shell completes words",
                                                       completion::completion_details, completion::completion);
}

int run_command(Program& program, int argc, char** argv) {
    const int code = program.called(argc, argv)();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        return fail(exit_io_failed, "cannot write to standard output");
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
        return fail(exit_io_failed, error.what());
    } catch (const std::system_error& error) {  // fmt, when a line can't be printed
        return fail(exit_io_failed, error.what());
    } catch (const std::bad_alloc&) {
        return fail(exit_io_failed, "out of memory");
    } catch (const std::exception& error) {  // an error of a library that no command expects
        return fail(exit_numerical_ending, fmt::format("unexpected: {}", error.what()));
    }
}

int run(int argc, char** argv) {
    Program program(
        "Swirl: a rigid polygon or disk in a swirled circular container, followed exactly from one collision "
        "to the next, and its mode named.",
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
    swirl::apps::prepare_standard_streams();
    swirl::apps::exit_when_interrupted();
    return swirl::apps::run(argc, argv);
}
