// Checks of numbers among the arguments, said before anything else is done.
#pragma once

#include "apps/command_line/flags.hpp"

#include <cstdint>

namespace swirl::apps {

/// The most impacts that a command is asked to follow, or to skip.
inline constexpr std::int64_t most_impacts = 1'000'000'000'000;

/// For Flag::transform: a whole number from `least` to `most`, in decimal digits: 010 is ten, as in every other
/// number of the command (CLI11's own conversion takes it for eight), and 0x10 and 1e3 are none.
TextCheck whole_number(std::int64_t least, std::int64_t most);

/// For Flag::check: a finite number, `least` or more. (CLI11's Range lets NaN through.)
TextCheck finite_number_from(double least);

}  // namespace swirl::apps
