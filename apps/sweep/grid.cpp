#include "apps/sweep/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace swirl::apps::sweep {

namespace {

constexpr std::array<const char*, 6> scene_axes = {"alpha", "beta", "mu", "restitution", "inertia-factor", "sides"};
constexpr const char* start_speed = "speed";  // of random starts
constexpr std::size_t most_axes = 5;
constexpr long most_points = 1'000'000;
constexpr double most_cells = 1e8;

template <std::size_t n>
bool is_among(const std::array<const char*, n>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

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

/// NAME, A, B and, unless the cells are a sample, COUNT.
std::vector<std::string> parts_of(const std::string& text, bool sampled) {
    const auto equals = text.find('=');
    const char* wanted = sampled ? "NAME=A:B is wanted, as --sample has the COUNT" : "NAME=A:B:COUNT is wanted";
    if (equals == std::string::npos) refuse(text, wanted);
    std::vector<std::string> parts = pieces_of(text, ':', equals + 1);
    parts.insert(parts.begin(), text.substr(0, equals));
    if (parts.size() != (sampled ? 3U : 4U)) refuse(text, wanted);
    return parts;
}

/// The steps of a grid, finer by 2^levels.
long refined(const std::string& text, long count, int levels) {
    if (levels == 0) return count;
    if (count < 2) refuse(text, "--refine needs COUNT >= 2");
    if (count > (most_points >> levels)) refuse(text, fmt::format("COUNT = {} is too large for --refine", count));
    return ((count - 1) << levels) + 1;
}

/// A + (B − A)u; of whole numbers each of A … B with an equal share.
std::vector<double> sampled_points(const std::string& name, double a, double b, const std::vector<double>& units) {
    std::vector<double> points;
    points.reserve(units.size());
    const double low = std::min(a, b), high = std::max(a, b);
    for (const double u : units)
        points.push_back(name == "sides" ? std::min(high, low + std::floor(u * (high - low + 1))) : a + (b - a) * u);
    return points;
}

/// The number of a law. @throws BadInput naming the axis
double law_number(const std::string& text, const std::string& word) {
    try {
        return static_cast<double>(law_from(word.empty() ? "(empty)" : word));
    } catch (const BadInput& error) {
        refuse(text, error.what());
    }
}

/// law=NAME,NAME…: each of them; of a sample each with an equal share.
GridAxis law_axis_from(const std::string& text, const GridForm& form, const std::vector<double>* units) {
    if (text == "law") refuse(text, "law=NAME,NAME,... is wanted");
    if (form.levels > 0) refuse(text, "--refine halves steps, and there is nothing between two laws");
    std::vector<double> laws;
    for (const std::string& word : pieces_of(text, ',', text.find('=') + 1)) {
        const double law = law_number(text, word);
        if (std::find(laws.begin(), laws.end(), law) != laws.end()) refuse(text, word + " is given twice");
        laws.push_back(law);
    }
    if (units == nullptr) return {"law", text, laws, false};
    std::vector<double> points;
    points.reserve(units->size());
    const auto count = static_cast<double>(laws.size());
    for (const double u : *units) points.push_back(laws[static_cast<std::size_t>(std::min(count - 1, u * count))]);
    return {"law", text, points, true};
}

GridAxis axis_from(const std::string& text, const GridForm& form, const std::vector<double>* units) {
    if (text == "law" || text.starts_with("law=")) return law_axis_from(text, form, units);
    const std::vector<std::string> parts = parts_of(text, units != nullptr);
    GridAxis axis{parts[0], text, {}, units != nullptr};
    if (!is_among(scene_axes, axis.name) && !is_among(start_numbers, axis.name) && axis.name != start_speed)
        refuse(text,
               "NAME is none of: alpha, beta, mu, restitution, inertia-factor, sides, law, speed, x, y, vx, vy, angle, "
               "spin");
    const double a = number_from<double>("A", parts[1]), b = number_from<double>("B", parts[2]);
    if (units != nullptr) {
        if (!std::isfinite(a) || !std::isfinite(b) || a == b) refuse(text, "A and B must be finite and differ");
        axis.points = sampled_points(axis.name, a, b, *units);
    } else {
        const long count = count_from(text, parts[3]);
        if (!std::isfinite(a) || !std::isfinite(b)) refuse(text, "A and B must be finite");
        if (count == 1 && a != b) refuse(text, "COUNT = 1 needs A = B");
        if (count > 1 && a == b) refuse(text, "A = B needs COUNT = 1");
        axis.points = points_between(parts[1], parts[2], refined(text, count, form.levels));
    }
    for (const double point : axis.points)
        if (axis.name == start_speed && point < 0)
            refuse(text, fmt::format("speed = {} is outside its range: speed >= 0", point));
        else if (axis.name == "sides" && point != std::round(point))
            refuse(text, fmt::format("sides = {} is not a whole number", point));
    return axis;
}

}  // namespace

std::string GridAxis::word_at(double point) const {
    return has_words() ? std::string(name_of(static_cast<Law>(static_cast<int>(point)))) : fmt::format("{}", point);
}

std::vector<GridAxis> grid_from(const std::vector<std::string>& texts, const GridForm& form) {
    if (texts.empty()) throw BadInput("--grid is missing: NAME=A:B:COUNT, once to five times");
    if (texts.size() > most_axes)
        throw BadInput(fmt::format("{} grids are given: 1 to {} are allowed", texts.size(), most_axes));
    std::vector<GridAxis> grid;
    std::vector<std::vector<double>> units;
    if (form.sample) units = unit_points(*form.sample, texts.size(), form.seed);
    for (const auto& text : texts) {
        grid.push_back(axis_from(text, form, form.sample ? &units[grid.size()] : nullptr));
        for (std::size_t i = 0; i + 1 < grid.size(); ++i)
            if (grid[i].name == grid.back().name) refuse(text, grid.back().name + " is given twice");
    }
    double cells = 1;  // may be more than a size_t counts
    if (!form.sample)
        for (const auto& axis : grid) cells *= static_cast<double>(axis.points.size());
    if (cells > most_cells)
        throw BadInput(fmt::format("the grid has {:.4g} cells: {:.0f} are the most", cells, most_cells));
    return grid;
}

std::vector<std::string> axes_to_offer() {
    std::vector<std::string> words;
    words.reserve(scene_axes.size() + 2 + start_numbers.size());
    for (const char* name : scene_axes) words.push_back(std::string(name) + "=");
    words.emplace_back("law=");
    words.push_back(std::string(start_speed) + "=");
    for (const char* name : start_numbers) words.push_back(std::string(name) + "=");
    return words;
}

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

Scene<double> cell_scene(SceneOptions scene, const std::vector<GridAxis>& grid, std::size_t cell) {
    const auto point = cell_point(grid, cell);
    for (std::size_t k = 0; k < grid.size(); ++k)
        if (is_among(scene_axes, grid[k].name) || grid[k].has_words())
            scene.set(grid[k].name,
                      grid[k].name == "sides" ? fmt::format("{:.0f}", point[k]) : grid[k].word_at(point[k]));
    return scene.scene<double>();
}

}  // namespace swirl::apps::sweep
