// What a description of a result (table.hpp) is for: JSON, records and tables for people.
#pragma once

#include "apps/output/table.hpp"
#include "apps/output/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace swirl::apps {

/// The fields that an output lists: those that come first there, then the others as described.
/// @throws std::logic_error for a name that the table does not have
template <class Row, class IsListed>
std::vector<Field<Row>> fields_of(const Table<Row>& table, const std::vector<std::string>& first,
                                  const IsListed& is_listed) {
    std::vector<Field<Row>> left = table.fields, fields;
    for (const auto& name : first) {
        const auto named =
            std::stable_partition(left.begin(), left.end(), [&](const auto& f) { return f.name != name; });
        if (named == left.end()) throw std::logic_error("a table has no field '" + name + "'");
        fields.insert(fields.end(), named, left.end());
        left.erase(named, left.end());
    }
    fields.insert(fields.end(), left.begin(), left.end());
    std::erase_if(fields, [&](const auto& field) { return !is_listed(field); });
    return fields;
}

/// A record's columns, with the names and all the dimensions of their datasets.
template <class Row>
std::vector<Field<Row>> record_columns(const Table<Row>& table) {
    auto fields =
        fields_of(table, table.first_in_record, [](const auto& field) { return field.in_record && field.is_column; });
    for (auto& field : fields) {
        if (field.is_coordinate) field.name = table.dimensions.front();
        field.dimensions.insert(field.dimensions.begin(), table.dimensions.begin(), table.dimensions.end());
    }
    return fields;
}

template <class Row>
std::vector<Field<Row>> shown_fields(const Table<Row>& table) {
    return fields_of(table, table.first_in_table, [](const auto& field) { return field.column_format.has_value(); });
}

// JSON.

/// One row, as members of an open object.
template <class Row>
void write_members(JsonWriter& json, const Table<Row>& table, const Row& row) {
    for (const auto& field : table.fields) {
        if (!field.in_json || (field.json_condition && !field.json_condition(row))) continue;
        json.key(field.name);
        if (field.json_content)
            field.json_content(json, row);
        else
            write_value(json, field.read(row));
    }
}

template <class Row>
void write_object(JsonWriter& json, const Table<Row>& table, const Row& row) {
    json.begin_object();
    write_members(json, table, row);
    json.end_object();
}

/// A list of objects, one a row.
template <class Row, class Rows>
void write_rows(JsonWriter& json, const Table<Row>& table, const Rows& rows, JsonLayout layout = JsonLayout::rows) {
    json.begin_array(layout);
    for (const Row& row : rows) write_object(json, table, row);
    json.end_array();
}
template <class Row, class Rows>
void write_json(JsonWriter& json, std::string_view key, const Table<Row>& table, const Rows& rows) {
    json.key(key);
    write_rows(json, table, rows);
}

/// Each field as a member of an open object: the list of its values.
template <class Row, class Rows>
void write_lists(JsonWriter& json, const Table<Row>& table, const Rows& rows) {
    for (const auto& field : table.fields) {
        if (!field.in_json) continue;
        json.key(field.name);
        json.begin_array();
        for (const Row& row : rows) write_value(json, field.read(row));
        json.end_array();
    }
}

// Records.

/// A column of rows along one dimension is handed on in pieces of so many numbers, which stay in the cache: a diagram
/// has millions of rows. Along several dimensions a piece would not be whole rows of the first one.
inline constexpr std::size_t numbers_at_once = 4096;

/// A dataset for each field, along dimensions that the group has already.
template <class Row, class Rows>
void write_columns(const RecordGroup& group, const Table<Row>& table, const Rows& rows) {
    for (const auto& field : record_columns(table)) {
        if (field.type == ElementType::string) {
            std::vector<std::string> texts;
            for (const Row& row : rows) texts.push_back(text_of(field.read(row)));
            group.write_strings(field.name, field.dimensions, texts, field.description);
        } else if (field.type == ElementType::float64) {
            auto column = group.column<double>(field.name, field.dimensions, field.description);
            std::vector<double> numbers;
            const auto write = [&] {
                column.append(numbers);
                numbers.clear();
            };
            for (const Row& row : rows) {
                append_numbers(numbers, field.read(row), field.row_length);
                if (table.dimensions.size() == 1 && numbers.size() >= numbers_at_once) write();
            }
            write();
        } else {
            const auto append = column_of(group, field.name, field.type, field.dimensions, field.description);
            for (const Row& row : rows) append(field.read(row));
        }
    }
}

/// The rows' dimension, and a dataset for each field.
template <class Row, class Rows>
void write_record(const RecordGroup& group, const Table<Row>& table, const Rows& rows) {
    group.dimension(table.dimensions.front(), rows.size());
    write_columns(group, table, rows);
}

/// One row as attributes; empty lists are left out.
template <class Row>
void write_attributes(const RecordGroup& group, const Table<Row>& table, const Row& row) {
    for (const auto& field : fields_of(table, table.first_in_record, [](const auto& f) { return f.in_record; })) {
        const Value value = field.read(row);
        const auto* list = std::get_if<std::vector<double>>(&value);
        if (list == nullptr || !list->empty()) group.attribute(field.name, value);
    }
}

/// Rows that come one by one, along a dimension that grows with them; no texts, no lists.
template <class Row>
class RecordRows {
public:
    RecordRows(const RecordGroup& group, const Table<Row>& table) : fields_(record_columns(table)) {
        group.dimension(table.dimensions.front(), growing);
        for (const auto& field : fields_)
            columns_.push_back(column_of(group, field.name, field.type, field.dimensions, field.description));
    }

    void add(const Row& row) {
        for (std::size_t i = 0; i < fields_.size(); ++i) columns_[i](fields_[i].read(row));
    }

private:
    std::vector<Field<Row>> fields_;
    std::vector<std::function<void(const Value&)>> columns_;
};

// Tables for people, of shown_fields().

/// A table with what it shows in SI units, if there are any: numbers of a field are multiplied by what its units
/// ask for, and its heading names the unit (shown_unit()).
template <class Row>
Table<Row> in_units(Table<Row> table, const std::optional<Units>& units) {
    for (auto& field : table.fields) {
        const auto shown = units ? shown_unit(*units, field.description.units) : std::nullopt;
        if (!units)
            field.unit.clear();
        else if (field.unit.empty())
            field.unit = shown ? shown->label : unit_label(field.description.units);
        if (!shown) continue;
        if (!field.column_format) {
            if (!field.read) continue;
            field.read = [read = field.read, scale = shown->scale](const Row& row) {
                const Value value = read(row);
                const auto* number = std::get_if<double>(&value);
                return number != nullptr ? Value(*number * scale) : value;
            };
            continue;
        }
        field.column_format->text = [text = field.column_format->text, scale = shown->scale](const Value& value) {
            const auto* number = std::get_if<double>(&value);
            return text(number != nullptr ? Value(*number * scale) : value);
        };
    }
    return table;
}

template <class Row>
std::string heading_of(const std::vector<Field<Row>>& shown) {
    std::string line;
    std::string units;
    for (const auto& field : shown) {
        line += fmt::format(fmt::runtime(field.column_format->heading), field.heading);
        units += fmt::format(fmt::runtime(field.column_format->heading), field.unit);
    }
    units.erase(units.find_last_not_of(' ') + 1);
    return line + "\n" + (units.empty() ? "" : units + "\n");
}

template <class Row>
std::string line_of(const std::vector<Field<Row>>& shown, const Row& row) {
    std::string line;
    for (const auto& field : shown) line += field.column_format->text(field.read(row));
    return line + "\n";
}

template <class Row, class Rows>
void print_table(const Table<Row>& table, const Rows& rows) {
    const auto shown = shown_fields(table);
    fmt::print("{}", heading_of(shown));
    for (const Row& row : rows) fmt::print("{}", line_of(shown, row));
}

/// One row as lines, heading and value of each shown field; a number that is not finite is left out.
template <class Row>
std::string shown_lines_of(const Table<Row>& table, const Row& row) {
    std::string lines;
    for (const auto& field : shown_fields(table)) {
        const Value value = field.read(row);
        const auto* number = std::get_if<double>(&value);
        if (number == nullptr || std::isfinite(*number))
            lines += fmt::format("  {:<33} {}{}{}\n", field.heading, field.column_format->text(value),
                                 field.unit.empty() ? "" : " ", field.unit);
    }
    return lines;
}

/// One row as lines, a name and a number each; only finite numbers that are no integers.
template <class Row>
std::string lines_of(const Table<Row>& table, const Row& row) {
    std::string lines;
    for (const auto& field : table.fields) {
        if (!field.read) continue;
        const Value value = field.read(row);
        const auto* number = std::get_if<double>(&value);
        if (number != nullptr && std::isfinite(*number))
            lines +=
                fmt::format("  {:<33} {:>16.8g}{}{}\n", field.name, *number, field.unit.empty() ? "" : " ", field.unit);
    }
    return lines;
}

}  // namespace swirl::apps
