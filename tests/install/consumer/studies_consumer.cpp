// Swirl::studies from outside: a scene is classified, its cycles are found and a grid is swept.
#include "apps/studies/cycles/find_orbits.hpp"
#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <cstdio>
#include <string>

int main() {
    using namespace swirl;
    const Scene<double> hexagon{6, 0.4, 0.5, 0.5, 0.9, Law::poisson, uniform_inertia_factor<double>(6)};
    const auto start = studies::random_start(hexagon.beta, studies::paper_speed, 1, 0);
    const studies::NamedMode mode = studies::name_mode(hexagon, start, {});
    const studies::cycles::FindOptions few{.candidates = {.starts = 50, .trajectories = 2}};
    const auto cycles = studies::cycles::find_orbits(hexagon, studies::shooting_map_of(hexagon), few).cycles;
    const studies::grids::GridStudy study{.grid = {{.name = "beta", .points = {0.4, 0.5}}}, .scene = hexagon};
    const auto runs = studies::grids::sweep_grid(study);

    const std::string kind(analysis::name_of(mode.verdict.kind));
    std::printf("kind %s, mean S %.17g, %zu fixed points\n", kind.c_str(), mode.verdict.mean, cycles.size());
    if (!runs || runs->size() != 2) return 1;
    // The second cell is the scene itself with the same seed. `swirl describe` lists its 31 steady modes: 6 and 25.
    const bool same = (*runs)[1].mean_spin == mode.verdict.mean && kind_of((*runs)[1]) == mode.verdict.kind;
    std::size_t steady = 0;
    for (const analysis::Cycle& cycle : cycles) steady += cycle.period() == 1 ? 1 : 0;
    std::printf("the grid's cell agrees: %s\n", same ? "yes" : "no");
    return same && steady >= 31 ? 0 : 1;
}
