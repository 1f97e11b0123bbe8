#include "apps/command_line/documents.hpp"
#include "apps/show/show_command.hpp"
#include "apps/show/show_text.hpp"

#include "apps/command_line/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace swirl::apps::show {

namespace {

/// How many dimensions a row's values have.
std::size_t own_dimensions(const ShownTable& table, const ShownColumn& column) {
    return column.axis ? 0 : column.info.shape.size() - table.shape.size();
}

/// A section point as everywhere in JSON, {psi chi vn vt S}; of several those beyond a cycle's period are left out.
void write_points(JsonWriter& json, const ShownColumn& column, const std::vector<Value>& values, bool several) {
    const std::size_t size = column.info.shape.back();
    if (several) json.begin_array();
    for (std::size_t first = 0; first < values.size(); first += size) {
        const auto* number = std::get_if<double>(&values[first]);
        if (several && number != nullptr && std::isnan(*number)) continue;
        json.begin_object();
        for (std::size_t i = 0; i < size; ++i) {
            const std::string& label = column.labels[first + i];
            json.key(label.substr(label.rfind('_') + 1));
            write_value(json, values[first + i]);
        }
        json.end_object();
    }
    if (several) json.end_array();
}

void write_cell(JsonWriter& json, const ShownTable& table, const ShownColumn& column,
                const std::vector<Value>& values) {
    const std::size_t own = own_dimensions(table, column);
    if (own == 0) return write_value(json, values.front());
    if (column.info.dimensions.back() == "coordinate") return write_points(json, column, values, own > 1);
    json.begin_array();
    for (const Value& value : values) write_value(json, value);
    json.end_array();
}

void write_rows_of(JsonWriter& json, const RecordReader& record, const ShownTable& table) {
    json.begin_array(JsonLayout::rows);
    for_each_part(record, table, [&](const ShownRows& rows) {
        for (std::uint64_t row = 0; row < rows.size(); ++row) {
            json.begin_object();
            for (std::size_t c = 0; c < table.columns.size(); ++c) {
                std::vector<Value> values;
                for (std::size_t i = 0; i < table.columns[c].width(); ++i) values.push_back(rows.at(c, row, i));
                json.key(table.columns[c].name);
                write_cell(json, table, table.columns[c], values);
            }
            json.end_object();
        }
    });
    json.end_array();
}

void write_group(JsonWriter& json, const RecordReader& record, const std::string& group, NamedValues& of_lists) {
    const std::string name = group.substr(group.rfind('/') + 1);
    const NamedValues values = in_written_order(attributes_of(record, group));
    const auto tables = tables_of(record, group);
    json.key(name);
    const bool is_list = tables.size() == 1 && (values.empty() || name == tables.front().dimensions.back() + "s");
    if (is_list) {
        write_rows_of(json, record, tables.front());
        for (const auto& [key, value] : values) of_lists.emplace_back(name + "_" + key, value);
        return;
    }
    json.begin_object();
    for (const auto& [key, value] : values) {
        json.key(key);
        write_value(json, value);
    }
    for (const ShownTable& table : tables) {
        json.key(table.dimensions.back());
        write_rows_of(json, record, table);
    }
    for (const auto& inner : record.groups(group)) write_group(json, record, group + "/" + inner, of_lists);
    json.end_object();
}

}  // namespace

void print_record(const RecordReader& record, const ShowOptions& options) {
    const auto groups = record.groups("/");
    const bool all = options.group.empty();
    if (!all && std::find(groups.begin(), groups.end(), options.group) == groups.end())
        throw BadInput(fmt::format("group = {}: record '{}' holds no such group; it holds {}", options.group,
                                   options.record, fmt::join(groups, ", ")));
    print_document([&](JsonWriter& json) {
        json.key("record");
        json.begin_object();
        for (const auto& [key, value] : attributes_of(record, "/")) {
            json.key(key);
            write_value(json, value);
        }
        json.end_object();
        NamedValues of_lists;
        for (const auto& name : groups)
            if (all || name == options.group) write_group(json, record, "/" + name, of_lists);
        if (of_lists.empty()) return;
        json.key("attributes");
        json.begin_object();
        for (const auto& [key, value] : of_lists) {
            json.key(key);
            write_value(json, value);
        }
        json.end_object();
    });
}

}  // namespace swirl::apps::show
