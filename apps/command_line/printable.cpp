#include "apps/command_line/printable.hpp"

#include <fmt/format.h>
#include <boost/locale/utf.hpp>

#include <algorithm>

namespace swirl::apps {

namespace {

bool is_control(char32_t point) {
    const bool allowed = point == U'\n' || point == U'\t';
    return (point < 0x20 && !allowed) || (point >= 0x7F && point < 0xA0);
}

std::string cleaned(std::string_view text, bool without_controls) {
    using Utf8 = boost::locale::utf::utf_traits<char>;
    std::string clean;
    clean.reserve(text.size());
    for (const char* position = text.data(); position != text.data() + text.size();) {
        const char* next = position;
        const auto point = Utf8::decode(next, text.data() + text.size());
        if (!boost::locale::utf::is_valid_codepoint(point)) {
            clean += "\xEF\xBF\xBD";
            ++position;  // a valid character may begin at the next byte
            continue;
        }
        if (without_controls && is_control(point))
            clean += fmt::format("\\x{:02x}", static_cast<unsigned>(point));
        else
            clean.append(position, next);
        position = next;
    }
    return clean;
}

}  // namespace

std::string valid_utf8(std::string text) {
    const auto is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    if (std::all_of(text.begin(), text.end(), is_ascii)) return text;
    return cleaned(text, false);
}

std::string printable(std::string_view text) {
    return cleaned(text, true);
}

}  // namespace swirl::apps
