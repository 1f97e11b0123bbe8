// Flights on which a search for the first contact is most easily wrong, and ordinary ones of orbits beside them.
#pragma once

#include "map/collision_map.hpp"
#include "tests/map/random_scenes.hpp"

#include <vector>

namespace swirl::tests {

enum class FlightKind {
    orbit,      ///< of an orbit, some impacts after a random start
    graze,      ///< beside the border at which a vertex begins to touch: a double root at 10⁻¹ … 10⁻¹⁶
    tie,        ///< beside the border at which another vertex is the first: two of them within 10⁻¹ … 10⁻¹⁶
    departure,  ///< leaves with a normal velocity of 10⁻⁹ … 10⁻³: its own double root at the start
    edge,       ///< two vertices within 10⁻¹⁵ … 10⁻² at the start
    extreme,    ///< a spin up to 300, a wide swirl or a body that all but fills the container
    airborne    ///< begins in flight, not on the wall
};
inline constexpr int flight_kinds = 7;
constexpr const char* name_of(FlightKind kind) {
    constexpr const char* names[flight_kinds] = {"orbit", "graze", "tie", "departure", "edge", "extreme", "airborne"};
    return names[static_cast<int>(kind)];
}

struct SampledFlight {
    FlightKind kind = FlightKind::orbit;
    Scene<double> scene;
    Flight<double> flight;
    double width = 0;  ///< of graze and tie: the distance to the border, along a line of starts of length 0.1 … 1
};

/// The next one or two flights of a seeded sequence.
std::vector<SampledFlight> next_flights(Random& random);

/// Those on both sides of a border, graze or tie.
std::vector<SampledFlight> next_border(Random& random);

/// What the search says of a flight, and whether its first part had both the root and the proof.
struct Claim {
    FirstContact<double> contact;
    bool direct = false;
};
Claim claim_of(const Scene<double>& scene, const Flight<double>& flight);

}  // namespace swirl::tests
