// Flags and what records call them: names and values.
#pragma once

#include "apps/record/record_types.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace swirl::apps {

/// A number or a word as its flag would give it: the shortest decimal that reads back to the same double. None of a
/// list, and of true and false.
std::optional<std::string> flag_text_of(const AttributeValue& value);

/// A flag's name as attributes, columns and dimensions have it: inertia-factor is inertia_factor there.
std::string record_name(std::string_view flag);

/// The flag of such a name: inertia-factor is that of inertia_factor.
std::string flag_name(std::string_view name);

}  // namespace swirl::apps
