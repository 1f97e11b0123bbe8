// The modes of several runs: what was found, as JSON, as groups of a record, and as a table for people.
#pragma once

#include "apps/classify/classify_command.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/early_chaos.hpp"
#include "apps/studies/modes/escape.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::apps::classify {

/// What was found, of the runs that are finished: all of them, unless interrupted.
struct RunsFound {
    std::vector<RunVerdict> runs;             ///< by seed
    std::vector<std::int64_t> called;         ///< of each the look at which its chaos was called; 0: at the limits
    std::vector<RunVerdict> sample;           ///< those by which the rate of escape is told: all, or the risk's sample
    std::vector<SharedAttractor> attractors;  ///< the most shared first
    std::optional<NamedMode> first;       ///< the verdict on the first attractor's representative, unless interrupted
    std::vector<SteadyShare> steady;      ///< the attracting steady modes, found or not
    std::vector<RiskEvidence> risk = {};  ///< when chaos was called, if a risk was allowed
    std::optional<analysis::EscapeRate> escape;  ///< where some have left chaos and others have not
};

/// The first attractor's verdict at top level, then modes, kinds, attractors and runs.
void write_runs_document(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found);

/// Groups scene, start, mode (the first attractor's verdict), attractors and runs.
void write_runs(const RecordGroup& root, const ClassifyCommandOptions& options, const Scene<double>& scene,
                const RunsFound& found);

void print_runs(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found);

}  // namespace swirl::apps::classify
