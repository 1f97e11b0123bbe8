// Branches of a scene's cycles as JSON, groups of a record and tables for people.
#pragma once

#include "apps/branches/section_point.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/studies/branches/branches.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// `branches` of the JSON document.
void write_branches(JsonWriter& json, const SceneBranches& scene, const std::vector<analysis::Branch>& branches);

/// Groups `branches` (points), `branch_ends` (one row a branch) and `special` of a record.
///   observable  a coordinate that is written as `value` beside S, unless it is S
void write_branches(const RecordGroup& root, const SceneBranches& scene, const std::vector<analysis::Branch>& branches,
                    const std::string& observable = "S");

///   units  the user's, if there are any, of a family's flight times
void print_branches(const SceneBranches& scene, const ParameterRange& along,
                    const std::vector<analysis::Branch>& branches, const std::optional<Units>& units = {});

}  // namespace swirl::apps
