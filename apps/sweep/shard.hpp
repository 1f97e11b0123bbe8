// A part of a sweep as a record of its own, for job arrays: `swirl join` makes the sweep's record of all of them.
#pragma once

#include "apps/sweep/sweep_command.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

/// What the record of a shard holds.
struct ReadShard {
    Shard shard;
    Settings settings;  ///< by name
    std::optional<Units> units;
    std::vector<std::int64_t> cells;
    std::vector<RunResult> results;  ///< by cell, then run
    std::vector<RiskEvidence> risk;
};

/// @throws BadInput for a record that is none of a shard, RecordError for a file that can't be read
ReadShard read_shard_file(const std::string& path);

/// The runs of a cell into their places, and `is_done` at each into `done`.
void take_runs(std::span<const RunResult> runs, std::size_t cell, char is_done, Sweep& sweep, std::vector<char>& done);

/// How many runs a record has of each cell that was made with these settings, or with fewer runs and else the same.
/// @throws BadInput naming the first setting that differs, and its values
std::int64_t runs_of_same_sweep(const std::string& path, const Settings& wanted, const Settings& found);

/// "runs = 2", or "another grid" of what has no short value; "no runs" of what is not there.
std::string setting_in_words(const Settings& settings, const std::string& name);

/// Its results into the sweep; `done` gets 1 at each. @throws BadInput if these are not all of the shard's cells
void put(const std::string& path, const ReadShard& read, std::int64_t runs, Sweep& sweep, std::vector<char>& done);

/// The name of the first that only one of them has, or that differs; empty: none.
std::string different_setting(const Settings& wanted, const Settings& found);

}  // namespace swirl::apps::sweep
