// A collision with its derivative, and the order of the section's coordinates in vectors and matrices.
#pragma once

#include "map/collision_map.hpp"

#include <Eigen/Core>

#include <array>

namespace swirl {

/// Dimension of the section: the disk drops χ.
template <Shape shape>
inline constexpr int section_dimension = shape == Shape::disk ? 4 : 5;

/// Coordinates in the order (ψ, χ, v_n, v_t, S); the disk's (ψ, v_n, v_t, S).
template <Shape shape, class T>
inline std::array<T, section_dimension<shape>> coordinates(const SectionPoint<T>& z) {
    if constexpr (shape == Shape::disk)
        return {z.psi, z.vn, z.vt, z.spin};
    else
        return {z.psi, z.chi, z.vn, z.vt, z.spin};
}

template <Shape shape, class T>
inline SectionPoint<T> section_point(const std::array<T, section_dimension<shape>>& c) {
    if constexpr (shape == Shape::disk)
        return {c[0], T(0), c[1], c[2], c[3]};
    else
        return {c[0], c[1], c[2], c[3], c[4]};
}

/// A state in Jets, seeded with its derivatives by the section coordinates: at the bits of the state itself, since
/// d cis ψ = (−sin ψ, cos ψ) dψ needs no angle. Jet components beyond the section's stay zero.
template <class Jet, Shape shape, class T>
inline PostImpactState<Jet> seeded(const PostImpactState<T>& z) {
    int i = 0;
    const auto angle = [&](const Vec2<T>& c) {
        Vec2<Jet> jets{Jet(c.x), Jet(c.y)};
        jets.x.v[i] = -c.y;
        jets.y.v[i] = c.x;
        ++i;
        return jets;
    };
    PostImpactState<Jet> jets;
    jets.psi = angle(z.psi);
    jets.chi = shape == Shape::disk ? Vec2<Jet>{Jet(T(1)), Jet(T(0))} : angle(z.chi);
    jets.vn = Jet(z.vn, i);
    jets.vt = Jet(z.vt, i + 1);
    jets.spin = Jet(z.spin, i + 2);
    return jets;
}

/// A state in Jets without derivatives.
template <class Jet, class T>
inline PostImpactState<Jet> state_in_jets(const PostImpactState<T>& z) {
    return {{Jet(z.psi.x), Jet(z.psi.y)}, {Jet(z.chi.x), Jet(z.chi.y)}, Jet(z.vn), Jet(z.vt), Jet(z.spin)};
}

/// F(z) with DF(z) (rows: the new coordinates; columns: the old).
template <class T, Shape shape>
struct LinearisedCollision {
    Collision<T> collision;
    Eigen::Matrix<T, section_dimension<shape>, section_dimension<shape>> derivative;
};

}  // namespace swirl
