// From a claim to its equations and a box.
#pragma once

#include "map/proof/shooting_in_balls.hpp"

#include <Eigen/Core>

#include <string>

namespace swirl::proof {

struct PreparedSystem {
    CycleSystem system;
    BallVector middle;        ///< exact doubles
    Eigen::MatrixXd inverse;  ///< ≈ G′(middle)⁻¹
    std::string reason;       ///< why there is nothing to prove; empty: there is
};

/// The equations, the claimed point corrected to rounding by Newton's method, and the approximate inverse there.
PreparedSystem prepared_system(const Scene<double>& scene, const CycleClaim& claim);

/// The box that Krawczyk's operator maps into itself.
struct KrawczykBox {
    BallVector box;
    std::string reason;  ///< how far it was from that; empty: it does
};
KrawczykBox krawczyk_box(const PreparedSystem& prepared);

}  // namespace swirl::proof
