// A part of a sweep as a record of its own, for job arrays: `swirl join` makes the sweep's record of all of them.
#pragma once

#include "apps/sweep/sweep_command.hpp"

#include <cstdint>
#include <optional>
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
};

/// @throws BadInput for a record that is none of a shard, RecordError for a file that can't be read
ReadShard read_shard_file(const std::string& path);

/// Its results into the sweep. @throws BadInput if these are not all of the shard's cells
void put(const std::string& path, const ReadShard& read, Sweep& sweep);

/// The name of the first that only one of them has, or that differs; empty: none.
std::string different_setting(const Settings& wanted, const Settings& found);

}  // namespace swirl::apps::sweep
