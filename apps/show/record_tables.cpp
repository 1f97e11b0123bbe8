#include "apps/show/record_tables.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace swirl::apps::show {

namespace {

std::string path_of(const std::string& group, const std::string& name) {
    return (group == "/" ? "" : group) + "/" + name;
}

/// What a group's dimensions are called by: the texts of a coordinate, or numbers from 1.
struct Dimensions {
    const RecordReader& record;
    std::string group;
    std::map<std::string, DatasetInfo> coordinates;

    bool is_named(const std::string& dimension) const {
        const auto found = coordinates.find(dimension);
        return found != coordinates.end() && found->second.type == ElementType::string;
    }
    /// Beyond the first dimension: does it run over rows?
    bool runs_over_rows(const std::string& dimension) const {
        return coordinates.count(dimension) != 0 && !is_named(dimension);
    }
    std::vector<std::string> labels(const std::string& dimension, std::uint64_t size) const {
        if (is_named(dimension)) return record.read_strings(path_of(group, dimension));
        if (size == 1) return {""};
        std::vector<std::string> numbers;
        for (std::uint64_t i = 1; i <= size; ++i) numbers.push_back(fmt::format("{}", i));
        return numbers;
    }
};

std::size_t row_dimensions(const Dimensions& dimensions, const DatasetInfo& info) {
    std::size_t count = 1;
    for (std::size_t axis = 1; axis < info.dimensions.size(); ++axis)
        if (dimensions.runs_over_rows(info.dimensions[axis])) count = axis + 1;
    return count;
}

std::vector<std::string> labels_of(const Dimensions& dimensions, const DatasetInfo& info, std::size_t beyond) {
    std::vector<std::string> labels{""};
    for (std::size_t axis = beyond; axis < info.dimensions.size(); ++axis) {
        std::vector<std::string> longer;
        const auto own = dimensions.labels(info.dimensions[axis], info.shape[axis]);
        for (const auto& before : labels)
            for (const auto& label : own)
                longer.push_back(before.empty() || label.empty() ? before + label : before + "_" + label);
        labels = std::move(longer);
    }
    return labels;
}

bool is_truth(const RecordReader& record, const std::string& path, const DatasetInfo& info) {
    return info.type == ElementType::boolean ||
           (info.type == ElementType::uint8 && record.has_attribute(path, "dtype"));
}

ShownTable& table_with(std::vector<ShownTable>& tables, const std::string& group, const DatasetInfo& info,
                       std::size_t count) {
    const auto at = static_cast<std::ptrdiff_t>(count);
    const std::vector<std::string> dimensions(info.dimensions.begin(), info.dimensions.begin() + at);
    for (ShownTable& table : tables)
        if (table.dimensions == dimensions) return table;
    tables.push_back({group, group.substr(1), dimensions, {info.shape.begin(), info.shape.begin() + at}, {}});
    return tables.back();
}

/// The rows' own coordinates stand first. Of several tables those with fewer dimensions come first, and the others are
/// named by the dimension that they have beyond these.
void finish(std::vector<ShownTable>& tables, const Dimensions& dimensions) {
    std::stable_sort(tables.begin(), tables.end(),
                     [](const auto& a, const auto& b) { return a.dimensions.size() < b.dimensions.size(); });
    for (ShownTable& table : tables) {
        if (&table != &tables.front()) table.name += "/" + table.dimensions.back();
        std::vector<ShownColumn> coordinates;
        for (std::size_t axis = 0; axis < table.dimensions.size(); ++axis) {
            const auto found = dimensions.coordinates.find(table.dimensions[axis]);
            if (found != dimensions.coordinates.end())
                coordinates.push_back({found->first, found->second, false, axis, {""}});
        }
        table.columns.insert(table.columns.begin(), coordinates.begin(), coordinates.end());
    }
}

/// Of any type but doubles and texts; 1 is true.
std::vector<std::int64_t> integers_of(const RecordReader& record, const std::string& path, const DatasetInfo& info,
                                      const Slab& part) {
    if (info.type != ElementType::boolean) return record.read<std::int64_t>(path, part);
    const std::vector<bool> truths = record.read<bool>(path, part);
    return {truths.begin(), truths.end()};
}

std::string text_at(const std::vector<std::string>& names, std::int64_t number) {
    return number >= 0 && number < std::ssize(names) ? names[static_cast<std::size_t>(number)]
                                                     : fmt::format("{}", number);
}

}  // namespace

std::uint64_t ShownTable::rows() const {
    return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

std::uint64_t ShownTable::rows_a_place() const {
    return std::accumulate(shape.begin() + 1, shape.end(), std::uint64_t{1}, std::multiplies<>());
}

std::vector<ShownTable> tables_of(const RecordReader& record, const std::string& group) {
    Dimensions dimensions{record, group, {}};
    std::vector<std::pair<std::string, DatasetInfo>> columns;
    for (const auto& name : record.datasets(group)) {
        const DatasetInfo info = record.info(path_of(group, name));
        if (info.dimensions == std::vector{name})
            dimensions.coordinates.emplace(name, info);
        else if (!info.shape.empty())
            columns.emplace_back(name, info);
    }
    std::vector<ShownTable> tables;
    for (const auto& [name, info] : columns) {
        const std::size_t count = row_dimensions(dimensions, info);
        const bool truth = is_truth(record, path_of(group, name), info);
        table_with(tables, group, info, count)
            .columns.push_back({name, info, truth, {}, labels_of(dimensions, info, count)});
    }
    for (const auto& [name, info] : dimensions.coordinates) {
        const auto uses = [&, dimension = name](const auto& column) {
            const auto& all = column.second.dimensions;
            return std::find(all.begin(), all.end(), dimension) != all.end();
        };
        if (std::none_of(columns.begin(), columns.end(), uses)) table_with(tables, group, info, 1);
    }
    finish(tables, dimensions);
    return tables;
}

std::vector<ShownTable> tables_of(const RecordReader& record) {
    std::vector<ShownTable> tables;
    const std::function<void(const std::string&)> add = [&](const std::string& group) {
        if (group != "/")
            for (ShownTable& table : tables_of(record, group)) tables.push_back(std::move(table));
        for (const auto& name : record.groups(group)) add(path_of(group, name));
    };
    add("/");
    return tables;
}

NamedValues attributes_of(const RecordReader& record, const std::string& group) {
    NamedValues values;
    for (const auto& name : record.attributes(group)) values.emplace_back(name, record.attribute(group, name));
    for (const auto& name : record.datasets(group)) {
        const std::string path = path_of(group, name);
        const DatasetInfo info = record.info(path);
        if (!info.shape.empty()) continue;
        if (info.type == ElementType::string)
            values.emplace_back(name, record.read_strings(path).front());
        else if (info.type == ElementType::float64)
            values.emplace_back(name, record.read<double>(path).front());
        else
            values.emplace_back(name, integers_of(record, path, info, {}).front());
    }
    return values;
}

ShownRows::ShownRows(const RecordReader& record, const ShownTable& table, std::uint64_t first, std::uint64_t count)
    : table_(&table), first_(first * table.rows_a_place()), size_(count * table.rows_a_place()) {
    for (const ShownColumn& column : table.columns) {
        const std::string path = path_of(table.group, column.name);
        Content content;
        content.whole = column.axis || column.info.type == ElementType::string;
        Slab part;
        if (!content.whole) {
            part.offset.assign(column.info.shape.size(), 0);
            part.count = column.info.shape;
            part.offset.front() = first;
            part.count.front() = count;
        }
        if (column.info.type == ElementType::string)
            content.texts = record.read_strings(path);
        else if (column.info.type == ElementType::float64)
            content.reals = record.read<double>(path, part);
        else
            content.integers = integers_of(record, path, column.info, part);
        contents_.push_back(std::move(content));
    }
}

Value ShownRows::at(std::size_t number, std::uint64_t row, std::size_t place) const {
    const ShownColumn& column = table_->columns[number];
    const Content& content = contents_[number];
    std::uint64_t index = (content.whole ? first_ + row : row) * column.width() + place;
    if (column.axis) {
        index = first_ + row;
        for (std::size_t axis = table_->shape.size() - 1; axis > *column.axis; --axis) index /= table_->shape[axis];
        index %= table_->shape[*column.axis];
    }
    if (column.info.type == ElementType::string) return content.texts[index];
    if (column.info.type == ElementType::float64) return content.reals[index];
    const std::int64_t integer = content.integers[index];
    if (!column.info.description.flag_meanings.empty()) return text_at(column.info.description.flag_meanings, integer);
    if (column.truth) return integer != 0;
    return integer;
}

}  // namespace swirl::apps::show
