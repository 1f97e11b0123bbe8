// A plane of two parameters in cells with a proven number of fixed points.
#pragma once

#include "apps/studies/bifurcation_curves/plane.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "map/cells/plane_piece.hpp"

#include <cstddef>
#include <vector>

namespace swirl::studies::certify {

using bifurcation_curves::Plane;

/// What one number of halvings gave.
struct DepthShare {
    int depth = 0;
    std::size_t cells = 0;   ///< that were looked at
    double proven_area = 0;  ///< share of the plane that is proven at this depth or before
    double seconds = 0;      ///< of cores, up to this depth; differs from run to run
};

struct ProvenPlane {
    Plane plane;
    double max_time = 0;
    int halvings = 0;                            ///< of each side, at most
    std::vector<swirl::cells::PlaneCell> cells;  ///< together the plane; their order is that of the halves
    std::vector<DepthShare> depths;
    bool whole = true;  ///< false: a stop left cells that were not looked at

    double proven_area() const;  ///< as a share of the plane
    std::size_t proven() const;
};

struct ProvenPlaneOptions {
    double max_time = 6;  ///< in 1/ω_s
    int halvings = 8;     ///< of each side, at most
    RunControl control = {};
};

/// @throws std::invalid_argument where fixed points are not isolated everywhere in the plane (a disk, μ = 0, β = 0,
/// e = 1)
void require_isolated(const Scene<double>& scene, const Plane& plane);

/// Cost: some milliseconds a cell, and as many cells as the curves are long in units of the smallest side.
/// @throws as require_isolated
ProvenPlane proven_plane(const Scene<double>& scene, const Plane& plane, const ProvenPlaneOptions& options);

}  // namespace swirl::studies::certify
