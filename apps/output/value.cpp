#include "apps/output/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace swirl::apps {

namespace {

std::uint8_t place_in(const std::vector<std::string>& meanings, const std::string& text) {
    const auto found = std::find(meanings.begin(), meanings.end(), text);
    if (found == meanings.end()) throw std::logic_error("'" + text + "' is no meaning of its column's flags");
    return static_cast<std::uint8_t>(found - meanings.begin());
}

template <class Integer>
Integer integer_of(const Value& value) {
    if (const auto* natural = std::get_if<std::uint64_t>(&value)) return static_cast<Integer>(*natural);
    if (const auto* truth = std::get_if<bool>(&value)) return *truth ? 1 : 0;
    return static_cast<Integer>(std::get<std::int64_t>(value));
}

template <class Integer>
std::function<void(const Value&)> integers(Column<Integer> column) {
    return [column](const Value& value) mutable { column.append(integer_of<Integer>(value)); };
}

}  // namespace

void write_value(JsonWriter& json, const Value& value) {
    std::visit(
        [&](const auto& content) {
            if constexpr (requires { json.value(content); })
                json.value(content);
            else
                json.array(content);
        },
        value);
}

std::function<void(const Value&)> column_of(const RecordGroup& group, const std::string& name, ElementType type,
                                            const std::vector<std::string>& dimensions,
                                            const Description& description) {
    if (type == ElementType::int64) return integers(group.column<std::int64_t>(name, dimensions, description));
    if (type == ElementType::int32) return integers(group.column<std::int32_t>(name, dimensions, description));
    if (type == ElementType::boolean)
        return [column = group.column<bool>(name, dimensions, description)](const Value& value) mutable {
            column.append(std::get<bool>(value));
        };
    if (type == ElementType::uint8)
        return [column = group.column<std::uint8_t>(name, dimensions, description),
                meanings = description.flag_meanings](const Value& value) mutable {
            column.append(place_in(meanings, std::get<std::string>(value)));
        };
    return [column = group.column<double>(name, dimensions, description)](const Value& value) mutable {
        column.append(std::get<double>(value));
    };
}

void append_numbers(std::vector<double>& numbers, const Value& value, std::size_t length) {
    if (const auto* number = std::get_if<double>(&value)) return numbers.push_back(*number);
    const auto& list = std::get<std::vector<double>>(value);
    numbers.insert(numbers.end(), list.begin(), list.end());
    numbers.resize(numbers.size() + length - list.size(), std::numeric_limits<double>::quiet_NaN());
}

std::string text_of(const Value& value) {
    if (const auto* natural = std::get_if<std::uint64_t>(&value)) return fmt::format("{}", *natural);
    return std::get<std::string>(value);
}

ColumnFormat column_format_of(const std::string& format) {
    std::string heading = format;  // "{:>14.8g}" -> "{:>14}"
    const auto precision = heading.find('.');
    if (precision != std::string::npos) heading.erase(precision, heading.find('}') - precision);
    return {heading, [format, heading](const Value& value) {
                const auto fill = [&](const auto& content) -> std::string {
                    using Content = std::decay_t<decltype(content)>;
                    if constexpr (std::is_floating_point_v<Content>)
                        if (std::isnan(content)) return fmt::format(fmt::runtime(heading), "-");
                    if constexpr (std::is_arithmetic_v<Content> || std::is_same_v<Content, std::string>)
                        return fmt::format(fmt::runtime(format), content);
                    throw std::logic_error("a list as a column of a table");
                };
                return std::visit(fill, value);
            }};
}

ColumnFormat dash_for_zero(const std::string& format) {
    const ColumnFormat plain = column_format_of(format);
    return {plain.heading, [plain](const Value& value) {
                return integer_of<std::int64_t>(value) == 0 ? fmt::format(fmt::runtime(plain.heading), "-")
                                                            : plain.text(value);
            }};
}

}  // namespace swirl::apps
