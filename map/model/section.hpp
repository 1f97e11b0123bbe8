// The section: the state just after an impact, in axes that turn with the swirl. map/README.md, "Section coordinates".
//
//     z = (ψ, χ, v_n, v_t, S)   ψ = arg n − t,  χ = arg r − arg n,  v_n, v_t: the centre's lab velocity along n and t.
#pragma once

#include "map/model/body.hpp"
#include "map/model/flight.hpp"
#include "map/model/impact.hpp"

#include <cmath>

namespace swirl {

/// A point of the section. The disk has χ = 0.
template <class T = double>
struct SectionPoint {
    T psi{};   ///< ψ ∈ (−π, π]
    T chi{};   ///< χ ∈ (−π, π]
    T vn{};    ///< v_n, in R_c ω_s
    T vt{};    ///< v_t, in R_c ω_s
    T spin{};  ///< S = ω_p/ω_s
};

#include "map/model/section_formulas.hpp"

template <class T>
inline PostImpactState<T> post_impact_state(const SectionPoint<T>& z) {
    return {cis(z.psi), cis(z.chi), z.vn, z.vt, z.spin};
}

template <class T>
inline SectionPoint<T> section_point(const PostImpactState<T>& post_impact) {
    using std::atan2;
    return {atan2(post_impact.psi.y, post_impact.psi.x), atan2(post_impact.chi.y, post_impact.chi.x), post_impact.vn,
            post_impact.vt, post_impact.spin};
}

/// The flight that begins at a point of the section, also of a body with rounded corners: in its units (Body::unit).
/// Divided, not multiplied by a reciprocal that is off the same way each time (map/README.md, "Section coordinates").
template <class T>
inline Flight<T> flight_of(const Body<T>& body, const PostImpactState<T>& post_impact) {
    Flight<T> flight = flight_from(body, post_impact);
    if (body.corner == T(0)) return flight;
    flight.velocity = {post_impact.vn / body.unit, post_impact.vt / body.unit};
    return flight;
}

/// Of a body with rounded corners in its own units, with velocities in these: the lever arm to where the wall is
/// touched is longer by r along n, so that u_t gains rS.
template <class T>
inline ContactKinematics<T> rounded_kinematics(const Body<T>& body, const PostImpactState<T>& post_impact) {
    ContactKinematics<T> u = contact_kinematics(body, post_impact);
    u.rn = u.rn + body.corner;
    u.ut = u.ut + body.corner * post_impact.spin;
    return u;
}

/// `contact_kinematics`, also of a body with rounded corners; in R_c.
template <class T>
inline ContactKinematics<T> kinematics_of(const Body<T>& body, const PostImpactState<T>& post_impact) {
    if (body.corner == T(0)) return contact_kinematics(body, post_impact);
    PostImpactState<T> state = post_impact;
    state.vn = post_impact.vn / body.unit;
    state.vt = post_impact.vt / body.unit;
    const ContactKinematics<T> u = rounded_kinematics(body, state);
    const T square = body.unit * body.unit;
    return {u.un * body.unit, u.ut * body.unit,   u.rn * body.unit,
            u.rt * body.unit, u.inertia * square, u.inverse_inertia / square};
}

/// Energy in the swirling frame, J = ½|V − ẑ×X|² − ½|X|² + ½I(S − 1)² − ½I with X from the swirl's centre
/// (map/README.md, "Energy in the swirling frame"). Conserved in flight.
template <class T>
inline T jacobi_of(const Body<T>& body, const PostImpactState<T>& post_impact) {
    const Vec2<T> position = Vec2<T>{T(1) - body.alpha * post_impact.chi.x, -(body.alpha * post_impact.chi.y)} +
                             body.beta * conjugate(post_impact.psi);
    const bool rounded = body.corner != T(0);
    const Vec2<T> velocity = rounded ? Vec2<T>{post_impact.vn / body.unit, post_impact.vt / body.unit}
                                     : Vec2<T>{post_impact.vn, post_impact.vt};
    const T jacobi = T(0.5) * dot(velocity, velocity) - cross(position, velocity) +
                     body.inertia * post_impact.spin * (T(0.5) * post_impact.spin - T(1));
    return rounded ? T(body.unit * body.unit * jacobi) : jacobi;
}

}  // namespace swirl
