#include "apps/sweep/sweep_command.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/number_checks.hpp"
#include "apps/command_line/parallel_pieces.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/command_line/record_input.hpp"
#include "apps/command_line/record_output.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/record/journal.hpp"
#include "apps/record/posix_file.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>

namespace swirl::apps::sweep {

const char* const sweep_details =
    R"(Names the mode of R random starts in every cell of a grid over one to three of alpha, beta, mu, restitution,
inertia-factor, sides and the starts' speed. Run r of a cell is what `swirl classify --seed SEED+r` gives for the cell's
scene. A cell's mean_S (over time), mean_S_per_impact, recurrence_rate and largest_exponent are means over its runs,
mean_S_error the standard error over them. With -o an interrupted sweep (also a killed one) is continued by the same command; a record made with other options is refused.

Examples:
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:9 --grid beta=0.1:0.9:5 --collisions 500
  swirl sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.1:1:4 --runs 2 -o sweep.h5)";

void SweepOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command.add_option("--grid", grid, "NAME=A:B:COUNT, once to three times")->type_name("")->allow_extra_args(false);
    command.add_option("--runs", runs, "random starts in each cell (default 1)")
        ->type_name("R")
        ->transform(whole_number(1, 1'000'000));
    command.add_option("--transient", settings.transient, "impacts before the tail (default 10000)")
        ->type_name("K")
        ->transform(whole_number(0, 1'000'000'000));
    command.add_option("--collisions", settings.collisions, "impacts of the tail, 64 or more (default 10000)")
        ->type_name("K")
        ->transform(whole_number(64, 100'000'000));
    command.add_option("--threshold", settings.recurrence_threshold, "delta of the recurrence rate (default 1e-6)")
        ->type_name("D")
        ->check(finite_number_from(0));
}

namespace {

constexpr std::size_t most_results = 100'000'000;

/// Everything that the results depend on. The scene's gridded parameters stand in the grid.
Settings settings_of(const SweepOptions& options, const std::vector<GridAxis>& grid, const Scene<double>& first) {
    Settings settings{{"swirl_version", std::string(version())}};
    std::vector<std::string> axes;
    for (const auto& axis : grid) axes.push_back(axis.text);
    settings.emplace_back("grid", axes);
    const auto gridded = [&](const std::string& name) { return has_axis(grid, name); };
    for (const auto& parameter : scene_settings(first)) {
        const bool inertia = parameter.first == "inertia_factor";
        if (gridded(inertia ? "inertia-factor" : parameter.first)) continue;
        if (inertia && gridded("sides") && !options.scene.has("inertia-factor"))
            settings.emplace_back("inertia_factor", std::string("uniform"));  // the lamina's, which depends on N
        else
            settings.push_back(parameter);
    }
    settings.emplace_back("runs", options.runs);
    if (!gridded("speed")) settings.emplace_back("speed", options.start.speed());
    settings.emplace_back("seed", options.start.seed());
    settings.emplace_back("transient", options.settings.transient);
    settings.emplace_back("collisions", options.settings.collisions);
    settings.emplace_back("threshold", options.settings.recurrence_threshold);
    settings.emplace_back("accuracy", options.output.accuracy_name);
    return settings;
}

/// The settings as the journal's header.
std::string header_of(const Settings& settings) {
    std::string text;
    for (const auto& [name, value] : settings) {
        text += name + " =";
        std::visit(
            [&](const auto& v) {
                using Value = std::decay_t<decltype(v)>;
                if constexpr (std::is_same_v<Value, double>)
                    text += fmt::format(" {:.17g}", v);
                else if constexpr (std::is_arithmetic_v<Value>)
                    text += fmt::format(" {}", v);
                else if constexpr (std::is_same_v<Value, std::string>)
                    text += " " + v;
                else
                    for (const auto& item : v) text += fmt::format(" {}", item);
            },
            value);
        text += "\n";
    }
    return text;
}

/// The journal of an unfinished record, and which results it brought.
class SweepJournal {
public:
    SweepJournal(const std::string& record, Sweep& sweep, std::vector<char>& done) {
        const std::string header = header_of(sweep.settings);
        const auto bytes = std::as_bytes(std::span(header.data(), header.size()));
        const auto replay = [&](std::uint64_t index, std::span<const std::byte> payload) {
            if (index >= sweep.results.size() || payload.size() != sizeof(RunResult)) return;
            std::memcpy(&sweep.results[index], payload.data(), sizeof(RunResult));
            done[index] = 1;
        };
        try {
            journal_.emplace(journal_path(record), bytes, replay);
        } catch (const JournalMismatch&) {
            throw BadInput(fmt::format(
                "an unfinished sweep with other options lies beside '{}' ({}); give the same options, or remove it",
                record, journal_path(record).filename().string()));
        } catch (const RecordError& error) {
            throw BadInput(error.what());
        }
    }

    /// On the disk twice a second at least.
    void append(std::size_t index, const RunResult& result) {
        journal_->append(index, std::as_bytes(std::span(&result, 1)));
        const auto now = std::chrono::steady_clock::now();
        if (now - flushed_ < std::chrono::milliseconds(500)) return;
        flushed_ = now;
        journal_->flush();
    }
    void flush() { journal_->flush(); }
    void remove() { journal_->remove(); }

private:
    std::optional<Journal> journal_;
    std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

/// Runs everything that is not done; false if interrupted. Results go to their own places, whatever thread makes them.
bool run_all(const SweepOptions& options, Sweep& sweep, std::vector<char>& done, SweepJournal* journal) {
    const auto runs = static_cast<std::size_t>(sweep.runs);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < done.size(); ++i)
        if (!done[i]) left.push_back(i);
    const Accuracy accuracy = options.output.accuracy();
    Progress progress("sweep", static_cast<double>(left.size()), options.output.quiet);
    const bool all = run_pieces(left.size(), options.output.threads, progress, [&](std::size_t i) -> KeepResult {
        const std::size_t index = left[i];
        const Scene<double> scene = cell_scene(options.scene, sweep.grid, index / runs);
        const double speed = cell_speed(options.start.speed(), sweep.grid, index / runs);
        const auto result = sweep_run(scene, speed, options.start.seed(), index % runs, options.settings, accuracy);
        if (!result) return {};
        return [&sweep, &done, journal, index, result] {
            sweep.results[index] = *result;
            done[index] = 1;
            if (journal != nullptr) journal->append(index, *result);
        };
    });
    finish_up();
    if (journal != nullptr) journal->flush();
    return all;
}

void check_all(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    if (!options.start.is_random())
        throw BadInput("a sweep's starts are random: give --speed and --seed, not --x … or --point");
    if (options.start.speed_given() && has_axis(grid, "speed"))
        throw BadInput("--speed and --grid speed=… are two speeds of the same starts: give one of them");
    options.start.require_one_way();
    options.start.require_seeds(static_cast<std::uint64_t>(options.runs));
    options.output.accuracy();  // a wrong name is told before any work
    const double results = static_cast<double>(cell_count(grid)) * static_cast<double>(options.runs);
    if (results > static_cast<double>(most_results))
        throw BadInput(fmt::format("cells x runs = {:.0f} is outside its range: 1 to {}", results, most_results));
    for (std::size_t c = 0; c < cell_count(grid); ++c) {
        const Scene<double> scene = cell_scene(options.scene, grid, c);
        const double speed = cell_speed(options.start.speed(), grid, c);
        flight_from(make_body(scene), random_start(scene.beta, speed, options.start.seed(), 0));
    }
}

/// What can be known of the record before any work.
void check_output(const SweepOptions& options) {
    const std::string& path = options.output.record;
    if (path.empty()) return;
    require_no_input(path, {options.scene.file()});
    if (const auto obstacle = obstacle_to_creating(path))
        throw BadInput(fmt::format("cannot create record '{}': {}", path, *obstacle));
}

/// Writes the record of a finished sweep. What can't be written stays in the journal.
void keep_sweep(const SweepOptions& options, const Sweep& sweep) {
    const std::string& path = options.output.record;
    constexpr auto kept = "the runs are kept: the same command writes them, once it can";
    if (!options.output.force && std::filesystem::exists(path))
        throw RecordError("cannot create record", path,
                          fmt::format("a file of this name has come there meanwhile; {}", kept));
    try {
        write_sweep(options, sweep);
    } catch (const RecordError& error) {
        throw RecordError(fmt::format("{}; {}", error.what(), kept));
    }
}

}  // namespace

int sweep(SweepOptions& options) {
    options.scene.read_file();
    options.start.take_units(options.scene);
    Sweep sweep{grid_from(options.grid), options.runs, {}, {}};
    check_all(options, sweep.grid);
    sweep.settings = settings_of(options, sweep.grid, cell_scene(options.scene, sweep.grid, 0));
    sweep.results.resize(cell_count(sweep.grid) * static_cast<std::size_t>(sweep.runs));
    const std::string& path = options.output.record;
    check_output(options);
    note_interruptions();
    const auto begin = std::chrono::steady_clock::now();
    if (!path.empty() && std::filesystem::exists(path) && !options.output.force) {
        try {
            read_sweep(path, sweep);
            warn_without_checksum(path, options.output.quiet);
        } catch (const RecordError& error) {
            throw BadInput(error.what());
        }
        if (!options.output.quiet) tell(fmt::format("swirl: '{}' holds this sweep already", path));
    } else {
        std::vector<char> done(sweep.results.size(), 0);
        std::optional<SweepJournal> journal;
        if (!path.empty()) journal.emplace(path, sweep, done);
        if (!run_all(options, sweep, done, journal ? &*journal : nullptr)) {
            if (journal && std::count(done.begin(), done.end(), 1) == 0) journal->remove();  // nothing to go on from
            if (journal && !options.output.quiet)
                tell(fmt::format("swirl: interrupted; {} of {} runs are kept: the same command goes on from there",
                                 std::count(done.begin(), done.end(), 1), done.size()));
            return exit_interrupted;
        }
        if (!path.empty()) {
            keep_sweep(options, sweep);
            journal->remove();
        }
    }
    if (options.output.json)
        write_sweep_document(options, sweep);
    else if (!options.output.quiet)
        print_sweep(sweep);
    if (!options.output.quiet && !options.output.json)
        tell(fmt::format("swirl: {:.1f} s",
                         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return exit_done;
}

}  // namespace swirl::apps::sweep
