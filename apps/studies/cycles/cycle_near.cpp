#include "apps/studies/cycles/cycle_near.hpp"

#include "analysis/cycles/cycle.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"

#include <iterator>

namespace swirl::studies::cycles {

analysis::CyclePoints cycle_from(const CyclePlace& place, int period, const analysis::ShootingMap& map, double p) {
    constexpr double closes = 1e-10;
    if (place.points.empty()) return {};
    const bool disk = place.scene.is_disk();
    analysis::CyclePoints guess;
    if (std::ssize(place.points) == period)
        for (const auto& z : place.points) guess.push_back(coordinates_of(z, disk));
    else
        guess = analysis::orbit_from(map, coordinates_of(place.points.front(), disk), p, period);
    if (guess.empty()) return {};
    const auto shot = analysis::solve_shooting(map, guess, p, closes);
    if (!shot.converged) return {};
    const auto cycle = analysis::minimal_cycle(map, shot.points, analysis::same_cycle);
    return static_cast<int>(cycle.size()) == period ? cycle : analysis::CyclePoints{};
}

}  // namespace swirl::studies::cycles
