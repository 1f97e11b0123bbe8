#include "apps/command_line/text_file.hpp"

#include "apps/command_line/errors.hpp"

#include <fmt/format.h>
#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

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

namespace {

/// It begins with the mark of that encoding, or with ASCII in pairs of bytes.
bool is_utf16(std::string_view begin) {
    if (begin.size() < 4) return false;
    const bool marked = begin.substr(0, 2) == "\xFF\xFE" || begin.substr(0, 2) == "\xFE\xFF";
    const auto zero = [&](std::size_t i) { return begin[i] == '\0'; };
    return marked || (zero(0) && !zero(1) && zero(2) && !zero(3)) || (!zero(0) && zero(1) && !zero(2) && zero(3));
}

}  // namespace

std::string read_text(const std::string& what, const std::string& name, std::size_t most) {
    std::error_code ignored;
    if (std::filesystem::is_directory(name, ignored))
        throw BadInput(fmt::format("{} '{}' is a directory; a text file is needed", what, name));
    using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
    const bool standard_input = name == "-";
    const File file(
        standard_input ? stdin : std::fopen(name.c_str(), "rb"),
        standard_input ? [](std::FILE*) { return 0; } : [](std::FILE* f) { return std::fclose(f); });
    if (!file) throw BadInput(fmt::format("{} '{}' cannot be opened: {}", what, name, std::strerror(errno)));
    std::string content;
    if (const auto size = std::filesystem::file_size(name, ignored); !ignored && size <= most) content.reserve(size);
    char buffer[65536];
    for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;) {
        if (content.empty() && is_utf16({buffer, got}))
            throw BadInput(
                fmt::format("{} '{}' is UTF-16 text; UTF-8 is needed: iconv -f UTF-16 -t UTF-8 makes it", what, name));
        if (std::memchr(buffer, '\0', got) != nullptr)
            throw BadInput(
                fmt::format("{} '{}' is not a text file: it holds a zero byte (a record of swirl is given "
                            "without --series)",
                            what, name));
        if (content.size() + got > most)
            throw BadInput(fmt::format("{} '{}' is longer than {} MiB, the most that is read", what, name, most >> 20));
        content.append(buffer, got);
    }
    if (std::ferror(file.get()) != 0)
        throw BadInput(fmt::format("{} '{}' cannot be read: {}", what, name, std::strerror(errno)));
    return content;
}

}  // namespace swirl::apps
