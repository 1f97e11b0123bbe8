// Recurrence quantification the plain way: the whole matrix, in the words of the definitions. The tests' reference.
#pragma once

#include "analysis/recurrence/lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace swirl::tests {

using Matrix = std::vector<std::vector<int>>;  // [row][column]
using Histogram = std::map<std::size_t, std::uint64_t>;

/// Any choices that can be made together; windows that leave out nothing, the main diagonal, a little, much, and more
/// than most series have.
inline analysis::recurrence::Settings random_settings(std::mt19937_64& random) {
    using namespace analysis::recurrence;
    const auto pick = [&](std::size_t below) { return random() % below; };
    Settings s;
    s.norm = static_cast<Norm>(pick(3));
    s.strict = pick(2) == 1;
    s.theiler = std::array{0, 1, 5, 70, 2000}[pick(5)];
    s.window_on_vertical = pick(3) != 0;
    s.triangles = pick(3) == 0 ? Triangles::one : Triangles::both;
    s.border_lines = pick(3) == 0 ? BorderLines::discarded : BorderLines::counted;
    s.recurrence_time = static_cast<RecurrenceTime>(pick(3));
    s.border_white_lines = s.recurrence_time == RecurrenceTime::white_lines && pick(2) == 1;
    return s;
}

/// One coordinate list per point; periods as in section_points. The distance as documented in metric.hpp, with sqrt.
inline double distance(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& periods,
                       analysis::recurrence::Norm norm) {
    double sum = 0, largest = 0;
    for (std::size_t m = 0; m < a.size(); ++m) {
        double d = 0;
        if (periods[m] > 0) {
            d = std::fabs(std::remainder(a[m], periods[m]) - std::remainder(b[m], periods[m]));
            d = std::min(d, periods[m] - d);
        } else {
            d = std::fabs(a[m] - b[m]);
        }
        largest = std::max(largest, d);
        sum += norm == analysis::recurrence::Norm::euclidean && a.size() > 1 ? d * d : d;
    }
    if (norm == analysis::recurrence::Norm::maximum) return largest;
    return norm == analysis::recurrence::Norm::euclidean && a.size() > 1 ? std::sqrt(sum) : sum;
}

inline Matrix recurrence_matrix(const std::vector<std::vector<double>>& x, const std::vector<std::vector<double>>& y,
                                const std::vector<double>& periods, double threshold,
                                const analysis::recurrence::Settings& settings) {
    Matrix r(x.size(), std::vector<int>(y.size()));
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < y.size(); ++j) {
            const double d = distance(x[i], y[j], periods, settings.norm);
            r[i][j] = settings.strict ? d < threshold : d <= threshold;
        }
    return r;
}

inline Matrix without_window(Matrix r, int window) {
    for (std::size_t i = 0; i < r.size(); ++i)
        for (std::size_t j = 0; j < r[i].size(); ++j)
            if (std::abs(static_cast<long>(i) - static_cast<long>(j)) < window) r[i][j] = 0;
    return r;
}

struct Run {
    std::size_t begin, end;  // positions begin ... end - 1 of the sequence
};
inline std::vector<Run> runs(const std::vector<int>& sequence) {
    std::vector<Run> found;
    for (std::size_t i = 0; i < sequence.size(); ++i) {
        if (sequence[i] == 0) continue;
        if (found.empty() || found.back().end != i) found.push_back({i, i});
        found.back().end = i + 1;
    }
    return found;
}

struct Lines {
    Histogram diagonal, vertical, time, diagonal_points;
    std::uint64_t points = 0, points_outside = 0;
};

inline void add_runs(const std::vector<int>& sequence, bool discard_border, Histogram& histogram) {
    for (const Run& run : runs(sequence))
        if (!discard_border || (run.begin != 0 && run.end != sequence.size())) ++histogram[run.end - run.begin];
}

inline void add_times(const std::vector<int>& column, const analysis::recurrence::Settings& settings,
                      Histogram& times) {
    using analysis::recurrence::RecurrenceTime;
    const std::vector<Run> found = runs(column);
    for (std::size_t k = 1; k < found.size(); ++k) {
        const Run &a = found[k - 1], &b = found[k];
        if (settings.recurrence_time == RecurrenceTime::line_starts)
            ++times[b.begin - a.begin];
        else if (settings.recurrence_time == RecurrenceTime::white_lines)
            ++times[b.begin - a.end];
        else
            ++times[b.begin - a.end + (a.end - a.begin) / 2 + (b.end - b.begin) / 2];
    }
    if (!settings.border_white_lines) return;
    if (found.empty()) {
        ++times[column.size()];
        return;
    }
    if (found.front().begin > 0) ++times[found.front().begin];
    if (found.back().end < column.size()) ++times[column.size() - found.back().end];
}

inline std::uint64_t sum(const Matrix& r) {
    std::uint64_t total = 0;
    for (const auto& row : r)
        for (int entry : row) total += static_cast<std::uint64_t>(entry);
    return total;
}

/// `symmetric`: one trajectory against itself, so that `triangles` applies.
inline Lines lines_of(const Matrix& matrix, bool symmetric, const analysis::recurrence::Settings& settings) {
    using namespace analysis::recurrence;
    const int window = theiler_window(settings, !symmetric);
    const Matrix outside = without_window(matrix, window);
    const bool discard = settings.border_lines == BorderLines::discarded;
    const long rows = static_cast<long>(matrix.size()), columns = static_cast<long>(matrix[0].size());
    Lines lines;
    lines.points = sum(matrix);
    lines.points_outside = sum(outside);
    for (long k = -(columns - 1); k < rows; ++k) {  // the diagonal i - j = k
        if (symmetric && settings.triangles == Triangles::one && k < 0) continue;
        std::vector<int> sequence;
        for (long j = std::max(0L, -k); j < columns && j + k < rows; ++j)
            sequence.push_back(outside[static_cast<std::size_t>(j + k)][static_cast<std::size_t>(j)]);
        add_runs(sequence, discard, lines.diagonal);
    }
    for (long i = 0; i < std::min(rows, columns); ++i)
        for (long j = 0; j < std::min(rows, columns); ++j)
            if (outside[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] != 0)
                ++lines.diagonal_points[static_cast<std::size_t>(std::labs(i - j))];
    const Matrix& for_vertical = settings.window_on_vertical ? outside : matrix;
    for (long j = 0; j < columns; ++j) {
        std::vector<int> column;
        for (const auto& row : for_vertical) column.push_back(row[static_cast<std::size_t>(j)]);
        add_runs(column, discard, lines.vertical);
        add_times(column, settings, lines.time);
    }
    return lines;
}

/// The library's vector form, without zeros.
inline Histogram as_map(const std::vector<std::uint64_t>& histogram) {
    Histogram map;
    for (std::size_t l = 0; l < histogram.size(); ++l)
        if (histogram[l] != 0) map[l] = histogram[l];
    return map;
}

}  // namespace swirl::tests
