#include "apps/sweep/sweep_command.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/modes/classify_flags.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/sweep/run_cells.hpp"
#include "apps/sweep/scenes_file.hpp"
#include "apps/sweep/start_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace swirl::apps::sweep {

const char* const sweep_details =
    R"(Names the modes of R random starts in every cell of a grid over one to five of alpha, beta, mu, restitution, inertia-factor,
sides, drag, spin-drag, floor-friction, gravity-ratio, tangential-restitution, corner, law and the starts' speed: NAME=A:B:COUNT,
NAME=A:B:COUNT:log (by logarithms), or a list NAME=V,V,... (laws, sides with a disk: sides=3,6,disk; lists do not go with --refine). A grid over numbers of the start (x, y, vx, vy, angle, spin; in
R_c, R_c omega_s, radians, omega_s, or in SI units) gives a map of basins of attraction: every cell has one start.
--scenes FILE.csv takes a scene from each row in place of a grid; its columns are named as the flags.

Run r of a cell is what `swirl classify --seed SEED+r` gives for the cell's scene: an orbit is followed until its verdict is
settled, at most through --transient and --collisions. mean_S (over time), mean_S_per_impact, recurrence_rate and
largest_exponent of a cell are means over its runs; mean_S_error is the standard error over the runs (of one run of chaos
its own, by blocks). A document lists what the runs of each cell came to (attractors), with Wilson's intervals, and the
attracting steady modes that follow from the scene's equations, with their shares of the runs: 0 where no start came to one.

The same command with -o continues an interrupted sweep (also a killed one), and adds runs to a finished one if --runs is
larger; the record is the one made at once. A record made with other options is refused.

  --refine LEVELS   halves the grid's steps so often where the verdicts (mode, kind, period of most runs) of
                    neighbours differ. Cells without runs (`visited` 0) have their neighbour's results.
  --sample          takes points that fill the box: Sobol's sequence, or a Latin hypercube by --seed.
  --track           follows each attractor over the grid and numbers it (`track`). A cycle of up to 64 impacts
                    is carried to the next cell by Newton's method; it is the attractor there to which it
                    comes, if that one leads back to it. Chaos, tori and motions on the wall are one where
                    each of two neighbouring cells has one of them. `swirl plot` draws shares.
  --saddles COUNT   finds the boundary of basins between neighbouring starts, at COUNT points evenly spread,
                    to 1e-12 of a step, and follows it to the unstable cycle or torus whose stable set it is,
                    or to a border, where the map jumps. It lists these saddles with their multipliers and
                    the number of points that lead to each (docs/command-line.md: other endings).
  --risk P          calls chaos early where all runs of a cell are chaotic and their mean exponent is large enough
                    that less than a share P of such runs has another verdict at the limits (95 %). A random
                    sample, followed to them, tells how large. All other verdicts are those without it.
  --shard i/n       does the i-th of n parts; `swirl join` makes the record of the whole of them.

Examples:
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:9 --grid beta=0.1:0.9:5 --collisions 500
  swirl sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.1:1:4 --runs 2 -o sweep.h5
  swirl sweep --sides 6 --alpha 0.5 --beta 0.5 --mu 0.5 --restitution 0.95 --grid vx=-1:1:9 --grid vy=-1:1:9 -o basins.h5
  swirl sweep --sides 6 --alpha 0.5 --beta 0.5 --mu 0.5 --restitution 0.95 --grid vx=-1:1:9 --grid vy=-1:1:9 --saddles 4
  swirl sweep --sides 6 --alpha 0.4 --beta 0.5 --grid law=poisson,newton,stronge --grid mu=0.1:1:4 --grid restitution=0.5:1:5
  swirl sweep --alpha 0.4 --beta 0.5 --restitution 0.9 --grid sides=3,6,disk --grid mu=0.001:1:4:log --collisions 500
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.8:4 --grid beta=0.1:0.9:4 --refine 2 --collisions 500
  swirl sweep --sides 6 --alpha 0.5 --mu 0.5 --restitution 0.95 --grid beta=0.45:0.55:11 --runs 20 --track
  swirl sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.1:0.4:7 --grid beta=0.1:0.9:5 --runs 20 --risk 0.05)";

void SweepOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command
        .add_option(
            "--grid", grid, "",
            "NAME=A:B:COUNT, NAME=A:B:COUNT:log or NAME=V,V,..., once to five times; with --sample without COUNT")
        ->offer(axes_to_offer())
        ->allow_extra_args(false);
    add_whole_number(command, "--refine", refine, "LEVELS", 1, most_levels,
                     "halve the grid's steps so often, where neighbours differ");
    command.add_option("--sample", sample, "", "sobol:COUNT or latin:COUNT points in place of a grid")
        ->offer({"sobol:", "latin:"});
    add_file(command, "--scenes", scenes, "FILE.csv", "a scene in each row in place of a grid, columns named as flags");
    command.add_flag("--track", track, "follow each attractor from cell to cell of a grid of random starts");
    add_whole_number(command, "--saddles", saddles, "COUNT", 1, 10'000,
                     "follow so many points on the boundaries of basins to their saddles");
    command.add_option("--shard", shard, "", "i/n: the i-th of n shards of the cells, for swirl join");
    add_whole_number(command, "--runs", runs, "R", 1, 1'000'000, "random starts in each cell (default 1)");
    add_classify_flags(command, settings);
    add_risk_flags(command, risk, error);
}

namespace {

constexpr std::size_t most_results = 100'000'000;

/// What a flag says of a parameter that the grid varies: the grid wins, but a value that is no number is reported.
void check_beside(const SweepOptions& options, const std::vector<GridAxis>& grid, const GridAxis& axis) {
    if (options.scene.flag(axis.name, "").empty()) return;
    if (axis.name == "law") throw BadInput("--law and --grid law=… are both given: give one of them");
    std::vector<GridAxis> others = grid;
    std::erase_if(others, [&](const GridAxis& other) { return other.name == axis.name; });
    scene_of_cell(options.scene, others, 0);
}

/// @throws BadInput, of a table of scenes naming the row
void check_cell(const SweepOptions& options, const std::vector<GridAxis>& grid, std::size_t c,
                std::optional<GridStudy>& study) {
    try {
        if (!study) study = study_of(options, grid);
        const Scene<double> scene = cell_scene(*study, c);
        flight_from(make_body(scene), cell_start(*study, scene, c, 0));
    } catch (const std::exception& error) {
        if (options.scenes.empty()) throw;
        throw BadInput(fmt::format("scenes '{}', scene {}: {}", options.scenes, c + 1, error.what()));
    }
}

void check_all(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    require_starts(options.start, grid, options.runs);
    check_risk(options.risk, options.error, options.settings.exhaustive);
    for (const GridAxis& axis : grid) check_beside(options, grid, axis);
    options.start.require_seeds(static_cast<std::uint64_t>(options.runs));
    options.output.accuracy();  // a wrong name is reported before any work
    const double results = static_cast<double>(cell_count(grid)) * static_cast<double>(options.runs);
    if (results > static_cast<double>(most_results))
        throw BadInput(fmt::format("cells x runs = {:.0f} is outside its range: 1 to {}", results, most_results));
    std::optional<GridStudy> study;  // made with the first cell, whose faults it has
    for (std::size_t c = 0; c < cell_count(grid); ++c) check_cell(options, grid, c, study);
}

/// Tracks lead from cell to cell of random starts that were all looked at.
void require_trackable(const SweepOptions& options, const std::vector<GridAxis>& grid) {
    const auto refuse = [](const char* other, const char* why) {
        throw BadInput(fmt::format("{} and track are both given: {}", other, why));
    };
    if (!options.sample.empty()) refuse("sample", "a sample has no neighbours");
    if (options.refine > 0) refuse("refine", "cells without runs of their own have no attractors to follow");
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

/// What can be known of the record before any work.
void check_output(const SweepOptions& options) {
    require_no_input(options.output.record, {options.scene.file(), options.scenes});
    require_creatable(options.output);
}

/// Writes the record of a finished sweep. What can't be written stays in the journal.
///   extends  the record that is there, with fewer runs
void keep_sweep(const SweepOptions& options, const Sweep& sweep, bool extends) {
    const std::string& path = options.output.record;
    constexpr auto kept = "the runs are kept: the same command writes them, once it can";
    if (!options.output.force && !extends && std::filesystem::exists(path))
        throw RecordError("cannot create record", path,
                          fmt::format("a file of this name has come there meanwhile; {}", kept));
    try {
        sweep.shard ? write_shard(options, sweep) : write_sweep(options, sweep);
    } catch (const RecordError& error) {
        throw RecordError(fmt::format("{}; {}", error.what(), kept));
    }
}

/// A table of scenes stands in place of what makes cells.
void require_scenes_alone(const SweepOptions& options) {
    const auto refuse = [](const char* other, const char* why) {
        throw BadInput(fmt::format("scenes and {} are both given: {}", other, why));
    };
    if (!options.grid.empty()) refuse("grid", "a table's rows are the cells");
    if (!options.sample.empty()) refuse("sample", "a table's rows are the cells");
    if (options.refine > 0) refuse("refine", "scenes of a table have no neighbours");
    if (options.track) refuse("track", "scenes of a table have no neighbours");
    if (options.saddles > 0) refuse("saddles", "scenes of a table have no neighbours");
}

std::vector<GridAxis> planned_grid(const SweepOptions& options) {
    GridForm form{{}, options.start.seed(), options.refine, 0};
    if (!options.scenes.empty()) {
        require_scenes_alone(options);
        const ScenesFile scenes = read_scenes(options.scenes);
        form.scenes = scenes.rows;
        return grid_from(grid_without_units(scenes.columns, options.scene.units()), form);
    }
    if (!options.sample.empty()) form.sample = sample_from(options.sample);
    return grid_from(grid_without_units(options.grid, options.scene.units()), form);
}

/// What is to be done; nothing is yet. @throws BadInput
Sweep plan(SweepOptions& options) {
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    if (options.refine > 0 && !options.sample.empty())
        throw BadInput("refine and sample are both given: a sample has no neighbours");
    if (options.refine > 0 && !options.shard.empty())
        throw BadInput("refine and shard are both given: what is refined depends on cells of the other shards");
    Sweep sweep;
    sweep.grid = planned_grid(options);
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

/// What a record of the same name holds of this sweep. True if that is all. @throws BadInput if it is another's
bool read_what_is_there(const SweepOptions& options, Sweep& sweep, std::vector<char>& done) {
    const std::string& path = options.output.record;
    try {
        const bool whole = sweep.shard ? read_shard(path, sweep, done) : read_sweep(path, sweep, done);
        warn_without_checksum(path, options.output.quiet);
        if (!options.output.quiet && whole) report(fmt::format("swirl: '{}' holds this sweep already", path));
        if (!options.output.quiet && !whole)
            report(fmt::format("swirl: '{}' holds {} of {} runs of this sweep: the others are added", path,
                               std::count(done.begin(), done.end(), 1), done.size()));
        return whole;
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

/// Runs what is not done, and writes the record. False if interrupted.
bool run_the_rest(const SweepOptions& options, Sweep& sweep, std::vector<char>& done, HandOut& hand_out) {
    const std::string& path = options.output.record;
    const auto count_done = [&] { return std::count(done.begin(), done.end(), 1); };
    const auto in_record = count_done();
    std::optional<SweepJournal> journal;
    if (!path.empty()) journal.emplace(path, sweep, done);
    const bool all =
        run_all(options, sweep, done, journal ? &*journal : nullptr, hand_out) && look_into_results(options, sweep);
    finish_up();
    if (!all) {
        if (journal && count_done() == in_record) journal->remove();  // nothing to go on from
        if (journal && !options.output.quiet)
            report(fmt::format("swirl: interrupted; {} of {} runs are kept: the same command goes on from there",
                               count_done(), done.size()));
        return false;
    }
    if (!path.empty()) {
        keep_sweep(options, sweep, in_record > 0);
        journal->remove();
    }
    return true;
}

int sweep_grid(SweepOptions& options, HandOut& hand_out) {
    Sweep sweep = plan(options);
    sweep.results.resize(cell_count(sweep.grid) * static_cast<std::size_t>(sweep.runs));
    const std::string& path = options.output.record;
    check_output(options);
    note_interruptions();
    const auto begin = std::chrono::steady_clock::now();
    std::vector<char> done(sweep.results.size(), 0);
    const bool is_there = !path.empty() && std::filesystem::exists(path) && !options.output.force;
    const bool whole = is_there && read_what_is_there(options, sweep, done);
    if (!(whole ? look_into_results(options, sweep) : run_the_rest(options, sweep, done, hand_out)))
        return exit_interrupted;
    if (options.output.json)
        write_sweep_document(sweep);
    else if (!options.output.quiet)
        print_sweep(sweep);
    if (!options.output.quiet && !options.output.json)
        report(fmt::format("swirl: {:.1f} s",
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return exit_done;
}

}  // namespace

int sweep(SweepOptions& options) {
    return on_all_ranks(
        options.output.quiet, options.output.threads, [&] { return work_of(options, plan(options)); },
        [&](HandOut& hand_out) { return sweep_grid(options, hand_out); });
}

}  // namespace swirl::apps::sweep
