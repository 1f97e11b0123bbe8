#include "apps/sweep/grid.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace swirl::apps::sweep {

namespace {

constexpr std::array<const char*, 6> axis_names = {"alpha", "beta", "mu", "restitution", "inertia-factor", "sides"};
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
        refuse(text, "NAME is none of: alpha, beta, mu, restitution, inertia-factor, sides");
    const double a = number_from<double>("A", text.substr(equals + 1, first - equals - 1));
    const double b = number_from<double>("B", text.substr(first + 1, second - first - 1));
    const long count = count_from(text, text.substr(second + 1));
    if (!std::isfinite(a) || !std::isfinite(b)) refuse(text, "A and B must be finite");
    if (count == 1 && a != b) refuse(text, "COUNT = 1 needs A = B");
    if (count > 1 && a == b) refuse(text, "A = B needs COUNT = 1");
    for (long i = 0; i < count; ++i) {
        const double share = count == 1 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1);
        axis.points.push_back(i == count - 1 ? b : a + (b - a) * share);
        if (axis.name == "sides" && axis.points.back() != std::round(axis.points.back()))
            refuse(text, fmt::format("sides = {} is not a whole number", axis.points.back()));
    }
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

Scene<double> cell_scene(SceneOptions scene, const std::vector<GridAxis>& grid, std::size_t cell) {
    const auto point = cell_point(grid, cell);
    for (std::size_t k = 0; k < grid.size(); ++k)
        scene.set(grid[k].name,
                  grid[k].name == "sides" ? fmt::format("{:.0f}", point[k]) : fmt::format("{:.17g}", point[k]));
    return scene.scene<double>();
}

}  // namespace swirl::apps::sweep
