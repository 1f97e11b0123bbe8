#include "analysis/recurrence/metric.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/special_values.hpp"
#include "analysis/within_period.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace swirl::analysis::recurrence {
namespace {

void require_finite(std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i])) refuse("series value " + std::to_string(i), values[i], "finite");
}

void require_period(double period) {
    if (!(std::isfinite(period) && period >= 0)) refuse("period", period, "finite and >= 0 (0: no angle)");
}

// Row numbers are kept in 32 bits.
void require_count(std::size_t count) {
    if (count >= std::numeric_limits<std::uint32_t>::max() / 2)
        throw std::invalid_argument("number of points = " + std::to_string(count) + ": must be < 2^31");
}

}  // namespace

Points embed_series(std::span<const double> series, int dimension, int delay, double period) {
    if (dimension < 1) throw std::invalid_argument("dimension = " + std::to_string(dimension) + ": must be >= 1");
    if (delay < 1) throw std::invalid_argument("delay = " + std::to_string(delay) + ": must be >= 1");
    require_period(period);
    require_finite(series);
    require_count(series.size());
    const std::size_t span = static_cast<std::size_t>(dimension - 1) * static_cast<std::size_t>(delay);
    if (series.size() <= span)
        throw std::invalid_argument("series length = " + std::to_string(series.size()) + ": must be > " +
                                    std::to_string(span) + " = (dimension - 1) * delay");
    Points points{{series.begin(), series.end()},
                  series.size() - span,
                  dimension,
                  static_cast<std::size_t>(delay),
                  std::vector<double>(static_cast<std::size_t>(dimension), period),
                  true};
    for (double& v : points.values) v = within_period(v, period);
    return points;
}

Points section_points(std::span<const double> row_major, int dimension, std::span<const double> periods) {
    if (dimension < 1) throw std::invalid_argument("dimension = " + std::to_string(dimension) + ": must be >= 1");
    const auto d = static_cast<std::size_t>(dimension);
    if (row_major.empty() || row_major.size() % d != 0)
        throw std::invalid_argument("number of values = " + std::to_string(row_major.size()) +
                                    ": must be a positive multiple of the dimension " + std::to_string(dimension));
    if (!periods.empty() && periods.size() != d)
        throw std::invalid_argument("number of periods = " + std::to_string(periods.size()) + ": must be 0 or " +
                                    std::to_string(dimension));
    require_finite(row_major);
    for (double period : periods) require_period(period);
    const std::size_t n = row_major.size() / d;
    require_count(n);
    Points points{std::vector<double>(row_major.size()), n, dimension, n, std::vector<double>(d, 0), false};
    std::copy(periods.begin(), periods.end(), points.periods.begin());
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t m = 0; m < d; ++m)
            points.values[i + m * n] = within_period(row_major[i * d + m], points.periods[m]);
    return points;
}

std::size_t Points::point_from(std::size_t distance) const {
    if (row_numbers.empty()) return std::min(distance, count);
    return static_cast<std::size_t>(std::lower_bound(row_numbers.begin(), row_numbers.end(), distance) -
                                    row_numbers.begin());
}

Points at_rows(Points points, std::span<const std::size_t> row_numbers) {
    if (row_numbers.size() != points.count)
        throw std::invalid_argument("number of rows = " + std::to_string(row_numbers.size()) +
                                    ": must be the number of points, " + std::to_string(points.count));
    for (std::size_t i = 1; i < row_numbers.size(); ++i)
        if (!(row_numbers[i] > row_numbers[i - 1]))
            refuse("rows[" + std::to_string(i) + "]", static_cast<double>(row_numbers[i]), "above the one before");
    require_count(row_numbers.back() - row_numbers.front());
    points.row_numbers.clear();
    if (row_numbers.back() - row_numbers.front() + 1 == points.count) return points;
    for (const std::size_t row : row_numbers)
        points.row_numbers.push_back(static_cast<std::uint32_t>(row - row_numbers.front()));
    return points;
}

double distance_of_key(double key, Norm norm, int dimension) {
    return norm == Norm::euclidean && dimension > 1 ? std::sqrt(key) : key;
}

double key_bound(double threshold, Norm norm, bool strict, int dimension) {
    if (!(threshold >= 0)) refuse("threshold", threshold, ">= 0");
    const double distance = strict ? std::nextafter(threshold, -infinity) : threshold;
    if (norm != Norm::euclidean || dimension == 1 || distance <= 0 || std::isinf(distance)) return distance;
    // The largest double whose rounded square root is still <= distance lies within a few ulp of the square.
    double bound = std::min(distance * distance, std::numeric_limits<double>::max());
    while (std::sqrt(bound) > distance) bound = std::nextafter(bound, 0.0);
    while (bound < std::numeric_limits<double>::max() && std::sqrt(std::nextafter(bound, infinity)) <= distance)
        bound = std::nextafter(bound, infinity);
    return bound;
}

double pair_key(const Points& a, std::size_t i, const Points& b, std::size_t j, Norm norm) {
    double key = 0;
    for (int m = 0; m < a.dimension; ++m) {
        double d = std::fabs(a.coordinate(m)[i] - b.coordinate(m)[j]);
        const double period = a.periods[static_cast<std::size_t>(m)];
        if (period > 0) d = std::min(d, period - d);
        if (norm == Norm::maximum || a.dimension == 1)
            key = std::max(key, d);
        else
            key += norm == Norm::euclidean ? d * d : d;
    }
    return key;
}

void require_same_space(const Points& a, const Points& b) {
    if (a.dimension != b.dimension)
        throw std::invalid_argument("dimension = " + std::to_string(b.dimension) + " of the second series: must be " +
                                    std::to_string(a.dimension) + ", that of the first");
    if (a.periods != b.periods) throw std::invalid_argument("periods of the two series: must be the same");
}

}  // namespace swirl::analysis::recurrence
