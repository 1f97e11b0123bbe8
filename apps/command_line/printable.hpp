// Text of a file as it may be shown: UTF-8 that is valid, and nothing that a terminal would obey.
#pragma once

#include <string>
#include <string_view>

namespace swirl::apps {

/// The text with U+FFFD in place of each byte that belongs to no character of UTF-8.
std::string valid_utf8(std::string text);

/// Valid UTF-8 in which a control character (C0 but line feed and tab, DEL, C1) is written as \x1b. O(bytes).
std::string printable(std::string_view text);

}  // namespace swirl::apps
