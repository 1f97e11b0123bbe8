// Which vertices can touch next: the two nearest to the centre's direction, whatever N is.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/circle_path.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace swirl {

namespace detail {

/// A vertex that may touch next.
template <class T>
struct Candidate {
    int vertex = 0;  ///< number from the reference vertex
    Vec2<T> arm;     ///< a now
    Gap<T> gap;
};

/// The two vertices nearest to the centre's direction.
template <class T>
struct NearestTwo {
    Candidate<T> first;
    Candidate<T> second;
};

#include "map/first_contact/vertices_formulas.hpp"

/// The number of the vertex nearest to the direction of X, or one next to it.
template <class T>
[[gnu::always_inline]] inline int vertex_towards(const Body<T>& body, const Vec2<T>& centre, const Vec2<T>& reference) {
    using std::atan2;
    using std::round;
    const Vec2<T> between = seen_from(reference, centre);
    if constexpr (std::is_same_v<T, double>) {
        if (!body.vertices.empty()) {
            const double number = rough_angle(between.y, between.x) * body.per_spacing;
            if (!(std::fabs(number) < body.sides)) return 0;  // there is no direction
            const int k = static_cast<int>((number + 0x1.8p52) - 0x1.8p52);
            return k < 0 ? k + body.sides : k;
        }
    }
    return body.vertex_number(static_cast<long long>(round(atan2(between.y, between.x) / body.spacing)));
}

/// Turns arm and number by whole vertices until the arm is the nearest one to X.
template <class T>
inline void turn_to_nearest(const Body<T>& body, const Vec2<T>& centre, const Vec2<T>& reference, Candidate<T>& c) {
    if (is_nearest(body, centre, c.arm)) return;
    c.vertex = vertex_towards(body, centre, reference);
    c.arm = body.turned_to_vertex(reference, c.vertex);
    if (is_nearest(body, centre, c.arm)) return;
    c.vertex = body.vertex_number(c.vertex + (cross(c.arm, centre) > 0 ? 1 : -1));
    c.arm = body.turned_to_vertex(reference, c.vertex);
}

template <class T>
[[gnu::noinline]] T short_side_gap(const Body<T>& body, const Instant<T>& at, int vertex) {
    return short_side_value(at, body.turn_to_vertex(vertex));
}

/// The circumscribed circle's gap, from that of the vertex that has struck where sides are short: with a₀ its arm at
/// the start and X₀ = (1, 0) − a₀,
///     |X|² − (1 − α)² = 2(α − a₀ₓ) + 2X₀·moved + |moved|²,  α − a₀ₓ = a₀ᵧ²/(α + a₀ₓ).
/// Known to ε only it would seem clear of the wall where it has vertices outside.
template <class T>
inline Gap<T> circumcircle_gap(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at) {
    Gap<T> gap = centre_gap(body, flight, at);
    const Vec2<T>& arm = flight.arm;
    if (flight.struck && body.short_sides && arm.x > T(0)) {
        const T at_start = T(2) * arm.y * arm.y / (body.alpha + arm.x);
        gap.value = at_start + (T(2) * dot(flight.centre, at.moved) + dot(at.moved, at.moved));
    }
    return gap;
}

/// Which bodies a search is compiled for: the usual one does not ask whether sides are short.
enum class Sides { any, not_short };

template <Sides sides = Sides::any, class T>
inline Gap<T> gap_of(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at,
                     const Candidate<T>& candidate) {
    if (flight.struck && candidate.vertex == 0) return struck_gap(flight, at);
    Gap<T> gap = vertex_gap(flight, at, candidate.arm);
    if (sides == Sides::any && body.short_sides && flight.struck) {
        gap.value = short_side_gap(body, at, candidate.vertex);
        return gap;
    }
    gap.value = gap.value + T(2) * dot(at.centre + candidate.arm, body.residual_of_vertex(at.arm, candidate.vertex));
    return gap;
}

/// The one nearest to a direction, from the last known number.
template <class T>
inline void look_at_nearest(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at,
                            const Vec2<T>& direction, Candidate<T>& nearest) {
    nearest.arm = body.turned_to_vertex(at.arm, nearest.vertex);
    turn_to_nearest(body, direction, at.arm, nearest);
    nearest.gap = gap_of(body, flight, at, nearest);
}

/// Brings the pair of vertices nearest to a direction up to date at a moment.
template <class T>
inline void look_around(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at, const Vec2<T>& direction,
                        NearestTwo<T>& pair) {
    look_at_nearest(body, flight, at, direction, pair.first);
    const int side = cross(pair.first.arm, direction) >= 0 ? 1 : -1;
    pair.second.vertex = body.vertex_number(pair.first.vertex + side);
    pair.second.arm = body.turned_to_vertex(at.arm, pair.second.vertex);
    pair.second.gap = gap_of(body, flight, at, pair.second);
}

/// The pair nearest to the centre's direction: no other vertex is as near to the wall.
template <class T>
inline void look_around(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at, NearestTwo<T>& pair) {
    look_around(body, flight, at, at.centre, pair);
}

/// A time for which no third vertex can be the nearest to the wall: it is at least 2π/N away from the centre's
/// direction and would have to come within π/N. The direction turns at a rate below 2|W|/|X| while |X| at most halves.
template <class T>
inline T two_are_enough(const Body<T>& body, const Flight<T>& flight, const FlightBounds<T>& bounds,
                        const T& distance) {
    using std::fabs;
    const T turning = T(0.5) * body.spacing / (fabs(flight.spin) + T(2) * bounds.drift / distance);
    return std::min(turning, T(distance / (T(2) * bounds.drift)));
}

/// The one that began the flight: at a start on the wall it is among the two, though not always the first (two vertices
/// that strike together are equally near).
template <class T>
inline Candidate<T>& struck_of(NearestTwo<T>& pair) {
    return pair.second.vertex == 0 ? pair.second : pair.first;
}

/// The neighbour that touches where a flight begins on the wall. A neighbour whose normal velocity is zero within
/// `rounding` touches only if g″ ≥ 0: two vertices may leave together.
template <class T>
inline const Candidate<T>* touching_neighbour(const NearestTwo<T>& pair, const T& rounding) {
    const Candidate<T>& other = pair.second.vertex == 0 ? pair.first : pair.second;
    if (other.vertex == 0 || other.gap.value < 0) return nullptr;
    const bool touches = other.gap.rate > rounding || (other.gap.rate >= -rounding && other.gap.curvature >= 0);
    return touches ? &other : nullptr;
}

template <class T>
inline void take(const Candidate<T>& vertex, FirstContact<T>& contact) {
    contact.outcome = FirstContactOutcome::contact;
    contact.vertex = vertex.vertex;
    contact.arm = vertex.arm;
}

/// Decides which of the two strikes: the earlier; on an exact tie the larger u_n, then the lower number.
///   size  of what the two gaps are the sum of
template <class T>
inline void choose(const NearestTwo<T>& pair, const T& size, FirstContact<T>& contact) {
    const T first = time_left(pair.first.gap);
    const T second = time_left(pair.second.gap);
    contact.simultaneous = touch_together(pair.first.gap, pair.second.gap, contact.at.time, size);
    bool take_second = second < first;
    if (first == second) {
        const T difference = pair.second.gap.rate - pair.first.gap.rate;  // g′ = 2 u_n
        take_second = difference > 0 || (difference == 0 && pair.second.vertex < pair.first.vertex);
    }
    take(take_second ? pair.second : pair.first, contact);
}

}  // namespace detail

}  // namespace swirl
