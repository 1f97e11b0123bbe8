// An impact with a wall that is rough: where the body strikes it, the normal is turned by an angle η against the
// circle's.
//
// With n′ = n cos η + t sin η the impact is that of impact.hpp in the axes (n′, t′): ψ′ = ψ + η, the same impulse law.
// A polygon's corner has the offset that it has, χ′ = χ − η; a disk touches where its rim is along n′, χ′ = 0, at
// (1 − α) n + α n′ from the container's centre. Of the energy J = E − ω_s L the impulse −p n′ + q t′ changes
// −p(ū_n′ − sin η) + q(ū_t′ − cos η), a disk's −p(ū_n′ − (1 − α) sin η) + q(ū_t′ − (1 − α) cos η − α). A facet that
// faces away, or leaves the body going into the circle (u_n > 0), is followed at once by an impact with the circle.
#pragma once

#include "map/model/body.hpp"
#include "map/model/impact.hpp"
#include "map/model/section.hpp"
#include "map/numbers/turn.hpp"

#include <cmath>

namespace swirl {

template <class T>
struct TurnedImpact {
    PostImpactState<T> after;
    Impulse<T> impulse;  ///< of the facet, in its own axes; where the circle followed, of the circle; 0: it was touched
    T jacobi_restitution{}, jacobi_friction{};
    bool struck_twice = false;
};

namespace detail {

/// One impact in the axes turned by η. `disk`: r is along n′.
template <ImpactRule rule, class T>
void strike_turned(const Body<T>& body, const T& mu, const T& restitution, const T& eta, TurnedImpact<T>& impact) {
    using std::cos;
    using std::sin;
    const Vec2<T> turn{cos(eta), sin(eta)};
    const bool disk = body.sides == disk_sides;
    PostImpactState<T>& state = impact.after;
    const Vec2<T> velocity = times(conjugate(turn), Vec2<T>{state.vn, state.vt});
    PostImpactState<T> turned{times(state.psi, turn), disk ? state.chi : times(state.chi, conjugate(turn)), velocity.x,
                              velocity.y, state.spin};
    const ContactKinematics<T> before = contact_kinematics(body, turned);
    if (!(before.un > T(0))) return;  // it faces away; `impulse` would take the approach for one of rounding
    Impulse<T> j;
    if constexpr (rule == ImpactRule::frictionless)
        j = impulse<rule>(before, mu, restitution);
    else
        j = disk ? disk_impulse(before.un, before.ut, body.disk_grip, mu, restitution)
                 : impulse<rule>(before, mu, restitution);
    apply_impulse(before, j.normal, j.tangential, turned);
    const ContactKinematics<T> after = contact_kinematics(body, turned);
    const T half(0.5);
    // The swirling wall's velocity where it is touched, ẑ × the place of contact, in the turned axes.
    const T along_normal = disk ? T(body.inner * turn.y) : turn.y;
    const T along_wall = disk ? T(body.inner * turn.x + body.alpha) : turn.x;
    impact.jacobi_restitution = impact.jacobi_restitution - j.normal * (half * (before.un + after.un) - along_normal);
    impact.jacobi_friction = impact.jacobi_friction + j.tangential * (half * (before.ut + after.ut) - along_wall);
    impact.impulse = j;
    const Vec2<T> back = times(turn, Vec2<T>{turned.vn, turned.vt});
    state.vn = back.x;
    state.vt = back.y;
    state.spin = turned.spin;
}

}  // namespace detail

/// The state before the impact that led to `after` by an impulse of the circle itself.
template <class T>
PostImpactState<T> before_impact(const Body<T>& body, const PostImpactState<T>& after, const Impulse<T>& j) {
    PostImpactState<T> state = after;
    apply_impulse(contact_kinematics(body, after), T(-j.normal), T(-j.tangential), state);
    return state;
}

///   before  the state at the contact, before the impact, in the circle's axes
///   eta     η, in radians, |η| < π/2
template <ImpactRule rule, class T>
TurnedImpact<T> turned_impact(const Body<T>& body, const PostImpactState<T>& before, const T& mu, const T& restitution,
                              const T& eta) {
    TurnedImpact<T> impact;
    impact.after = before;
    detail::strike_turned<rule>(body, mu, restitution, eta, impact);
    if (!(contact_kinematics(body, impact.after).un > T(0))) return impact;
    impact.struck_twice = true;
    detail::strike_turned<rule>(body, mu, restitution, T(0), impact);
    return impact;
}

}  // namespace swirl
