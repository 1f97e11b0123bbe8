#include "apps/input/bodies.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/input/cells.hpp"
#include "apps/input/column_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace swirl::apps {

namespace {

struct Seen {
    double last = -std::numeric_limits<double>::infinity();
    std::size_t rows = 0;
};

/// The values of a column, if it tells bodies apart.
///   times  of the rows; empty: unknown
std::optional<std::vector<std::string>> ids_in(const DelimitedFile& file, std::size_t column,
                                               const std::vector<double>& times) {
    std::unordered_map<std::string, Seen> seen;
    std::vector<std::string> ids;
    CellReader reader(file);
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        const std::string id(reader.at(row)[column]);
        if (is_missing(id)) continue;
        Seen& body = seen[id];
        if (body.rows++ == 0) ids.push_back(printable(id));
        if (times.empty()) continue;
        if (!(times[row] > body.last)) return std::nullopt;
        body.last = times[row];
        if (seen.size() > file.rows.size() / 2 + 1) return std::nullopt;
    }
    const bool repeated =
        std::all_of(seen.begin(), seen.end(), [](const auto& entry) { return entry.second.rows > 1; });
    // Of many fragments some may have one row.
    const bool mostly = 2 * seen.size() <= file.rows.size();
    if (ids.size() < 2 || !(repeated || mostly)) return std::nullopt;
    return ids;
}

/// A word or a whole number.
bool may_be_identity(const std::string& id) {
    const auto number = number_in(id);
    return !number || *number == std::floor(*number);
}

}  // namespace

bool rises(const std::vector<double>& values) {
    return std::adjacent_find(values.begin(), values.end(), [](double a, double b) { return !(b > a); }) ==
           values.end();
}

Bodies bodies_in(const DelimitedFile& file, std::optional<std::size_t> time, const std::vector<double>& times) {
    for (std::size_t k = 0; k < file.header.size(); ++k)
        if (time != k && names_body(file.header[k]))
            if (auto ids = ids_in(file, k, times)) return {k, std::move(*ids)};
    if (rises(times) || file.columns < 3) return {};
    for (std::size_t k = 0; k < file.columns; ++k) {
        if (time == k || (!file.header.empty() && (names_frame(file.header[k]) || names_spin(file.header[k]))))
            continue;
        auto ids = ids_in(file, k, times);
        if (ids && std::all_of(ids->begin(), ids->end(), may_be_identity)) return {k, std::move(*ids)};
    }
    return {};
}

std::vector<std::string> values_of(const DelimitedFile& file, std::size_t column) {
    std::vector<std::string> values;
    std::unordered_map<std::string, bool> seen;
    CellReader reader(file);
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        const std::string value(reader.at(row)[column]);
        if (!is_missing(value) && !std::exchange(seen[value], true)) values.push_back(value);
    }
    return values;
}

Condition condition_from(const DelimitedFile& file, const std::string& text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0)
        throw BadInput(fmt::format("where = '{}' is not COLUMN=VALUE, as particle=3 is", text));
    return {column_of(file, "--where", text.substr(0, equals)), text.substr(equals + 1)};
}

void keep_rows(DelimitedFile& file, const Condition& condition) {
    const char decimal = file.layout.decimal;
    const auto wanted = number_in(condition.value, decimal);
    std::vector<TextRow> kept;
    CellReader reader(file);
    for (std::size_t row = 0; row < file.rows.size(); ++row) {
        const std::string_view cell = reader.at(row)[condition.column];
        if (cell == condition.value || (wanted && number_in(cell, decimal) == wanted)) kept.push_back(file.rows[row]);
    }
    if (kept.empty())
        throw BadInput(fmt::format("where: no row of '{}' has {} = {}; its values are: {}", file.name,
                                   column_name(file, condition.column), condition.value,
                                   listed(values_of(file, condition.column))));
    file.rows = std::move(kept);
}

std::string listed(const std::vector<std::string>& values) {
    constexpr std::size_t most = 12;
    if (values.size() <= most) return printable(fmt::format("{}", fmt::join(values, ", ")));
    return printable(
        fmt::format("{} and {} others", fmt::join(values.begin(), values.begin() + most, ", "), values.size() - most));
}

void require_one_body(const DelimitedFile& file, const Bodies& bodies) {
    if (!bodies.column) return;
    const std::string name = column_name(file, *bodies.column);
    throw BadInput(fmt::format("series '{0}' holds {1} bodies, {2} = {3}: --where {2}={4} takes one, --each {2} all",
                               file.name, bodies.ids.size(), name, listed(bodies.ids), bodies.ids.front()));
}

}  // namespace swirl::apps
