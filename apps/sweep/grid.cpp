#include "apps/sweep/grid.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace swirl::apps::sweep {

namespace {

constexpr std::array<const char*, 7> axis_names = {"alpha",          "beta",  "mu",   "restitution",
                                                   "inertia-factor", "sides", "speed"};
constexpr const char* start_speed = "speed";  // of the random starts; the other axes are the scene's
constexpr std::size_t most_axes = 3;
constexpr long most_points = 1'000'000;

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
    throw BadInput(fmt::format("grid {}: {}", text, why));
}

long count_from(const std::string& text, const std::string& count) {
    long value = 0;
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), value);
    if (error != std::errc() || end != count.data() + count.size() || value < 1 || value > most_points)
        refuse(text, fmt::format("COUNT = {} is outside its range: 1 to {}", count, most_points));
    return value;
}

GridAxis axis_from(const std::string& text) {
    const auto equals = text.find('=');
    const auto first = text.find(':', equals == std::string::npos ? 0 : equals);
    const auto second = first == std::string::npos ? first : text.find(':', first + 1);
    if (equals == std::string::npos || second == std::string::npos || text.find(':', second + 1) != std::string::npos)
        refuse(text, "NAME=A:B:COUNT is wanted");
    GridAxis axis{text.substr(0, equals), text, {}};
    if (std::find(axis_names.begin(), axis_names.end(), axis.name) == axis_names.end())
        refuse(text, "NAME is none of: alpha, beta, mu, restitution, inertia-factor, sides, speed");
    const std::string low = text.substr(equals + 1, first - equals - 1);
    const std::string high = text.substr(first + 1, second - first - 1);
    const double a = number_from<double>("A", low), b = number_from<double>("B", high);
    const long count = count_from(text, text.substr(second + 1));
    if (!std::isfinite(a) || !std::isfinite(b)) refuse(text, "A and B must be finite");
    if (count == 1 && a != b) refuse(text, "COUNT = 1 needs A = B");
    if (count > 1 && a == b) refuse(text, "A = B needs COUNT = 1");
    axis.points = points_between(low, high, count);
    for (const double point : axis.points)
        if (axis.name == start_speed && point < 0)
            refuse(text, fmt::format("speed = {} is outside its range: speed >= 0", point));
        else if (axis.name == "sides" && point != std::round(point))
            refuse(text, fmt::format("sides = {} is not a whole number", point));
    return axis;
}

}  // namespace

std::vector<GridAxis> grid_from(const std::vector<std::string>& texts) {
    if (texts.empty()) throw BadInput("--grid is missing: NAME=A:B:COUNT, once to three times");
    if (texts.size() > most_axes)
        throw BadInput(fmt::format("{} grids are given: 1 to {} are allowed", texts.size(), most_axes));
    std::vector<GridAxis> grid;
    for (const auto& text : texts) {
        grid.push_back(axis_from(text));
        for (std::size_t i = 0; i + 1 < grid.size(); ++i)
            if (grid[i].name == grid.back().name) refuse(text, grid.back().name + " is given twice");
    }
    return grid;
}

std::size_t cell_count(const std::vector<GridAxis>& grid) {
    std::size_t count = 1;
    for (const auto& axis : grid) count *= axis.points.size();
    return count;
}

std::vector<double> cell_point(const std::vector<GridAxis>& grid, std::size_t cell) {
    std::vector<double> point(grid.size());
    for (std::size_t k = grid.size(); k-- > 0;) {
        point[k] = grid[k].points[cell % grid[k].points.size()];
        cell /= grid[k].points.size();
    }
    return point;
}

bool has_axis(const std::vector<GridAxis>& grid, const std::string& name) {
    return std::any_of(grid.begin(), grid.end(), [&](const GridAxis& axis) { return axis.name == name; });
}

Scene<double> cell_scene(SceneOptions scene, const std::vector<GridAxis>& grid, std::size_t cell) {
    const auto point = cell_point(grid, cell);
    for (std::size_t k = 0; k < grid.size(); ++k)
        if (grid[k].name != start_speed)
            scene.set(grid[k].name,
                      grid[k].name == "sides" ? fmt::format("{:.0f}", point[k]) : fmt::format("{:.17g}", point[k]));
    return scene.scene<double>();
}

double cell_speed(double otherwise, const std::vector<GridAxis>& grid, std::size_t cell) {
    const auto point = cell_point(grid, cell);
    for (std::size_t k = 0; k < grid.size(); ++k)
        if (grid[k].name == start_speed) return point[k];
    return otherwise;
}

}  // namespace swirl::apps::sweep
