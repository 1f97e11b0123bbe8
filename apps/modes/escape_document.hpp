// How fast runs leave chaos, as JSON, as attributes of a record and as a line for people.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/studies/modes/escape.hpp"

#include <optional>
#include <string>

namespace swirl::apps {

/// {left, remaining, impacts, rate, least_rate, most_rate, half_life, others_will_leave}, or null.
void write_escape(JsonWriter& json, const std::optional<analysis::EscapeRate>& escape);
/// As attributes of a group.
void write_escape(const RecordGroup& group, const analysis::EscapeRate& escape);
/// A line for people.
std::string in_words(const analysis::EscapeRate& escape, std::int64_t settling = chaos_begins);

}  // namespace swirl::apps
