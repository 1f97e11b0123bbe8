#include "apps/input/delimited_file.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/text_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace swirl::apps {

namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

// Ten million rows of a hundred bytes; above it a file is taken for one that never ends.
constexpr std::size_t longest_series = std::size_t{1} << 30;

char separator_of(const std::string& line) {
    bool quoted = false;
    bool tab = false, semicolon = false, comma = false;
    for (const char c : line) {
        if (c == '"') quoted = !quoted;
        if (quoted) continue;
        tab = tab || c == '\t';
        semicolon = semicolon || c == ';';
        comma = comma || c == ',';
    }
    return tab ? '\t' : semicolon ? ';' : comma ? ',' : ' ';
}

bool is_missing(const std::string& cell) {
    std::string lower = cell;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower.empty() || lower == "nan" || lower == "na" || lower == "-nan";
}

/// A plain decimal; no hexadecimal, infinity or nan.
std::optional<double> number_in(const std::string& cell) {
    if (cell.empty() || cell.find_first_not_of("0123456789+-.eE") != std::string::npos) return std::nullopt;
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// Meant as a number, though perhaps none that can be used: inf, 1e400, 0x10.
bool looks_like_a_number(const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return !cell.empty() && *end == '\0' && !std::isnan(value);
}

bool is_header(const std::vector<std::string>& cells) {
    bool word = false;
    for (const auto& cell : cells) {
        if (number_in(cell)) return false;
        word = word || !(is_missing(cell) || looks_like_a_number(cell));
    }
    return word;
}

std::string shown(const std::string& line) {
    constexpr std::size_t longest = 100;  // of a message of one line
    if (line.size() <= longest) return line;
    return line.substr(0, longest) + "...";
}

std::string list_of(const DelimitedFile& file) {
    if (file.header.empty()) return fmt::format("it has no header; columns are numbered 1 to {}", file.columns);
    return fmt::format("its columns are: {}", fmt::join(file.header, ", "));
}

}  // namespace

std::vector<std::string> cells_of(const std::string& line, char separator) {
    std::vector<std::string> cells;
    const std::string_view text = separator == '\t' ? std::string_view(line) : trimmed(line);
    std::size_t i = 0;
    const auto at_separator = [&] { return separator == ' ' ? is_blank(text[i]) : text[i] == separator; };
    while (true) {
        std::string cell;
        bool quoted = false;  // some of the cell was in quotes: that part keeps its blanks
        std::size_t kept = 0;
        while (i < text.size() && !at_separator()) {
            if (text[i] != '"') {
                cell += text[i++];
                continue;
            }
            if (trimmed(std::string_view(cell).substr(kept)).empty()) cell.resize(kept);
            quoted = true;
            for (++i; i < text.size(); ++i) {
                if (text[i] == '"' && i + 1 < text.size() && text[i + 1] == '"')
                    cell += text[++i];
                else if (text[i] == '"')
                    break;
                else
                    cell += text[i];
            }
            if (i < text.size()) ++i;
            kept = cell.size();
        }
        if (!quoted)
            cell = std::string(trimmed(cell));
        else if (trimmed(std::string_view(cell).substr(kept)).empty())
            cell.resize(kept);
        cells.push_back(std::move(cell));
        if (i >= text.size()) return cells;
        ++i;
        if (separator == ' ')
            while (i < text.size() && is_blank(text[i])) ++i;
    }
}

DelimitedFile read_delimited(const std::string& name) {
    const std::string content = read_text("series", name, longest_series);
    DelimitedFile file;
    file.name = name;
    std::size_t begin = content.rfind("\xEF\xBB\xBF", 0) == 0 ? 3 : 0;  // a byte order mark
    for (std::size_t line = 1; begin < content.size(); ++line) {
        std::size_t end = content.find('\n', begin);
        if (end == std::string::npos) end = content.size();
        std::string text = content.substr(begin, end - begin);
        begin = end + 1;
        if (!text.empty() && text.back() == '\r') text.pop_back();
        const std::string_view core = trimmed(text);
        if (core.empty() || core.front() == '#' || core.front() == '%') continue;
        if (file.columns == 0) {
            file.separator = separator_of(text);
            auto cells = cells_of(text, file.separator);
            file.columns = cells.size();
            if (is_header(cells)) {
                file.header = std::move(cells);
                continue;
            }
        }
        file.rows.push_back({line, std::move(text)});
    }
    if (file.rows.empty())
        throw BadInput(fmt::format("series '{}' has no rows of numbers; at least one is needed", name));
    return file;
}

std::string at_line(const DelimitedFile& file, std::size_t row, const std::string& what) {
    return fmt::format("series '{}', line {}: {}; the line reads '{}'", file.name, file.rows[row].line, what,
                       shown(file.rows[row].text));
}

std::string column_name(const DelimitedFile& file, std::size_t column) {
    return file.header.empty() ? fmt::format("{}", column + 1) : file.header[column];
}

std::size_t column_of(const DelimitedFile& file, const std::string& option, const std::string& wanted) {
    const auto named = std::find(file.header.begin(), file.header.end(), wanted);
    if (named != file.header.end()) {
        if (std::count(file.header.begin(), file.header.end(), wanted) > 1)
            throw BadInput(fmt::format("{} = '{}': several columns of '{}' have this name; give a number, 1 to {}",
                                       option, wanted, file.name, file.columns));
        return static_cast<std::size_t>(named - file.header.begin());
    }
    char* end = nullptr;
    const long number = std::strtol(wanted.c_str(), &end, 10);
    if (wanted.empty() || *end != '\0' || number < 1 || static_cast<std::size_t>(number) > file.columns)
        throw BadInput(fmt::format("{} = '{}' is no column of '{}': {}{}", option, wanted, file.name, list_of(file),
                                   file.header.empty() ? "" : fmt::format(" (or a number, 1 to {})", file.columns)));
    return static_cast<std::size_t>(number - 1);
}

std::vector<std::vector<double>> numbers_of(const DelimitedFile& file, const std::vector<std::size_t>& wanted,
                                            const std::vector<bool>& gaps) {
    std::vector<std::vector<double>> columns(wanted.size());
    for (auto& column : columns) column.reserve(file.rows.size());
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        const auto cells = cells_of(file.rows[row].text, file.separator);
        if (cells.size() != file.columns)
            throw BadInput(
                at_line(file, row, fmt::format("{} cells, where {} are needed", cells.size(), file.columns)));
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const std::string& cell = cells[wanted[k]];
            const auto number = number_in(cell);
            if (!number && !(gaps[k] && is_missing(cell)))
                throw BadInput(at_line(
                    file, row,
                    fmt::format("'{}' in column {} is not a number; a finite decimal number is needed{}", shown(cell),
                                column_name(file, wanted[k]), gaps[k] ? ", or nothing, nan or NA for a gap" : "")));
            columns[k].push_back(number.value_or(std::nan("")));
        }
    }
    return columns;
}

}  // namespace swirl::apps
