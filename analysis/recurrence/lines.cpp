#include "analysis/recurrence/lines.hpp"

#include "analysis/recurrence/columns.hpp"
#include "analysis/recurrence/line_counter.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace swirl::analysis::recurrence {
namespace {

std::vector<double> bounds_of(std::span<const double> thresholds, const Points& points, const Settings& settings) {
    if (thresholds.empty()) throw std::invalid_argument("thresholds: at least one is needed");
    std::vector<double> bounds;
    for (double threshold : thresholds)
        bounds.push_back(key_bound(threshold, settings.norm, settings.strict, points.dimension));
    return bounds;
}

std::vector<LineHistograms> count(const Points& rows, const Points& columns, bool symmetric,
                                  std::span<const double> thresholds, const Settings& settings) {
    validate(settings);
    const std::vector<double> bounds = bounds_of(thresholds, rows, settings);
    const detail::SortedRows sorted = detail::sort_rows(rows, settings.norm);
    const detail::Shape shape{rows.count, columns.count, symmetric, theiler_window(settings, !symmetric)};
    // A source per block of columns: it owns the scratch that filling needs.
    const auto make_source = [&] {
        return [&, scratch = detail::make_scratch(sorted)](std::size_t c, std::size_t offset,
                                                           std::span<std::uint64_t* const> frames) mutable {
            detail::fill_column(sorted, columns, c, bounds, offset, frames, scratch);
        };
    };
    return detail::count_all_lines(shape, bounds.size(), settings, make_source);
}

}  // namespace

std::vector<LineHistograms> count_lines(const Points& points, std::span<const double> thresholds,
                                        const Settings& settings) {
    return count(points, points, true, thresholds, settings);
}

LineHistograms count_lines(const Points& points, double threshold, const Settings& settings) {
    return count(points, points, true, {&threshold, 1}, settings).front();
}

std::vector<LineHistograms> count_cross_lines(const Points& rows, const Points& columns,
                                              std::span<const double> thresholds, const Settings& settings) {
    require_same_space(rows, columns);
    return count(rows, columns, false, thresholds, settings);
}

LineHistograms count_lines(const BinaryMatrix& matrix, const Settings& settings) {
    validate(settings);
    if (matrix.rows == 0 || matrix.columns == 0 || matrix.entries.size() != matrix.rows * matrix.columns)
        throw std::invalid_argument("number of matrix entries = " + std::to_string(matrix.entries.size()) +
                                    ": must be rows * columns = " + std::to_string(matrix.rows * matrix.columns) +
                                    " and > 0");
    const auto make_source = [&] {
        return [&](std::size_t c, std::size_t offset, std::span<std::uint64_t* const> frames) {
            for (std::size_t r = 0; r < matrix.rows; ++r)
                if (matrix.entries[r * matrix.columns + c] != 0)
                    frames[0][(r + offset) >> 6] |= std::uint64_t{1} << ((r + offset) & 63);
        };
    };
    const detail::Shape shape{matrix.rows, matrix.columns, false, theiler_window(settings, true)};
    return detail::count_all_lines(shape, 1, settings, make_source).front();
}

}  // namespace swirl::analysis::recurrence
