// DF, exact, by hand: the flight's Jacobian at fixed time, the shift of the contact's time, the turn of the axes, the
// impact's differential. Derivation: map/README.md, "Derivative".
#pragma once

#include "map/derivative/linearised_collision.hpp"
#include "map/derivative/saltation_impact.hpp"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>

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
    const T per_square = T(1) / dot(y, y), per_rate = T(-1) / dot(y, rate);
    contact.normal = sqrt(per_square) * y;
    for (int i = 0; i < 5; ++i) {
        const Vec2<T>& change = partial[static_cast<std::size_t>(i)];
        contact.time[i] = per_rate * dot(y, change);
        contact.normal_turn[i] = per_square * cross(y, change + contact.time[i] * rate);
    }
    return contact;
}

/// The contact of vertex `vertex` (polygon) or of the disk's centre with its circle, after a flight of length τ.
template <Shape shape, class T>
ContactChange<T> contact_change_of(const Body<T>& body, const Flight<T>& flight, const T& time, int vertex) {
    const T zero(0);
    const Vec2<T> turn = cis_minus_one(time);  // E(τ) = cis τ − 1
    const Instant<T> at = instant_at<shape>(flight, time, turn);
    const Vec2<T> by_psi = quarter_turned(flight.beta * times(flight.phase, turn));  // i(w − w₀)
    const Vec2<T> by_vn{time, zero}, by_vt{zero, time};
    if constexpr (shape == Shape::disk) {
        return contact_change<T>(at.centre, at.drift, {by_psi, Vec2<T>{zero, zero}, by_vn, by_vt, Vec2<T>{zero, zero}});
    } else {
        const Vec2<T> arm = body.turned_to_vertex(at.arm, vertex);
        const Vec2<T> arm_moved = vertex == 0 ? at.arm_moved : arm - flight.arm;
        return contact_change<T>(at.centre + arm, at.drift + flight.spin * quarter_turned(arm),
                                 {by_psi, quarter_turned(arm_moved), by_vn, by_vt, time * quarter_turned(arm)});
    }
}

/// The flight's part of DF: from (ψ, χ, v_n, v_t, S) after one impact to the same before the next.
template <Shape shape, class T>
Matrix5<T> flight_derivative(const Flight<T>& flight, const ContactChange<T>& contact, const T& time) {
    const Vec2<T> velocity = seen_from(contact.normal, flight.velocity);
    Matrix5<T> d = Matrix5<T>::Zero();
    // ψ ← ψ + ν − τ
    d.row(0) = contact.normal_turn - contact.time;
    d(0, 0) += T(1);
    // χ ← χ + Sτ + 2πk/N − ν; the disk has none
    if constexpr (shape == Shape::polygon) {
        d.row(1) = flight.spin * contact.time - contact.normal_turn;
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

/// r_n of a vertex, or of a rounded corner's centre: what turns with the body.
template <bool rounded, class T>
T turning_arm(const Body<T>& body, const T& rn) {
    if constexpr (rounded)
        return rn - body.corner;
    else
        return rn;
}

/// u_n, u_t, B₁, B₂, B₃ and their differentials at a state before the impact.
///   rounded  of a body with rounded corners, in its units (Body::unit)
template <bool rounded, class T>
VariedKinematics<T> varied_kinematics(const Body<T>& body, const PostImpactState<T>& before) {
    ContactKinematics<T> k;
    if constexpr (rounded)
        k = rounded_kinematics(body, before);
    else
        k = contact_kinematics(body, before);
    const T &rn = k.rn, &rt = k.rt, &inverse_inertia = body.inverse_inertia;
    const T arm = turning_arm<rounded>(body, rn);
    VariedKinematics<T> a;
    a.un.value = approaching(k.un);
    if (a.un.value > T(0)) a.un.change << -body.beta * before.psi.x, -before.spin * arm, T(1), T(0), -rt;
    a.ut.value = k.ut;
    a.ut.change << body.beta * before.psi.y, -before.spin * rt, T(0), T(1), rn;
    a.b1.value = k.b1();
    a.b2.value = k.b2();
    a.b3.value = k.b3();
    a.b1.change[1] = T(-2) * rn * rt * inverse_inertia;  // dr = (−r_t, r_n) dχ, of a corner's centre
    a.b2.change[1] = T(2) * arm * rt * inverse_inertia;
    a.b3.change[1] = (rn * arm - rt * rt) * inverse_inertia;
    return a;
}

/// The impact on top of it: v_n ← v_n − p, v_t ← v_t + q, S ← S + (r_n q + r_t p)/I.
///   d       by the start's coordinates, of those before the impact; the disk's χ is zero and stays
///   before  the state before the impact
///   j       its impulse
template <ImpactRule rule, bool rounded = false, class T>
void add_impact(const Body<T>& body, const Scene<T>& scene, const PostImpactState<T>& before, const Impulse<T>& j,
                Matrix5<T>& d) {
    const VariedKinematics<T> at = varied_kinematics<rounded>(body, before);
    ImpulseChange<T> change = impulse_change<rule>(at, scene.mu, scene.restitution, j.mode);
    if (body.tangential_restitution != T(0) && ends_in_stick(j.mode))  // of the disk: q = −(1 + e_t)u_t/B₁
        change.tangential -= (body.tangential_restitution / at.b1.value) * at.ut.change;
    const Vec2<T> arm = body.alpha * before.chi;
    const Vec2<T> r = rounded ? Vec2<T>{arm.x + body.corner, arm.y} : arm;
    const Differential<T> normal = change.normal * d, tangential = change.tangential * d;
    d.row(2) -= normal;
    d.row(3) += tangential;
    d.row(4) +=
        (r.x * tangential + r.y * normal + (arm.x * j.normal - arm.y * j.tangential) * d.row(1)) * body.inverse_inertia;
}

/// The state before an impact at `normal`: its position, and the velocities that the flight came with.
template <class T>
PostImpactState<T> before_impact(const Flight<T>& flight, const Vec2<T>& normal, const PostImpactState<T>& after) {
    const Vec2<T> velocity = seen_from(normal, flight.velocity);
    return {after.psi, after.chi, velocity.x, velocity.y, flight.spin};
}

/// A 5 × 5 derivative in the coordinates of a shape: the disk has no χ.
template <Shape shape, class T>
auto in_coordinates(const Matrix5<T>& d) {
    if constexpr (shape == Shape::polygon) {
        return d;
    } else {
        constexpr int kept[] = {0, 2, 3, 4};  // all but χ
        Eigen::Matrix<T, 4, 4> without_chi;
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) without_chi(i, k) = d(kept[i], kept[k]);
        return without_chi;
    }
}

}  // namespace detail

/// DF(z) by the saltation form, where the next collision is known already: 4 × 4 for the disk, 5 × 5 for polygons.
///   map    the collision map
///   start  z, just after an impact
///   known  the collision that `map` finds from there
/// Cost: a third of a collision. Source: map/README.md; for the method P. C. Müller, Chaos, Solitons & Fractals 5
/// (1995) 1671.
template <class T, Shape shape, ImpactRule rule>
auto derivative_by_saltation(const CollisionMap<T, shape, rule>& map, const PostImpactState<T>& start,
                             const Collision<T>& known) {
    const Body<T>& body = map.body();
    const Flight<T> flight = flight_from(body, start);
    const auto contact = detail::contact_change_of<shape>(body, flight, known.flight_time, known.vertex_step);
    detail::Matrix5<T> d = detail::flight_derivative<shape>(flight, contact, known.flight_time);
    const PostImpactState<T> before = detail::before_impact(flight, known.normal, known.after);
    detail::add_impact<rule>(body, map.scene(), before, known.impulse, d);
    return detail::in_coordinates<shape>(d);
}

/// What an orbit keeps of a collision.
struct KeptFlight {
    double flight_time = 0;
    int vertex_step = 0;
    ContactMode mode = ContactMode::frictionless;
    const PostImpactState<double>& after;
};

/// DF(z) of a collision of which no more is kept, without a search: the impulse is the change of the velocities, to
/// rounding, so that DF is the one above to some ε (1 + |v|)/u_n of its size.
template <Shape shape, ImpactRule rule>
auto derivative_by_saltation(const CollisionMap<double, shape, rule>& map, const PostImpactState<double>& start,
                             const KeptFlight& kept) {
    const Body<double>& body = map.body();
    const Flight<double> flight = flight_from(body, start);
    const auto contact = detail::contact_change_of<shape>(body, flight, kept.flight_time, kept.vertex_step);
    detail::Matrix5<double> d = detail::flight_derivative<shape>(flight, contact, kept.flight_time);
    const PostImpactState<double> before = detail::before_impact(flight, contact.normal, kept.after);
    const Impulse<double> impulse{before.vn - kept.after.vn, kept.after.vt - before.vt, kept.mode};
    detail::add_impact<rule>(body, map.scene(), before, impulse, d);
    return detail::in_coordinates<shape>(d);
}

/// F(z) and DF(z); `derivative` is meaningless unless a contact was found.
template <class T, Shape shape, ImpactRule rule>
LinearisedCollision<T, shape> linearise_by_saltation(const CollisionMap<T, shape, rule>& map,
                                                     const SectionPoint<T>& z) {
    SectionPoint<T> start = z;
    if constexpr (shape == Shape::disk) start.chi = T(0);
    const PostImpactState<T> post_impact = post_impact_state(start);
    LinearisedCollision<T, shape> result;
    result.collision = map.advance(post_impact);
    if (result.collision.outcome == FirstContactOutcome::contact)
        result.derivative = derivative_by_saltation(map, post_impact, result.collision);
    return result;
}

}  // namespace swirl
