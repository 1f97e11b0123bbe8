// The numbers of a scene that the inner loops read, worked out once per scene.
#pragma once

#include "map/model/scene.hpp"
#include "map/numbers/turn.hpp"
#include "map/numbers/vec2.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl {

enum class Shape { disk, polygon };

/// The directions of a regular polygon's vertices.
template <class T>
struct VertexTable {
    std::vector<Vec2<T>> directions;  ///< cis(2πk/N)
    std::vector<Vec2<T>> rests;       ///< what rounding left out of them (double only)
};

/// What a flight needs to know of the body and its container. Lengths in R_c; with rounded corners in R_c − r, in which
/// they are those of the polygon of the corners' centres: these touch the circle of radius R_c − r as sharp vertices
/// do.
template <class T>
struct Body {
    int sides = disk_sides;
    bool short_sides = false;  ///< below `longest_short_side`
    T alpha{}, beta{};
    T inertia{};          ///< I = κ α² (m = 1)
    T inverse_inertia{};  ///< 1/I: what is divided by at every impact is kept as a reciprocal
    T inverse_inner{};    ///< 1/(1 − α)
    T disk_grip{};        ///< of the disk (1 + e_t)/B₁, 1/B₁ = I/(I + α²): −q/u_t of an impact that sticks
    T tangential_restitution{};  ///< e_t of the disk
    // α, 1/α, 1 − α and 1/(1 − α) for products that must not be biased.
    UnbiasedFactor<T> unbiased_alpha{}, unbiased_inverse_alpha{}, unbiased_inner{}, unbiased_inverse_inner{};
    T inner{};          ///< 1 − α: the centre's distance at which the circumscribed circle touches
    T outer{};          ///< the largest distance the centre can have (next to an edge's middle); inner for the disk
    T spacing{};        ///< 2π/N, the angle from a vertex to the next
    T per_spacing{};    ///< N/2π
    T half_slope{};     ///< tan(π/N)
    Vec2<T> next_turn;  ///< cis(2π/N) − 1
    T side{};           ///< the length of a side, 2α sin(π/N)
    std::span<const Vec2<T>> vertices;            ///< cis(2πk/N) for N small enough to be worth a table …
    std::span<const Vec2<T>> rests;               ///< … and what rounding left out of it (double only)
    std::shared_ptr<const VertexTable<T>> table;  ///< which these are of: bodies of the same N may share it
    T unit = T(1);                                ///< the unit of its lengths, 1 − r
    T corner{};                                   ///< r in that unit: the wall is touched so far beyond the vertex

    static constexpr int table_limit = 1024;
    /// Below it gaps are known better relative to the vertex that has struck (`short_side_gap`).
    static constexpr double longest_short_side = 1.0 / 32;

    /// tan(π/2), finite: of a rod's ends the one on X's side is nearer, however little.
    static constexpr double slope_of_rod = 1e40;

    /// v turned by 2πk/N, 0 ≤ k < N.
    Vec2<T> turned_to_vertex(const Vec2<T>& v, int k) const {
        if (k == 0) return v;
        if (vertices.empty()) return times(v, direction_by_formula(k));
        return times(v, vertices[static_cast<std::size_t>(k)]);
    }
    /// The rounding error of the tabled rotation, some 10⁻¹⁷ of v and the same for the same k. It is below the last
    /// digit of the vector, and is added to the vertex's gap and to the angles of its impact, or J would drift.
    Vec2<T> residual_of_vertex(const Vec2<T>& v, int k) const {
        if (rests.empty()) return {T(0), T(0)};
        return times(v, rests[static_cast<std::size_t>(k)]);
    }
    /// The angle that is missing from that rotation, < 0 if it went too far.
    T residual_angle(int k) const {
        if (rests.empty()) return T(0);
        return cross(vertices[static_cast<std::size_t>(k)], rests[static_cast<std::size_t>(k)]);
    }
    /// cis(2πk/N) − 1 to a few ε of itself, 0 ≤ k < N.
    Vec2<T> turn_to_vertex(int k) const {
        if (rests.empty()) {
            const Vec2<Plain<T>> turn = cis_minus_one(angle_of_vertex(k));
            return {T(turn.x), T(turn.y)};
        }
        return minus_one(vertices[static_cast<std::size_t>(k)], rests[static_cast<std::size_t>(k)]);
    }
    Vec2<T> direction_by_formula(int k) const {
        const Vec2<Plain<T>> direction = cis(angle_of_vertex(k));
        return {T(direction.x), T(direction.y)};
    }
    /// 2πk/N, the shorter way round.
    Plain<T> angle_of_vertex(int k) const {
        const int centred = 2 * k > sides ? k - sides : k;
        return Plain<T>(2 * pi<T>() * centred / sides);
    }
    /// k reduced to 0 … N − 1.
    int vertex_number(long long k) const {
        const long long reduced = k % sides;
        return static_cast<int>(reduced < 0 ? reduced + sides : reduced);
    }
};

/// The speed of the body's points to within a constant factor: the largest of |V|'s components and α|S|.
template <class T>
inline T speed_of(const Body<T>& body, const T& vx, const T& vy, const T& spin) {
    using std::fabs;
    return std::max(std::max(T(fabs(vx)), T(fabs(vy))), T(body.alpha * fabs(spin)));
}

/// The table for N sides, each direction rounded once.
template <class T>
inline std::shared_ptr<const VertexTable<T>> vertex_table(const Body<T>& body) {
    VertexTable<T> table;
    for (int k = 0; k < body.sides; ++k) {
        if constexpr (std::is_same_v<T, double>) {
            const long double angle = 2 * pi<long double>() * (2 * k > body.sides ? k - body.sides : k) / body.sides;
            const detail::TabledVector entry = detail::tabled(cis(angle));
            table.directions.push_back(entry.value);
            table.rests.push_back(entry.rest);
        } else {
            table.directions.push_back(body.direction_by_formula(k));
        }
    }
    return std::make_shared<const VertexTable<T>>(std::move(table));
}

namespace detail {

/// The polygon of the corners' centres, in R_c − r: α ← (α − r)/(1 − r), β ← β/(1 − r), and the same I.
template <class T>
inline Scene<T> of_corner_centres(Scene<T> scene) {
    const T unit = T(1) - scene.corner, arm = scene.alpha - scene.corner;
    scene.inertia_factor = scene.inertia_factor * (scene.alpha / arm) * (scene.alpha / arm);
    scene.alpha = arm / unit;
    scene.beta = scene.beta / unit;
    scene.corner = T(0);
    return scene;
}

}  // namespace detail

/// Cost: without `similar` the directions of N ≤ 1024 vertices, some 0.1 µs each. Jets have no table: the one direction
/// that they need costs less to work out than all to differentiate.
///   similar  a body whose table is taken, if it has the same N
template <class T>
inline Body<T> make_body(const Scene<T>& scene, const Body<T>* similar = nullptr);

/// That of a polygon with rounded corners; r = 0 is the sharp one's.
template <class T>
inline Body<T> rounded_body(const Scene<T>& scene, const Body<T>* similar = nullptr) {
    Body<T> body = make_body(detail::of_corner_centres(scene), similar);
    body.unit = T(1) - scene.corner;
    body.corner = scene.corner / body.unit;
    return body;
}

template <class T>
inline Body<T> make_body(const Scene<T>& scene, const Body<T>* similar) {
    if (scene.is_rounded()) return rounded_body(scene, similar);
    using std::sqrt;
    using std::tan;
    Body<T> body;
    body.sides = scene.sides;
    body.alpha = scene.alpha;
    body.beta = scene.beta;
    body.inertia = scene.inertia_factor * scene.alpha * scene.alpha;
    body.inner = T(1) - scene.alpha;
    body.inverse_inertia = T(1) / body.inertia;
    body.inverse_inner = T(1) / body.inner;
    body.unbiased_alpha = unbiased(body.alpha);
    body.unbiased_inverse_alpha = unbiased(T(T(1) / body.alpha));
    body.unbiased_inner = unbiased(body.inner);
    body.unbiased_inverse_inner = unbiased(body.inverse_inner);
    body.tangential_restitution = scene.tangential_restitution;
    body.disk_grip = (T(1) + scene.tangential_restitution) * (body.inertia / (body.inertia + body.alpha * body.alpha));
    body.outer = body.inner;
    if (scene.is_disk()) return body;
    const Vec2<T> half = scene.is_rod() ? Vec2<T>{T(0), T(1)} : cis(T(pi<T>() / scene.sides));  // 0, not ±ε
    const T across = scene.alpha * half.y;
    body.outer = sqrt(T(1) - across * across) - scene.alpha * half.x;
    body.spacing = T(2 * pi<T>() / scene.sides);
    body.per_spacing = T(1) / body.spacing;
    body.half_slope = scene.is_rod() ? T(Body<T>::slope_of_rod) : half.y / half.x;
    body.side = T(2) * scene.alpha * half.y;
    body.short_sides = body.side < T(Body<T>::longest_short_side);
    body.next_turn = {T(-2) * half.y * half.y, T(2) * half.y * half.x};
    if (scene.sides > Body<T>::table_limit || !std::is_same_v<T, Plain<T>>) return body;
    body.table = similar && similar->table && similar->sides == scene.sides ? similar->table : vertex_table(body);
    body.vertices = body.table->directions;
    body.rests = body.table->rests;
    return body;
}

}  // namespace swirl
