// The modes of several runs as JSON, as groups of a record, and as a table for people.
#pragma once

#include "apps/classify/classify_runs.hpp"
#include "apps/command_line/documents.hpp"

namespace swirl::apps::classify {

/// The first attractor's verdict at top level, then modes, kinds, attractors and runs.
void write_runs_document(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found);

/// Groups scene, start, mode (the first attractor's verdict), attractors and runs.
void write_runs(const RecordGroup& root, const ClassifyCommandOptions& options, const Scene<double>& scene,
                const RunsFound& found);

void print_runs(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found);

}  // namespace swirl::apps::classify
