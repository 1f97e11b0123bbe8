// The results of runs as columns of a record.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/record/record_writer.hpp"
#include "apps/studies/grids/run_results.hpp"

#include <span>
#include <string>
#include <vector>

namespace swirl::apps::sweep {

using namespace studies::grids;

/// The columns run_mode, run_kind, … along `axes`, the last of which is the run.
void write_run_columns(const RecordGroup& group, const std::vector<std::string>& axes,
                       std::span<const RunResult> results);

/// Reads them from a group, in the same order; as many as the first of them has. @throws RecordError
std::vector<RunResult> read_run_columns(const RecordReader& record, const std::string& group);

}  // namespace swirl::apps::sweep
