// A measured motion of its columns: positions about an origin, the angle of marks, points that a tracker is unsure of.
#pragma once

#include "apps/input/measured_series.hpp"
#include "apps/input/series_columns.hpp"

#include <array>
#include <vector>

namespace swirl::apps {

/// The circle (x − x₀)² + (y − y₀)² = r² that fits best in the least squares of x² + y² − 2 x₀ x − 2 y₀ y − c (Kåsa
/// 1976): O(points). NaN are left out.
struct FittedCircle {
    std::array<double, 2> centre = {0, 0};
    double radius = 0;
    double residual = 0;  ///< root mean square of the distances from it
};
/// @throws BadInput for fewer than three points, or points on a line
FittedCircle fitted_circle(const std::vector<double>& x, const std::vector<double>& y);

/// The values of the choice's columns, rows by columns, as they are before lost rows are put in: gaps where a point's
/// likelihood is below --likelihood; of --marks and --mark one column, the angle in radians; of --position x and y from
/// the origin, times the scale. Notes: points of small likelihood that are read, an origin outside the points, an axis
/// that is likely to point down.
/// @throws BadInput for what is no number, or too large
std::vector<std::vector<double>> values_of_motion(const DelimitedFile& file, const SeriesChoice& choice,
                                                  const SeriesColumns& columns, MeasuredSeries& series);

}  // namespace swirl::apps
