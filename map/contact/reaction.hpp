// The wall's force on a body in contact, and the resulting accelerations.
//
// With w the swirl's arm (w_n = β cos ψ, w_t = −β sin ψ), r the lever arm and the force −λ n + f t, in the container's
// frame
//     vertex:  λ = w_n + u_t² − S′ r_t − S² r_n,  u_t′ = w_t + f + S′ r_n − S² r_t,  I S′ = r_n f + r_t λ
//     rim:     λ = w_n + ρν′²,  ρν″ = w_t + f,  I S′ = α f   (ρ = 1 − α, ρν′ = u_t − αS)
//     edge:    both vertices run along the wall, S = ν′: (I + d²) S′ = Σf − dβ sin ψ_c with d the centre's distance and
//              ψ_c its direction; the radial and tangential balance give both λ.
// Over a floor that drags (ContactFloor) w is (1 − iγ[table]) w, the centre has −γX′ and S has −γ_r S besides:
//     vertex:  λ gains −γS r_t, u_t′ gains −γ(u_t − S r_n), S′ gains −γ_r S
//     rim:     ρν″ gains −γρν′, S′ gains −γ_r S
//     edge:    (I + d²)S′ gains −(γd² + γ_r I)S, w_t in the balance along the wall −(γ − γ_r) dS.
// A push of the floor is in w; its torque, by I, is added to S′ = (r_n f + r_t λ)/I.
// Sliding: f = −μ sign(u_t) λ. Sticking: u_t = 0. Source: Routh's equations of a rigid body with one or two unilateral
// constraints (Brogliato, Nonsmooth Mechanics, 3rd ed. 2016, ch. 5); derived in map/contact/README.md.
#pragma once

#include "map/contact/contact_state.hpp"
#include "map/numbers/real.hpp"

#include <cmath>

namespace swirl {

template <class T>
struct Reaction {
    T normal{};     ///< λ (of an edge: of the clockwise vertex)
    T second{};     ///< λ of an edge's other vertex
    T friction{};   ///< f, along t (of an edge: both together)
    T ut_rate{};    ///< du_t/dt
    T spin_rate{};  ///< S′
    T reserve{};    ///< sticking: μλ − |f|, negative if friction can't hold it (edge: see `edge_reserve`)
    T stiffness =
        T(1);  ///< sliding on a vertex: B₂ − sμB₃; at 0 and below λ is not unique or does not exist (Painlevé)
};

/// The sums Λ of an edge's two λ between which both of its forces are within their friction cones; none where most <
/// least. Of the pairs that hold an edge at rest, which are not unique, reports have the one whose Λ is nearest to that
/// without tension along the edge, f₁ = f₂.
template <class T>
struct EdgeNormals {
    T least{}, most{};

    T nearest_to(const T& sum) const { return sum > most && most > least ? most : sum < least ? least : sum; }
};

/// Those of an edge that is held by a force of the wall.
///   force         of both vertices, along n and t of the edge's middle
///   sum_friction  f₁ + f₂
template <class T>
EdgeNormals<T> edge_normals(const ContactScene<T>& scene, const Vec2<T>& force, const T& sum_friction);

template <class T>
Reaction<T> reaction_of(const ContactScene<T>& scene, Support support, ContactMotion motion,
                        const ContactState<T>& state);

/// A margin beyond its limit within which friction still counts as holding, so that the direction of the slip that
/// follows is not decided by rounding.
template <class T>
T stick_margin(const ContactScene<T>& scene, const ContactState<T>& state);

/// B₂ − sμB₃ up to this is rounding: a slip that comes so close to Painlevé's border is on it. With what rounding
/// leaves λ there, known to ε/(B₂ − sμB₃), velocities change by ε only on the way to it.
template <class T>
T painleve_margin() {
    return tolerance<T>(1e-13);
}

/// dν/dt of the contact's normal.
template <class T>
T normal_rate(const ContactScene<T>& scene, Support support, const ContactState<T>& state);

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
