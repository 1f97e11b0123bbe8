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

/// Energy in the swirling frame, J = ½|V − ẑ×X|² − ½|X|² + ½I(S − 1)² − ½I with X from the swirl's centre
/// (map/README.md, "Energy in the swirling frame"). Conserved in flight.
template <class T>
inline T jacobi_of(const Body<T>& body, const PostImpactState<T>& post_impact) {
    const Vec2<T> position = Vec2<T>{T(1) - body.alpha * post_impact.chi.x, -(body.alpha * post_impact.chi.y)} +
                             body.beta * conjugate(post_impact.psi);
    const Vec2<T> velocity{post_impact.vn, post_impact.vt};
    return T(0.5) * dot(velocity, velocity) - cross(position, velocity) +
           body.inertia * post_impact.spin * (T(0.5) * post_impact.spin - T(1));
}

}  // namespace swirl
