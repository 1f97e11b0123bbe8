// Points, their distances, and the one rule that decides whether two of them are recurrent.
//
// The rule. With d_m = |a_m - b_m| in each coordinate, or min(d_m, P - d_m) for an angle of period P (both values
// first reduced to [-P/2, P/2], which is exact), the key of two points is, in double precision and in this order,
//     maximum     max_m d_m            manhattan   d_1 + d_2 + ...         euclidean   d_1^2 + d_2^2 + ...
// and in one dimension d_1 for every norm. The distance is the key, or its rounded square root for the euclidean norm.
// Points are recurrent when distance <= threshold (or <). Because rounding is monotone this is the same as
// key <= key_bound(threshold) for one double, found once: no square root is taken, and no decision differs.
#pragma once

#include "analysis/recurrence/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence {

/// n points of `dimension` coordinates. Coordinate m of point i is values[i + m * stride]: a delay embedding shares
/// one copy of its series (stride = delay), plain points lie coordinate after coordinate (stride = n).
struct Points {
    std::vector<double> values;  ///< angles reduced to [-P/2, P/2]
    std::size_t count = 0;       ///< n
    int dimension = 0;
    std::size_t stride = 0;
    std::vector<double> periods;  ///< of each coordinate; 0: not an angle
    bool embedded = false;        ///< all coordinates are one scalar series, `values`
    /// The row of each point in time, rising from 0; empty: i. Rows without a point are gaps, at which lines end.
    std::vector<std::uint32_t> row_numbers = {};

    std::size_t row(std::size_t i) const { return row_numbers.empty() ? i : row_numbers[i]; }
    /// Rows from the first point to the last, those of gaps among them.
    std::size_t rows() const { return row_numbers.empty() ? count : row_numbers.back() + std::size_t{1}; }
    /// The first point that is `distance` rows or more from row 0 on, `count` if none is.
    std::size_t point_from(std::size_t distance) const;
    const double* coordinate(int m) const { return values.data() + static_cast<std::size_t>(m) * stride; }
};

/// Delay vectors (x_i, x_{i+L}, ..., x_{i+(M-1)L}) of a scalar series; i = 0 ... N - (M-1)L - 1.
/// dimension M >= 1, delay L >= 1, period > 0 if x is an angle, else 0.
/// Throws std::invalid_argument for values that are not finite, or a series too short. Cost: O(N).
Points embed_series(std::span<const double> series, int dimension = 1, int delay = 1, double period = 0);

/// n points given row after row (point after point). `periods`: empty, or one entry per coordinate (0: not an angle).
/// Throws std::invalid_argument for values that are not finite or sizes that do not fit. Cost: O(n dimension).
Points section_points(std::span<const double> row_major, int dimension, std::span<const double> periods = {});

/// Points with gaps between them: `row_numbers` of them, rising; the first counts as 0.
/// Throws std::invalid_argument for another number of them, or row numbers that do not rise. Cost: O(n).
Points at_rows(Points points, std::span<const std::size_t> row_numbers);

/// The largest key that is recurrent: key <= key_bound decides. threshold >= 0 (throws otherwise).
double key_bound(double threshold, Norm norm, bool strict, int dimension);

/// The distance that a key stands for (see the head of this file).
double distance_of_key(double key, Norm norm, int dimension);

/// Key of point i of `a` and point j of `b`; the plain form of the rule, for single pairs.
double pair_key(const Points& a, std::size_t i, const Points& b, std::size_t j, Norm norm);

/// Throws std::invalid_argument unless a and b have the same dimension and the same angles.
void require_same_space(const Points& a, const Points& b);

}  // namespace swirl::analysis::recurrence
