// A body that goes along with a floor with dry friction. map/dry/README.md, "Riding".
#pragma once

#include "map/dragged/riding.hpp"
#include "map/dry/dry_flight.hpp"

#include <optional>

namespace swirl {

/// The distance of the body's farthest point from a place's origin.
///   place, arm  of the centre, and from it to vertex 0
double farthest_point(const Body<double>& body, const Vec2<double>& place, const Vec2<double>& arm);

/// True if the body will go along with the dish and meet the wall no more: by what is left, in linear order, of its way
/// to U = c w, |U| = √(β² − a_f²), S = 0. Not where β ≤ a_f, where it stops.
bool rides(const DryFlight<double>& flight, const DryMoment<double>& moment);

/// Where a flight that meets the wall no more comes to, with S = 0 (Riding): on a dish at rest against it, radius 0, or
/// for β > a_f on a circle of radius √(β² − a_f²); on a table at rest in the laboratory, radius β. Nothing where the
/// flight comes to the wall.
///   released  it begins where the wall has released a disk
/// @throws std::invalid_argument if a parameter of the scene is out of range
std::optional<Riding> riding_over_dry_floor(const Scene<double>& scene, const Flight<double>& flight,
                                            bool released = false);

}  // namespace swirl
