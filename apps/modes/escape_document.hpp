// How fast runs leave chaos, as JSON, as attributes of a record and as a line for people.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/studies/modes/escape.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace swirl::apps {

/// {left, remaining, impacts, rate, least_rate, most_rate, half_life, others_will_leave}, or null.
void write_escape(JsonWriter& json, const std::optional<analysis::EscapeRate>& escape);
/// As attributes of a group.
void write_escape(const RecordGroup& group, const analysis::EscapeRate& escape);
/// A line for people.
std::string in_words(const analysis::EscapeRate& escape, std::int64_t settling = chaos_begins);

/// What the verdict on a run says of its stay in chaos.
struct JudgedRun {
    analysis::Kind kind;
    Outcome outcome;
    std::int64_t impacts;
    std::size_t cell;  ///< of a grid, or column of a diagram: runs of one scene
};

/// What is known of the chaos of many scenes' runs from their verdicts alone, in lines for people: how many were in it,
/// for how long, how many may have left it, and so how long it lasts. Only cells with a chaotic run count. Empty where
/// no run is chaotic.
std::string chaos_in_words(std::span<const JudgedRun> runs);

}  // namespace swirl::apps
