#include "analysis/recurrence/rates.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/recurrence/pair_census.hpp"
#include "analysis/special_values.hpp"
#include "analysis/within_period.hpp"

#include <gsl/gsl_statistics_double.h>
#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

namespace swirl::analysis::recurrence {
namespace {

std::vector<double> sorted_values(const Points& points) {
    const double* x = points.coordinate(0);
    std::vector<double> values(x, x + points.count);
    hwy::Sorter()(values.data(), values.size(), hwy::SortAscending());
    return values;
}

double deviation_of(std::span<const double> values, double period, Deviation deviation) {
    std::vector<double> differences;
    if (period > 0) {  // to the circular mean
        double s = 0, c = 0;
        const double to_radians = 2 * M_PI / period;
        for (double v : values) {
            s += std::sin(v * to_radians);
            c += std::cos(v * to_radians);
        }
        const double mean = std::atan2(s, c) / to_radians;
        for (double v : values) differences.push_back(within_period(v - mean, period));
        values = differences;
    }
    return deviation == Deviation::sample
               ? gsl_stats_sd(values.data(), 1, values.size())
               : gsl_stats_sd_with_fixed_mean(values.data(), 1, values.size(),
                                              gsl_stats_mean(values.data(), 1, values.size()));
}

// The smallest m with m / pairs >= rate.
std::uint64_t pairs_for_rate(double rate, std::uint64_t pairs) {
    const auto share = [pairs](std::uint64_t m) { return static_cast<double>(m) / static_cast<double>(pairs); };
    auto m = std::min(pairs, static_cast<std::uint64_t>(rate * static_cast<double>(pairs)));
    while (m < pairs && share(m) < rate) ++m;
    while (m > 1 && share(m - 1) >= rate) --m;
    return std::max<std::uint64_t>(m, 1);
}

// One dimension: bisection on the bits of the key; each count takes O(n) on the sorted values.
double select_scalar_key(const Points& points, std::size_t gap, std::uint64_t rank) {
    const std::vector<double> sorted = sorted_values(points);
    const auto count = [&](double bound) {  // unordered pairs with j - i >= gap
        std::uint64_t pairs = (detail::count_sorted_pairs(sorted, points.periods[0], bound) - points.count) / 2;
        for (std::size_t i = 0; i < points.count; ++i)
            for (std::size_t j = i + 1; j < points.count && points.row(j) - points.row(i) < gap; ++j)
                pairs -= pair_key(points, i, points, j, Norm::maximum) <= bound;
        return pairs;
    };
    std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::max());
    while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        if (count(std::bit_cast<double>(middle)) >= rank)
            high = middle;
        else
            low = middle + 1;
    }
    return std::bit_cast<double>(low);
}

}  // namespace

double RecurrenceRate::with_diagonal() const {
    return static_cast<double>(points) / (static_cast<double>(count) * static_cast<double>(count));
}

double RecurrenceRate::without_diagonal() const {
    if (count < 2) return 0;
    return static_cast<double>(points - diagonal) / (static_cast<double>(count) * static_cast<double>(count - 1));
}

std::vector<RecurrenceRate> recurrence_rates(const Points& points, std::span<const double> thresholds,
                                             const Settings& settings) {
    validate(settings);
    std::vector<double> bounds;
    for (double t : thresholds) bounds.push_back(key_bound(t, settings.norm, settings.strict, points.dimension));
    std::vector<std::uint64_t> counts;
    if (points.dimension == 1) {
        const std::vector<double> sorted = sorted_values(points);
        for (double bound : bounds)
            counts.push_back(bound < 0 ? 0 : detail::count_sorted_pairs(sorted, points.periods[0], bound));
    } else {
        counts = detail::count_pairs(points, settings.norm, 1, bounds);
        for (std::size_t k = 0; k < bounds.size(); ++k) counts[k] = 2 * counts[k] + (bounds[k] < 0 ? 0 : points.count);
    }
    std::vector<RecurrenceRate> rates;
    for (std::size_t k = 0; k < bounds.size(); ++k)
        rates.push_back({counts[k], bounds[k] < 0 ? 0 : points.count, points.count});
    return rates;
}

RecurrenceRate recurrence_rate(const Points& points, double threshold, const Settings& settings) {
    return recurrence_rates(points, {&threshold, 1}, settings).front();
}

double threshold_of_deviation(const Points& points, double factor, Deviation deviation) {
    if (!(factor >= 0 && std::isfinite(factor))) refuse("threshold-std", factor, "finite and >= 0");
    if (points.count < 2)
        throw std::invalid_argument("number of points = " + std::to_string(points.count) +
                                    ": a standard deviation needs at least 2");
    if (points.embedded) return factor * deviation_of(points.values, points.periods[0], deviation);
    double squares = 0;
    for (int m = 0; m < points.dimension; ++m) {
        const double one =
            deviation_of({points.coordinate(m), points.count}, points.periods[static_cast<std::size_t>(m)], deviation);
        squares += one * one;
    }
    return factor * std::sqrt(squares / points.dimension);
}

double threshold_of_rate(const Points& points, double rate, const Settings& settings) {
    validate(settings);
    if (!(rate > 0 && rate <= 1)) refuse("recurrence-rate", rate, "in (0, 1]");
    const auto window = static_cast<std::size_t>(theiler_window(settings, false));
    const std::size_t gap = std::max<std::size_t>(window, 1);
    const bool with_diagonal = window == 0;
    if (gap >= points.rows() && !with_diagonal)
        throw std::invalid_argument("theiler = " + std::to_string(window) + ": must be < " +
                                    std::to_string(points.rows()) + ", the number of points");
    std::uint64_t half = 0;
    for (std::size_t i = 0; i < points.count; ++i) half += points.count - points.point_from(points.row(i) + gap);
    const std::uint64_t diagonal = with_diagonal ? points.count : 0;
    const std::uint64_t wanted = pairs_for_rate(rate, 2 * half + diagonal);
    double key = 0;  // the pairs (i, i) are at distance 0
    if (wanted > diagonal) {
        const std::uint64_t rank = (wanted - diagonal + 1) / 2;
        key = points.dimension == 1 ? select_scalar_key(points, gap, rank)
                                    : detail::select_key(points, settings.norm, gap, rank);
    }
    const double distance = distance_of_key(key, settings.norm, points.dimension);
    return settings.strict ? std::nextafter(distance, infinity) : distance;
}

}  // namespace swirl::analysis::recurrence
