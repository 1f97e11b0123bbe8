#include "apps/show/show_text.hpp"

#include "apps/command_line/documents.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/show/show_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace swirl::apps::show {

namespace {

std::string text_with(const Value& value, const char* number) {
    return std::visit(
        [number](const auto& content) -> std::string {
            using T = std::decay_t<decltype(content)>;
            if constexpr (std::is_same_v<T, bool>) return content ? "true" : "false";
            if constexpr (std::is_same_v<T, double>)
                return std::isnan(content) ? "nan" : fmt::format(fmt::runtime(number), content);
            if constexpr (std::is_same_v<T, std::string>) return content;
            if constexpr (std::is_integral_v<T>) return fmt::format("{}", content);
            if constexpr (!std::is_arithmetic_v<T> && !std::is_same_v<T, std::string>)
                return fmt::format("{}", fmt::join(content, " "));
        },
        value);
}

}  // namespace

std::string text_of_value(const Value& value) {
    return text_with(value, "{}");
}

std::string short_text_of(const Value& value) {
    return text_with(value, "{:.10g}");
}

std::string heading_of_value(const ShownColumn& column, const std::string& label) {
    return label.empty() ? column.name : column.name + "_" + label;
}

NamedValues in_written_order(const NamedValues& values) {
    constexpr std::array after_scene{"speed", "seed", "x",  "y",  "vx", "vy",     "angle", "spin",
                                     "psi",   "chi",  "vn", "vt", "S",  "length", "time",  "mass"};
    const auto index_in = [](const auto& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) - names.begin();
    };
    const auto place = [&](const auto& named) {
        const auto index = index_in(scene_setting_names, named.first);
        const auto scene = static_cast<std::ptrdiff_t>(scene_setting_names.size());
        return index < scene ? index : scene + index_in(after_scene, named.first);
    };
    NamedValues sorted = values;
    std::stable_sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
    return sorted;
}

namespace {

constexpr std::size_t widest_line = most_columns;
constexpr std::size_t most_values = 12;  ///< of a list that a table for people has

/// "name value, name value", in lines that are not longer than a terminal's.
std::string in_lines(const std::string& head, const NamedValues& values) {
    std::string text = head, line = head;
    bool first = true;
    for (const auto& [name, value] : values) {
        const std::string words = fmt::format("{} {}", name, short_text_of(value));
        if (!first) text += ",", line += ",";
        if (!first && line.size() + words.size() + 2 > widest_line) {
            line = wrapped("    " + words + ",", 6);  // a comma may follow
            line.pop_back();
            text += "\n" + line;
            line.erase(0, line.rfind('\n') + 1);
        } else {
            text += " " + words;
            line += " " + words;
        }
        first = false;
    }
    return text + "\n";
}

/// One column of the printed table, as wide as what it holds.
struct Printed {
    std::vector<std::string> cells;  ///< the heading first
    std::size_t width = 0;
    bool left = false;  ///< words stand at the left

    void add(std::string cell) {
        width = std::max(width, cell.size());
        cells.push_back(std::move(cell));
    }
};

std::vector<Printed> printed_columns(const ShownTable& table, const ShownRows& rows, std::uint64_t count) {
    std::vector<Printed> columns;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const ShownColumn& column = table.columns[c];
        if (column.width() > most_values) continue;
        for (std::size_t place = 0; place < column.width(); ++place) {
            Printed printed;
            printed.left = column.info.type == ElementType::string || !column.info.description.flag_meanings.empty();
            printed.add(heading_of_value(column, column.labels[place]));
            for (std::uint64_t row = 0; row < count; ++row) printed.add(short_text_of(rows.at(c, row, place)));
            columns.push_back(std::move(printed));
        }
    }
    return columns;
}

/// Columns side by side as far as a line goes, the others below, each block with the rows' numbers.
std::string in_blocks(const Printed& numbers, const std::vector<Printed>& columns) {
    std::string text;
    for (std::size_t first = 0; first < columns.size();) {
        std::size_t width = 2 + numbers.width, end = first;
        do {
            width += 2 + columns[end++].width;
        } while (end < columns.size() && width + 2 + columns[end].width <= widest_line);
        for (std::size_t line = 0; line < numbers.cells.size(); ++line) {
            std::string words = fmt::format("  {:>{}}", numbers.cells[line], numbers.width);
            for (std::size_t c = first; c < end; ++c)
                words += columns[c].left ? fmt::format("  {:<{}}", columns[c].cells[line], columns[c].width)
                                         : fmt::format("  {:>{}}", columns[c].cells[line], columns[c].width);
            words.erase(words.find_last_not_of(' ') + 1);
            text += words + "\n";
        }
        first = end;
        if (first < columns.size()) text += "\n";
    }
    return text;
}

std::string text_of_table(const RecordReader& record, const ShownTable& table, std::int64_t most_rows) {
    const std::uint64_t count = std::min<std::uint64_t>(table.rows(), static_cast<std::uint64_t>(most_rows));
    const std::uint64_t a_place = table.rows_a_place();
    const ShownRows rows(record, table, 0, (count + a_place - 1) / a_place);
    Printed numbers;
    numbers.add("");
    for (std::uint64_t row = 1; row <= count; ++row) numbers.add(fmt::format("{}", row));
    std::string text = in_blocks(numbers, printed_columns(table, rows, count));
    for (const ShownColumn& column : table.columns)
        if (column.width() > most_values)
            text += fmt::format("  {}: {} values a row, which --json and --csv give\n", column.name, column.width());
    if (count < table.rows())
        text += fmt::format("  rows 1 to {} of {}; --rows {} prints all\n", count, table.rows(), table.rows());
    return text;
}

std::string text_of_group(const RecordReader& record, const std::string& group, std::int64_t most_rows) {
    const NamedValues values = in_written_order(attributes_of(record, group));
    const auto tables = tables_of(record, group);
    if (values.empty() && tables.empty()) return "";
    std::string text = values.empty() ? "" : in_lines(group.substr(1) + ":", values);
    for (const ShownTable& table : tables) {
        const std::string rows = table.rows() == 1 ? "1 row" : fmt::format("{} rows", table.rows());
        text += fmt::format("{}: {}\n", table.name, rows) + text_of_table(record, table, most_rows);
    }
    return text;
}

/// What made a record stands before what it holds.
std::vector<std::string> groups_in_order(const RecordReader& record, const std::string& parent) {
    std::vector<std::string> names = record.groups(parent);
    const auto makes = [](const std::string& name) {
        return name == "scene" || name == "start" || name == "units" || name == "settings";
    };
    std::stable_partition(names.begin(), names.end(), makes);
    return names;
}

/// A group and those within it, or one table.
std::string text_asked_for(const RecordReader& record, const ShowOptions& options) {
    std::string text;
    std::vector<std::string> names;
    const std::function<void(const std::string&, bool)> add = [&](const std::string& parent, bool wanted) {
        for (const auto& name : groups_in_order(record, parent)) {
            const std::string group = (parent == "/" ? "" : parent) + "/" + name;
            names.push_back(group.substr(1));
            const bool asked = wanted || group.substr(1) == options.group;
            if (asked) text += text_of_group(record, group, options.rows);
            add(group, asked);
        }
    };
    add("/", options.group.empty());
    for (const ShownTable& table : tables_of(record))
        if (text.empty() && table.name == options.group) text = text_of_table(record, table, options.rows);
    if (text.empty() && !options.group.empty())
        throw BadInput(fmt::format("group = {}: record '{}' holds no such group; it holds {}", options.group,
                                   options.record, fmt::join(names, ", ")));
    return text;
}

}  // namespace

std::string text_of(const RecordReader& record, const ShowOptions& options) {
    std::string head = text_of_value(record.attribute("/", "title")) + "\n";
    if (record.has_attribute("/", "command"))
        head += fmt::format("  written by swirl {} {} ({})\n", text_of_value(record.attribute("/", "command")),
                            text_of_value(record.attribute("/", "swirl_version")),
                            text_of_value(record.attribute("/", "instruction_set")));
    return head + text_asked_for(record, options);
}

}  // namespace swirl::apps::show
