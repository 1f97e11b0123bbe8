// A verdict as JSON, as a group of a record, and as lines for people.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/modes/name_mode.hpp"

#include <string>

namespace swirl::apps {

/// Members mode, kind, period, mean_S, … evidence, settings, outcome into an open object.
void write_verdict(JsonWriter& json, const NamedMode& named, const analysis::ClassifyOptions& settings);

/// The same as attributes; the evidence as datasets along dimension `evidence`.
void write_verdict(const RecordGroup& group, const NamedMode& named, const analysis::ClassifyOptions& settings);

/// Several lines, the last ends with a newline.
std::string table_of(const NamedMode& named);

/// Member `evidence`: name, value, threshold, says, changes_if.
void write_evidence(JsonWriter& json, const std::vector<analysis::Evidence>& evidence);
/// The same along dimension `evidence`; nothing if there is none.
void write_evidence(const RecordGroup& group, const std::vector<analysis::Evidence>& evidence);
/// Two lines each.
std::string table_of(const std::vector<analysis::Evidence>& evidence);

/// "mode quasi-steady (cycle), period 4"
std::string mode_in_words(const analysis::Classification& verdict);

}  // namespace swirl::apps
