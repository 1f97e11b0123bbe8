// The slip in which an edge lands.
#pragma once

#include "map/sustained/contact_state.hpp"

namespace swirl {

/// Velocities of an edge as two impulses change them: of either vertex towards the wall, and S.
template <class T>
struct EdgeVelocities {
    T here, there, spin;
};

template <class T>
EdgeVelocities<T> edge_velocities(const ContactScene<T>& scene, const PostImpactState<T>& z) {
    return {contact_kinematics(scene.body, z).un, contact_kinematics(scene.body, seen_from_neighbour(scene, z)).un,
            z.spin};
}

/// z after the impulse −n + ratio t at its own vertex.
template <class T>
PostImpactState<T> after_unit_impulse(const ContactScene<T>& scene, PostImpactState<T> z, const T& ratio) {
    const ContactKinematics<T> u = contact_kinematics(scene.body, z);
    z.vn -= T(1);
    z.vt += ratio;
    z.spin += (u.rn * ratio + u.rt) / u.inertia;
    return z;
}

/// S = ν′ with which an edge lands while it slides: chatter and rocking of the two vertices leave what contact does
/// not, as much of either's normal impulse as removes both u_n, with −sμ of it along the wall. By p₁ and p₂ with
///
///     u_n,1 + p₁ ∂u_n,1/∂p₁ + p₂ ∂u_n,1/∂p₂ = 0 = u_n,2 + p₁ ∂u_n,2/∂p₁ + p₂ ∂u_n,2/∂p₂.
///
/// Without friction where their determinant is not positive: the slip would jam.
///   z  on either vertex, |χ| = χ_m
template <class T>
T edge_rate(const ContactScene<T>& scene, const PostImpactState<T>& z, bool with_friction = true) {
    const T ut = contact_kinematics(scene.body, z).ut;
    const T ratio = !with_friction ? T(0) : plain(ut) > 0 ? T(-scene.mu) : scene.mu;
    const EdgeVelocities<T> before = edge_velocities(scene, z);
    const EdgeVelocities<T> a = edge_velocities(scene, after_unit_impulse(scene, z, ratio));
    const PostImpactState<T> struck = after_unit_impulse(scene, seen_from_neighbour(scene, z), ratio);
    const EdgeVelocities<T> b = edge_velocities(scene, seen_from_neighbour(scene, struck));
    const T a1 = a.here - before.here, a2 = a.there - before.there;
    const T b1 = b.here - before.here, b2 = b.there - before.there;
    const T determinant = a1 * b2 - a2 * b1;
    if (with_friction && !(plain(determinant) > 0)) return edge_rate(scene, z, false);
    const T p = (b1 * before.there - b2 * before.here) / determinant;
    const T q = (a2 * before.here - a1 * before.there) / determinant;
    return before.spin + p * (a.spin - before.spin) + q * (b.spin - before.spin);
}

}  // namespace swirl
