// The tables that a record holds, whatever command wrote it.
#pragma once

#include "apps/output/value.hpp"
#include "apps/record/record_reader.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::show {

/// A dataset as a column: `width` values a row.
struct ShownColumn {
    std::string name;
    DatasetInfo info;
    bool truth = false;
    std::optional<std::size_t> axis;  ///< the coordinate of this dimension of the rows; none: a value for each row
    std::vector<std::string> labels;  ///< of the values of one row: "psi", "2_psi"; one that is empty: a single value
    std::size_t width() const { return labels.size(); }
};

/// Datasets of one group that have their rows in common. Rows run over the dimensions, the last fastest.
struct ShownTable {
    std::string group;  ///< "/orbits"
    std::string name;   ///< "orbits"; "recurrence/diagonal_length" of a group that holds several
    std::vector<std::string> dimensions;
    std::vector<std::uint64_t> shape;
    std::vector<ShownColumn> columns;
    std::uint64_t rows() const;
    /// Rows at one place of the first dimension.
    std::uint64_t rows_a_place() const;
};

/// A group's tables. Dimensions that number or name the values of one cell (bare ones and those whose coordinate is a
/// text, beyond the first) do not run over rows.
std::vector<ShownTable> tables_of(const RecordReader& record, const std::string& group);
/// Those of all groups.
std::vector<ShownTable> tables_of(const RecordReader& record);

using NamedValues = std::vector<std::pair<std::string, Value>>;
/// A group's attributes, and datasets of one value.
NamedValues attributes_of(const RecordReader& record, const std::string& group);

/// What some rows hold.
class ShownRows {
public:
    /// Of `count` places of the first dimension, from `first` on.
    ShownRows(const RecordReader& record, const ShownTable& table, std::uint64_t first, std::uint64_t count);
    std::uint64_t size() const { return size_; }
    /// Of a row, from 0 here. Names stand for the integers that mean them.
    Value at(std::size_t column, std::uint64_t row, std::size_t place) const;

private:
    struct Content {
        std::vector<double> reals;
        std::vector<std::int64_t> integers;
        std::vector<std::string> texts;
        bool whole = false;  ///< all of the dataset, not these rows
    };
    const ShownTable* table_;
    std::uint64_t first_ = 0, size_ = 0;
    std::vector<Content> contents_;
};

/// Calls `take` with all rows, a part of some thousand after another.
template <class Take>
void for_each_part(const RecordReader& record, const ShownTable& table, const Take& take) {
    constexpr std::uint64_t rows_together = 8192;
    const std::uint64_t step = std::max<std::uint64_t>(1, rows_together / table.rows_a_place());
    for (std::uint64_t place = 0; place < table.shape.front(); place += step)
        take(ShownRows(record, table, place, std::min(step, table.shape.front() - place)));
}

}  // namespace swirl::apps::show
