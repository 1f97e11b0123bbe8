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

/// How velocities change by the impulse −n + ratio t at z's own vertex: of z at rest on a wall at rest, so that no
/// speed is so large that the change is lost beside it.
template <class T>
PostImpactState<T> struck_at_rest(const ContactScene<T>& at_rest, PostImpactState<T> z, const T& ratio) {
    z.vn = z.vt = z.spin = T(0);
    const ContactKinematics<T> u = contact_kinematics(at_rest.body, z);
    z.vn = T(-1);
    z.vt = ratio;
    z.spin = (u.rn * ratio + u.rt) / u.inertia;
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
    ContactScene<T> at_rest = scene;
    at_rest.body.beta = T(0);
    const PostImpactState<T> other = struck_at_rest(at_rest, seen_from_neighbour(scene, z), ratio);
    const EdgeVelocities<T> before = edge_velocities(scene, z);
    const EdgeVelocities<T> a = edge_velocities(at_rest, struck_at_rest(at_rest, z, ratio));
    const EdgeVelocities<T> b = edge_velocities(at_rest, seen_from_neighbour(scene, other));
    const T determinant = a.here * b.there - a.there * b.here;
    if (!(plain(determinant) > 0)) return {};
    const T p = (b.here * before.there - b.there * before.here) / determinant;
    const T q = (a.there * before.here - a.here * before.there) / determinant;
    return T(before.spin + p * a.spin + q * b.spin);
}

/// S = ν′ with which an edge lands: chatter and rocking of the two vertices leave what contact does not, with −sμ of it
/// along the wall, s the sense in which the edge then slides: the one in which it did, or the other if friction does
/// not let that be; 0 where it lets neither. Without friction where the slip would jam; u_t of z's vertex where
/// rounding leaves no positive determinant without it either.
///   z  on either vertex, |χ| = χ_m
template <class T>
T edge_rate(const ContactScene<T>& scene, const PostImpactState<T>& z) {
    const T ut = contact_kinematics(scene.body, z).ut;
    const bool forward = plain(ut) > 0;
    for (const bool sense : {forward, !forward}) {
        const std::optional<T> rate = edge_rate_with(scene, z, sense ? T(-scene.mu) : scene.mu);
        if (!rate || scene.mu == T(0)) return edge_rate_with(scene, z, T(0)).value_or(ut);
        if (sense == (plain(*rate) > 0)) return *rate;
    }
    return T(0);
}

}  // namespace swirl
