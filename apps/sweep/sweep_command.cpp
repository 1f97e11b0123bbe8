#include "apps/sweep/sweep_command.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/number_checks.hpp"
#include "apps/command_line/record_input.hpp"
#include "apps/command_line/record_output.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/sweep/run_cells.hpp"
#include "apps/sweep/starts.hpp"
#include "apps/sweep/tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

namespace swirl::apps::sweep {

const char* const sweep_details =
    R"(A grid goes over one to five of alpha, beta, mu, restitution, inertia-factor, sides, law (a list) and the starts' speed; in
every cell the modes of R random starts are named. Or it goes over numbers of the start (x, y, vx, vy, angle, spin; in R_c,
R_c omega_s, radians, omega_s, or in SI units): every cell has one start, and the map is one of basins of attraction. Run r
of a cell is what `swirl classify --seed SEED+r` gives for the cell's scene: an orbit is followed until its verdict is
settled, at most through --transient and --collisions. A cell's mean_S (over time), mean_S_per_impact, recurrence_rate and largest_exponent are means over its runs,
mean_S_error the standard error over them (of one run of chaos its own, by blocks). Each cell also lists the attracting steady modes that follow from the scene's
equations, with their shares of the runs: 0 of one that no start came to. A document lists what the runs of each cell came to
(attractors), with Wilson's intervals. --grid law=NAME,NAME goes over impact laws, not with --refine. With -o an interrupted sweep (also a killed one) is continued by the same command; a record made with other options is refused.

--refine LEVELS halves the steps of the grid so often where the verdicts (mode, kind, period of most runs) of neighbours
differ; the record is that of the full grid, in which cells that were not looked at (`visited` 0) have their neighbour's
results. --sample takes points that fill the box in place of a grid: Sobol's sequence, or a Latin hypercube by --seed.
--track follows each attractor over the grid: a cycle of up to 64 impacts is carried to the next cell by Newton's method and
is the attractor there to which it comes, if that one leads back to it; chaos, tori and motions on the wall are one where
each of the two cells has one of them. Attractors get a number, track, in document and record; `swirl plot` draws the shares by it.
--saddles PLACES, of a map of basins: between neighbouring starts that came to different attractors, at so many places evenly
spread, the boundary is found to 1e-12 of a step and followed to the unstable cycle or torus whose stable set it is, or to a
border, where the map jumps: saddles with their multipliers and how many places lead to each (the other endings: docs/command-line.md).
--shard i/n does the i-th of n parts; `swirl join` makes the record of the whole of them.

Examples:
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:9 --grid beta=0.1:0.9:5 --collisions 500
  swirl sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.1:1:4 --runs 2 -o sweep.h5
  swirl sweep --sides 6 --alpha 0.5 --beta 0.5 --mu 0.5 --restitution 0.95 --grid vx=-1:1:9 --grid vy=-1:1:9 -o basins.h5
  swirl sweep --sides 6 --alpha 0.5 --beta 0.5 --mu 0.5 --restitution 0.95 --grid vx=-1:1:9 --grid vy=-1:1:9 --saddles 4
  swirl sweep --sides 6 --alpha 0.4 --beta 0.5 --grid law=poisson,newton,stronge --grid mu=0.1:1:4 --grid restitution=0.5:1:5
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.8:4 --grid beta=0.1:0.9:4 --refine 2 --collisions 500
  swirl sweep --sides 6 --alpha 0.5 --mu 0.5 --restitution 0.95 --grid beta=0.45:0.55:11 --runs 20 --track)";

void SweepOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command.add_option("--grid", grid, "NAME=A:B:COUNT, once to five times; with --sample NAME=A:B; law=NAME,NAME,...")
        ->type_name("")
        ->offer(axes_to_offer())
        ->allow_extra_args(false);
    command.add_option("--refine", refine, "halve the grid's steps so often, where neighbours differ")
        ->type_name("LEVELS")
        ->transform(whole_number(1, most_levels));
    command.add_option("--sample", sample, "sobol:COUNT or latin:COUNT points in place of a grid")
        ->type_name("")
        ->offer({"sobol:", "latin:"});
    command.add_flag("--track", track, "follow each attractor from cell to cell of a grid of random starts");
    command.add_option("--saddles", saddles, "follow so many places on the boundaries of basins to their saddles")
        ->type_name("PLACES")
        ->transform(whole_number(1, 10'000));
    command.add_option("--shard", shard, "i/n: the i-th of n shards of the cells, for swirl join")->type_name("");
    command.add_option("--runs", runs, "random starts in each cell (default 1)")
        ->type_name("R")
        ->transform(whole_number(1, 1'000'000));
    command.add_option("--transient", settings.transient, "impacts before the tail, at most (default 10000)")
        ->type_name("K")
        ->transform(whole_number(0, 1'000'000'000));
    command.add_option("--collisions", settings.collisions, "impacts of the tail, at most; 64 or more (default 10000)")
        ->type_name("K")
        ->transform(whole_number(64, 100'000'000));
    command.add_flag("--exhaustive", settings.exhaustive,
                     "follow every orbit through all of these impacts, whatever its verdict needs");
    command.add_option("--threshold", settings.recurrence_threshold, "delta of the recurrence rate (default 1e-6)")
        ->type_name("D")
        ->check(finite_number_from(0));
}

namespace {

constexpr std::size_t most_results = 100'000'000;

/// What a flag says of a parameter that the grid varies: the grid wins, but a value that is none is told.
void check_beside(const SweepOptions& options, const std::vector<GridAxis>& grid, const GridAxis& axis) {
    if (options.scene.flag(axis.name, "").empty()) return;
    if (axis.has_words()) throw BadInput("--law and --grid law=… are both given: give one of them");
    std::vector<GridAxis> others = grid;
    std::erase_if(others, [&](const GridAxis& other) { return other.name == axis.name; });
    cell_scene(options.scene, others, 0);
}

void check_all(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    require_starts(options.start, grid, options.runs);
    for (const GridAxis& axis : grid) check_beside(options, grid, axis);
    options.start.require_seeds(static_cast<std::uint64_t>(options.runs));
    options.output.accuracy();  // a wrong name is told before any work
    const double results = static_cast<double>(cell_count(grid)) * static_cast<double>(options.runs);
    if (results > static_cast<double>(most_results))
        throw BadInput(fmt::format("cells x runs = {:.0f} is outside its range: 1 to {}", results, most_results));
    for (std::size_t c = 0; c < cell_count(grid); ++c) {
        const Scene<double> scene = cell_scene(options.scene, grid, c);
        flight_from(make_body(scene), cell_start(options.start, scene, grid, c, 0));
    }
}

/// Tracks lead from cell to cell of random starts that were all looked at.
void require_trackable(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    const auto refuse = [](const char* other, const char* why) {
        throw BadInput(fmt::format("{} and track are both given: {}", other, why));
    };
    if (!options.sample.empty()) refuse("sample", "a sample has no neighbours");
    if (options.refine > 0) refuse("refine", "cells that are not looked at have no attractors of their own");
    if (!options.shard.empty()) refuse("shard", "neighbours of its cells are in other shards");
    if (starts_are_placed(grid)) refuse("a grid over the start", "its cells have one start each, and one attractor");
}

/// Boundaries of basins lie between neighbouring starts of one scene.
void require_boundaries(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    const auto refuse = [&](const char* why) { throw BadInput(fmt::format("saddles = {}: {}", options.saddles, why)); };
    if (!are_all_of_the_start(grid)) refuse("boundaries of basins are those of a grid over numbers of the start alone");
    if (!options.sample.empty()) refuse("the starts of a sample have no neighbours");
    if (!options.shard.empty()) refuse("neighbours of a shard's cells are in other shards");
}

/// What is found from the results of all runs. False if interrupted.
bool look_into_results(const SweepOptions& options, Sweep& sweep) {
    if (!find_steady_modes(options, sweep)) return false;
    if (options.track && !track_attractors(options, sweep)) return false;
    find_basins(sweep);
    return find_saddles(options, sweep);
}

/// What can be known of the record before any work.
void check_output(const SweepOptions& options) {
    require_no_input(options.output.record, {options.scene.file()});
    require_creatable(options.output);
}

/// Writes the record of a finished sweep. What can't be written stays in the journal.
void keep_sweep(const SweepOptions& options, const Sweep& sweep) {
    const std::string& path = options.output.record;
    constexpr auto kept = "the runs are kept: the same command writes them, once it can";
    if (!options.output.force && std::filesystem::exists(path))
        throw RecordError("cannot create record", path,
                          fmt::format("a file of this name has come there meanwhile; {}", kept));
    try {
        sweep.shard ? write_shard(options, sweep) : write_sweep(options, sweep);
    } catch (const RecordError& error) {
        throw RecordError(fmt::format("{}; {}", error.what(), kept));
    }
}

/// What is to be done; nothing is yet. @throws BadInput
Sweep planned(SweepOptions& options) {
    options.scene.read_file();
    options.start.take_from(options.scene);
    if (options.refine > 0 && !options.sample.empty())
        throw BadInput("refine and sample are both given: a sample has no neighbours");
    if (options.refine > 0 && !options.shard.empty())
        throw BadInput("refine and shard are both given: what is refined depends on cells of the other shards");
    GridForm form{{}, options.start.seed(), options.refine};
    if (!options.sample.empty()) form.sample = sample_from(options.sample);
    Sweep sweep;
    sweep.grid = grid_from(grid_without_units(options.grid, options.scene.units()), form);
    if (options.track) require_trackable(options, sweep.grid);
    if (options.saddles > 0) require_boundaries(options, sweep.grid);
    sweep.runs = options.runs;
    sweep.units = options.scene.units();
    check_all(options, sweep.grid);
    sweep.settings = settings_of(options, sweep.grid);
    if (!options.shard.empty()) take_shard(shard_from(options.shard), sweep);
    if (!options.shard.empty() && options.output.record.empty())
        throw BadInput(fmt::format("shard = {}: a shard is written for swirl join: -o is missing", options.shard));
    return sweep;
}

int sweep_grid(SweepOptions& options, HandOut& hand_out) {
    Sweep sweep = planned(options);
    sweep.results.resize(cell_count(sweep.grid) * static_cast<std::size_t>(sweep.runs));
    const std::string& path = options.output.record;
    check_output(options);
    note_interruptions();
    const auto begin = std::chrono::steady_clock::now();
    if (!path.empty() && std::filesystem::exists(path) && !options.output.force) {
        try {
            sweep.shard ? read_shard(path, sweep) : read_sweep(path, sweep);
            warn_without_checksum(path, options.output.quiet);
        } catch (const RecordError& error) {
            throw BadInput(error.what());
        }
        if (!options.output.quiet) tell(fmt::format("swirl: '{}' holds this sweep already", path));
        if (!look_into_results(options, sweep)) return exit_interrupted;
    } else {
        std::vector<char> done(sweep.results.size(), 0);
        std::optional<SweepJournal> journal;
        if (!path.empty()) journal.emplace(path, sweep, done);
        const bool all =
            run_all(options, sweep, done, journal ? &*journal : nullptr, hand_out) && look_into_results(options, sweep);
        finish_up();
        if (!all) {
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
        write_sweep_document(sweep);
    else if (!options.output.quiet)
        print_sweep(sweep);
    if (!options.output.quiet && !options.output.json)
        tell(fmt::format("swirl: {:.1f} s",
                         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return exit_done;
}

}  // namespace

int sweep(SweepOptions& options) {
    return on_all_ranks(
        options.output.quiet, options.output.threads, [&] { return work_of(options, planned(options)); },
        [&](HandOut& hand_out) { return sweep_grid(options, hand_out); });
}

}  // namespace swirl::apps::sweep
