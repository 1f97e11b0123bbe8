// A named text file, read whole, and its text as it may be shown: UTF-8 that is valid, and nothing that a terminal
// would obey.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace swirl::apps {

// Text of a file as it may be shown: UTF-8 that is valid, and nothing that a terminal would obey.

/// The text with U+FFFD in place of each byte that belongs to no character of UTF-8.
std::string valid_utf8(std::string text);

/// Valid UTF-8 in which a control character (C0 but line feed and tab, DEL, C1) is written as \x1b. O(bytes).
std::string printable(std::string_view text);

// A named text file, read whole.

/// The content of a text file; "-" is standard input. What never ends (a device, a pipe that goes on) is read no
/// further than `most` bytes, or its first zero byte.
///   what  begins each message: "scene file", "series"
/// @throws BadInput naming the file: it can't be opened or read, is a directory, is longer, is not a text file, is
/// UTF-16
std::string read_text(const std::string& what, const std::string& name, std::size_t most);

}  // namespace swirl::apps
