#include "apps/show/value_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

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
    constexpr std::array order{"sides", "alpha", "beta", "mu", "restitution", "law", "inertia_factor",
                               "speed", "seed",  "x",    "y",  "vx",          "vy",  "angle",
                               "spin",  "psi",   "chi",  "vn", "vt",          "S",   "length",
                               "time",  "mass"};
    const auto place = [&](const auto& named) {
        return std::find(order.begin(), order.end(), named.first) - order.begin();
    };
    NamedValues sorted = values;
    std::stable_sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
    return sorted;
}

}  // namespace swirl::apps::show
