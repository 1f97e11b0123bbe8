#include "apps/sweep/run_cells.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/ranks/packed.hpp"
#include "apps/studies/basins/cell_verdicts.hpp"
#include "apps/studies/grids/refine.hpp"
#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/modes/early_chaos.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>

namespace swirl::apps::sweep {

namespace {

RiskPieces risk_pieces_of(const GridStudy& study) {
    const std::size_t runs = cell_count(study.grid) * static_cast<std::size_t>(study.runs);
    return {runs, risk_question(study, runs).look};
}

}  // namespace

NamedWork work_of(const SweepOptions& options, const Sweep& sweep) {
    const GridStudy study = study_of(options, sweep.grid);
    const auto work = [study, numbers = risk_pieces_of(study)](std::span<const std::size_t> pieces,
                                                               const KeepPiece& keep) {
        for (const RiskPieces::Group& group : numbers.groups(pieces)) {
            const auto keep_run = [&](std::size_t run, const RunResult& result) {
                keep({numbers.number(run, group.look), packed(result)});
            };
            name_runs(study, group.runs, is_interrupted, keep_run, group.look);
        }
    };
    return {name_of_work(sweep.settings), work, most_named_together()};
}

namespace {

/// A sweep whose runs are followed.
struct RunningSweep {
    const SweepOptions& options;
    Sweep& sweep;
    std::vector<char>& done;  ///< 1 of each result that is there
    SweepJournal* journal;
    HandOut& hand_out;
};

void keep_run(RunningSweep& running, std::size_t run) {
    if (running.done[run]) return;
    running.done[run] = 1;
    if (running.journal != nullptr) running.journal->append(run, running.sweep.results[run]);
}

/// Runs that were followed, to the look (0: to the limits); of those that are done already nothing is followed. Results
/// go to their own places, whatever thread or rank makes them; those of a look are kept for good by `keep_run` alone.
/// None if it was interrupted.
std::optional<std::vector<SeenRun>> follow(RunningSweep& running, std::span<const std::size_t> runs, std::int64_t look,
                                           const std::string& task) {
    Sweep& sweep = running.sweep;
    const SweepOptions& options = running.options;
    const RiskPieces numbers = risk_pieces_of(study_of(options, sweep.grid));
    std::vector<std::size_t> pieces;
    for (const std::size_t run : runs)
        if (look > 0 || !running.done[run]) pieces.push_back(numbers.number(run, look));
    std::map<std::size_t, SeenRun> at_look;  // of those that are done, whose results stay
    const auto keep = [&](const PieceResult& piece) {
        const std::size_t run = numbers.run(piece.piece);
        const auto result = unpacked<RunResult>(piece.bytes);
        if (running.done[run]) {
            at_look[run] = seen_of(result);
            return;
        }
        sweep.results[run] = result;
        if (look == 0) keep_run(running, run);
    };
    Progress progress(task, static_cast<double>(pieces.size()), options.output.quiet);
    const bool all = running.hand_out.run(pieces, options.output.threads, work_of(options, sweep), progress, keep);
    if (running.journal != nullptr) running.journal->flush();
    if (!all) return std::nullopt;
    std::vector<SeenRun> seen;
    for (const std::size_t run : runs) {
        const auto found = at_look.find(run);
        seen.push_back(found != at_look.end() ? found->second : seen_of(sweep.results[run]));
    }
    return seen;
}

std::vector<std::size_t> runs_of(const std::vector<std::size_t>& cells, const Sweep& sweep) {
    const auto each = static_cast<std::size_t>(sweep.runs);
    std::vector<std::size_t> runs;
    for (const std::size_t cell : cells)
        for (std::size_t r = 0; r < each; ++r) runs.push_back(cell * each + r);
    return runs;
}

/// Runs what is not done of these cells.
///   population  the cells for whose runs a risk holds; `cells` are their places among these
bool run_cells(RunningSweep& running, const std::vector<std::size_t>& cells, const std::vector<std::size_t>& population,
               const std::string& task) {
    const std::vector<std::size_t> all = runs_of(population, running.sweep), own = runs_of(cells, running.sweep);
    const auto names_of = [&](std::span<const std::size_t> places) {
        std::vector<std::size_t> names;
        for (const std::size_t place : places) names.push_back(all[place]);
        return names;
    };
    RunsAtRisk runs;
    runs.follow = [&](std::span<const std::size_t> places, std::int64_t look) {
        const std::string to_look = look > 0 ? fmt::format("{}, the first {} impacts", task, look) : task;
        return follow(running, names_of(places), look, to_look);
    };
    runs.keep = [&](std::size_t place) { keep_run(running, all[place]); };
    const auto followed =
        follow_at_risk(risk_question(study_of(running.options, running.sweep.grid), all.size()), own, runs);
    if (followed && running.options.risk > 0) running.sweep.risk.push_back(followed->evidence);
    return followed.has_value();
}

/// Coarse points first, then those that the tree asks for, until it asks for none.
bool run_tree(RunningSweep& running) {
    Sweep& sweep = running.sweep;
    Lattice lattice{{}, running.options.refine};
    for (const auto& axis : sweep.grid) lattice.points.push_back(axis.points.size());
    sweep.visited.assign(lattice.size(), 0);
    CellVerdicts verdicts(sweep.grid);
    const auto verdict = [&](std::size_t cell) { return verdicts.of(sweep.cell(cell)); };
    int wave = 0;
    for (auto cells = coarse_points(lattice); !cells.empty(); cells = next_points(lattice, sweep.visited, verdict)) {
        const std::string task = wave == 0 ? "sweep" : fmt::format("sweep, refined {}", wave);
        std::vector<std::size_t> places(cells.size());
        std::iota(places.begin(), places.end(), std::size_t{0});
        if (!run_cells(running, places, cells, task)) return false;
        for (const std::size_t cell : cells) sweep.visited[cell] = 1;
        ++wave;
    }
    const auto runs = static_cast<std::ptrdiff_t>(sweep.runs);
    const std::vector<std::size_t> source = sources(lattice, sweep.visited);
    for (std::size_t cell = 0; cell < source.size(); ++cell) {
        if (source[cell] == cell) continue;
        const auto from = sweep.results.begin() + static_cast<std::ptrdiff_t>(source[cell]) * runs;
        std::copy(from, from + runs, sweep.results.begin() + static_cast<std::ptrdiff_t>(cell) * runs);
    }
    return true;
}

}  // namespace

SweepJournal::SweepJournal(const std::string& record, Sweep& sweep, std::vector<char>& done) {
    const std::string header = settings_text(sweep.settings);
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
            "an unfinished sweep with other options lies beside '{}' ({}); give the same options, or remove it", record,
            journal_path(record).filename().string()));
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

void SweepJournal::append(std::size_t index, const RunResult& result) {
    journal_->append(index, std::as_bytes(std::span(&result, 1)));
    const auto now = std::chrono::steady_clock::now();
    if (now - flushed_ < std::chrono::milliseconds(500)) return;
    flushed_ = now;
    journal_->flush();
}

bool run_all(const SweepOptions& options, Sweep& sweep, std::vector<char>& done, SweepJournal* journal,
             HandOut& hand_out) {
    RunningSweep running{options, sweep, done, journal, hand_out};
    if (options.refine > 0) return run_tree(running);
    std::vector<std::size_t> cells, all(cell_count(sweep.grid));
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const std::size_t c : all)
        if (sweep.is_visited(c)) cells.push_back(c);
    return run_cells(running, cells, all, "sweep");
}

}  // namespace swirl::apps::sweep
