// The `swirl` command: parses, runs one subcommand, and turns every way of failing into one line and an exit code.
#include "apps/animate/animate_command.hpp"
#include "apps/bifurcate/bifurcate_command.hpp"
#include "apps/boundaries/boundaries_command.hpp"
#include "apps/certify/certify_command.hpp"
#include "apps/classify/classify_command.hpp"
#include "apps/command_line/command.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/command_line/words.hpp"
#include "apps/continue/continue_command.hpp"
#include "apps/describe/describe_command.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/lyapunov/lyapunov_command.hpp"
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

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <system_error>
#include <vector>

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

using Commands = std::vector<std::pair<CLI::App*, std::function<int()>>>;

Commands add_commands(CLI::App& app) {
    const std::string classify_text =
        fmt::format("{}\n\n{}", classify::classify_series_details, classify::classify_details);
    const std::string recurrence_text = fmt::format("{}\n{}", input_details, recurrence::recurrence_details);
    const std::string spectrum_text = fmt::format("{}\n{}", input_details, spectrum::spectrum_details);
    return {
        add_command<simulate::SimulateOptions>(app, "simulate", "follow one orbit, impact by impact",
                                               simulate::simulate_details, simulate::simulate),
        add_command<classify::ClassifyCommandOptions>(app, "classify", "name the mode of a scene, with its evidence",
                                                      classify_text, classify::classify_scene),
        add_command<recurrence::RecurrenceOptions>(app, "recurrence",
                                                   "quantify the recurrences of an orbit or a measured series",
                                                   recurrence_text, recurrence::quantify_recurrence),
        add_command<spectrum::SpectrumOptions>(app, "spectrum", "the power spectrum of an orbit or a measured series",
                                               spectrum_text, spectrum::find_spectrum),
        add_command<lyapunov::LyapunovCommandOptions>(app, "lyapunov", "the whole Lyapunov spectrum of an orbit",
                                                      lyapunov::lyapunov_details, lyapunov::lyapunov),
        add_command<orbits::OrbitsOptions>(app, "orbits", "fixed points and cycles, stable and unstable",
                                           orbits::orbits_details, orbits::orbits),
        add_command<continuation::ContinueOptions>(app, "continue", "branches of a cycle over one parameter",
                                                   continuation::continue_details, continuation::continue_orbit),
        add_command<bifurcate::BifurcateOptions>(app, "bifurcate",
                                                 "what orbits settle on over one parameter, and the branches beneath",
                                                 bifurcate::bifurcate_details, bifurcate::bifurcate),
        add_command<boundaries::BoundariesOptions>(app, "boundaries",
                                                   "curves in two parameters on which cycles bifurcate",
                                                   boundaries::boundaries_details, boundaries::boundaries),
        add_command<sweep::SweepOptions>(app, "sweep", "the modes across parameters", sweep::sweep_details,
                                         sweep::sweep),
        add_command<tradeoff::TradeoffOptions>(app, "tradeoff", "accuracy against cost, measured on a scene",
                                               tradeoff::tradeoff_details, tradeoff::tradeoff),
        add_command<sweep::JoinOptions>(app, "join", "one record of the shards of a sweep", sweep::join_details,
                                        sweep::join),
        add_command<describe::DescribeOptions>(app, "describe", "what is known of a scene in closed form",
                                               describe::describe_details, describe::describe),
        add_command<certify::CertifyOptions>(app, "certify", "prove cycles by interval arithmetic",
                                             certify::certify_details, certify::certify),
        add_command<plot::PlotOptions>(app, "plot", "a figure of a record", plot::plot_details, plot::plot),
        add_command<animate::AnimateOptions>(app, "animate", "a film of an orbit", animate::animate_details,
                                             animate::animate),
        add_command<notebook::NotebookOptions>(app, "notebook", "a notebook of a record, executed",
                                               notebook::notebook_details, notebook::notebook),
        add_command<tour::TourOptions>(app, "tour", "name the modes of a built-in set of scenes", tour::tour_details,
                                       tour::tour),
    };
}

int run_command(const Commands& commands) {
    for (const auto& [command, run] : commands) {
        if (!command->parsed()) continue;
        const int code = run();
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
            return fail(exit_io_failed, "cannot write to standard output");
        return code;
    }
    return fail(exit_bad_input, "no command given; swirl --help lists them");
}

/// --help and --version.
int print_help(const CLI::App& app, const CLI::Success& success) {
    app.exit(success);
    if (!std::cout.flush()) return fail(exit_io_failed, "cannot write to standard output");
    return exit_done;
}

/// Runs the command that was called; every way of failing becomes one line and an exit code.
int run_or_fail(const Commands& commands) {
    try {
        return run_command(commands);
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
    CLI::App app{
        "Swirl: a rigid polygon or disk in a swirled circular container, followed exactly from one collision "
        "to the next, and its mode named."};
    app.set_version_flag("--version", fmt::format("swirl {} ({})", version(), instruction_set()));
    app.require_subcommand(0, 1);
    const Commands commands = add_commands(app);
    app.footer(path_through_commands);
    try {
        check_words(app, std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return print_help(app, success);
    } catch (const BadInput& error) {
        return fail(exit_bad_input, error.what());
    } catch (const CLI::ParseError& error) {
        return fail(exit_bad_input, error.what());
    }
    const int code = run_or_fail(commands);
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
