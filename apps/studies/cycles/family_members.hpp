// How far families of cycles reach, and their members with a given S or return time.
#pragma once

#include "analysis/cycles/family.hpp"
#include "apps/studies/cycles/find_orbits.hpp"

#include <optional>

namespace swirl::studies::cycles {

/// A family's range over its members.
struct FamilyRange {
    double least_spin = 0, most_spin = 0, shortest = 0, longest = 0;
    bool closed = false;
};

/// Of a one-parameter family: of fixed points in closed form, of others by walking along it.
FamilyRange range_of(const Scene<double>& scene, const analysis::ShootingMap& map,
                     const std::optional<SteadySearch>& steady, const analysis::Cycle& cycle);

/// What picks a member of a family: its S just after the first impact, or its return time.
struct Pin {
    bool by_time = false;
    double value = 0;
};

/// Replaces the families by their members where S or the return time has the value. (Where it is the same all along a
/// family there is no single one.)
void pin_families(const Scene<double>& scene, const analysis::ShootingMap& map, const Pin& pin, FoundOrbits& found);

}  // namespace swirl::studies::cycles
