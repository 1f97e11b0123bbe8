// What the tests of orbits share: a search as the command does it, and points of the references as states.
#pragma once

#include "apps/studies/cycles/find_orbits.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "tests/references/references.hpp"

#include <algorithm>
#include <complex>
#include <limits>
#include <vector>

namespace swirl::tests {

inline std::vector<analysis::Cycle> cycles_of(const Scene<double>& scene, int period,
                                              studies::cycles::FindOptions options = {}) {
    options.first_period = options.last_period = period;
    return studies::cycles::find_orbits(scene, studies::shooting_map_of(scene), options).cycles;
}

/// The distance of a listed point from the nearest point of a cycle.
inline double distance_to(const analysis::ShootingMap& map, const analysis::Cycle& cycle, const Eigen::VectorXd& z) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& point : cycle.points) nearest = std::min(nearest, map.distance(point, z));
    return nearest;
}

/// The largest difference of multipliers, relative for those above 1, each against the nearest of the listed ones.
inline double multiplier_error(const analysis::Cycle& cycle, const nlohmann::json& listed) {
    double largest = 0;
    for (const auto& pair : listed) {
        const std::complex<double> m(pair[0].get<double>(), pair[1].get<double>());
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& found : cycle.multipliers) nearest = std::min(nearest, std::abs(found - m));
        largest = std::max(largest, nearest / std::max(1.0, std::abs(m)));
    }
    return largest;
}

}  // namespace swirl::tests
