// `swirl classify --runs R`: the modes that random starts of one scene settle on.
#pragma once

#include "apps/classify/classify_command.hpp"
#include "apps/modes/attractors.hpp"
#include "apps/modes/escape.hpp"
#include "apps/modes/steady_shares.hpp"

#include <optional>
#include <vector>

namespace swirl::apps::classify {

/// What was found, of the runs that are finished: all of them, unless interrupted.
struct RunsFound {
    std::vector<RunVerdict> runs;             ///< by seed
    std::vector<SharedAttractor> attractors;  ///< the most shared first
    std::optional<NamedMode> first;   ///< the verdict on the first attractor's representative, unless interrupted
    std::vector<SteadyShare> steady;  ///< the attracting steady modes, found or not
    std::optional<analysis::EscapeRate> escape;  ///< where some have left chaos and others have not
};

/// One run: what `swirl classify --seed` gives. A pure function of its arguments, unless it is interrupted: then
/// nothing.
std::optional<RunVerdict> classify_run(const Scene<double>& scene, double speed, std::uint64_t seed,
                                       const analysis::ClassifyOptions& settings, Accuracy accuracy);

/// Run r starts from seed + r. Equal arguments give equal results, whatever the number of threads.
/// @return the exit code @throws BadInput for a start that is given, not random
int classify_runs(const ClassifyCommandOptions& options, const Scene<double>& scene);

}  // namespace swirl::apps::classify
