// The numbers of a scene that the inner loops read, worked out once per scene.
#pragma once

#include "map/scene.hpp"
#include "map/turn.hpp"
#include "map/vec2.hpp"

#include <cmath>
#include <type_traits>
#include <vector>

namespace swirl {

namespace detail {

/// Of the vectors within two roundings of a unit vector, the one whose length is nearest to 1. The arm of a vertex that
/// is always too long by the same part of ε would displace the centre the same way at each of its impacts, and J would
/// drift in proportion to their number.
template <class T>
inline Vec2<T> nearest_unit(const Vec2<T>& v) {
    if constexpr (!std::is_same_v<T, double>) {
        return v;  // no wider hardware type to measure the length in; the drift is below 2⁻¹¹ of double's
    } else {
        const auto excess = [](const Vec2<double>& a) {
            const long double x = a.x, y = a.y;
            return std::fabs((x * x - 0.5L) + (y * y - 0.5L));
        };
        Vec2<double> best = v;
        for (int i = -2; i <= 2; ++i)
            for (int j = -2; j <= 2; ++j) {
                const Vec2<double> next{v.x + i * 0x1p-54, v.y + j * 0x1p-54};
                if (excess(next) < excess(best)) best = next;
            }
        return best;
    }
}

}  // namespace detail

enum class Shape { disk, polygon };

/// What a flight needs to know of the body and its container. Lengths in R_c.
template <class T>
struct Body {
    int sides = disk_sides;
    T alpha{}, beta{};
    T inertia{};         ///< I = κ α² (m = 1)
    T inner{};           ///< 1 − α: the centre's distance at which the circumscribed circle touches
    T outer{};           ///< the largest distance the centre can have (next to an edge's middle); inner for the disk
    T spacing{};         ///< 2π/N, the angle from a vertex to the next
    T half_slope{};      ///< tan(π/N)
    std::vector<Vec2<T>> vertices;  ///< cis(2πk/N) for N small enough to be worth a table …
    std::vector<Vec2<T>> rests;     ///< … and what rounding left out of it, which would add up (double only)

    static constexpr int table_limit = 1024;

    /// v turned by 2πk/N, 0 ≤ k < N.
    Vec2<T> turned_to_vertex(const Vec2<T>& v, int k) const {
        if (k == 0) return v;
        if (vertices.empty()) return times(v, direction_by_formula(k));
        const auto index = static_cast<std::size_t>(k);
        if constexpr (std::is_same_v<T, double>) return times(v, vertices[index]) + times(v, rests[index]);
        return times(v, vertices[index]);
    }
    Vec2<T> direction_by_formula(int k) const {
        const int centred = 2 * k > sides ? k - sides : k;  // the shorter way round keeps the argument small
        return cis(T(2 * pi<T>() * centred / sides));
    }
    /// k reduced to 0 … N − 1.
    int vertex_number(long long k) const {
        const long long reduced = k % sides;
        return static_cast<int>(reduced < 0 ? reduced + sides : reduced);
    }
};

template <class T>
inline Body<T> make_body(const Scene<T>& scene) {
    using std::sqrt;
    using std::tan;
    Body<T> body;
    body.sides = scene.sides;
    body.alpha = scene.alpha;
    body.beta = scene.beta;
    body.inertia = scene.inertia_factor * scene.alpha * scene.alpha;
    body.inner = T(1) - scene.alpha;
    body.outer = body.inner;
    if (scene.is_disk()) return body;
    const Vec2<T> half = cis(T(pi<T>() / scene.sides));
    const T across = scene.alpha * half.y;
    body.outer = sqrt(T(1) - across * across) - scene.alpha * half.x;
    body.spacing = T(2 * pi<T>() / scene.sides);
    body.half_slope = half.y / half.x;
    if (scene.sides > Body<T>::table_limit) return body;
    for (int k = 0; k < scene.sides; ++k) {
        if constexpr (std::is_same_v<T, double>) {
            const long double angle = 2 * pi<long double>() * (2 * k > scene.sides ? k - scene.sides : k) / scene.sides;
            const detail::TabledVector entry = detail::tabled(cis(angle));
            body.vertices.push_back(entry.value);
            body.rests.push_back(entry.rest);
        } else {
            body.vertices.push_back(detail::nearest_unit(body.direction_by_formula(k)));
        }
    }
    return body;
}

}  // namespace swirl
