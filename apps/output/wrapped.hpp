// Text for people in lines of at most 100 columns.
#pragma once

#include <cstddef>
#include <string>

namespace swirl::apps {

inline constexpr std::size_t most_columns = 100;

/// One line, broken between words where it is longer than most_columns; what follows a break begins with `indent`
/// blanks. A word that is longer than that stays whole.
std::string wrapped(const std::string& line, std::size_t indent);

/// A text, each of whose lines is broken so.
std::string all_wrapped(const std::string& text, std::size_t indent);

/// Where the descriptions of `--help` begin, beside flags or below them.
inline constexpr std::size_t description_column = 30;

/// What `--help` prints: paragraphs and the descriptions of lists are filled, these under themselves, and examples are
/// broken before a flag with "\", so that they run as they stand.
std::string help_in_columns(const std::string& help);

}  // namespace swirl::apps
