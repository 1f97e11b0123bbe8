// One description of a result, of which its JSON, its record and its table for people are made (write_table.hpp).
#pragma once

#include "apps/output/value.hpp"

#include <concepts>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl::apps {

/// Where a column's units and meaning would stand: it is none of a record, but an attribute, or in JSON or a table
/// alone.
struct NoColumn {};
inline constexpr NoColumn no_column{};

/// A column of a result: its name, how it is read from a row, and what a record says of it. JSON and records list it
/// unless it says otherwise, tables for people if it is `shown`. Written as
///   {"mean_S", &Row::mean_spin, "1", "time mean of S"}
/// with a member or a function of a row that gives what value_from() takes. Units: "1" of a pure number, a count or a
/// truth, none of names.
template <class Row>
struct Field {
    template <class Reader>
    requires std::invocable<const Reader&, const Row&> Field(std::string its_name, Reader reader, std::string units,
                                                             std::string long_name)
        : name(std::move(its_name)),
          type(element_of<std::decay_t<std::invoke_result_t<const Reader&, const Row&>>>()),
          description{std::move(units), std::move(long_name), {}},
          read([reader](const Row& row) { return value_from(std::invoke(reader, row)); }) {}

    template <class Reader>
    requires std::invocable<const Reader&, const Row&> Field(std::string its_name, Reader reader, NoColumn)
        : Field(std::move(its_name), std::move(reader), "", "") {
        is_column = false;
    }

    /// A member of JSON alone, its content (an object, say) written by a function of the writer and a row.
    template <class Write>
    requires std::invocable<const Write&, JsonWriter&, const Row&> Field(std::string its_name, Write write)
        : name(std::move(its_name)), in_record(false), json_content(write) {}

    Field& record_only() { return in_json = false, *this; }
    Field& table_only() { return in_json = in_record = false, *this; }
    /// Left out everywhere unless `condition`: a disk has no chi.
    Field& when(bool condition) { return condition ? *this : (column_format.reset(), table_only()); }

    /// JSON says something else: null, an empty optional, where a record has 0, say.
    template <class Reader>
    Field& json_as(Reader reader) {
        return json_written([reader](JsonWriter& json, const Row& row) {
            const auto content = std::invoke(reader, row);
            if constexpr (requires { content.has_value(); })
                content ? write_value(json, value_from(*content)) : json.null();
            else
                write_value(json, value_from(content));
        });
    }
    /// JSON has content that a function writes.
    Field& json_written(std::function<void(JsonWriter&, const Row&)> write) {
        return json_content = std::move(write), *this;
    }
    /// JSON leaves the member out of the other rows.
    Field& json_if(std::function<bool(const Row&)> condition) { return json_condition = std::move(condition), *this; }

    /// In a record it is the coordinate of the rows' dimension, and is named as that.
    Field& coordinate() { return is_coordinate = true, *this; }
    /// In a record texts are stored as their places in `names`.
    Field& flags(std::vector<std::string> names) {
        type = ElementType::uint8;
        description.flag_meanings = std::move(names);
        return *this;
    }
    /// A record has another type than that of the values: int32, or a text for a seed, which needs all of 64 bits.
    Field& stored_as(ElementType other) { return type = other, *this; }
    /// A list, along dimensions of its own (declared by who writes the record); `length`: the product of their sizes.
    Field& along(std::vector<std::string> own_dimensions, std::size_t length) {
        dimensions = std::move(own_dimensions);
        row_length = length;
        return *this;
    }

    /// A table for people has it under this heading.
    Field& shown(std::string words, ColumnFormat how) {
        heading = std::move(words);
        column_format = std::move(how);
        return *this;
    }
    /// See column_format_of().
    Field& shown(std::string words, const char* format) { return shown(std::move(words), column_format_of(format)); }

    /// A table in SI units names this one: 1/s of an exponent, where "omega_s" would be rad/s.
    Field& in_si(std::string label) { return unit = std::move(label), *this; }

    std::string name;
    ElementType type = ElementType::string;
    Description description;
    std::function<Value(const Row&)> read;
    bool in_json = true, in_record = true, is_column = true, is_coordinate = false;
    std::function<void(JsonWriter&, const Row&)> json_content;
    std::function<bool(const Row&)> json_condition;
    std::vector<std::string> dimensions;  ///< a list's own
    std::size_t row_length = 0;
    std::string heading;
    std::string unit;  ///< that a table for people names, in SI: set by in_units(), unless it is named here
    std::optional<ColumnFormat> column_format;
};

/// Rows of a result. Outputs list the fields as they stand here; one that has another order names those that come
/// first.
template <class Row>
struct Table {
    std::vector<std::string> dimensions;  ///< of the rows in a record; several: row-major
    std::vector<Field<Row>> fields;
    std::vector<std::string> first_in_record = {}, first_in_table = {};
};

}  // namespace swirl::apps
