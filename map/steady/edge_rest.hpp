// A polygon at rest on the wall in the frame that turns with the swirl, on two neighbouring vertices: S = 1, and the
// wall slips along it backwards for ever (README.md, "Rest on an edge").
#pragma once

#include "map/model/scene.hpp"

#include <vector>

namespace swirl {

struct EdgeRest {
    double psi = 0;    ///< direction of the edge's middle from the container's centre, less the swirl's, in (−π, π]
    double force = 0;  ///< Λ, of the wall's two normal forces together
    bool restored = false;  ///< a displacement along the wall is driven back; friction also damps it, if there is any
};

/// Two of a polygon in a swirl at most, by rising ψ: those whose two vertices are both pressed on. With e < 1 impacts
/// may come to one that is restored; the others repel. None of a disk, and without a swirl.
/// Cost: a microsecond. @throws std::invalid_argument if a parameter is out of range
std::vector<EdgeRest> edge_rests(const Scene<double>& scene);

}  // namespace swirl
