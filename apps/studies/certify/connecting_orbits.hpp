// Orbits from one saddle cycle to another, or back to the same: where an unstable manifold meets a stable one.
#pragma once

#include "apps/studies/certify/saddles.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace swirl::studies::certify {

/// The points between two sets about cycles: the first is the image of a point of set `from_set` of saddle `from` and
/// lies outside it, the last one's image lies in set `to_set` of saddle `to`, near the middle of its stretched side.
struct ConnectingOrbit {
    std::size_t from = 0, from_set = 0, to = 0, to_set = 0;  ///< saddles by their place in the list
    double leaves_at = 0;                                    ///< q_0 of the point of `from_set`
    Eigen::MatrixXd first_by_state;                          ///< DF there
    std::vector<Eigen::VectorXd> points;
    std::vector<ChartStep> steps;  ///< one a point
};

/// A point z and its orbit make a boundary value problem: z_0 on the unstable direction of a cycle's point, z_K on the
/// stable directions of another's, F(z_i) = z_{i+1} between them. Guesses are points of an unstable manifold whose
/// orbits come near a cycle, continued by what is linear there; Newton's method has all z_i as unknowns, so that long
/// orbits are as well conditioned as short ones. Near is a tenth of the coordinates' unit, however small the sets are:
/// of an attractor with D dimensions a share ~ r^D of all points is as near as r.
/// Each orbit once, in the order of the scan. Cost: `most` steps a point of the scan, and some 2 ms an orbit.
///   most  points of an orbit between the sets
std::vector<ConnectingOrbit> connecting_orbits(const ChartMap& map, const std::vector<Saddle>& saddles,
                                               const ScanPart& part, int most, const std::function<bool()>& stop);

}  // namespace swirl::studies::certify
