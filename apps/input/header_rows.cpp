#include "apps/input/header_rows.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/printable.hpp"
#include "apps/input/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace swirl::apps {

namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t most_rows = 6;  // of names

template <std::size_t N>
bool is_among(const std::array<const char*, N>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_unit(const std::string& cell) {
    static constexpr std::array units = {"s",   "sec", "ms", "us",    "µs",    "min",    "h",    "m",     "mm",
                                         "cm",  "um",  "µm", "px",    "pixel", "pixels", "deg",  "°",     "degrees",
                                         "rad", "rpm", "Hz", "rad/s", "deg/s", "m/s",    "mm/s", "frame", "frames"};
    if (is_among(units, cell)) return true;
    return cell.size() > 1 &&
           ((cell.front() == '(' && cell.back() == ')') || (cell.front() == '[' && cell.back() == ']'));
}

bool are_units(const Cells& cells) {
    bool any = false;
    for (const auto& cell : cells) {
        if (!cell.empty() && !is_unit(cell)) return false;
        any = any || !cell.empty();
    }
    return any;
}

/// The rows of names directly above the first row of numbers, from above.
std::vector<Cells> rows_of_names(const std::vector<TextRow>& lines, const TableLayout& layout) {
    std::vector<Cells> rows;
    for (std::size_t i = layout.first_row; i > 0 && rows.size() < most_rows; --i) {
        Cells cells = cells_of(lines[i - 1].text, layout.separator);
        if (!is_header(cells) && !begins_pose_row(cells)) break;
        if ((layout.columns > 1 && cells.size() < 2) || cells.size() > layout.columns + 1) break;
        rows.insert(rows.begin(), std::move(cells));
    }
    return rows;
}

/// "tip.x" of bodyparts and coords; the scorer is the same everywhere, and one individual's name says nothing.
Cells pose_names(const std::vector<Cells>& rows, std::size_t columns) {
    Cells names{"frame"};
    for (std::size_t k = 1; k < columns; ++k) {
        std::string name;
        for (const Cells& row : rows) {
            if (k >= row.size() || row.front() == "scorer") continue;
            const bool same = std::all_of(row.begin() + 1, row.end(), [&](const auto& cell) { return cell == row[1]; });
            if (row.front() == "individuals" && same) continue;
            name += (name.empty() ? "" : ".") + row[k];
        }
        names.push_back(name);
    }
    return names;
}

/// An upper row names groups of columns where it, or the row below it, begins with an empty cell.
bool names_groups(const Cells& upper, const Cells& lower) {
    const bool has_empty = std::any_of(upper.begin() + 1, upper.end(), [](const auto& cell) { return cell.empty(); });
    return (upper.front().empty() || lower.front().empty()) && (has_empty || upper.size() < lower.size());
}

Cells group_names(const Cells& upper, const Cells& lower, std::size_t columns) {
    const auto cell = [](const Cells& cells, std::size_t k) { return k < cells.size() ? cells[k] : std::string(); };
    Cells groups;
    std::set<std::string> different;
    for (std::size_t k = 0; k < columns; ++k) {
        const std::string group = cell(upper, k);
        groups.push_back(group.empty() && k > 0 ? groups.back() : group);
        if (!groups.back().empty() && !cell(lower, k).empty()) different.insert(groups.back());
    }
    Cells names;
    for (std::size_t k = 0; k < columns; ++k) {
        const std::string name = cell(lower, k);
        const bool plain = groups[k].empty() || different.size() < 2;
        names.push_back(name.empty() ? cell(upper, k) : plain ? name : groups[k] + "." + name);
    }
    return names;
}

/// The names, and how many of the rows hold them, from below.
std::pair<Cells, std::size_t> names_in(const std::vector<Cells>& rows, std::size_t columns) {
    const std::size_t n = rows.size();
    std::size_t pose = 0;
    while (pose < n && begins_pose_row(rows[n - 1 - pose])) ++pose;
    if (pose > 0) return {pose_names({rows.end() - static_cast<std::ptrdiff_t>(pose), rows.end()}, columns), pose};
    if (n >= 3 && rows[n - 1] == rows[n - 2] && rows[n - 3].size() == rows[n - 1].size()) return {rows[n - 3], 3};
    if (n >= 2 && names_groups(rows[n - 2], rows[n - 1])) return {group_names(rows[n - 2], rows[n - 1], columns), 2};
    return {rows[n - 1], 1};
}

bool last_cells_are_empty(const std::vector<TextRow>& lines, const TableLayout& layout) {
    for (std::size_t i = layout.first_row; i < std::min(lines.size(), layout.first_row + lines_looked_at); ++i) {
        const Cells cells = cells_of(lines[i].text, layout.separator);
        if (cells.size() != layout.columns || !cells.back().empty()) return false;
    }
    return true;
}

}  // namespace

bool begins_pose_row(const Cells& cells) {
    static constexpr std::array names = {"scorer", "individuals", "bodyparts", "coords"};
    return is_among(names, cells.front());
}

bool is_header(const Cells& cells) {
    bool word = false;
    for (const auto& cell : cells) {
        if (number_in(cell) || has_decimal_comma(cell)) return false;
        word = word || !(is_missing(cell) || looks_like_a_number(cell) || clock_time_in(cell));
    }
    return word;
}

void take_header(const std::vector<TextRow>& lines, TableLayout& layout) {
    std::vector<Cells> rows = rows_of_names(lines, layout);
    const std::size_t seen = rows.size();
    if (rows.size() > 1 && are_units(rows.back())) {
        layout.units = std::move(rows.back());
        rows.pop_back();
    }
    const bool has_units = rows.size() < seen;
    std::size_t used = 0;
    if (!rows.empty()) std::tie(layout.header, used) = names_in(rows, layout.columns);
    const std::size_t above = layout.first_row - used - (has_units ? 1 : 0);
    if (above == 0) return;
    const std::size_t last = lines[above - 1].line;
    layout.notes.push_back(last == 1 ? "line 1 is above the table and is not read"
                                     : fmt::format("lines 1 to {} are above the table and are not read", last));
}

void fit_header(const std::string& file, const std::vector<TextRow>& lines, TableLayout& layout) {
    const std::size_t names = layout.header.size();
    if (names == layout.columns + 1 && layout.header.back().empty()) {
        layout.header.pop_back();
    } else if (names + 1 == layout.columns && last_cells_are_empty(lines, layout)) {
        layout.columns = names;
        layout.ends_in_separator = true;
    } else if (names + 1 == layout.columns) {
        layout.header.insert(layout.header.begin(), "row");
        if (!layout.units.empty()) layout.units.insert(layout.units.begin(), "");
        layout.notes.emplace_back("the header has a name less than rows have cells: the first cells name the rows");
    } else {
        const TextRow& row = lines[layout.first_row];
        throw BadInput(fmt::format("{}, line {}: {} cells, where {} are needed; the line reads '{}'", file, row.line,
                                   layout.columns, names, printable(row.text.substr(0, 100))));
    }
}

void drop_empty_column(const std::vector<TextRow>& lines, TableLayout& layout) {
    if (layout.columns < 2 || layout.separator == ' ' || layout.comma_in_pairs || layout.ends_in_separator) return;
    if (!layout.header.empty() && !layout.header.back().empty()) return;
    if (!last_cells_are_empty(lines, layout)) return;
    --layout.columns;
    layout.ends_in_separator = true;
    if (!layout.header.empty()) layout.header.pop_back();
}

std::string unit_in_name(const std::string& name) {
    for (const auto& [open, close] : {std::pair('(', ')'), std::pair('[', ']')})
        if (const std::size_t begin = name.rfind(open);
            !name.empty() && name.back() == close && begin != std::string::npos)
            return name.substr(begin + 1, name.size() - begin - 2);
    const std::size_t underscore = name.rfind('_');
    static constexpr std::array units = {"s", "sec", "ms", "us", "min", "px", "mm", "cm", "deg", "rad"};
    if (underscore == std::string::npos || !is_among(units, std::string_view(name).substr(underscore + 1))) return "";
    return name.substr(underscore + 1);
}

}  // namespace swirl::apps
