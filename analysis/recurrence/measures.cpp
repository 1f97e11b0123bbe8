#include "analysis/recurrence/measures.hpp"

#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::analysis::recurrence {
namespace {

struct Summary {
    std::uint64_t lines = 0, points = 0;  // of at least the minimal length
    std::uint64_t all_points = 0;         // of every length
    std::size_t longest = 0;
    double entropy = nan;

    double mean() const { return lines == 0 ? 0 : static_cast<double>(points) / static_cast<double>(lines); }
};

double log_base(Logarithm logarithm) {
    switch (logarithm) {
        case Logarithm::natural:
            return 1;
        case Logarithm::binary:
            return std::log(2.0);
        case Logarithm::decimal:
            return std::log(10.0);
    }
    return 1;
}

Summary summarise(const std::vector<std::uint64_t>& histogram, int minimum, const Settings& settings) {
    Summary s;
    const auto least = static_cast<std::size_t>(minimum);
    for (std::size_t l = 1; l < histogram.size(); ++l) {
        if (histogram[l] == 0) continue;
        s.all_points += histogram[l] * l;
        if (l >= least || settings.longest_of_all_lines) s.longest = l;
        if (l < least) continue;
        s.lines += histogram[l];
        s.points += histogram[l] * l;
    }
    if (s.lines == 0) {
        if (settings.empty_is_zero) s.entropy = 0;
        return s;
    }
    double entropy = 0;
    for (std::size_t l = least; l < histogram.size(); ++l) {
        if (histogram[l] == 0) continue;
        const double p = static_cast<double>(histogram[l]) / static_cast<double>(s.lines);
        entropy -= p * std::log(p);
    }
    s.entropy = entropy / log_base(settings.logarithm);
    return s;
}

double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

// Pairs with |i - j| >= W of a rows x columns matrix.
std::uint64_t pairs_outside_window(const LineHistograms& lines) {
    std::uint64_t inside = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(lines.theiler); ++k) {
        const auto length = [](std::size_t a, std::size_t b, std::size_t shift) {  // rows i, columns i + shift
            return b > shift ? std::min(a, b - shift) : std::size_t{0};
        };
        inside += length(lines.rows, lines.columns, k) + (k > 0 ? length(lines.columns, lines.rows, k) : 0);
    }
    return static_cast<std::uint64_t>(lines.rows) * lines.columns - inside;
}

double recurrence_rate(const LineHistograms& lines, const Settings& settings) {
    const bool has_gaps = !lines.diagonal_pairs.empty();
    std::uint64_t pairs = has_gaps ? lines.pairs : static_cast<std::uint64_t>(lines.rows) * lines.columns;
    if (settings.rate_pairs == RatePairs::outside_window)
        pairs = has_gaps ? lines.pairs_outside_window : pairs_outside_window(lines);
    return share(settings.window_on_rate ? lines.points_outside_window : lines.points, pairs);
}

// As RecurrenceAnalysis.jl: diagonals d = 1 + W ... b, b = n - border (d = 1 is the main one), weights d - (W + b)/2.
// Diagonals on which gaps leave no pair have no rate, and are left out.
double trend(const LineHistograms& lines, const Settings& settings) {
    const auto n = static_cast<std::ptrdiff_t>(lines.diagonal_points.size());
    const std::ptrdiff_t first = 1 + lines.theiler, last = n - settings.trend_border;
    if (last < first) return nan;
    const bool has_gaps = !lines.diagonal_pairs.empty();
    const auto length = [&](std::ptrdiff_t d) {
        return has_gaps ? static_cast<double>(lines.diagonal_pairs[static_cast<std::size_t>(d - 1)])
                        : static_cast<double>(n - (d - 1)) * (d == 1 ? 1 : 2);
    };
    const auto rate = [&](std::ptrdiff_t d) {
        return static_cast<double>(lines.diagonal_points[static_cast<std::size_t>(d - 1)]) / length(d);
    };
    double mean = 0, count = 0;
    for (std::ptrdiff_t d = first; d <= last; ++d)
        if (length(d) > 0) mean += rate(d), ++count;
    if (count == 0) return nan;
    mean /= count;
    double numerator = 0, denominator = 0;
    for (std::ptrdiff_t d = first; d <= last; ++d) {
        if (!(length(d) > 0)) continue;
        const double weight = static_cast<double>(d) - static_cast<double>(lines.theiler + last) / 2;
        numerator += weight * (rate(d) - mean);
        denominator += weight * weight;
    }
    return denominator > 0 ? 1000 * numerator / denominator : nan;
}

}  // namespace

Measures measures(const LineHistograms& lines, const Settings& settings) {
    validate(settings);
    const Summary diagonal = summarise(lines.diagonal, settings.min_diagonal, settings);
    const Summary vertical = summarise(lines.vertical, settings.min_vertical, settings);
    Settings of_times = settings;
    of_times.longest_of_all_lines = false;
    const Summary times = summarise(lines.recurrence_time, settings.min_recurrence_time, of_times);

    Measures m;
    m.RR = recurrence_rate(lines, settings);
    m.DET = share(diagonal.points, settings.determinism_of_all_points ? lines.points : diagonal.all_points);
    m.L = diagonal.mean();
    m.Lmax = static_cast<double>(diagonal.longest);
    m.DIV = diagonal.longest > 0 ? 1 / m.Lmax : settings.empty_is_zero ? 0 : nan;
    m.ENTR = diagonal.entropy;
    m.LAM = share(vertical.points, vertical.all_points);
    m.TT = vertical.mean();
    m.Vmax = static_cast<double>(vertical.longest);
    m.VENTR = vertical.entropy;
    m.MRT = times.mean();
    m.RTE = times.entropy;
    if (settings.time_entropy_scale == TimeEntropyScale::log_longest) {
        const double scale = std::log(static_cast<double>(times.longest)) / log_base(settings.logarithm);
        m.RTE = times.longest > 1 ? m.RTE / scale : nan;
    }
    m.TREND = trend(lines, settings);
    return m;
}

}  // namespace swirl::analysis::recurrence
