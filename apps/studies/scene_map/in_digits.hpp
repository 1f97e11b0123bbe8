// States, flights and impacts in other number types: from double into more digits, and rounded back.
#pragma once

#include "apps/studies/scene_map/accuracy.hpp"
#include "map/numbers/quad.hpp"
#include "map/orbit/return_map.hpp"

#include <type_traits>
#include <utility>

namespace swirl::studies {

/// Calls `use` with a zero of the number type in which an orbit of that accuracy is followed: the one place where it
/// is chosen for orbits that keep all digits from step to step.
template <class Use>
auto with_number_of(Accuracy accuracy, Use&& use) {
    if (accuracy == Accuracy::extended) return use(0.0L);
    if (accuracy == Accuracy::quad) return use(Quad(0));
    return use(0.0);
}

template <class To, class From>
Vec2<To> vector_in(const Vec2<From>& v) {
    return {static_cast<To>(v.x), static_cast<To>(v.y)};
}

/// A state's numbers in another type, rounded where it has fewer digits.
template <class To, class From>
PostImpactState<To> state_in(const PostImpactState<From>& z) {
    return {vector_in<To>(z.psi), vector_in<To>(z.chi), static_cast<To>(z.vn), static_cast<To>(z.vt),
            static_cast<To>(z.spin)};
}

template <class T>
Flight<T> flight_in(const Flight<double>& f) {
    return {vector_in<T>(f.centre),
            vector_in<T>(f.velocity),
            vector_in<T>(f.phase),
            vector_in<T>(f.arm),
            T(f.spin),
            T(f.beta),
            f.struck};
}

template <class T>
Collision<double> rounded_from(const Collision<T>& c) {
    const auto d = [](const T& x) { return static_cast<double>(x); };
    return {c.outcome,
            state_in<double>(c.after),
            d(c.flight_time),
            vector_in<double>(c.normal),
            c.vertex_step,
            {d(c.impulse.normal), d(c.impulse.tangential), c.impulse.mode},
            d(c.jacobi_restitution),
            d(c.jacobi_friction),
            c.simultaneous,
            c.steps};
}

template <class T>
ReturnStep<double> rounded_from(ReturnStep<T> step) {
    return {step.outcome, rounded_from(step.collision), static_cast<double>(step.turned),
            static_cast<double>(step.contact_work), std::move(step.contacts)};
}

/// Double's directions have length 1 to its own rounding, and an impact without restitution leaves at u_n = 0 to that:
/// in more digits neither would be a state of the section.
template <class T>
PostImpactState<T> begin_in(const Body<T>& body, const PostImpactState<double>& state) {
    PostImpactState<T> z = state_in<T>(state);
    if constexpr (std::is_same_v<T, double>) return z;
    z.psi = renormalised(z.psi);
    z.chi = renormalised(z.chi);
    const T un = kinematics_of(body, z).un;
    if (un > T(0)) z.vn = z.vn - un;
    return z;
}

}  // namespace swirl::studies
