// Is a record of the scene?
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/record/record_reader.hpp"

#include <string>
#include <vector>

namespace swirl::apps::boundaries {

/// What the record's group says of a scene must be what `scene` says, but for the parameters `varied`.
///   what  the record in words, to begin a message with
/// @throws BadInput with the first name whose values differ
void require_same_scene(const RecordReader& record, const std::string& what, const std::string& group,
                        const Settings& scene, const std::vector<std::string>& varied = {});

}  // namespace swirl::apps::boundaries
