#include "apps/input/delimited_file.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/input/cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

namespace swirl::apps {

namespace {

// Ten million rows of a hundred bytes; above it a file is taken for one that never ends.
constexpr std::size_t longest_series = std::size_t{1} << 30;

std::string shown(std::string_view line) {
    constexpr std::size_t longest = 100;  // of a message of one line
    if (line.size() <= longest) return printable(line);
    return printable(line.substr(0, longest)) + "...";
}

std::string list_of(const DelimitedFile& file) {
    if (file.header.empty()) return fmt::format("it has no header; columns are numbered 1 to {}", file.columns);
    return fmt::format("its columns are: {}", fmt::join(file.header, ", "));
}

/// The lines of a text, without their ends and a byte order mark.
std::vector<TextRow> lines_of(std::string_view content) {
    const char end = content.find('\n') == std::string::npos ? '\r' : '\n';
    std::vector<TextRow> lines;
    lines.reserve(static_cast<std::size_t>(std::count(content.begin(), content.end(), end)) + 1);
    std::size_t begin = content.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (std::size_t line = 1; begin < content.size(); ++line) {
        const std::size_t stop = std::min(content.find(end, begin), content.size());
        std::string_view text = content.substr(begin, stop - begin);
        begin = stop + 1;
        if (text.ends_with('\r')) text.remove_suffix(1);
        lines.push_back({line, text});
    }
    return lines;
}

/// The separator that a line "sep=;" names, else 0.
char separator_in(std::string_view line) {
    std::string text(line.substr(0, 20));
    text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text.size() == 5 && text.rfind("sep=", 0) == 0 ? text[4] : '\0';
}

bool is_comment(std::string_view text) {
    const std::string_view core = trimmed(text);
    return !core.empty() && (core.front() == '#' || core.front() == '%');
}

/// The lines that a table is made of, and the numbers of the blank ones.
struct TableLines {
    std::vector<TextRow> lines;
    std::vector<std::size_t> blank;
    char separator = '\0';  ///< that a line `sep=;` names
};

TableLines lines_of_table(std::vector<TextRow> lines, const LayoutChoice& choice) {
    const std::size_t header = choice.header_line.value_or(0);
    TableLines table;
    const auto is_none = [&](TextRow& line) {
        if (table.separator == '\0' && line.line == 1 && (table.separator = separator_in(line.text)) != '\0')
            return true;
        if (line.line == header && is_comment(line.text))  // "# t S": the sign is none of its names
            line.text = trimmed(trimmed(line.text).substr(1));
        if (line.line <= header) return line.line != header;
        const bool blank = trimmed(line.text).empty();
        if (blank) table.blank.push_back(line.line);
        return blank || is_comment(line.text);
    };
    std::size_t kept = 0;
    for (TextRow& line : lines)
        if (!is_none(line)) std::swap(lines[kept++], line);
    lines.resize(kept);
    table.lines = std::move(lines);
    return table;
}

/// With the blank lines between the rows of one column, which are gaps.
std::vector<TextRow> with_gaps(std::vector<TextRow> rows, const std::vector<std::size_t>& blank) {
    const std::size_t first = rows.front().line, last = rows.back().line;
    for (const std::size_t line : blank)
        if (first < line && line < last) rows.push_back({line, ""});
    std::sort(rows.begin(), rows.end(), [](const TextRow& a, const TextRow& b) { return a.line < b.line; });
    return rows;
}

/// Letters and digits alone, in lower case, without the unit in brackets.
std::string core_of(const std::string& name) {
    const std::string unit = unit_in_name(name);
    const bool bracketed = !name.empty() && (name.back() == ')' || name.back() == ']') && name.size() > unit.size() + 2;
    std::string core;
    for (const char c : name.substr(0, bracketed ? name.size() - unit.size() - 2 : name.size())) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || byte >= 0x80) core += static_cast<char>(std::tolower(byte));
    }
    return core;
}

/// The one column whose name is nearly the wanted one.
std::optional<std::size_t> similar_column(const DelimitedFile& file, const std::string& wanted) {
    const auto only = [&](const auto& fits) -> std::optional<std::size_t> {
        const auto found = std::find_if(file.header.begin(), file.header.end(), fits);
        if (found == file.header.end() || std::count_if(file.header.begin(), file.header.end(), fits) > 1)
            return std::nullopt;
        return static_cast<std::size_t>(found - file.header.begin());
    };
    const std::string core = core_of(wanted);
    if (core.empty()) return std::nullopt;
    if (const auto column = only([&](const std::string& name) { return core_of(name) == core; })) return column;
    return only([&](const std::string& name) {
        const std::size_t point = name.rfind('.');
        return point != std::string::npos && core_of(name.substr(point + 1)) == core;
    });
}

}  // namespace

std::vector<std::string> DelimitedFile::cells(std::size_t row) const {
    CellReader reader(*this);
    const auto& found = reader.at(row);
    return {found.begin(), found.end()};
}

const std::vector<std::string_view>& CellReader::at(std::size_t row) {
    const std::string_view text = file_.rows[row].text;
    const TableLayout& layout = file_.layout;
    if (layout.comma_in_pairs || text.find('"') != std::string_view::npos) {
        copies_ = cells_in(text, layout);
        cells_.assign(copies_.begin(), copies_.end());
    } else {
        split_cells(text, layout.separator, cells_);
        if (layout.ends_in_separator && cells_.size() == layout.columns + 1 && cells_.back().empty()) cells_.pop_back();
    }
    if (cells_.size() != file_.columns)
        throw BadInput(at_line(file_, row, fmt::format("{} cells, where {} are needed", cells_.size(), file_.columns)));
    return cells_;
}

DelimitedFile read_delimited(const std::string& name, const LayoutChoice& choice) {
    const auto content = std::make_shared<const std::string>(valid_utf8(read_text(choice.what, name, longest_series)));
    std::vector<TextRow> lines = lines_of(*content);
    if (choice.header_line && (*choice.header_line < 1 || *choice.header_line >= lines.size()))
        throw BadInput(fmt::format("header-line = {} is outside its range: 1 to {}, the lines of '{}' but the last",
                                   *choice.header_line, std::max<std::size_t>(lines.size(), 2) - 1, name));
    TableLines table = lines_of_table(std::move(lines), choice);
    DelimitedFile file;
    file.what = choice.what;
    file.name = name;
    file.content = content;
    file.layout = layout_of(fmt::format("{} '{}'", choice.what, name), table.lines, choice, table.separator);
    file.separator = file.layout.separator;
    file.header = file.layout.header;
    file.columns = file.layout.columns;
    if (file.layout.first_row >= table.lines.size())
        throw BadInput(fmt::format("{} '{}' has no rows of numbers; at least one is needed", choice.what, name));
    file.rows = std::move(table.lines);
    file.rows.erase(file.rows.begin(), file.rows.begin() + static_cast<std::ptrdiff_t>(file.layout.first_row));
    if (file.columns == 1 && !table.blank.empty()) file.rows = with_gaps(std::move(file.rows), table.blank);
    return file;
}

std::string at_line(const DelimitedFile& file, std::size_t row, const std::string& what) {
    return fmt::format("{} '{}', line {}: {}; the line reads '{}'", file.what, file.name, file.rows[row].line, what,
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
    const bool is_number = !wanted.empty() && *end == '\0';
    if (!is_number)
        if (const auto similar = similar_column(file, wanted)) return *similar;
    if (!is_number || number < 1 || static_cast<std::size_t>(number) > file.columns)
        throw BadInput(fmt::format("{} = '{}' is no column of '{}': {}{}", option, wanted, file.name, list_of(file),
                                   file.header.empty() ? "" : fmt::format(" (or a number, 1 to {})", file.columns)));
    return static_cast<std::size_t>(number - 1);
}

std::vector<std::vector<double>> numbers_of(const DelimitedFile& file, const std::vector<std::size_t>& wanted,
                                            const std::vector<bool>& gaps) {
    std::vector<std::vector<double>> columns(wanted.size());
    for (auto& column : columns) column.reserve(file.rows.size());
    CellReader reader(file);
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        const auto& cells = reader.at(row);
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            const std::string_view cell = cells[wanted[k]];
            const auto number = number_in(cell, file.layout.decimal);
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

ReadTimes times_of(const DelimitedFile& file, std::size_t column) {
    const auto first = clock_time_in(file.cells(0)[column]);
    if (!first) return {numbers_of(file, {column}, {false})[0], false};
    constexpr double day = 86400;
    double days = 0;
    ReadTimes times{{}, true};
    times.values.reserve(file.rows.size());
    CellReader reader(file);
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        const std::string_view cell = reader.at(row)[column];
        const auto time = clock_time_in(cell);
        if (!time)
            throw BadInput(at_line(file, row,
                                   fmt::format("'{}' in column {} is no time of the clock, as 12:30:00.25 or "
                                               "2024-10-07T12:30:00.25 is",
                                               shown(cell), column_name(file, column))));
        double value = static_cast<double>(time->seconds - first->seconds) + (time->fraction - first->fraction) + days;
        const bool has_date = static_cast<double>(time->seconds) >= 2 * day;
        if (!has_date && !times.values.empty() && value < times.values.back() - day / 2)  // over midnight
            days += day, value += day;
        times.values.push_back(value);
    }
    return times;
}

}  // namespace swirl::apps
