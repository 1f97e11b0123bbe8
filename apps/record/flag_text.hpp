// An attribute as the text of a flag.
#pragma once

#include "apps/record/record_types.hpp"

#include <optional>
#include <string>

namespace swirl::apps {

/// A number or a word as its flag would give it: the shortest decimal that reads back to the same double. None of a
/// list, and of true and false.
std::optional<std::string> flag_text_of(const AttributeValue& value);

}  // namespace swirl::apps
