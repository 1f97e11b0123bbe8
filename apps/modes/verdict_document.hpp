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

}  // namespace swirl::apps
