// Several runs of one scene of which some have left chaos and others have not: how fast they leave.
#pragma once

#include "analysis/classification/escape_rate.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/modes/attractors.hpp"
#include "apps/modes/name_mode.hpp"

#include <optional>
#include <vector>

namespace swirl::apps {

/// Impacts at the start of a run that are left out: a run that leaves before may never have been in chaos.
inline constexpr std::int64_t chaos_begins = 1000;

/// The rate of escape where some runs are chaotic and others on a cycle or on the wall; none otherwise. A run on a
/// cycle left chaos at the last impact farther than 0.01 from it; one that came to stay on the wall at its last impact.
/// Runs whose leaving has no date (tori, undecided ones) are left out.
/// None, too, after an interruption.
///   speed  of the random starts
/// Cost: each run on a cycle is followed once more.
std::optional<analysis::EscapeRate> escape_of(const Scene<double>& scene, double speed,
                                              const std::vector<RunVerdict>& runs, const OutputOptions& output);

/// The rate of escape whatever has become of the runs: where none has left it is 0 with its upper bound; where all
/// have, no run tells any more that there was chaos, and so a run that left counts only if neighbouring orbits came
/// apart on its way there, ten-thousandfold at least. None where no run was in chaos after `settling` impacts, after an
/// interruption, or once it was stopped.
/// Cost: each run that left is followed twice more, once with its derivative.
std::optional<analysis::EscapeRate> escape_of_any(const Scene<double>& scene, double speed,
                                                  const std::vector<RunVerdict>& runs, std::int64_t settling,
                                                  const OutputOptions& output, const analysis::Stop& stop = {});

/// Names the chaotic runs `transient` where they are to be expected to leave, too.
void name_remaining(const analysis::EscapeRate& escape, std::vector<RunVerdict>& runs);
/// The same for the verdict on one of them, with the rate as evidence.
void name_remaining(const analysis::EscapeRate& escape, NamedMode& named);

/// {left, remaining, impacts, rate, least_rate, most_rate, half_life, others_will_leave}, or null.
void write_escape(JsonWriter& json, const std::optional<analysis::EscapeRate>& escape);
/// As attributes of a group.
void write_escape(const RecordGroup& group, const analysis::EscapeRate& escape);
/// A line for people.
std::string in_words(const analysis::EscapeRate& escape, std::int64_t settling = chaos_begins);

}  // namespace swirl::apps
