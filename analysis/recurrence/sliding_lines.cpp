#include "analysis/recurrence/sliding_lines.hpp"

#include "analysis/recurrence/bit_tree.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace swirl::analysis::recurrence::detail {
namespace {

constexpr int widest_window = 16;

struct Line {
    std::size_t begin, end;  // rows begin ... end - 1
};

// Consecutive lines around one row; P and N of them, if any, lie whole on either side.
struct Neighbourhood {
    std::array<Line, 4> lines;
    std::size_t count = 0;
    bool from_first = true, to_last = true;  // no line before the first of these, none after the last

    void push(Line line) { lines[count++] = line; }
};

// The lines of one column, and the histograms of all columns.
class SlidingColumn {
public:
    SlidingColumn(std::size_t rows, std::size_t longest, const Settings& settings)
        : rows_(rows), settings_(settings), members_(rows, false), others_(rows, true) {
        counts.lines.assign(longest + 1, 0);
        counts.times.assign(longest + 1, 0);
    }

    VerticalCounts counts;

    bool contains(std::size_t row) const { return members_.contains(row); }

    // `columns`: how many columns, from here on, the change counts in.
    void insert(std::size_t row, std::uint64_t columns) {
        account(around(row, false), std::uint64_t{0} - columns);
        account(around(row, true), columns);
        members_.insert(row);
        others_.erase(row);
    }
    void erase(std::size_t row, std::uint64_t columns) {
        members_.erase(row);
        others_.insert(row);
        account(around(row, true), std::uint64_t{0} - columns);
        account(around(row, false), columns);
    }
    // The empty column, before anything is inserted.
    void start(std::uint64_t columns) { account({}, columns); }

private:
    std::size_t rows_;
    const Settings& settings_;
    BitTree members_, others_;

    Line line_ending_at(std::size_t last) const {
        const std::size_t gap = others_.before(last);
        return {gap == BitTree::none ? 0 : gap + 1, last + 1};
    }
    Line line_beginning_at(std::size_t first) const {
        const std::size_t gap = others_.after(first);
        return {first, gap == BitTree::none ? rows_ : gap};
    }

    // `row` is not a member now; the lines around it as they are, or as they would be with it.
    Neighbourhood around(std::size_t row, bool with_row) const {
        Neighbourhood n;
        Line own{row, row + 1};
        const bool left = row > 0 && contains(row - 1), right = row + 1 < rows_ && contains(row + 1);
        const Line left_line = left ? line_ending_at(row - 1) : own;
        const Line right_line = right ? line_beginning_at(row + 1) : own;
        const std::size_t before = members_.before(left_line.begin);
        if (before != BitTree::none) n.push(line_ending_at(before));
        n.from_first = before == BitTree::none;
        if (with_row) n.push({left_line.begin, right_line.end});
        if (!with_row && left) n.push(left_line);
        if (!with_row && right) n.push(right_line);
        const std::size_t after = members_.after(right_line.end - 1);
        if (after != BitTree::none) n.push(line_beginning_at(after));
        n.to_last = after == BitTree::none;
        return n;
    }

    // Counts may be negative on the way: unsigned arithmetic modulo 2^64 gives the right sum.
    void account(const Neighbourhood& n, std::uint64_t columns) {
        for (std::size_t k = 0; k < n.count; ++k) {
            const Line& line = n.lines[k];
            if (settings_.border_lines == BorderLines::counted || (line.begin != 0 && line.end != rows_))
                counts.lines[line.end - line.begin] += columns;
            if (k > 0) counts.times[time_between(n.lines[k - 1], line)] += columns;
        }
        if (!settings_.border_white_lines) return;
        if (n.count == 0 && n.from_first && n.to_last) counts.times[rows_] += columns;
        if (n.count == 0) return;
        if (n.from_first && n.lines[0].begin > 0) counts.times[n.lines[0].begin] += columns;
        if (n.to_last && n.lines[n.count - 1].end < rows_) counts.times[rows_ - n.lines[n.count - 1].end] += columns;
    }

    std::size_t time_between(const Line& a, const Line& b) const {
        switch (settings_.recurrence_time) {
            case RecurrenceTime::line_starts:
                return b.begin - a.begin;
            case RecurrenceTime::white_lines:
                return b.begin - a.end;
            case RecurrenceTime::midpoints:
                break;
        }
        return b.begin - a.end + (a.end - a.begin) / 2 + (b.end - b.begin) / 2;
    }
};

}  // namespace

bool can_slide(const Points& rows, int theiler) {
    return rows.dimension == 1 && rows.periods[0] == 0 && theiler <= widest_window;
}

VerticalCounts count_vertical_sliding(const SortedRows& rows, const Points& columns,
                                      std::span<const std::uint32_t> column_order, double bound, int theiler,
                                      const Settings& settings) {
    const std::vector<double>& x = rows.coordinates[0];
    const double* y = columns.coordinate(0);
    const std::size_t n = x.size();
    SlidingColumn column(n, std::max(n, columns.count), settings);
    std::uint64_t left = columns.count;  // columns from this one on
    column.start(left);
    std::size_t low = 0, high = 0;
    std::vector<std::size_t> inside;
    for (const std::uint32_t c : column_order) {
        const double value = y[c];
        const auto too_low = [&](double v) { return v < value && value - v > bound; };
        while (low < high && too_low(x[low])) column.erase(rows.order[low++], left);
        while (low == high && low < n && too_low(x[low])) low = ++high;
        while (high < n && (x[high] <= value ? value - x[high] : x[high] - value) <= bound)
            column.insert(rows.order[high++], left);
        column.counts.points += high - low;

        inside.clear();
        const auto reach = static_cast<std::size_t>(theiler);
        for (std::size_t r = c + 1 > reach ? c + 1 - reach : 0; r < std::min(n, c + reach); ++r)
            if (column.contains(r)) inside.push_back(r);
        column.counts.points_outside += high - low - inside.size();
        --left;
        if (!settings.window_on_vertical) continue;
        for (std::size_t r : inside) column.erase(r, left + 1);
        for (std::size_t r : inside) column.insert(r, left);
    }
    return std::move(column.counts);
}

}  // namespace swirl::analysis::recurrence::detail
