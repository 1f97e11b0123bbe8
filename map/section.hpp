// The section: the state just after an impact, in axes that turn with the swirl. Design, section 4.
//
//     z = (ψ, χ, v_n, v_t, S)   ψ = arg n − t,  χ = arg r − arg n,  v_n, v_t: the centre's lab velocity along n and t.
#pragma once

#include "map/body.hpp"
#include "map/flight.hpp"
#include "map/impact.hpp"

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

/// The same with the angles as unit vectors, which is what the map iterates: no arc tangent per impact.
template <class T>
struct Launch {
    Vec2<T> psi;  ///< cis ψ
    Vec2<T> chi;  ///< cis χ
    T vn{}, vt{}, spin{};
};

template <class T>
inline Launch<T> launch_from(const SectionPoint<T>& z) {
    return {cis(z.psi), cis(z.chi), z.vn, z.vt, z.spin};
}

template <class T>
inline SectionPoint<T> section_point(const Launch<T>& launch) {
    using std::atan2;
    return {atan2(launch.psi.y, launch.psi.x), atan2(launch.chi.y, launch.chi.x), launch.vn, launch.vt, launch.spin};
}

/// The flight that begins there, in the axes (n, t): the struck vertex is at (1, 0), the swirl's arm at angle −ψ.
template <class T>
[[gnu::always_inline]] inline Flight<T> flight_from(const Body<T>& body, const Launch<T>& launch) {
    Flight<T> flight;
    flight.arm = body.alpha * launch.chi;
    flight.centre = Vec2<T>{T(1) - flight.arm.x, -flight.arm.y};
    flight.velocity = {launch.vn, launch.vt};
    flight.phase = conjugate(launch.psi);
    flight.beta = body.beta;
    flight.spin = launch.spin;
    flight.struck = true;
    return flight;
}

/// Slip velocities and lever arms at the contact: u = V + S ẑ×r − O′,
/// u_n = v_n − αS sin χ − β sin ψ, u_t = v_t + αS cos χ − β cos ψ.
template <class T>
[[gnu::always_inline]] inline Approach<T> approach_of(const Body<T>& body, const Launch<T>& launch) {
    const Vec2<T> r = body.alpha * launch.chi;
    return {launch.vn - launch.spin * r.y - body.beta * launch.psi.y,
            launch.vt + launch.spin * r.x - body.beta * launch.psi.x,
            r.x,
            r.y,
            body.inertia,
            body.per_inertia};
}

/// Energy in the swirling frame, J = ½|V − ẑ×X|² − ½|X|² + ½I(S − 1)² − ½I with X from the swirl's centre
/// (design, section 3). Conserved in flight.
template <class T>
inline T jacobi_of(const Body<T>& body, const Launch<T>& launch) {
    const Vec2<T> place =
        Vec2<T>{T(1) - body.alpha * launch.chi.x, -(body.alpha * launch.chi.y)} + body.beta * conjugate(launch.psi);
    const Vec2<T> velocity{launch.vn, launch.vt};
    return T(0.5) * dot(velocity, velocity) - cross(place, velocity) +
           body.inertia * launch.spin * (T(0.5) * launch.spin - T(1));
}

}  // namespace swirl
