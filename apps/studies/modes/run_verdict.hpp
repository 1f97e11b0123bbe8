// What is kept of the verdict on one of several runs.
#pragma once

#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/name_mode.hpp"

namespace swirl::studies {

/// The verdict on the run from a seed; `attractor` is not known yet.
RunVerdict run_verdict(std::uint64_t seed, const NamedMode& named);

}  // namespace swirl::studies
