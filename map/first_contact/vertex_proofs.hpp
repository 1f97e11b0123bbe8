// Proofs that no vertex of a polygon touched the wall between the start of a flight and a contact that was found
// without guarantee: by the circumscribed circle; by the two vertices nearest to the wall; by every vertex.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/vertices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace swirl {

namespace detail {

/// Up to this many sides every vertex is examined where the two nearest are not enough, on pieces of the flight down to
/// an eighth. (Of the flights of a map's chaotic hexagons that need it 85 % are proven as a whole, 10 % in halves, 4 %
/// in quarters or eighths, 0.3 % not.)
inline constexpr int few_sides = 8;
inline constexpr int most_halvings = 3;

/// The gap a small time d later by its own derivatives.
template <class T>
[[gnu::always_inline]] inline Gap<T> gap_after(const Gap<T>& gap, const T& d) {
    const T curvature = gap.curvature + d * gap.jerk;
    return {gap.value + d * (gap.rate + T(0.5) * d * (gap.curvature + fraction<T>(1, 3) * d * gap.jerk)),
            gap.rate + T(0.5) * d * (gap.curvature + curvature), curvature, gap.jerk};
}

/// The neighbour of a candidate on the side of X.
template <class T>
[[gnu::always_inline]] inline Candidate<T> neighbour_of(const Body<T>& body, const Flight<T>& flight,
                                                        const Instant<T>& at, const Candidate<T>& nearest) {
    Candidate<T> neighbour;
    const int k = nearest.vertex + (cross(nearest.arm, at.centre) >= 0 ? 1 : -1);
    neighbour.vertex = k < 0 ? k + body.sides : k == body.sides ? 0 : k;
    neighbour.arm = body.turned_to_vertex(at.arm, neighbour.vertex);
    neighbour.gap = gap_of(body, flight, at, neighbour);
    return neighbour;
}

/// What bounds the vertices' gaps while nothing is outside.
template <class T>
struct VertexBounds {
    T drift;  ///< |W| ≤ |V| + β
    T apart;  ///< half of the second derivative of the difference between neighbours' gaps, 2 X·(a₂ − a₁)
    T third;  ///< |g‴|
    T centre_sixth;
};

template <class T>
[[gnu::always_inline]] inline VertexBounds<T> vertex_bounds(const Body<T>& body, const Flight<T>& flight) {
    using std::fabs;
    VertexBounds<T> bounds;
    bounds.drift = fabs(flight.velocity.x) + fabs(flight.velocity.y) + body.beta;
    const T s = fabs(flight.spin);
    bounds.apart = body.side * (body.beta + s * (T(2) * bounds.drift + s * body.outer));
    bounds.third = vertex_third(body, flight, bounds.drift);
    bounds.centre_sixth = derivative_bounds<6, Shape::disk>(body, flight).centre;
    return bounds;
}

/// True if for `t` after a moment (or before it) the two vertices nearest to the centre's direction then stay so: as
/// `two_are_enough`, with |X| ≥ `distance`.
template <class T>
[[gnu::always_inline]] inline bool two_suffice(const Body<T>& body, const Flight<T>& flight, const T& drift, const T& t,
                                               const T& distance) {
    using std::fabs;
    return t * (fabs(flight.spin) * distance + T(2) * drift) <= T(0.5) * body.spacing * distance &&
           T(2) * t * drift <= distance;
}

/// Proof for one end of a flight from one vertex alone: for `t` after a moment when the vertex at `arm` is at the wall
/// it stays inside (g′ = −`rate`, g″ ≤ `curvature`), and the one second nearest to the centre's direction, at an angle
/// of 2π/N to it, is farther inside. `drift` = W and `spin` = S; both change sign backwards in time, for a vertex that
/// arrives.
template <class T>
[[gnu::always_inline]] inline bool only_one_at_wall(const Body<T>& body, const VertexBounds<T>& bounds,
                                                    const Vec2<T>& centre, const Vec2<T>& drift, const T& spin,
                                                    const Vec2<T>& arm, const T& rate, const T& curvature, const T& t,
                                                    const T& slack) {
    using std::copysign;
    using std::fabs;
    const T across = cross(arm, centre);
    const T along = dot(arm, centre);
    const Vec2<T> side = times(arm, Vec2<T>{body.next_turn.x, T(copysign(body.next_turn.y, across))});  // a₂ − a₁
    const T behind = T(2) * dot(centre, side);
    const T slope = T(2) * (dot(drift, side) - spin * cross(centre, side));
    return fabs(across) <= body.half_slope * along && rate > 0 &&
           t * (curvature + fraction<T>(1, 3) * bounds.third * t) <= T(2) * rate && rate * behind + slack <= 0 &&
           rate * (behind + t * (slope + t * bounds.apart)) + slack <= 0;
}

/// Proves that nothing touched between the start and a contact `correction` after `at`, where `nearest` strikes.
/// Between the ends the circumscribed circle stays clear of the wall but for two short times, and during these only one
/// vertex can be at the wall. False: not proven.
template <class T>
[[gnu::always_inline]] inline bool clear_by_circumcircle(const Body<T>& body, const Flight<T>& flight,
                                                         const Gap<T>& leaving, const Gap<T>& struck,
                                                         const Instant<T>& at, const Candidate<T>& nearest,
                                                         const T& correction) {
    using std::fabs;
    const VertexBounds<T> bounds = vertex_bounds(body, flight);
    const ClosedBetween<T> ring = closed_between(leaving, centre_gap(body, flight, at), at.time, bounds.centre_sixth);
    const T shift = fabs(correction);
    const T in = ring.in + shift;
    // At the contact itself. `slack`: the gap within which `touch_together` calls two times the same, and the motion
    // between `at` and the contact.
    const T rate = nearest.gap.rate - shift * (fabs(nearest.gap.curvature) + bounds.third * shift);
    const T curvature = nearest.gap.curvature + bounds.third * shift;
    const T fastest = T(2) * (bounds.drift + body.alpha * fabs(flight.spin));  // |g′| of any vertex
    const T slack = T(32) * epsilon<T>() * (T(1) + fastest) * (T(1) + fastest * at.time) +
                    rate * shift * T(2) * body.side * (bounds.drift + body.outer * fabs(flight.spin));
    const Vec2<T> start_drift = flight.velocity - flight.beta * quarter_turned(flight.phase);
    return ring.proven &&
           two_suffice(body, flight, bounds.drift, std::max(ring.out, in), T(body.inner - bounds.drift * shift)) &&
           only_one_at_wall(body, bounds, flight.centre, start_drift, flight.spin, flight.arm, T(-struck.rate),
                            struck.curvature, ring.out, T(0)) &&
           only_one_at_wall(body, bounds, at.centre, Vec2<T>{-at.drift.x, -at.drift.y}, T(-flight.spin), nearest.arm,
                            rate, curvature, in, slack);
}

/// The same with the gaps of both vertices at both ends, as far as |g‴| ≤ M takes them. Nothing may touch until `out`
/// and from `in` before the contact, at which `striking` and `neighbour` hold.
template <class T>
inline bool clear_by_pairs(const Body<T>& body, const Flight<T>& flight, const Instant<T>& start, const Gap<T>& leaving,
                           const Gap<T>& arriving, const Gap<T>& struck, const Gap<T>& striking,
                           const Gap<T>& neighbour, const T& time, const T& correction) {
    using std::fabs;
    const VertexBounds<T> bounds = vertex_bounds(body, flight);
    const ClosedBetween<T> ring = closed_between(leaving, arriving, time, bounds.centre_sixth);
    const T shift = fabs(correction);
    if (!(ring.proven && two_suffice(body, flight, bounds.drift, std::max(ring.out, T(ring.in + shift)),
                                     T(body.inner - bounds.drift * shift))))
        return false;
    const Gap<T> other = neighbour_of(body, flight, start, Candidate<T>{0, flight.arm, struck}).gap;
    return nonpositive_until(struck.value, struck.rate, struck.curvature, ring.out, bounds.third) &&
           nonpositive_until(other.value, other.rate, other.curvature, ring.out, bounds.third) &&
           nonpositive_until(striking.value, T(-striking.rate), striking.curvature, ring.in, bounds.third) &&
           nonpositive_until(neighbour.value, T(-neighbour.rate), neighbour.curvature, ring.in, bounds.third);
}

/// The gaps of all vertices at a moment, of a polygon with few.
template <class T>
using EveryGap = std::array<Gap<T>, few_sides>;

template <class T>
inline EveryGap<T> every_gap(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at) {
    EveryGap<T> gaps;
    for (int k = 0; k < body.sides; ++k)
        gaps[static_cast<std::size_t>(k)] = gap_of(body, flight, at, {k, body.turned_to_vertex(at.arm, k), {}});
    return gaps;
}

/// Proves every vertex clear between two moments, or on either half of that interval.
///   sixth  bounds the sixth derivative of each one's gap
template <class T>
bool every_vertex_clear(const Body<T>& body, const Flight<T>& flight, const EveryGap<T>& before,
                        const EveryGap<T>& after, const T& from, const T& to, const T& sixth, int halvings) {
    std::size_t k = 0;
    const auto sides = static_cast<std::size_t>(body.sides);
    while (k < sides && clear_between(before[k], after[k], T(to - from), sixth)) ++k;
    if (k == sides) return true;
    if (halvings == 0) return false;
    const T time = T(0.5) * (from + to);
    const EveryGap<T> half_way = every_gap(body, flight, instant_at<Shape::polygon>(flight, time));
    return every_vertex_clear(body, flight, before, half_way, from, time, sixth, halvings - 1) &&
           every_vertex_clear(body, flight, half_way, after, time, to, sixth, halvings - 1);
}

/// The further proofs, tried where `clear_by_circumcircle` fails: both vertices' own derivatives, then the quintics of
/// all vertices. False, too, if the neighbour touches within rounding of the same time: `choose` then decides.
template <class T>
[[gnu::noinline]] bool clear_by_derivatives(const Body<T>& body, const Flight<T>& flight, const Gap<T>& leaving,
                                            const Gap<T>& struck, const Instant<T>& at, const Candidate<T>& nearest,
                                            const T& correction) {
    if (!is_nearest(body, at.centre, nearest.arm)) return false;
    const Instant<T> start = instant_at_start(flight);
    const Gap<T> arriving = gap_after(centre_gap(body, flight, at), correction);
    Gap<T> striking = gap_after(nearest.gap, correction);
    striking.value = T(0);
    const Gap<T> neighbour = gap_after(neighbour_of(body, flight, at, nearest).gap, correction);
    const T time = at.time + correction;
    if (touch_together(striking, neighbour, time)) return false;
    if (clear_by_pairs(body, flight, start, leaving, arriving, struck, striking, neighbour, time, correction))
        return true;
    if (body.sides > few_sides) return false;
    Instant<T> end = at;
    advance<Shape::polygon>(flight, end, correction);
    EveryGap<T> after = every_gap(body, flight, end);
    T& at_wall = after[static_cast<std::size_t>(nearest.vertex)].value;  // a number from 0 to N − 1
    at_wall = std::min(at_wall, T(0));
    return every_vertex_clear(body, flight, every_gap(body, flight, start), after, T(0), end.time,
                              derivative_bounds<6, Shape::polygon>(body, flight).vertex, most_halvings);
}

}  // namespace detail

}  // namespace swirl
