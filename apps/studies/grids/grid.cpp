#include "apps/studies/grids/grid.hpp"

#include <algorithm>

namespace swirl::studies::grids {

std::size_t cell_count(const std::vector<GridAxis>& grid) {
    if (grid.front().sampled) return grid.front().points.size();
    std::size_t count = 1;
    for (const auto& axis : grid) count *= axis.points.size();
    return count;
}

std::vector<double> cell_point(const std::vector<GridAxis>& grid, std::size_t cell) {
    std::vector<double> point(grid.size());
    for (std::size_t k = grid.size(); k-- > 0;) {
        if (grid[k].sampled) {
            point[k] = grid[k].points[cell];
            continue;
        }
        point[k] = grid[k].points[cell % grid[k].points.size()];
        cell /= grid[k].points.size();
    }
    return point;
}

bool has_axis(const std::vector<GridAxis>& grid, const std::string& name) {
    return std::any_of(grid.begin(), grid.end(), [&](const GridAxis& axis) { return axis.name == name; });
}

}  // namespace swirl::studies::grids
