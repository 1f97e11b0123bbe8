// Names of enumerators, a table for each enumeration.
#pragma once

#include <initializer_list>
#include <string_view>

namespace swirl::analysis {

template <class Enum>
struct NamedEnumerator {
    Enum value;
    std::string_view name;
};

/// The name of an enumerator; "" of a value that is not in the table.
template <class Enum>
constexpr std::string_view name_in(std::initializer_list<NamedEnumerator<Enum>> table, Enum value) {
    for (const auto& [named, name] : table)
        if (named == value) return name;
    return {};
}

}  // namespace swirl::analysis
