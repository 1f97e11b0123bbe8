// Chatter that sticks moves the body along the wall, which contact that sticks does not.
//
// Each flight begins with u_t = 0 and lasts τ = 2v/a: the point that touches comes down ½ a_t τ² farther, a and a_t the
// free accelerations towards the wall and along it. The next impact stops it and sends it back at e′v, where e′, which
// with friction need not be e, is that of an impact at u_t/u_n = 2a_t/a, the same for all of them. In all
//
//     d = 2 a_t (v/a)²/(1 − e′²)                                                                         (order T²).
//
// (By e′ chatter lasts 2v/(a(1 − e′)): where e′ is close to 1 or beyond the sum does not hold.) With A and B the
// differences in ∫p dt and ∫q dt between chatter and contact, B₂A + B₃B = 0 (both end at the wall) and B₃A + B₁B = d.
// So a polygon has turned by (r_n B + r_t A)/I = d r_n/(I + α²), and a disk's centre has run d/B₁ along the wall. About
// the place of contact both motions have the same angular momentum up to T³: of a polygon, with u = 0 at either end,
// that is (I + α²)S, less d S r_t for the vertex that has moved by d; a rolling disk's S goes with its ν′.
#pragma once

#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/impulse_by_law.hpp"

#include <cmath>

namespace swirl {

/// Chatter may last so many times what it would by e for its sum to hold.
inline constexpr int most_longer = 64;

/// Moves a landing by what the rest of chatter that sticks does.
///   post_impact   the impact before: it stopped the slip
///   acceleration  a > 0
///   state         in contact, u_n removed
/// No move where v is rounding, where friction does not stop the slip of each impact, and where e′ ≥ 1 or is so close
/// to 1 that 1 − e > `most_longer` (1 − e′).
template <class T>
void move_along_wall(const ContactScene<T>& scene, const PostImpactState<T>& post_impact, const T& acceleration,
                     ContactState<T>& state) {
    using std::abs, std::sin;
    const Body<T>& body = scene.body;
    ContactKinematics<T> u = contact_kinematics(body, post_impact);
    const T along = -body.beta * sin(state.psi) - (scene.is_disk() ? T(0) : T(state.spin * state.spin * u.rt));
    const T v = -u.un;
    const T flight = v / acceleration;  // half of the first one's duration
    if (!(plain(v) > plain(velocity_rounding(scene, post_impact)))) return;
    u.un = T(1);
    u.ut = T(2) * along / acceleration;
    const Impulse<T> next = impulse_by_law(scene, u, scene.restitution);
    const bool stops = next.mode == ContactMode::c_sticking || next.mode == ContactMode::r_sticking;
    const T rebound = u.b2() * next.normal + u.b3() * next.tangential - T(1);  // e′
    const bool accumulates = plain(T(T(1) - scene.restitution)) <= most_longer * plain(T(T(1) - rebound));
    if (!(stops && accumulates)) return;
    const T d = T(2) * along * flight * flight / (T(1) - rebound * rebound);
    if (scene.is_disk()) {
        state.psi += d / (body.inner * u.b1());
        return;
    }
    const T about_vertex = body.inertia + body.alpha * body.alpha;
    state.psi += d;
    state.chi += d * u.rn / about_vertex - d;
    state.spin += d * state.spin * u.rt / about_vertex;
}

}  // namespace swirl
