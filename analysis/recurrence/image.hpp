// The recurrence plot as a picture: how dense the recurrence points are in each cell of an m x m grid.
#pragma once

#include "analysis/recurrence/metric.hpp"
#include "analysis/recurrence/settings.hpp"

#include <cstddef>
#include <vector>

namespace swirl::analysis::recurrence {

/// density[a * pixels + b]: share of recurrent pairs among rows [a n/m, (a+1) n/m) and columns [b n'/m, (b+1) n'/m),
/// m = pixels. No Theiler window. Rows of gaps (Points::row_numbers) have their room; NaN where a cell has no pair.
struct Image {
    std::size_t pixels = 0;
    std::vector<double> density;
};

/// 1 <= pixels <= number of points (throws otherwise). Cost: as count_lines; memory O(n + pixels^2).
Image recurrence_image(const Points& points, double threshold, std::size_t pixels, const Settings& settings = {});
Image cross_recurrence_image(const Points& rows, const Points& columns, double threshold, std::size_t pixels,
                             const Settings& settings = {});

}  // namespace swirl::analysis::recurrence
