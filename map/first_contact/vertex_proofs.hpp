// Proofs that no vertex of a polygon touched the wall between the start of a flight and a contact that was found
// without guarantee: by the circumscribed circle; by the two vertices nearest to the wall; by every vertex.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace swirl {

namespace detail {

/// Up to this many sides every vertex is examined where the two nearest are not enough, on pieces of the flight down to
/// an eighth. (Of the flights of a map's chaotic hexagons that need it 85 % are proven as a whole, 10 % in halves, 4 %
/// in quarters or eighths, 0.3 % not.)
inline constexpr int few_sides = 8;
inline constexpr int most_halvings = 3;

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

/// Proof by the gaps of both vertices at both ends, as far as |g‴| ≤ M takes them. Nothing may touch until `out`
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
    return pairs_keep_inside(ring, struck, other, striking, neighbour, bounds.third);
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
///   sixth    bounds the sixth derivative of each one's gap
///   gaps_at  the gaps of all at a time
template <class T, class GapsAt>
bool every_vertex_clear(std::size_t sides, const GapsAt& gaps_at, const EveryGap<T>& before, const EveryGap<T>& after,
                        const T& from, const T& to, const T& sixth, int halvings) {
    std::size_t k = 0;
    while (k < sides && clear_between(before[k], after[k], T(to - from), sixth)) ++k;
    if (k == sides) return true;
    if (halvings == 0) return false;
    const T time = T(0.5) * (from + to);
    const EveryGap<T> half_way = gaps_at(time);
    return every_vertex_clear(sides, gaps_at, before, half_way, from, time, sixth, halvings - 1) &&
           every_vertex_clear(sides, gaps_at, half_way, after, time, to, sixth, halvings - 1);
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
    const auto gaps_at = [&](const T& t) { return every_gap(body, flight, instant_at<Shape::polygon>(flight, t)); };
    return every_vertex_clear(static_cast<std::size_t>(body.sides), gaps_at, every_gap(body, flight, start), after,
                              T(0), end.time, derivative_bounds<6, Shape::polygon>(body, flight).vertex, most_halvings);
}

}  // namespace detail

}  // namespace swirl
