// One value of a result, as JSON, records and tables take it.
#pragma once

#include "apps/json/json_writer.hpp"
#include "apps/record/record_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace swirl::apps {

using Value = AttributeValue;

/// A number, truth, text, list of numbers, or an enumerator (its name).
template <class T>
Value value_from(const T& content) {
    if constexpr (requires { name_of(content); })
        return std::string(name_of(content));
    else if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::vector<double>>)
        return content;
    else if constexpr (std::is_unsigned_v<T>)
        return static_cast<std::uint64_t>(content);
    else if constexpr (std::is_integral_v<T>)
        return static_cast<std::int64_t>(content);
    else if constexpr (std::is_arithmetic_v<T>)
        return static_cast<double>(content);
    else
        return std::string(content);
}

/// How records store what value_from() takes.
template <class T>
constexpr ElementType element_of() {
    if constexpr (std::is_same_v<T, bool>) return ElementType::boolean;
    if constexpr (std::is_integral_v<T>) return ElementType::int64;
    if constexpr (std::is_floating_point_v<T> || std::is_same_v<T, std::vector<double>>) return ElementType::float64;
    return ElementType::string;
}

void write_value(JsonWriter& json, const Value& value);

/// A dataset of one dimension that takes values one by one: numbers, truths, or texts as their places in
/// `flag_meanings` (uint8). @throws std::logic_error for a text that flag_meanings lacks
std::function<void(const Value&)> column_of(const RecordGroup& group, const std::string& name, ElementType type,
                                            const std::vector<std::string>& dimensions, const Description& description);
/// A number, or a list that is filled up with NaN to `length`, at the end of a dataset's numbers.
void append_numbers(std::vector<double>& numbers, const Value& value, std::size_t length);
/// The value in a dataset of texts.
std::string text_of(const Value& value);

/// The names of the enumerators from the first, 0, to `last`.
template <class Enum>
std::vector<std::string> names_up_to(Enum last) {
    std::vector<std::string> names;
    for (int i = 0; i <= static_cast<int>(last); ++i) names.emplace_back(name_of(static_cast<Enum>(i)));
    return names;
}

/// How a column of a table for people looks.
struct ColumnFormat {
    std::string heading;  ///< the format of the heading
    std::function<std::string(const Value&)> text;
};

/// " {:>14.8g}": blanks before the column, alignment and width, precision. The heading has the same but for precision.
/// NaN, what is not there, is "-".
ColumnFormat column_format_of(const std::string& format);
/// A format, as column_format_of() reads it, with "-" for 0.
ColumnFormat dash_for_zero(const std::string& format);

}  // namespace swirl::apps
