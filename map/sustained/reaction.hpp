// The wall's force on a body in contact, and the resulting accelerations.
//
// With w the swirl's arm (w_n = β cos ψ, w_t = −β sin ψ), r the lever arm and the force −λ n + f t, in the container's
// frame
//     vertex:  λ = w_n + u_t² − S′ r_t − S² r_n,  u_t′ = w_t + f + S′ r_n − S² r_t,  I S′ = r_n f + r_t λ
//     rim:     λ = w_n + ρν′²,  ρν″ = w_t + f,  I S′ = α f   (ρ = 1 − α, ρν′ = u_t − αS)
//     edge:    both vertices run along the wall, S = ν′: (I + d²) S′ = Σf − dβ sin ψ_c with d the centre's distance and
//              ψ_c its direction; the radial and tangential balance give both λ.
// Sliding: f = −μ sign(u_t) λ. Sticking: u_t = 0. Source: Routh's equations of a rigid body with one or two unilateral
// constraints (Brogliato, Nonsmooth Mechanics, 3rd ed. 2016, ch. 5); derived in map/sustained/README.md.
#pragma once

#include "map/sustained/contact_state.hpp"

namespace swirl {

struct Reaction {
    double normal = 0;     ///< λ (of an edge: of the clockwise vertex)
    double second = 0;     ///< λ of an edge's other vertex
    double friction = 0;   ///< f, along t (of an edge: both together)
    double ut_rate = 0;    ///< du_t/dt
    double spin_rate = 0;  ///< S′
    double reserve = 0;    ///< sticking: μλ − |f|, negative if friction can't hold it (edge: see `edge_reserve`)
    double stiffness =
        1;  ///< sliding on a vertex: B₂ − sμB₃; at 0 and below λ is not unique or does not exist (Painlevé)
};

Reaction reaction_of(const ContactScene& scene, Support support, ContactMotion motion, const ContactState& state);

/// A margin beyond its limit within which friction still counts as holding, so that the direction of the slip that
/// follows is not decided by rounding.
double stick_margin(const ContactScene& scene, const ContactState& state);

/// dν/dt of the contact's normal.
double normal_rate(const ContactScene& scene, Support support, const ContactState& state);

}  // namespace swirl
