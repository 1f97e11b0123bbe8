#include "apps/command_line/documents.hpp"
#include "apps/record/output_file.hpp"
#include "apps/show/show_command.hpp"
#include "apps/show/show_text.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace swirl::apps::show {

namespace {

/// As RFC 4180 has it: quotes where a text holds what divides cells.
std::string cell_of(const Value& value) {
    std::string text = text_of_value(value);
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + "\"";
}

std::string meaning_of(const ShownColumn& column) {
    const apps::Description& d = column.info.description;
    const std::string units = d.units.empty() || d.units == "1" ? "" : fmt::format(" [{}]", d.units);
    const std::string scale = d.physical_scale ? fmt::format("; times {} in the user's units", *d.physical_scale) : "";
    return fmt::format("# {}{}: {}{}\n", column.name, units, d.long_name, scale);
}

std::string head_of(const RecordReader& record, const ShownTable& table) {
    std::string head = fmt::format("# {}\n# table {}", text_of_value(record.attribute("/", "title")), table.name);
    for (const char* const name : {"command", "swirl_version"})
        if (record.has_attribute("/", name))
            head += fmt::format(", {} {}", name, text_of_value(record.attribute("/", name)));
    head += "\n";
    for (const char* const group : {"/scene", "/units"})
        if (record.contains(group))
            for (const auto& [name, value] : in_written_order(attributes_of(record, group)))
                head += fmt::format("# {} {} = {}\n", group + 1, name, text_of_value(value));
    for (const ShownColumn& column : table.columns) head += meaning_of(column);
    std::string names;
    for (const ShownColumn& column : table.columns)
        for (const auto& label : column.labels) {
            if (!names.empty()) names += ",";
            names += cell_of(heading_of_value(column, label));
        }
    return head + names + "\n";
}

std::string lines_of(const ShownTable& table, const ShownRows& rows) {
    std::string lines;
    for (std::uint64_t row = 0; row < rows.size(); ++row) {
        bool first = true;
        for (std::size_t column = 0; column < table.columns.size(); ++column)
            for (std::size_t place = 0; place < table.columns[column].width(); ++place) {
                if (!first) lines += ",";
                first = false;
                lines += cell_of(rows.at(column, row, place));
            }
        lines += "\n";
    }
    return lines;
}

}  // namespace

void write_csv(const RecordReader& record, const ShownTable& table, const std::string& file) {
    OutputFile output(file, "table");
    output.append(head_of(record, table));
    for_each_part(record, table, [&](const ShownRows& rows) { output.append(lines_of(table, rows)); });
    output.commit();
}

}  // namespace swirl::apps::show
