// Recurrence rates without lines, and the thresholds that deviations or rates stand for.
#pragma once

#include "analysis/recurrence/metric.hpp"
#include "analysis/recurrence/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence {

/// How many of the n^2 ordered pairs (i, j) are recurrent, the pairs (i, i) included.
struct RecurrenceRate {
    std::uint64_t points = 0;    ///< recurrent pairs, main diagonal included
    std::uint64_t diagonal = 0;  ///< those of the main diagonal: n, or 0 with strict and threshold 0
    std::size_t count = 0;       ///< n

    /// RC of Sun 2019 (docs/references.md), (1/n^2) sum_ij [ |x_i - x_j| <= delta ]: k equally visited values give 1/k.
    double with_diagonal() const;
    /// The rate over the n (n - 1) pairs of different points; 0 if n = 1.
    double without_diagonal() const;
};

/// RC at each of the thresholds, exactly as the pairs would give it. One sort serves all thresholds.
/// Cost: O(n log n) + O(n) per threshold in one dimension (angles too), else n^2/2 distances. Memory O(n).
std::vector<RecurrenceRate> recurrence_rates(const Points& points, std::span<const double> thresholds,
                                             const Settings& settings = {});
RecurrenceRate recurrence_rate(const Points& points, double threshold, const Settings& settings = {});

/// Which standard deviation a threshold is measured in: divided by n - 1, or by n (pyunicorn).
enum class Deviation { sample, population };

/// `factor` standard deviations (GSL). In one dimension or for an embedded series: the series'; otherwise the root mean
/// square over the coordinates. Of an angle: of its differences to the circular mean, wrapped. factor >= 0. Cost: O(n).
double threshold_of_deviation(const Points& points, double factor, Deviation deviation = Deviation::sample);

/// The smallest distance of two points such that the share of pairs at most so far apart is >= rate, 0 < rate <= 1,
/// among the pairs that the Theiler window leaves: an exact order statistic of the distances, in memory O(n).
/// With settings.strict the next larger double, so that the same pairs are recurrent.
/// Cost: in one dimension O(n log n) (+ O(n W)); else a few passes over the n^2/2 distances.
double threshold_of_rate(const Points& points, double rate, const Settings& settings = {});

}  // namespace swirl::analysis::recurrence
