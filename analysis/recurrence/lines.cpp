#include "analysis/recurrence/lines.hpp"

#include "analysis/recurrence/column_finder.hpp"
#include "analysis/recurrence/gaps.hpp"
#include "analysis/recurrence/line_counter.hpp"
#include "analysis/recurrence/sliding_lines.hpp"
#include "analysis/recurrence/smooth_lines.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace swirl::analysis::recurrence {
namespace {

std::vector<double> bounds_of(std::span<const double> thresholds, const Points& points, const Settings& settings) {
    if (thresholds.empty()) throw std::invalid_argument("thresholds: at least one is needed");
    std::vector<double> bounds;
    for (double threshold : thresholds)
        bounds.push_back(key_bound(threshold, settings.norm, settings.strict, points.dimension));
    return bounds;
}

void take_vertical(detail::VerticalCounts counts, LineHistograms& lines) {
    detail::trim_zeros(counts.lines);
    detail::trim_zeros(counts.times);
    lines.vertical = std::move(counts.lines);
    lines.recurrence_time = std::move(counts.times);
    lines.points = counts.points;
    lines.points_outside_window = counts.points_outside;
}

void take_pairs(const detail::Presences& presences, int theiler, std::vector<LineHistograms>& histograms) {
    std::uint64_t rows = 0, columns = 0;
    for (const detail::PointRun& run : presences.rows.runs) rows += run.count;
    for (const detail::PointRun& run : presences.columns.runs) columns += run.count;
    const std::uint64_t inside = detail::pairs_within(presences, static_cast<std::size_t>(theiler));
    const std::vector<std::uint64_t> by_distance = detail::pairs_by_distance(presences);
    for (LineHistograms& lines : histograms) {
        lines.pairs = rows * columns;
        lines.pairs_outside_window = lines.pairs - inside;
        lines.diagonal_pairs = by_distance;
    }
}

std::vector<LineHistograms> count(const Points& rows, const Points& columns, bool symmetric,
                                  std::span<const double> thresholds, const Settings& settings) {
    validate(settings);
    const std::vector<double> bounds = bounds_of(thresholds, rows, settings);
    const detail::ColumnFinder finder = detail::find_columns(rows, columns, settings.norm, bounds);
    const detail::SortedRows& sorted = finder.sorted;
    const int theiler = theiler_window(settings, !symmetric);
    std::vector<LineHistograms> histograms;
    if (symmetric && finder.by_tiles && detail::can_follow_diagonals(finder.tiled)) {
        for (std::size_t k = 0; k < bounds.size(); ++k)
            histograms.push_back(detail::count_smooth_lines(finder.tiled, k, theiler, settings));
        return histograms;
    }
    std::optional<detail::Presences> presences;
    if (!rows.row_numbers.empty() || !columns.row_numbers.empty())
        presences = detail::Presences{detail::Presence(rows), detail::Presence(columns)};
    const bool sliding = !presences && detail::can_slide(rows, theiler);
    const detail::Shape shape{rows.rows(), columns.rows(), symmetric,
                              theiler,     !sliding,       presences ? &*presences : nullptr};
    std::vector<detail::VerticalCounts> vertical(bounds.size());
    const auto slide = [&] {
        if (!sliding) return;
        const std::vector<std::uint32_t> other =
            symmetric ? std::vector<std::uint32_t>{} : detail::sort_rows(columns, settings.norm).order;
        tbb::parallel_for(std::size_t{0}, bounds.size(), [&](std::size_t k) {
            vertical[k] = detail::count_vertical_sliding(sorted, columns, symmetric ? sorted.order : other, bounds[k],
                                                         theiler, settings);
        });
    };
    const auto make_source = [&] {
        detail::ColumnSource source = detail::source_of(finder);
        return presences ? detail::with_gaps(std::move(source), *presences, rows.count, bounds.size()) : source;
    };
    tbb::parallel_invoke(slide,
                         [&] { histograms = detail::count_all_lines(shape, bounds.size(), settings, make_source); });
    if (presences) take_pairs(*presences, theiler, histograms);
    if (sliding)
        for (std::size_t k = 0; k < bounds.size(); ++k) take_vertical(std::move(vertical[k]), histograms[k]);
    return histograms;
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
