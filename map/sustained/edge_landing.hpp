// The slip in which an edge lands.
#pragma once

#include "map/sustained/contact_state.hpp"

#include <optional>

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

/// S = ν′ once as much of either vertex' normal impulse as removes both u_n has acted, with `ratio` of it along the
/// wall, by p₁ and p₂ with
///
///     u_n,1 + p₁ ∂u_n,1/∂p₁ + p₂ ∂u_n,1/∂p₂ = 0 = u_n,2 + p₁ ∂u_n,2/∂p₁ + p₂ ∂u_n,2/∂p₂;
///
/// nothing where their determinant is not positive: the slip would jam.
template <class T>
std::optional<T> edge_rate_with(const ContactScene<T>& scene, const PostImpactState<T>& z, const T& ratio) {
    const EdgeVelocities<T> before = edge_velocities(scene, z);
    const EdgeVelocities<T> a = edge_velocities(scene, after_unit_impulse(scene, z, ratio));
    const PostImpactState<T> struck = after_unit_impulse(scene, seen_from_neighbour(scene, z), ratio);
    const EdgeVelocities<T> b = edge_velocities(scene, seen_from_neighbour(scene, struck));
    const T a1 = a.here - before.here, a2 = a.there - before.there;
    const T b1 = b.here - before.here, b2 = b.there - before.there;
    const T determinant = a1 * b2 - a2 * b1;
    if (!(plain(determinant) > 0)) return {};
    const T p = (b1 * before.there - b2 * before.here) / determinant;
    const T q = (a2 * before.here - a1 * before.there) / determinant;
    return T(before.spin + p * (a.spin - before.spin) + q * (b.spin - before.spin));
}

/// S = ν′ with which an edge lands: chatter and rocking of the two vertices leave what contact does not, with −sμ of it
/// along the wall, s the sense in which the edge then slides: the one in which it did, or the other if friction does
/// not let that be; 0 where it lets neither. Without friction where the slip would jam.
///   z  on either vertex, |χ| = χ_m
template <class T>
T edge_rate(const ContactScene<T>& scene, const PostImpactState<T>& z) {
    const bool forward = plain(contact_kinematics(scene.body, z).ut) > 0;
    for (const bool sense : {forward, !forward}) {
        const std::optional<T> rate = edge_rate_with(scene, z, sense ? T(-scene.mu) : scene.mu);
        if (!rate || scene.mu == T(0)) return *edge_rate_with(scene, z, T(0));
        if (sense == (plain(*rate) > 0)) return *rate;
    }
    return T(0);
}

}  // namespace swirl
