// DF, exact, by hand: the flight's Jacobian at fixed time, the shift of the contact's time, the turn of the axes, the
// impact's differential. It shares neither arithmetic nor formulas with the Jets of derivative.hpp and so checks them.
// Derivation: map/README.md, "Derivative".
#pragma once

#include "map/derivative/linearised_collision.hpp"
#include "map/derivative/saltation_impact.hpp"

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace swirl {

namespace detail {

template <class T>
using Matrix5 = Eigen::Matrix<T, 5, 5>;

/// The contact in the axes of the start, and by how much it moves.
template <class T>
struct ContactChange {
    Vec2<T> normal;               ///< n, the contact's direction
    Differential<T> time;         ///< dτ
    Differential<T> normal_turn;  ///< dν, ν = arg n
};

/// From the partial derivatives ∂y (fixed time) of the point y that must reach a circle, and its velocity y′:
/// dτ = −(y·∂y)/(y·y′), then dν = y × (∂y + y′ dτ)/|y|².
template <class T>
ContactChange<T> contact_change(const Vec2<T>& y, const Vec2<T>& rate, const std::array<Vec2<T>, 5>& partial) {
    using std::sqrt;
    ContactChange<T> contact;
    const T square = dot(y, y);
    contact.normal = (T(1) / sqrt(square)) * y;
    for (int i = 0; i < 5; ++i) {
        const T shift = -dot(y, partial[i]) / dot(y, rate);
        contact.time[i] = shift;
        contact.normal_turn[i] = cross(y, partial[i] + shift * rate) / square;
    }
    return contact;
}

/// The contact of vertex `vertex` (polygon) or of the disk's centre with its circle, after a flight of length τ.
template <class T, Shape shape>
ContactChange<T> contact_change_of(const Body<T>& body, const SectionPoint<T>& z, const T& time, int vertex) {
    using std::sin;
    const T zero(0);
    const Vec2<T> swirl = body.beta * cis(T(-z.psi));                                 // w₀
    const Vec2<T> turn = T(2) * sin(T(time / 2)) * quarter_turned(cis(T(time / 2)));  // E(τ) = cis τ − 1
    const Vec2<T> swirl_moved = times(swirl, turn);                                   // w − w₀
    const Vec2<T> start_arm = body.alpha * cis(z.chi);
    const Vec2<T> velocity{z.vn, z.vt};
    const Vec2<T> centre = Vec2<T>{T(1), zero} - start_arm + time * velocity - swirl_moved;
    const Vec2<T> drift = velocity - quarter_turned(swirl + swirl_moved);
    const Vec2<T> by_psi = quarter_turned(swirl_moved);
    const Vec2<T> by_vn{time, zero}, by_vt{zero, time};
    if constexpr (shape == Shape::disk) {
        return contact_change<T>(centre, drift, {by_psi, Vec2<T>{zero, zero}, by_vn, by_vt, Vec2<T>{zero, zero}});
    } else {
        const Vec2<T> arm = times(body.alpha * cis(T(z.chi + z.spin * time)), body.direction_by_formula(vertex));
        const Vec2<T> by_chi = quarter_turned(arm - start_arm);
        return contact_change<T>(centre + arm, drift + z.spin * quarter_turned(arm),
                                 {by_psi, by_chi, by_vn, by_vt, time * quarter_turned(arm)});
    }
}

/// The flight's part of DF: from (ψ, χ, v_n, v_t, S) after one impact to the same before the next.
template <class T, Shape shape>
Matrix5<T> flight_derivative(const Body<T>& body, const SectionPoint<T>& z, const T& time, int vertex) {
    const ContactChange<T> contact = contact_change_of<T, shape>(body, z, time, vertex);
    const Vec2<T> velocity = seen_from(contact.normal, Vec2<T>{z.vn, z.vt});
    Matrix5<T> d = Matrix5<T>::Zero();
    // ψ ← ψ + ν − τ
    d.row(0) = contact.normal_turn - contact.time;
    d(0, 0) += T(1);
    // χ ← χ + Sτ + 2πk/N − ν; the disk has none
    if constexpr (shape == Shape::polygon) {
        d.row(1) = z.spin * contact.time - contact.normal_turn;
        d(1, 1) += T(1);
        d(1, 4) += time;
    }
    // v ← cis(−ν) v
    d.row(2) = velocity.y * contact.normal_turn;
    d(2, 2) += contact.normal.x;
    d(2, 3) += contact.normal.y;
    d.row(3) = -velocity.x * contact.normal_turn;
    d(3, 2) -= contact.normal.y;
    d(3, 3) += contact.normal.x;
    d(4, 4) = T(1);
    return d;
}

/// u_n, u_t, B₁, B₂, B₃ and their differentials at a state before the impact.
template <class T>
VariedKinematics<T> varied_kinematics(const Body<T>& body, const SectionPoint<T>& before) {
    const Vec2<T> psi = cis(before.psi);
    const Vec2<T> r = body.alpha * cis(before.chi);
    const T& inertia = body.inertia;
    VariedKinematics<T> a;
    a.un.value = before.vn - before.spin * r.y - body.beta * psi.y;
    a.un.change << -body.beta * psi.x, -before.spin * r.x, T(1), T(0), -r.y;
    a.ut.value = before.vt + before.spin * r.x - body.beta * psi.x;
    a.ut.change << body.beta * psi.y, -before.spin * r.y, T(0), T(1), r.x;
    a.b1.value = T(1) + r.x * r.x / inertia;
    a.b2.value = T(1) + r.y * r.y / inertia;
    a.b3.value = r.x * r.y / inertia;
    a.b1.change[1] = T(-2) * r.x * r.y / inertia;  // dr = (−r_t, r_n) dχ
    a.b2.change[1] = T(2) * r.x * r.y / inertia;
    a.b3.change[1] = (r.x * r.x - r.y * r.y) / inertia;
    return a;
}

/// The impact's part of DF: v_n ← v_n − p, v_t ← v_t + q, S ← S + (r_n q + r_t p)/I. The disk's χ is zero and stays.
template <class T, ImpactRule rule>
Matrix5<T> impact_derivative(const Body<T>& body, const Scene<T>& scene, const SectionPoint<T>& before,
                             const Impulse<T>& j) {
    const ImpulseChange<T> change =
        impulse_change<rule>(varied_kinematics(body, before), scene.mu, scene.restitution, j.mode);
    const Vec2<T> r = body.alpha * cis(before.chi);
    Matrix5<T> d = Matrix5<T>::Identity();
    d.row(2) -= change.normal;
    d.row(3) += change.tangential;
    d.row(4) += (r.x * change.tangential + r.y * change.normal) / body.inertia;
    d(4, 1) += (r.x * j.normal - r.y * j.tangential) / body.inertia;
    return d;
}

/// The state before the impact, from the one after: the impulse taken back.
template <class T>
SectionPoint<T> before_impact(const Body<T>& body, const Collision<T>& collision) {
    SectionPoint<T> z = section_point(collision.after);
    const Impulse<T>& j = collision.impulse;
    const Vec2<T> r = body.alpha * collision.after.chi;
    z.vn += j.normal;
    z.vt -= j.tangential;
    z.spin -= (r.x * j.tangential + r.y * j.normal) / body.inertia;
    return z;
}

}  // namespace detail

/// F(z) and DF(z) by the saltation form.
///   map  the collision map
///   z    a point of its section (the disk's χ is not read)
/// `derivative` (4 × 4 for the disk, 5 × 5 for polygons) is meaningless unless a contact was found. Cost: one collision
/// and two 5 × 5 matrices. Source: map/README.md; for the method P. C. Müller, Chaos, Solitons & Fractals 5 (1995)
/// 1671.
template <class T, Shape shape, ImpactRule rule>
LinearisedCollision<T, shape> linearise_by_saltation(const CollisionMap<T, shape, rule>& map,
                                                     const SectionPoint<T>& z) {
    LinearisedCollision<T, shape> result;
    SectionPoint<T> start = z;
    if constexpr (shape == Shape::disk) start.chi = T(0);
    result.collision = map.advance(post_impact_state(start));
    const Collision<T>& collision = result.collision;
    if (collision.outcome != FirstContactOutcome::contact) return result;
    const SectionPoint<T> before = detail::before_impact(map.body(), collision);
    const detail::Matrix5<T> flight =
        detail::flight_derivative<T, shape>(map.body(), start, collision.flight_time, collision.vertex_step);
    const detail::Matrix5<T> impact =
        detail::impact_derivative<T, rule>(map.body(), map.scene(), before, collision.impulse);
    const detail::Matrix5<T> product = impact * flight;
    if constexpr (shape == Shape::disk) {
        constexpr int kept[] = {0, 2, 3, 4};  // all but χ
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) result.derivative(i, j) = product(kept[i], kept[j]);
    } else {
        result.derivative = product;
    }
    return result;
}

}  // namespace swirl
