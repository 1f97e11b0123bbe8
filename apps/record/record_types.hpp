#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace swirl::apps {

/// The conventions of README.md in this folder. A reader refuses records of a later number.
inline constexpr std::int64_t record_schema_version = 2;

enum class ElementType { float64, int64, int32, uint8, boolean, string };

/// What a dataset can be written from and read into; strings have functions of their own.
template <class T>
concept RecordElement = std::same_as<T, double> || std::same_as<T, std::int64_t> || std::same_as<T, std::int32_t> ||
    std::same_as<T, std::uint8_t> || std::same_as<T, bool>;

template <RecordElement T>
constexpr ElementType element_type() {
    if constexpr (std::same_as<T, double>) return ElementType::float64;
    if constexpr (std::same_as<T, std::int64_t>) return ElementType::int64;
    if constexpr (std::same_as<T, std::int32_t>) return ElementType::int32;
    if constexpr (std::same_as<T, std::uint8_t>) return ElementType::uint8;
    if constexpr (std::same_as<T, bool>) return ElementType::boolean;
}

using AttributeValue = std::variant<bool, std::int64_t, std::uint64_t, double, std::string, std::vector<std::int64_t>,
                                    std::vector<double>, std::vector<std::string>>;

/// A dimension of this size takes its length from the datasets that are appended to.
inline constexpr std::uint64_t growing = std::numeric_limits<std::uint64_t>::max();

/// What a dataset's numbers mean. Empty members are left out of the record.
struct Description {
    /// As CF and UDUNITS write them; "1" for a pure number. Not a word that xarray takes for a time span and converts
    /// to whole nanoseconds ("seconds", "days", ...): write "s".
    std::string units;
    std::string long_name;
    /// For integers that stand for names: value i (from 0) means flag_meanings[i]; names without blanks.
    std::vector<std::string> flag_meanings;
    /// A number times this is in the user's physical units. Not CF's scale_factor: readers do not apply it themselves.
    std::optional<double> physical_scale = {};
};

}  // namespace swirl::apps
