// The runs of a sweep, on all threads, kept in a journal until the record is written, and their columns there.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/ranks/hand_out.hpp"
#include "apps/record/journal.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/record/record_writer.hpp"
#include "apps/studies/grids/run_cells.hpp"
#include "apps/sweep/sweep_command.hpp"

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

// The results of runs as columns of a record.

using namespace studies::grids;

/// How runs may end, by the enumerators' numbers: those of a floor that drags where one of the runs has them.
std::vector<std::string> outcome_names(std::span<const RunResult> results);
/// The kinds likewise, with `riding` where one of the runs rides.
std::vector<std::string> kind_names(std::span<const RunResult> results);

/// The columns run_mode, run_kind, … along `axes`, the last of which is the run.
void write_run_columns(const RecordGroup& group, const std::vector<std::string>& axes,
                       std::span<const RunResult> results);

/// Reads them from a group, in the same order; as many as the first of them has. @throws RecordError
std::vector<RunResult> read_run_columns(const RecordReader& record, const std::string& group);

/// The journal of an unfinished record. What it holds goes to the results.
class SweepJournal {
public:
    /// `done` gets 1 at each result that it brought. @throws BadInput if it is another sweep's, or can't be written
    SweepJournal(const std::string& record, Sweep& sweep, std::vector<char>& done);

    /// On the disk twice a second at least.
    void append(std::size_t index, const RunResult& result);
    void flush() { journal_->flush(); }
    void remove() { journal_->remove(); }

private:
    std::optional<Journal> journal_;
    std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

/// Runs all that is not done of the sweep's cells: of the grid, of the shard, or of the tree that --refine makes (its
/// `visited`, and then the results of all other cells from their `sources`). False if interrupted.
///   done      1 of each result that is there
///   hand_out  to the other ranks, if there are any
bool run_all(const SweepOptions& options, Sweep& sweep, std::vector<char>& done, SweepJournal* journal,
             HandOut& hand_out);

/// The runs of a sweep, by their indices; a piece is one of them. It holds what it uses: after an interruption it may
/// outlive the sweep.
NamedWork work_of(const SweepOptions& options, const Sweep& sweep);

}  // namespace swirl::apps::sweep
