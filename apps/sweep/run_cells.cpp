#include "apps/sweep/run_cells.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/ranks/packed.hpp"
#include "apps/studies/basins/cell_verdicts.hpp"
#include "apps/studies/grids/refine.hpp"
#include "apps/studies/grids/run_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace swirl::apps::sweep {

NamedWork work_of(const SweepOptions& options, const Sweep& sweep) {
    const auto work = [study = study_of(options, sweep.grid)](std::span<const std::size_t> pieces,
                                                              const KeepPiece& keep) {
        name_runs(study, pieces, is_interrupted, [&keep](std::size_t index, const RunResult& result) {
            keep({index, packed(result)});
        });
    };
    return {name_of_work(sweep.settings), work, most_named_together()};
}

namespace {

/// Runs what is not done of these cells. Results go to their own places, whatever thread or rank makes them.
bool run_cells(const SweepOptions& options, const std::vector<std::size_t>& cells, const std::string& task,
               Sweep& sweep, std::vector<char>& done, SweepJournal* journal, HandOut& hand_out) {
    const auto runs = static_cast<std::size_t>(sweep.runs);
    std::vector<std::size_t> left;
    for (const std::size_t cell : cells)
        for (std::size_t i = cell * runs; i < (cell + 1) * runs; ++i)
            if (!done[i]) left.push_back(i);
    const auto keep = [&sweep, &done, journal](const PieceResult& piece) {
        sweep.results[piece.piece] = unpacked<RunResult>(piece.bytes);
        done[piece.piece] = 1;
        if (journal != nullptr) journal->append(piece.piece, sweep.results[piece.piece]);
    };
    Progress progress(task, static_cast<double>(left.size()), options.output.quiet);
    const bool all = hand_out.run(left, options.output.threads, work_of(options, sweep), progress, keep);
    if (journal != nullptr) journal->flush();
    return all;
}

/// Coarse points first, then those that the tree asks for, until it asks for none.
bool run_tree(const SweepOptions& options, Sweep& sweep, std::vector<char>& done, SweepJournal* journal,
              HandOut& hand_out) {
    Lattice lattice{{}, options.refine};
    for (const auto& axis : sweep.grid) lattice.points.push_back(axis.points.size());
    sweep.visited.assign(lattice.size(), 0);
    CellVerdicts verdicts(sweep.grid);
    const auto verdict = [&](std::size_t cell) { return verdicts.of(sweep.cell(cell)); };
    int wave = 0;
    for (auto cells = coarse_points(lattice); !cells.empty(); cells = next_points(lattice, sweep.visited, verdict)) {
        const std::string task = wave == 0 ? "sweep" : fmt::format("sweep, refined {}", wave);
        if (!run_cells(options, cells, task, sweep, done, journal, hand_out)) return false;
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
    if (options.refine > 0) return run_tree(options, sweep, done, journal, hand_out);
    std::vector<std::size_t> cells;
    for (std::size_t c = 0; c < cell_count(sweep.grid); ++c)
        if (sweep.visited.empty() || sweep.visited[c]) cells.push_back(c);
    return run_cells(options, cells, "sweep", sweep, done, journal, hand_out);
}

}  // namespace swirl::apps::sweep
