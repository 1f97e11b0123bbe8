#include "apps/sweep/start_settings.hpp"

#include "apps/studies/grids/starts.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace swirl::apps::sweep {

namespace {

/// What the flags say, whatever the cell.
LabStart<double> placed_by_flags(const StartOptions& options, const Scene<double>& scene) {
    if (!options.is_random()) return std::get<LabStart<double>>(options.start(scene));
    LabStart<double> start;
    start.x = scene.beta;
    return start;
}

}  // namespace

std::vector<std::pair<std::string, double>> start_settings(const StartOptions& options, const Scene<double>& scene,
                                                           const std::vector<GridAxis>& grid) {
    if (!starts_are_placed(grid)) {
        if (has_axis(grid, "speed")) return {};
        return {{"speed", options.speed()}};
    }
    std::vector<std::pair<std::string, double>> settings;
    const LabStart<double> start = placed_by_flags(options, scene);
    const bool follows_beta = has_axis(grid, "beta") && !options.gives("x");
    for (std::size_t i = 0; i < start_numbers.size(); ++i)
        if (!has_axis(grid, start_numbers[i]) && !(i == 0 && follows_beta))
            settings.emplace_back(start_numbers[i], start.*start_members[i]);
    return settings;
}

void require_starts(const StartOptions& options, const std::vector<GridAxis>& grid, std::int64_t runs) {
    options.require_one_way();
    if (!starts_are_placed(grid)) {
        if (!options.is_random())
            throw BadInput(
                "a sweep's starts are random, unless --grid is over numbers of the start (x, y, vx, vy, angle, "
                "spin): give --speed and --seed, not --x … or --point");
        if (options.speed_given() && has_axis(grid, "speed"))
            throw BadInput("--speed and --grid speed=… are two speeds of the same starts: give one of them");
        return;
    }
    if (has_axis(grid, "speed") || options.speed_given() || options.gives("point"))
        throw BadInput(
            "a grid over numbers of the start places every start: --speed, --point and --grid speed=… do not "
            "go with it, --x … do");
    if (options.given() && options.is_random() && !grid.front().sampled)
        throw BadInput("a grid over numbers of the start places every start: --seed does not go with it");
    if (runs != 1)
        throw BadInput(fmt::format("runs = {}: a grid over numbers of the start has one start in each cell", runs));
    for (const char* name : start_numbers)
        if (has_axis(grid, name) && options.gives(name))
            throw BadInput(fmt::format("--{0} and --grid {0}=… are both given: give one of them", name));
}

std::vector<std::string> grid_without_units(std::vector<std::string> texts, const std::optional<Units>& units) {
    for (std::string& text : texts)
        text = range_without_units(text, units, units_of_axis(text.substr(0, text.find('='))));
    return texts;
}

std::string units_of_axis(const std::string& name) {
    if (name == "x" || name == "y") return "R_c";
    if (name == "vx" || name == "vy" || name == "speed") return "R_c omega_s";
    if (name == "angle") return "rad";
    return name == "spin" ? "omega_s" : "1";
}

}  // namespace swirl::apps::sweep
