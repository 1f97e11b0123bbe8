// Invalid input in one line: what, its value, what is allowed.
#pragma once

#include <array>
#include <charconv>
#include <stdexcept>
#include <string>

namespace swirl::analysis {

/// The fewest digits that read back as the same number: 1e-09, -1, 268435456. (std::to_string gives 0.000000 for the
/// first.)
inline std::string digits_of(double number) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr};
}

/// @throws std::invalid_argument "what = value: must be allowed"
[[noreturn]] inline void refuse(const std::string& what, double value, const std::string& allowed) {
    throw std::invalid_argument(what + " = " + digits_of(value) + ": must be " + allowed);
}

}  // namespace swirl::analysis
