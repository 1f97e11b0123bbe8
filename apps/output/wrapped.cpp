#include "apps/output/wrapped.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace swirl::apps {

namespace {

std::size_t blanks_before(const std::string& line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

/// Characters, not bytes, of UTF-8.
std::size_t columns_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// "  --flag K    what it does": where what it does begins; 0 of other lines.
std::size_t description_at(const std::string& line) {
    if (blanks_before(line) >= description_column) return blanks_before(line);
    if (blanks_before(line) != 2) return 0;
    const auto gap = line.find("  ", 2);
    return gap == std::string::npos ? 0 : line.find_first_not_of(' ', gap);
}

/// "  swirl sweep … \" with the rest below it.
std::string example_in_columns(const std::string& line) {
    std::string text, rest = line;
    while (rest.size() > most_columns) {
        const auto at = rest.rfind(" --", most_columns - 2);
        if (at == std::string::npos || at <= blanks_before(rest)) break;
        text += rest.substr(0, at) + " \\\n";
        rest = "      " + rest.substr(at + 1);
    }
    return text + rest;
}

}  // namespace

std::string wrapped(const std::string& line, std::size_t indent) {
    if (columns_of(line) <= most_columns) return line;
    std::string text, current(line, 0, blanks_before(line));
    bool empty = true;
    std::size_t at = blanks_before(line);
    while (at < line.size()) {
        const auto begin = line.find_first_not_of(' ', at);
        if (begin == std::string::npos) break;
        const auto end = std::min(line.find(' ', begin), line.size());
        const std::string gap(empty ? 0 : begin - at, ' '), word = line.substr(begin, end - begin);
        if (!empty && columns_of(current) + gap.size() + columns_of(word) > most_columns) {
            text += current + "\n";
            current = std::string(indent, ' ') + word;
        } else {
            current += gap + word;
        }
        empty = false;
        at = end;
    }
    return text + current;
}

std::string all_wrapped(const std::string& text, std::size_t indent) {
    std::istringstream lines(text);
    std::string all;
    for (std::string line; std::getline(lines, line);) all += wrapped(line, indent) + "\n";
    return all;
}

std::string help_in_columns(const std::string& help) {
    std::istringstream lines(help);
    std::string all, paragraph, item;
    const auto flush = [&] {
        if (!paragraph.empty()) all += wrapped(paragraph, 0) + "\n";
        if (!item.empty()) all += wrapped(item, std::max(description_at(item), blanks_before(item))) + "\n";
        paragraph.clear();
        item.clear();
    };
    bool was_blank = false;
    for (std::string line; std::getline(lines, line);) {
        const bool blank = line.find_first_not_of(' ') == std::string::npos;
        if (blank) {
            flush();
            if (!was_blank) all += "\n";
        } else if (line.starts_with("  swirl ")) {
            flush();
            all += example_in_columns(line) + "\n";
        } else if (line[0] == ' ') {
            if (!item.empty() && blanks_before(line) == description_at(item)) {
                item += line.substr(blanks_before(line) - 1);
            } else {
                flush();
                item = line;
            }
        } else {
            if (!item.empty() || line.starts_with("Usage: ")) flush();
            paragraph += (paragraph.empty() ? "" : " ") + line;
            if (line.ends_with(':')) flush();  // a heading, or what leads to a list
        }
        was_blank = blank;
    }
    flush();
    return all;
}

}  // namespace swirl::apps
