#include "apps/sweep/grid_options.hpp"

#include "apps/command_line/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

namespace swirl::apps::sweep {

namespace {

constexpr const char* start_speed = "speed";  // of random starts
constexpr std::size_t most_axes = 5;
constexpr long most_points = 1'000'000;
constexpr double most_cells = 1e8;
constexpr std::size_t most_in_sample = 1'000'000;

template <std::size_t n>
bool is_among(const std::array<const char*, n>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
    throw BadInput(fmt::format("grid {}: {}", text, why));
}

long count_from(const std::string& text, const std::string& count) {
    const auto value = whole_number_from(count);
    if (!value || *value < 1 || *value > most_points)
        refuse(text, fmt::format("COUNT = {} is outside its range: 1 to {}", count, most_points));
    return *value;
}

/// NAME, A, B and, unless the cells are a sample, COUNT; then log, if it is given.
std::vector<std::string> parts_of(const std::string& text, bool sampled) {
    const auto equals = text.find('=');
    const char* wanted = sampled ? "NAME=A:B, NAME=A:B:log or NAME=V,V,... is wanted, as --sample has the COUNT"
                                 : "NAME=A:B:COUNT, NAME=A:B:COUNT:log or NAME=V,V,... is wanted";
    if (equals == std::string::npos) refuse(text, wanted);
    std::vector<std::string> parts = pieces_of(text, ':', equals + 1);
    parts.insert(parts.begin(), text.substr(0, equals));
    const std::size_t least = sampled ? 3 : 4;
    const bool has_log = parts.size() == least + 1 && parts.back() == "log";
    if (parts.size() != least && !has_log) refuse(text, wanted);
    return parts;
}

/// The steps of a grid, finer by 2^levels.
long refined(const std::string& text, long count, int levels) {
    if (levels == 0) return count;
    if (count < 2) refuse(text, "--refine needs COUNT >= 2");
    if (count > (most_points >> levels)) refuse(text, fmt::format("COUNT = {} is too large for --refine", count));
    return ((count - 1) << levels) + 1;
}

/// A + (B − A)u, or A (B/A)^u; of whole numbers each of A … B with an equal share.
std::vector<double> sampled_points(const std::string& name, double a, double b, bool by_logarithm,
                                   const std::vector<double>& units) {
    std::vector<double> points;
    points.reserve(units.size());
    const double low = std::min(a, b), high = std::max(a, b);
    for (const double u : units)
        if (by_logarithm)
            points.push_back(std::clamp(a * std::exp(std::log(b / a) * u), low, high));
        else
            points.push_back(name == "sides" ? std::min(high, low + std::floor(u * (high - low + 1)))
                                             : a + (b - a) * u);
    return points;
}

/// Laws, words and whatever has a comma.
bool is_list(const std::string& text, const GridForm& form) {
    const std::string after = text.substr(std::min(text.find('='), text.size()));
    return form.scenes > 0 || text == "law" || text.starts_with("law=") || after == "=disk" ||
           after.find(',') != std::string::npos;
}

void require_axis_name(const std::string& text, const std::string& name) {
    if (!is_axis_name(name)) refuse(text, fmt::format("NAME is none of: {}", axis_names()));
}

/// NAME=V,V…: each of them; of a sample each with an equal share; of a table of scenes one a row.
GridAxis list_axis_from(const std::string& text, const GridForm& form, const std::vector<double>* units) {
    if (text == "law") refuse(text, "law=NAME,NAME,... is wanted");
    if (form.levels > 0)
        refuse(text, text.starts_with("law=") ? "--refine halves steps, and there is nothing between two laws"
                                              : "--refine halves steps, and a list has none");
    GridAxis axis{text.substr(0, text.find('=')), text, {}, units != nullptr || form.scenes > 0, false};
    require_axis_name(text, axis.name);
    std::vector<double> values;
    for (const std::string& word : pieces_of(text, ',', text.find('=') + 1)) {
        try {
            values.push_back(axis_value(axis.name, word.empty() ? "(empty)" : word));
        } catch (const BadInput& error) {
            refuse(text, error.what());
        }
        const bool is_new = std::find(values.begin(), values.end() - 1, values.back()) == values.end() - 1;
        if (!is_new && form.scenes == 0) refuse(text, word + " is given twice");
    }
    const bool has_disk =
        axis.name == "sides" && std::find(values.begin(), values.end(), double{disk_sides}) != values.end();
    axis.in_words = axis.name == "law" || has_disk;
    if (form.scenes == 0 && !axis.in_words) std::sort(values.begin(), values.end());
    if (units == nullptr) {
        axis.points = values;
        return axis;
    }
    const auto count = static_cast<double>(values.size());
    for (const double u : *units)
        axis.points.push_back(values[static_cast<std::size_t>(std::min(count - 1, u * count))]);
    return axis;
}

/// What is no point of its axis.
void check_points(const std::string& text, const GridAxis& axis) {
    for (const double point : axis.points)
        if (axis.name == start_speed && point < 0)
            refuse(text, fmt::format("speed = {} is outside its range: speed >= 0", point));
        else if (axis.name == "sides" && point != std::round(point))
            refuse(text, fmt::format("sides = {} is not a whole number", point));
        else if (axis.name == "sides" && !axis.in_words && point < rod_sides)
            refuse(text, fmt::format("sides = {} is outside its range: 2 to {}, or disk in a list", point, max_sides));
        else if (axis.name == "sides")
            sides_from(word_at(axis, point));
}

GridAxis range_axis_from(const std::string& text, const GridForm& form, const std::vector<double>* units) {
    const std::vector<std::string> parts = parts_of(text, units != nullptr);
    GridAxis axis{parts[0], text, {}, units != nullptr, false};
    require_axis_name(text, axis.name);
    if (axis.name == "law") refuse(text, "law=NAME,NAME,... is wanted");
    const bool by_logarithm = parts.back() == "log";
    const double a = number_from<double>("A", parts[1]), b = number_from<double>("B", parts[2]);
    if (by_logarithm && axis.name == "sides") refuse(text, "sides are whole numbers: give a list, sides=3,6,12");
    if (by_logarithm && !(a > 0 && b > 0)) refuse(text, "A and B of :log must be above 0");
    if (units != nullptr) {
        if (!std::isfinite(a) || !std::isfinite(b) || a == b) refuse(text, "A and B must be finite and differ");
        axis.points = sampled_points(axis.name, a, b, by_logarithm, *units);
        return axis;
    }
    const long count = count_from(text, parts[3]);
    if (!std::isfinite(a) || !std::isfinite(b)) refuse(text, "A and B must be finite");
    if (count == 1 && a != b) refuse(text, "COUNT = 1 needs A = B");
    if (count > 1 && a == b) refuse(text, "A = B needs COUNT = 1");
    const long steps = refined(text, count, form.levels);
    axis.points =
        by_logarithm ? points_between_logarithms(parts[1], parts[2], steps) : points_between(parts[1], parts[2], steps);
    return axis;
}

GridAxis axis_from(const std::string& text, const GridForm& form, const std::vector<double>* units) {
    GridAxis axis = is_list(text, form) ? list_axis_from(text, form, units) : range_axis_from(text, form, units);
    check_points(text, axis);
    return axis;
}

}  // namespace

std::string word_at(const GridAxis& axis, double point) {
    if (axis.name == "law") return std::string(name_of(static_cast<Law>(static_cast<int>(point))));
    if (axis.name == "sides") return point == disk_sides ? "disk" : fmt::format("{:.0f}", point);
    return fmt::format("{}", point);
}

std::string axis_names() {
    return fmt::format("{}, law, {}, {}", fmt::join(scene_axes, ", "), start_speed, fmt::join(start_numbers, ", "));
}

bool is_axis_name(const std::string& name) {
    return is_among(scene_axes, name) || is_among(start_numbers, name) || name == start_speed || name == "law";
}

double axis_value(const std::string& name, const std::string& text) {
    if (name == "law") return static_cast<double>(law_from(text));
    if (name == "sides") return sides_from(text);
    const double value = number_from<double>(name, text);
    if (!std::isfinite(value)) throw BadInput(fmt::format("{} = {} is not finite", name, text));
    return value;
}

std::vector<GridAxis> grid_from(const std::vector<std::string>& texts, const GridForm& form) {
    if (texts.empty())
        throw BadInput("--grid is missing: NAME=A:B:COUNT or NAME=V,V,..., once to five times (or --scenes FILE.csv)");
    if (texts.size() > most_axes && form.scenes == 0)
        throw BadInput(fmt::format("{} grids are given: 1 to {} are allowed", texts.size(), most_axes));
    std::vector<GridAxis> grid;
    std::vector<std::vector<double>> units;
    if (form.sample) units = unit_points(*form.sample, texts.size(), form.seed);
    for (const auto& text : texts) {
        grid.push_back(axis_from(text, form, form.sample ? &units[grid.size()] : nullptr));
        for (std::size_t i = 0; i + 1 < grid.size(); ++i)
            if (grid[i].name == grid.back().name) refuse(text, grid.back().name + " is given twice");
        if (form.scenes > 0 && grid.back().points.size() != form.scenes)
            throw BadInput(fmt::format("{} of {} values is no column of {} scenes", grid.back().name,
                                       grid.back().points.size(), form.scenes));
    }
    double cells = 1;  // may be more than a size_t counts
    if (!grid.front().sampled)
        for (const auto& axis : grid) cells *= static_cast<double>(axis.points.size());
    if (cells > most_cells)
        throw BadInput(fmt::format("the grid has {:.4g} cells: {:.0f} are the most", cells, most_cells));
    return grid;
}

Sample sample_from(const std::string& text) {
    const auto colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    if (colon == std::string::npos || (kind != "sobol" && kind != "latin"))
        throw BadInput(fmt::format("sample = {} is none of: sobol:COUNT, latin:COUNT", text));
    Sample sample{kind == "sobol" ? Sample::Kind::sobol : Sample::Kind::latin, 0};
    const char *begin = text.data() + colon + 1, *end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(begin, end, sample.count);
    if (error != std::errc() || stop != end || sample.count < 1 || sample.count > most_in_sample)
        throw BadInput(fmt::format("sample = {}: COUNT is outside its range: 1 to {}", text, most_in_sample));
    return sample;
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

Scene<double> scene_of_cell(SceneOptions scene, const std::vector<GridAxis>& grid, std::size_t cell) {
    const auto point = cell_point(grid, cell);
    for (std::size_t k = 0; k < grid.size(); ++k)
        if (is_among(scene_axes, grid[k].name) || grid[k].has_words())
            scene.set(grid[k].name, word_at(grid[k], point[k]));
    return scene.scene<double>(Extensions::followed);
}

}  // namespace swirl::apps::sweep
