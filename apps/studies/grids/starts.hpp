// What a grid is of, and the scene and the start of each of its runs.
#pragma once

#include "analysis/classification/classify.hpp"
#include "apps/studies/grids/grid.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/start.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace swirl::studies::grids {

/// What is asked of every cell.
struct GridStudy {
    std::vector<GridAxis> grid = {};
    Scene<double> scene = {};  ///< what the grid does not vary is every cell's
    bool uniform = true;    ///< κ is the uniform lamina's of each cell's N, unless it is an axis; false: the scene's
    std::int64_t runs = 1;  ///< in each cell
    double speed = paper_speed;  ///< of random starts, unless it is an axis
    std::uint64_t seed = 1;      ///< of a cell's run 0; run r has seed + r
    /// Where axes are numbers of the start: its other numbers …
    LabStart<double> placed = {};
    bool at_centre = true;  ///< … of which x is each cell's β, the container's centre; false: x of `placed`
    analysis::ClassifyOptions settings = {};         ///< of a verdict
    Accuracy accuracy = Accuracy::double_precision;  ///< in which orbits are followed
    double risk = 0;  ///< that chaos which is called before the limits has another verdict there (early_chaos.hpp)
    /// Of runs whose chaos is called so: mean S is followed on until its error is no larger, or to the limits.
    double error = std::numeric_limits<double>::infinity();
};

/// start_numbers, as members.
inline constexpr std::array<double LabStart<double>::*, start_numbers.size()> start_members = {
    &LabStart<double>::x,  &LabStart<double>::y,     &LabStart<double>::vx,
    &LabStart<double>::vy, &LabStart<double>::angle, &LabStart<double>::spin};

/// True if an axis is a number of a start in the laboratory (x, y, vx, vy, angle, spin): each cell has one start then,
/// and the grid is a plane of starts, of whose basins of attraction it makes a map.
bool starts_are_placed(const std::vector<GridAxis>& grid);

/// True if all axes are: every cell has the same scene.
bool are_all_of_the_start(const std::vector<GridAxis>& grid);

/// The scene of a cell. @throws std::invalid_argument out of range
Scene<double> cell_scene(const GridStudy& study, std::size_t cell);

/// The start of run `run` of a cell, which has this scene: placed by the grid's numbers, or the random one of seed +
/// run with the cell's speed.
LabStart<double> cell_start(const GridStudy& study, const Scene<double>& scene, std::size_t cell, std::uint64_t run);

/// The start whose numbers along the grid's axes are those of a point, in a cell or between.
LabStart<double> placed_start(const GridStudy& study, const Scene<double>& scene, const std::vector<double>& point);

}  // namespace swirl::studies::grids
