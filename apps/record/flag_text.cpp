#include "apps/record/flag_text.hpp"

#include <fmt/format.h>

namespace swirl::apps {

std::optional<std::string> flag_text_of(const AttributeValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *integer);
    if (const auto* natural = std::get_if<std::uint64_t>(&value)) return fmt::format("{}", *natural);
    return std::nullopt;
}

}  // namespace swirl::apps
