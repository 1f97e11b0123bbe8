// DF over a floor that drags, by hand (the saltation form), and ∂F along a number of the scene by Jets.
// map/dragged/README.md, "Derivative".
#pragma once

#include "map/derivative/parameter.hpp"
#include "map/derivative/saltation.hpp"
#include "map/dragged/dragged_map.hpp"
#include "map/numbers/jets.hpp"

#include <array>
#include <cmath>

namespace swirl {

/// D of Jets: by γ, where it is small, D has the difference of two numbers that are nearly equal; there the series
/// D = τ Σ (−γτ)ᵏ/(k + 1)! is differentiated.
template <class U, int n>
ceres::Jet<U, n> decayed_time(const ceres::Jet<U, n>& rate, const ceres::Jet<U, n>& time) {
    using J = ceres::Jet<U, n>;
    const J x = rate * time;
    if (!(plain(x) < Plain<J>(1))) return (J(U(1)) - exp(-x)) / rate;
    J sum(U(0));
    for (int k = 24; k > 0; --k) sum = J(U(1)) - x * sum / U(k + 1);  // 1/25! is below ε of double
    return time * sum;
}

namespace detail {

template <class J>
void decay_in_jets(const FloorDrag<J>& floor, const J& time, DraggedInstant<J>& moment) {
    moment.length = decayed_time(floor.drag, time);
    moment.spin_length = decayed_time(floor.spin_drag, time);
    moment.decay = exp(-(floor.drag * time));
    moment.spin_decay = exp(-(floor.spin_drag * time));
}

/// The contact of vertex `vertex` (polygon) or of the disk's centre with its circle, as without drag. With ∂w₀/∂ψ =
/// −i w₀ in X₀ + U D − h w₀ E and U = V − γh w₀,
///     ∂ψ: i(γh D + h E) w₀     ∂χ: i(a − a₀)     ∂v_n, ∂v_t: D, i D     ∂S: i D_r a.
template <Shape shape, class T>
ContactChange<T> contact_change_of(const Body<T>& body, const DraggedFlight<T>& flight, const DraggedInstant<T>& moment,
                                   int vertex) {
    const T zero(0);
    const T& length = moment.length;
    const Vec2<T> swirl = flight.start.beta * flight.start.phase;
    const Vec2<T> by_psi =
        quarter_turned(Vec2<T>(length * times(flight.floor.carrying, swirl) + (moment.ridden - flight.ridden)));
    const Vec2<T> by_vn{length, zero}, by_vt{zero, length};
    if constexpr (shape == Shape::disk) {
        return contact_change<T>(moment.at.centre, moment.at.drift,
                                 {by_psi, Vec2<T>{zero, zero}, by_vn, by_vt, Vec2<T>{zero, zero}});
    } else {
        const Vec2<T> arm = body.turned_to_vertex(moment.at.arm, vertex);
        const Vec2<T> arm_moved = vertex == 0 ? moment.at.arm_moved : arm - flight.start.arm;
        const Vec2<T> across = quarter_turned(arm);
        return contact_change<T>(moment.at.centre + arm, moment.at.drift + moment.spin * across,
                                 {by_psi, quarter_turned(arm_moved), by_vn, by_vt, moment.spin_length * across});
    }
}

/// The flight's part of DF: from (ψ, χ, v_n, v_t, S) after one impact to the same before the next.
template <Shape shape, class T>
Matrix5<T> flight_derivative(const DraggedFlight<T>& flight, const DraggedInstant<T>& moment,
                             const ContactChange<T>& contact) {
    const FloorDrag<T>& floor = flight.floor;
    const Vec2<T>& n = contact.normal;
    const Vec2<T> velocity = laboratory_velocity(flight, moment);
    const Vec2<T> ends_with = seen_from(n, velocity);
    // V = U e^{−γτ} + γh w: ∂V/∂ψ = i γh (w₀ e^{−γτ} − w), V′ = −γ U e^{−γτ} + i γh w
    const Vec2<T> swirl = flight.start.beta * flight.start.phase;
    const Vec2<T> by_psi =
        seen_from(n, quarter_turned(times(floor.carrying, Vec2<T>(moment.decay * swirl - moment.at.swirl))));
    const Vec2<T> by_time =
        seen_from(n, Vec2<T>(quarter_turned(times(floor.carrying, moment.at.swirl)) - floor.drag * moment.stream));
    const T spin = moment.spin_decay * flight.start.spin;
    Matrix5<T> d = Matrix5<T>::Zero();
    d.row(0) = contact.normal_turn - contact.time;  // ψ ← ψ + ν − τ
    d(0, 0) += T(1);
    if constexpr (shape == Shape::polygon) {  // χ ← χ + S D_r + 2πk/N − ν
        d.row(1) = spin * contact.time - contact.normal_turn;
        d(1, 1) += T(1);
        d(1, 4) += moment.spin_length;
    }
    d.row(2) = ends_with.y * contact.normal_turn + by_time.x * contact.time;  // v ← cis(−ν) V(τ)
    d(2, 0) += by_psi.x;
    d(2, 2) += moment.decay * n.x;
    d(2, 3) += moment.decay * n.y;
    d.row(3) = -ends_with.x * contact.normal_turn + by_time.y * contact.time;
    d(3, 0) += by_psi.y;
    d(3, 2) -= moment.decay * n.y;
    d(3, 3) += moment.decay * n.x;
    d.row(4) = (-floor.spin_drag * spin) * contact.time;  // S ← S e^{−γ_r τ}
    d(4, 4) += moment.spin_decay;
    return d;
}

/// DF from the flight, its contact and the impulse there; `impulse` takes the state before it.
template <class T, Shape shape, ImpactRule rule, class ImpulseOf>
auto derivative_over_floor(const DraggedMap<T, shape, rule>& map, const PostImpactState<T>& start, const T& time,
                           int vertex, const PostImpactState<T>& after, const ImpulseOf& impulse) {
    const DraggedFlight<T> flight = dragged_flight(map.floor(), flight_from(map.body(), start));
    const DraggedInstant<T> moment = dragged_instant<shape>(flight, time);
    const ContactChange<T> contact = contact_change_of<shape>(map.body(), flight, moment, vertex);
    Matrix5<T> d = flight_derivative<shape>(flight, moment, contact);
    const PostImpactState<T> before = before_impact(arriving(flight, moment), contact.normal, after);
    add_impact<rule>(map.body(), map.scene(), before, impulse(before), d);
    return in_coordinates<shape>(d);
}

}  // namespace detail

/// DF(z) where the next collision is known, as `derivative_by_saltation` without drag. Cost: a third of a collision.
template <class T, Shape shape, ImpactRule rule>
auto derivative_by_saltation(const DraggedMap<T, shape, rule>& map, const PostImpactState<T>& start,
                             const Collision<T>& known) {
    return detail::derivative_over_floor(map, start, known.flight_time, known.vertex_step, known.after,
                                         [&](const PostImpactState<T>&) { return known.impulse; });
}

/// DF(z) where no more is kept: the impulse is the change of the velocities.
template <Shape shape, ImpactRule rule>
auto derivative_by_saltation(const DraggedMap<double, shape, rule>& map, const PostImpactState<double>& start,
                             const KeptFlight& kept) {
    return detail::derivative_over_floor(
        map, start, kept.flight_time, kept.vertex_step, kept.after, [&](const PostImpactState<double>& before) {
            return Impulse<double>{before.vn - kept.after.vn, kept.after.vt - before.vt, kept.mode};
        });
}

namespace detail {

/// dτ = −dg/g′ of the contact at a moment known in plain numbers (map/derivative/strike_along.hpp). A disk's centre has
/// to reach |X| = 1 − α, which may change, too; a vertex |x| = 1.
///   arm  of the vertex that touches
template <Shape shape, class J>
J contact_shift(const Body<J>& body, const Instant<J>& at, const J& spin, const Vec2<J>& arm) {
    Vec2<J> x = at.centre, rate = at.drift;
    J reach = body.inner;
    if constexpr (shape == Shape::polygon) {
        x = x + arm;
        rate = rate + spin * quarter_turned(arm);
        reach = J(Plain<J>(1));
    }
    J shift = J(Plain<J>(-1) / (2 * plain(dot(x, rate)))) * (dot(x, x) - reach * reach);
    shift.a = Plain<J>(0);
    return shift;
}

/// The arm of the vertex, of a disk that of the rim's point on the wall.
template <Shape shape, class J>
Vec2<J> arm_of_contact(const Body<J>& body, const Instant<J>& at, int vertex) {
    if constexpr (shape == Shape::disk) {
        using std::sqrt;
        return (body.alpha / sqrt(dot(at.centre, at.centre))) * at.centre;
    } else {
        return body.turned_to_vertex(at.arm, vertex);
    }
}

}  // namespace detail

/// A collision that is known, once more in Jets (map/derivative/strike_along.hpp): `flight` carries the derivatives.
template <class J, Shape shape, ImpactRule rule>
Collision<J> strike_along(const DraggedMap<J, shape, rule>& map, const DraggedFlight<J>& flight, const Plain<J>& time,
                          int vertex) {
    const auto moment_at_time = [&](const J& at) {
        DraggedInstant<J> moment;
        moment.at.time = at;
        detail::decay_in_jets(flight.floor, at, moment);
        complete<shape>(flight, cis_minus_one(at), moment);
        return moment;
    };
    const auto arm_at = [&](const DraggedInstant<J>& moment) {
        return detail::arm_of_contact<shape>(map.body(), moment.at, vertex);
    };
    const DraggedInstant<J> nominal = moment_at_time(J(time));
    const J shift = detail::contact_shift<shape>(map.body(), nominal.at, nominal.spin, arm_at(nominal));
    const DraggedInstant<J> moment = moment_at_time(J(time) + shift);
    Collision<J> collision;
    map.strike(flight, moment, arm_at(moment), 0, collision);
    return collision;
}

/// ∂F/∂λ at a fixed state where the next collision is known, λ a parameter of the scene. By Jets of one dimension.
template <class T, Shape shape, ImpactRule rule>
auto derivative_along(const DraggedMap<T, shape, rule>& map, Parameter parameter, const PostImpactState<T>& post_impact,
                      const Collision<T>& known) {
    return detail::along_in_jets(map, parameter, post_impact, known, [](const auto& jets, const auto& state) {
        return dragged_flight(jets.floor(), flight_from(jets.body(), state));
    });
}

}  // namespace swirl
