#include "apps/studies/grids/starts.hpp"

#include "map/model/parameter.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace swirl::studies::grids {

namespace {

bool is_of_the_start(const GridAxis& axis) {
    return std::find(start_numbers.begin(), start_numbers.end(), axis.name) != start_numbers.end();
}

}  // namespace

bool starts_are_placed(const std::vector<GridAxis>& grid) {
    return std::any_of(grid.begin(), grid.end(), is_of_the_start);
}

bool are_all_of_the_start(const std::vector<GridAxis>& grid) {
    return std::all_of(grid.begin(), grid.end(), is_of_the_start);
}

Scene<double> cell_scene(const GridStudy& study, std::size_t cell) {
    const auto point = cell_point(study.grid, cell);
    Scene<double> scene = study.scene;
    for (std::size_t k = 0; k < study.grid.size(); ++k) {
        const std::string& name = study.grid[k].name;
        if (name == "sides")
            scene.sides = static_cast<int>(point[k]);
        else if (name == "law")
            scene.law = static_cast<Law>(static_cast<int>(point[k]));
        else if (name == "spin-drag")
            scene.spin_drag = point[k];
        else if (name == "floor-friction")
            scene.floor_friction = point[k];
        else if (name == "gravity-ratio")
            scene.gravity_ratio = point[k];
        else if (const auto parameter = parameter_named(name))
            number_of(scene, *parameter) = point[k];
        else if (name != "speed" && !is_of_the_start(study.grid[k]))
            throw std::logic_error("a grid over " + name + ", which no scene has");
    }
    if (study.uniform && !has_axis(study.grid, "inertia-factor"))
        scene.inertia_factor = uniform_inertia_factor<double>(scene.sides, scene.alpha, scene.corner);
    return validated(scene);
}

LabStart<double> cell_start(const GridStudy& study, const Scene<double>& scene, std::size_t cell, std::uint64_t run) {
    const auto point = cell_point(study.grid, cell);
    if (starts_are_placed(study.grid)) return placed_start(study, scene, point);
    const auto speed =
        std::find_if(study.grid.begin(), study.grid.end(), [](const GridAxis& axis) { return axis.name == "speed"; });
    const double of_cell =
        speed == study.grid.end() ? study.speed : point[static_cast<std::size_t>(speed - study.grid.begin())];
    return random_start(scene.beta, of_cell, study.seed + run, 0);
}

LabStart<double> placed_start(const GridStudy& study, const Scene<double>& scene, const std::vector<double>& point) {
    LabStart<double> start = study.placed;
    if (study.at_centre) start.x = scene.beta;
    for (std::size_t k = 0; k < study.grid.size(); ++k)
        for (std::size_t i = 0; i < start_numbers.size(); ++i)
            if (study.grid[k].name == start_numbers[i]) start.*start_members[i] = point[k];
    return start;
}

}  // namespace swirl::studies::grids
