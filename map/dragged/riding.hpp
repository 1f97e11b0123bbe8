// What a flight that meets the wall no more comes to over a floor that drags. map/dragged/README.md, "Flight".
#pragma once

#include "map/model/flight.hpp"
#include "map/model/scene.hpp"

#include <optional>

namespace swirl {

/// In the container's frame the body ends on a circle about a place Q: with U as in dragged_flight.hpp
///
///     X → Q − h w      Q = X₀ + h w₀ + U/γ      θ → θ₀ + S₀/γ_r      S → 0 (γ_r = 0: S₀)
///
/// |h|β = β/√(1 + γ²) of a dish. Over a table h = 1: it comes to rest in the laboratory, and the container goes about
/// it.
struct Riding {
    Vec2<double> place;  ///< Q, in the axes of the flight, from the container's centre
    double radius = 0;   ///< |h|β, in R_c
    /// How far from the wall it is at its nearest in the end: 1 − |h|β − max |Q + a| over the vertices, 1 − α − |h|β −
    /// |Q| of a disk and of a polygon that turns for ever. Negative: it meets the wall before it rides.
    double room = 0;
    double spin = 0;  ///< S in the end
};

/// Nothing where γ = 0: the body's velocity stays.
/// @throws std::invalid_argument if a parameter of the scene is out of range
std::optional<Riding> riding_of(const Scene<double>& scene, const Flight<double>& flight);

}  // namespace swirl
