// A body in contact on one vertex rocks onto its neighbour.
#pragma once

#include "map/sustained/reaction.hpp"

#include <cmath>

namespace swirl {

/// The neighbour that |χ| = χ_m brings to the wall, in a state of contact on a vertex. u_n of it is lever · χ′ towards
/// the wall, χ′ = S − u_t by the sign of χ.
template <class T>
struct Rocking {
    T lever;         ///< α|sin χ − sin(χ ∓ 2π/N)|
    T acceleration;  ///< lever · χ″ towards the wall, by the forces of `motion`
};

/// To first order in χ′: at rest, and to vanishing order as a rocking motion comes to rest.
template <class T>
Rocking<T> rocking_of(const ContactScene<T>& scene, ContactMotion motion, const ContactState<T>& z) {
    using std::abs, std::sin;
    const Reaction<T> r = reaction_of(scene, Support::vertex, motion, z);
    const int side = z.chi > 0 ? -1 : 1;
    const T lever = scene.body.alpha * abs(sin(z.chi) - sin(z.chi + side * scene.body.spacing));
    return {lever, lever * side * -(r.spin_rate - r.ut_rate)};
}

}  // namespace swirl
