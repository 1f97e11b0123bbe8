// A cycle by Newton's method from points near it.
#pragma once

#include "analysis/cycles/multi_shooting.hpp"
#include "apps/studies/cycles/cycle_place.hpp"

namespace swirl::studies::cycles {

/// The cycle of that minimal period to which multi-shooting leads from the points of a place, or from the states that
/// follow its first point where there are fewer; empty if it leads to none.
///   map  of the place's scene, along a parameter with the value p
analysis::CyclePoints cycle_from(const CyclePlace& place, int period, const analysis::ShootingMap& map, double p);

}  // namespace swirl::studies::cycles
