// Several runs of one scene of which some have left chaos and others have not: how fast they leave.
#pragma once

#include "analysis/classification/escape_rate.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace swirl::studies {

/// Impacts at the start of a run that are left out: a run that leaves before may never have been in chaos.
inline constexpr std::int64_t chaos_begins = 1000;

/// The rate of escape where some runs are chaotic and others on a cycle or on the wall; none otherwise. A run on a
/// cycle left chaos at the last impact farther than 0.01 from it; one that came to stay on the wall at its last impact.
/// Runs whose leaving has no date (tori, undecided ones) are left out.
/// None, too, once it was stopped.
///   speed     of the random starts
///   accuracy  in which the runs were followed
/// Cost: each run on a cycle is followed once more.
std::optional<analysis::EscapeRate> escape_of(const Scene<double>& scene, double speed,
                                              const std::vector<RunVerdict>& runs, Accuracy accuracy,
                                              const RunControl& control);

/// The rate of escape whatever has become of the runs: where none has left it is 0 with its upper bound; where all
/// have, no run tells any more that there was chaos, and so a run that left counts only if neighbouring orbits came
/// apart on its way there, ten-thousandfold at least. None where no run was in chaos after `settling` impacts, or
/// once it was stopped.
///   over  true: no run is followed any further; beside control.stop, which leaves those alone that do not end at once
/// Cost: each run that left is followed twice more, once with its derivative.
std::optional<analysis::EscapeRate> escape_of_any(const Scene<double>& scene, double speed,
                                                  const std::vector<RunVerdict>& runs, std::int64_t settling,
                                                  Accuracy accuracy, const RunControl& control,
                                                  const analysis::Stop& over = {});

/// What the verdict on a run alone tells of its stay: to its end where it is chaotic; where it came to a cycle or to
/// stay on the wall, to its last impact, as if it had been in chaos until then (it may have settled slowly instead).
/// Nothing of others.
analysis::ChaoticStay stay_as_judged(analysis::Kind kind, Outcome outcome, std::int64_t impacts);

/// Names the chaotic runs `transient` where they are to be expected to leave, too.
void name_remaining(const analysis::EscapeRate& escape, std::vector<RunVerdict>& runs);
/// Names the verdict on one of them `transient`, with the rate as evidence.
void name_remaining(const analysis::EscapeRate& escape, NamedMode& named);

}  // namespace swirl::studies
