// A verdict as JSON, as a group of a record, and as lines for people.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/modes/verdict_in_words.hpp"
#include "apps/studies/modes/name_mode.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// Members mode, kind, period, mean_S, … evidence, settings, outcome into an open object.
///   risk   of chaos that is called before the limits; a setting where it is not 0
///   error  of its mean S; a setting where it is finite
void write_verdict(JsonWriter& json, const NamedMode& named, const analysis::ClassifyOptions& settings, double risk = 0,
                   double error = std::numeric_limits<double>::infinity());

/// The verdict as attributes; the evidence as datasets along dimension `evidence`.
void write_verdict(const RecordGroup& group, const NamedMode& named, const analysis::ClassifyOptions& settings,
                   double risk = 0, double error = std::numeric_limits<double>::infinity());

/// The verdict, how sure and why, a line each; with `verbose` the numbers and all of the evidence after it. Mean S is
/// in the user's units, if there are any.
std::string table_of(const NamedMode& named, bool verbose, const std::optional<Units>& units = {});

/// Member `evidence`: name, value, threshold, says, changes_if.
void write_evidence(JsonWriter& json, const std::vector<analysis::Evidence>& evidence);
/// The evidence along dimension `evidence`; nothing if there is none.
void write_evidence(const RecordGroup& group, const std::vector<analysis::Evidence>& evidence);

}  // namespace swirl::apps
