// The evidence of a verdict as JSON, as datasets of a record, and as lines for people.
#pragma once

#include "analysis/classification/evidence.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/record/record_writer.hpp"

#include <string>
#include <vector>

namespace swirl::apps {

/// Member `evidence`: name, value, threshold, says, changes_if.
void write_evidence(JsonWriter& json, const std::vector<analysis::Evidence>& evidence);

/// The same along dimension `evidence`; nothing if there is none.
void write_evidence(const RecordGroup& group, const std::vector<analysis::Evidence>& evidence);

/// Two lines each.
std::string table_of(const std::vector<analysis::Evidence>& evidence);

}  // namespace swirl::apps
