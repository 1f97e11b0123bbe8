// `swirl classify --runs R`: the modes that random starts of one scene settle on.
#pragma once

#include "apps/classify/classify_command.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/escape.hpp"
#include "apps/studies/modes/steady_shares.hpp"

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

/// Run r starts from seed + r: what `swirl classify --seed` gives. Equal arguments give equal results, whatever the
/// number of threads and ranks.
/// @return the exit code @throws BadInput for a start that is given, not random
int classify_runs(ClassifyCommandOptions& options);

}  // namespace swirl::apps::classify
