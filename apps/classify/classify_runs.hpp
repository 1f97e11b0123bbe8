// `swirl classify --runs R`: the modes that random starts of one scene settle on.
#pragma once

#include "apps/classify/classify_command.hpp"

namespace swirl::apps::classify {

/// Run r starts from seed + r: what `swirl classify --seed` gives. Equal arguments give equal results, whatever the
/// number of threads and ranks.
/// @return the exit code @throws BadInput for a start that is given, not random
int classify_runs(ClassifyCommandOptions& options);

}  // namespace swirl::apps::classify
