#include "apps/command_line/number_checks.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace swirl::apps {

TextCheck whole_number(std::int64_t least, std::int64_t most) {
    // A transform rewrites its text: what CLI11 converts then has no leading zeros.
    const auto check = [least, most](std::string& text) {
        std::int64_t value = 0;
        const char* begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error == std::errc::invalid_argument || stop != end)
            return fmt::format("Value {} is no whole number: {} to {} are allowed", text, least, most);
        if (error != std::errc() || value < least || value > most)
            return fmt::format("Value {} not in range {} to {}", text, least, most);
        text = fmt::format("{}", value);
        return std::string();
    };
    return {check, fmt::format("INT in [{} - {}]", least, most)};
}

TextCheck finite_number_from(double least) {
    const auto check = [least](const std::string& text) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool number = end != text.c_str() && *end == '\0';
        if (!number || !std::isfinite(value) || value < least)
            return fmt::format("Value {} is outside its range: {:g} or more, finite", text, least);
        return std::string();
    };
    return {check, fmt::format("FLOAT >= {:g}", least)};
}

}  // namespace swirl::apps
