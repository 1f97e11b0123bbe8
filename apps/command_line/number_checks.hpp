// Checks of numbers among the arguments, said before anything else is done.
#pragma once

#include "apps/command_line/flags.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace swirl::apps {

/// The most impacts that a command is asked to follow, or to skip.
inline constexpr std::int64_t most_impacts = 1'000'000'000'000;

/// The whole number that a decimal is, also one with an exponent: 10000, 1e4, 2.5e3; 010 is ten; 10.0, 1e-3 and 0x10
/// are none. Nothing too of one beyond 64 bits: `too_large`, if it is given, tells these apart.
std::optional<std::int64_t> whole_number_from(std::string_view text, bool* too_large = nullptr);

/// For Flag::transform: a whole number from `least` to `most`, as whole_number_from() reads it. (CLI11's own conversion
/// takes 010 for eight.)
TextCheck whole_number(std::int64_t least, std::int64_t most);

/// For Flag::check: a finite number, `least` or more. (CLI11's Range lets NaN through.)
TextCheck finite_number_from(double least);

/// For Flag::check: a number, `least` or more and below `limit`.
TextCheck number_below(double least, double limit);

}  // namespace swirl::apps
