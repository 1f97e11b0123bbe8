// Looks at every vertex of a flight again.
#pragma once

#include "map/proof_check/impact_equations.hpp"

#include <string>

namespace swirl::proof_check {

/// The balls of a point and of the flight that begins there.
struct FlightBox {
    Ball psi, chi, vn, vt, spin, tau;
};

/// Empty if no vertex is outside before the flight's end; else which could not be shown to be inside, and when. Time is
/// halved; each half keeps the list of those vertices that the whole left open.
std::string open_vertex(const StatedScene& scene, const FlightBox& box, int arriving);

}  // namespace swirl::proof_check
