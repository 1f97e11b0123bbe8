#include "apps/input/table_layout.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/input/cells.hpp"
#include "apps/input/column_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace swirl::apps {

namespace {

using Cells = std::vector<std::string>;

/// A row of measured values: a number or a time of the clock among them, or nothing but gaps.
bool is_row(const Cells& cells, char decimal) {
    bool all_missing = true;
    if (begins_pose_row(cells)) return false;
    for (const auto& cell : cells) {
        if (is_missing(cell)) continue;
        all_missing = false;
        if (number_in(cell, decimal) || clock_time_in(cell)) return true;
    }
    return all_missing;
}

bool has_word(const Cells& cells) {
    return std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
        return !number_in(cell, ',') && !is_missing(cell) && !looks_like_a_number(cell);
    });
}

/// Decimal commas, where they are no separators: numbers with a comma, and none with a point.
char decimal_of(const std::vector<TextRow>& lines, std::size_t first, char separator) {
    if (separator == ',') return '.';
    bool comma = false;
    for (std::size_t i = first; i < std::min(lines.size(), first + lines_looked_at); ++i)
        for (const auto& cell : cells_of(lines[i].text, separator)) {
            comma = comma || has_decimal_comma(cell);
            if (cell.find('.') != std::string::npos && number_in(cell)) return '.';
        }
    return comma ? ',' : '.';
}

/// The rows of a table that a separator makes of the last of the lines.
struct Run {
    char separator = ' ';
    std::size_t first = 0, columns = 0;
    double values = 0;  ///< share of the cells that are none of words; 0: no table
};

Run run_of(const std::vector<TextRow>& lines, char separator, bool decimal_comma) {
    const std::size_t count = std::min(lines.size(), lines_looked_at);
    Run run{separator, count, 0, 0};
    std::size_t values = 0, cells_seen = 0;
    while (run.first > 0) {
        const Cells cells = cells_of(lines[run.first - 1].text, separator);
        if (run.columns == 0) run.columns = cells.size();
        // In one column nothing shows that a comma separates nothing.
        const char decimal = separator == ',' || (run.columns == 1 && !decimal_comma) ? '.' : ',';
        if (cells.size() != run.columns || !is_row(cells, decimal)) break;
        for (const auto& cell : cells) values += is_value(cell, decimal) ? 1 : 0;
        cells_seen += cells.size();
        --run.first;
    }
    const std::size_t rows = count - run.first;
    // A line of numbers alone is a row that doesn't fit, no preamble.
    bool words_above = true;
    for (std::size_t i = 0; i < run.first; ++i) {
        const Cells cells = cells_of(lines[i].text, separator);
        words_above = words_above && (has_word(cells) || std::all_of(cells.begin(), cells.end(), is_missing));
    }
    if (rows >= 2 && words_above) run.values = static_cast<double>(values) / static_cast<double>(cells_seen);
    return run;
}

/// Of the separators the one that leaves fewest words, the first of equal ones.
Run best_run(const std::vector<TextRow>& lines, char given, bool decimal_comma) {
    Run best;
    for (const char separator : {'\t', ';', ',', ' '}) {
        if (given != 0 && separator != given) continue;
        const Run run = run_of(lines, separator, decimal_comma);
        if (run.values > best.values + 1e-9 ||
            (run.values > best.values - 1e-9 && run.columns > 1 && best.columns == 1))
            best = run;
    }
    return best;
}

/// The first line is the header, or the first row, and what follows has as many cells.
bool is_plain(const std::vector<TextRow>& lines, char separator, bool header) {
    const std::size_t columns = cells_of(lines.front().text, separator).size();
    const std::size_t count = std::min(lines.size(), lines_looked_at);
    if (header && count > 1 && !is_row(cells_of(lines[1].text, separator), separator == ',' ? '.' : ',')) return false;
    return std::all_of(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(count),
                       [&](const TextRow& row) { return cells_of(row.text, separator).size() == columns; });
}

void find_table(const std::vector<TextRow>& lines, char separator, bool decimal_comma, TableLayout& layout) {
    Cells first = cells_of(lines.front().text, layout.separator);
    layout.columns = first.size();
    const bool header = is_header(first);
    const Run run = is_plain(lines, layout.separator, header) ? Run{} : best_run(lines, separator, decimal_comma);
    if (run.values > 0) {
        layout.separator = run.separator;
        layout.columns = run.columns;
        layout.first_row = run.first;
        take_header(lines, layout);
    } else if (header) {
        layout.first_row = 1;
        layout.header = std::move(first);
    }
}

/// The header is the first of the lines, whatever it looks like; a row of units may follow.
void take_named_header(const std::vector<TextRow>& lines, char separator, bool decimal_comma, TableLayout& layout) {
    const Run run = best_run({lines.begin() + 1, lines.end()}, separator, decimal_comma);
    if (run.values > 0) layout.separator = run.separator;
    layout.header = cells_of(lines.front().text, layout.separator);
    layout.columns = run.values > 0 ? run.columns : layout.header.size();
    layout.first_row = 1 + (run.values > 0 ? run.first : 0);
    if (layout.first_row == 2) layout.units = cells_of(lines[1].text, layout.separator);
}

/// Rows and header do not fit unless commas are decimal ones, too.
void refuse_ambiguous(const std::string& file, const TextRow& row, std::size_t cells, std::size_t names) {
    throw BadInput(
        fmt::format("{}, line {}: {} cells between commas, where the header has {}: if half of the commas are decimal "
                    "ones, --decimal-comma says so; the line reads '{}'",
                    file, row.line, cells, names, printable(row.text.substr(0, 100))));
}

/// Rows of two whole numbers of which the second has leading zeros, or always as many digits: it may be a fraction.
bool may_be_decimal(const std::vector<TextRow>& lines, std::size_t first) {
    std::size_t digits = 0, rows = 0;
    bool leading_zero = false;
    for (std::size_t i = first; i < std::min(lines.size(), first + lines_looked_at); ++i, ++rows) {
        const Cells cells = cells_of(lines[i].text, ',');
        if (cells.size() != 2 || cells[1].empty()) return false;
        if (cells[0].find('.') != std::string::npos) return false;
        if (cells[1].find_first_not_of("0123456789") != std::string::npos) return false;
        if (digits != 0 && digits != cells[1].size()) return false;
        digits = cells[1].size();
        leading_zero = leading_zero || (digits > 1 && cells[1].front() == '0');
    }
    return rows >= 3 && digits > 1 && leading_zero;
}

void settle_commas(const std::string& file, const std::vector<TextRow>& lines, const LayoutChoice& choice,
                   TableLayout& layout) {
    if (!choice.decimal_comma) {
        layout.decimal = decimal_of(lines, layout.first_row, layout.separator);
        if (layout.separator == ',' && layout.columns == 2 && may_be_decimal(lines, layout.first_row))
            layout.notes.emplace_back(
                "the comma is taken for a separator; if it is a decimal comma, --decimal-comma says so");
        return;
    }
    layout.decimal = ',';
    if (layout.separator != ',') return;
    const std::size_t names = layout.header.empty() ? layout.columns / 2 : layout.header.size();
    if (layout.columns != 2 * names)
        throw BadInput(
            fmt::format("decimal-comma: the rows of '{}' have {} cells between commas: decimal commas need two "
                        "for each number, so {}",
                        file, layout.columns, 2 * std::max<std::size_t>(names, 1)));
    layout.comma_in_pairs = true;
    layout.columns = names;
}

}  // namespace

std::vector<std::string> cells_in(std::string_view line, const TableLayout& layout) {
    Cells cells = cells_of(line, layout.separator);
    if (layout.ends_in_separator && cells.size() == layout.columns + 1 && cells.back().empty()) cells.pop_back();
    if (!layout.comma_in_pairs || cells.size() != 2 * layout.columns) return cells;
    Cells joined;
    for (std::size_t k = 0; k + 1 < cells.size(); k += 2) joined.push_back(cells[k] + "," + cells[k + 1]);
    return joined;
}

TableLayout layout_of(const std::string& file, const std::vector<TextRow>& lines, const LayoutChoice& choice,
                      char separator) {
    TableLayout layout;
    if (lines.empty()) return layout;
    layout.separator = separator != 0 ? separator : separator_of(lines.front().text);
    if (choice.header_line)
        take_named_header(lines, separator, choice.decimal_comma, layout);
    else
        find_table(lines, separator, choice.decimal_comma, layout);
    if (layout.first_row >= lines.size()) return layout;
    if (!layout.header.empty() && layout.separator == ',' && layout.columns == 2 * layout.header.size() &&
        !choice.decimal_comma)
        refuse_ambiguous(file, lines[layout.first_row], layout.columns, layout.header.size());
    settle_commas(file, lines, choice, layout);
    if (!layout.header.empty() && layout.header.size() != layout.columns) fit_header(file, lines, layout);
    drop_empty_column(lines, layout);
    for (auto& name : layout.header) name = printable(name);
    if (layout.columns > 1 && !layout.header.empty() && layout.header.front().empty()) layout.header.front() = "row";
    if (layout.units.size() < layout.header.size()) layout.units.resize(layout.header.size());
    for (std::size_t k = 0; k < layout.header.size(); ++k)
        if (layout.units[k].empty()) layout.units[k] = unit_in_name(layout.header[k]);
    return layout;
}

}  // namespace swirl::apps
