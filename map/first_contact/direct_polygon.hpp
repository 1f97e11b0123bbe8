// The usual flight of a polygon from wall to wall: a root sought without guarantee, then the proof that it is the
// first.
#pragma once

#include "map/first_contact/bounds.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/circle_path.hpp"
#include "map/first_contact/vertices.hpp"

namespace swirl {

namespace detail {

/// Up to this many sides every vertex is examined where the two nearest are not enough.
inline constexpr int few_sides = 8;
/// Corrections of the guess beyond this are rejected; radians of swirl.
inline constexpr double longest_step = 0.125;

/// The moment `later` after one whose rotations are known, that of the body by `spun`.
template <class T>
[[gnu::always_inline]] inline Instant<T> instant_after(const Flight<T>& flight, const TurnedMoment<T>& near,
                                                       const Vec2<T>& spun, const T& later) {
    Instant<T> at;
    const Vec2<T> turn = turn_after(near, later);
    at.time = near.time + later;
    at.moved = (near.time * flight.velocity + later * flight.velocity) - flight.beta * times(flight.phase, turn);
    at.centre = flight.centre + at.moved;
    at.phase = turned(flight.phase, turn);
    at.swirl = flight.beta * at.phase;
    at.drift = flight.velocity - quarter_turned(at.swirl);
    at.arm_moved = times(flight.arm, compose(spun, turn_minus_one(T(flight.spin * later))));
    at.arm = flight.arm + at.arm_moved;
    return at;
}

/// The gap a small time d later by its own derivatives.
template <class T>
[[gnu::always_inline]] inline Gap<T> gap_after(const Gap<T>& gap, const T& d) {
    const T bend = gap.bend + d * gap.jerk;
    return {gap.value + d * (gap.rate + T(0.5) * d * (gap.bend + fraction<T>(1, 3) * d * gap.jerk)),
            gap.rate + T(0.5) * d * (gap.bend + bend), bend, gap.jerk};
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
/// it stays inside (g′ = −`rate`, g″ ≤ `bend`), and the one second nearest to the centre's direction, at an angle of
/// 2π/N to it, is farther inside. `drift` = W and `spin` = S; both change sign backwards in time, for a vertex that
/// arrives.
template <class T>
[[gnu::always_inline]] inline bool only_one_at_wall(const Body<T>& body, const VertexBounds<T>& bounds,
                                                    const Vec2<T>& centre, const Vec2<T>& drift, const T& spin,
                                                    const Vec2<T>& arm, const T& rate, const T& bend, const T& t,
                                                    const T& slack) {
    using std::copysign;
    using std::fabs;
    const T across = cross(arm, centre);
    const T along = dot(arm, centre);
    const Vec2<T> side = times(arm, Vec2<T>{body.next_turn.x, T(copysign(body.next_turn.y, across))});  // a₂ − a₁
    const T behind = T(2) * dot(centre, side);
    const T slope = T(2) * (dot(drift, side) - spin * cross(centre, side));
    return fabs(across) <= body.half_slope * along && rate > 0 &&
           t * (bend + fraction<T>(1, 3) * bounds.third * t) <= T(2) * rate && rate * behind + slack <= 0 &&
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
    const T rate = nearest.gap.rate - shift * (fabs(nearest.gap.bend) + bounds.third * shift);
    const T bend = nearest.gap.bend + bounds.third * shift;
    const T fastest = T(2) * (bounds.drift + body.alpha * fabs(flight.spin));  // |g′| of any vertex
    const T slack = T(32) * epsilon<T>() * (T(1) + fastest) * (T(1) + fastest * at.time) +
                    rate * shift * T(2) * body.side * (bounds.drift + body.outer * fabs(flight.spin));
    const Vec2<T> start_drift = flight.velocity - flight.beta * quarter_turned(flight.phase);
    return ring.proven &&
           two_suffice(body, flight, bounds.drift, std::max(ring.out, in), T(body.inner - bounds.drift * shift)) &&
           only_one_at_wall(body, bounds, flight.centre, start_drift, flight.spin, flight.arm, T(-struck.rate),
                            struck.bend, ring.out, T(0)) &&
           only_one_at_wall(body, bounds, at.centre, Vec2<T>{-at.drift.x, -at.drift.y}, T(-flight.spin), nearest.arm,
                            rate, bend, in, slack);
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
    return nonpositive_until(struck.value, struck.rate, struck.bend, ring.out, bounds.third) &&
           nonpositive_until(other.value, other.rate, other.bend, ring.out, bounds.third) &&
           nonpositive_until(striking.value, T(-striking.rate), striking.bend, ring.in, bounds.third) &&
           nonpositive_until(neighbour.value, T(-neighbour.rate), neighbour.bend, ring.in, bounds.third);
}

/// Proves every vertex clear between two moments, or on either half of that interval.
template <class T>
bool every_vertex_clear(const Body<T>& body, const Flight<T>& flight, const Instant<T>& from, const Instant<T>& to,
                        int striking, int halvings) {
    const T sixth = derivative_bounds<6, Shape::polygon>(body, flight).vertex;
    bool clear = true;
    for (int k = 0; clear && k < body.sides; ++k) {
        const Gap<T> first = gap_of(body, flight, from, {k, body.turned_to_vertex(from.arm, k), {}});
        Gap<T> last = gap_of(body, flight, to, {k, body.turned_to_vertex(to.arm, k), {}});
        if (k == striking) last.value = std::min(last.value, T(0));
        clear = clear_between(first, last, T(to.time - from.time), sixth);
    }
    if (clear) return true;
    if (halvings == 0) return false;
    const Instant<T> half_way = instant_at<Shape::polygon>(flight, T(T(0.5) * (from.time + to.time)));
    return every_vertex_clear(body, flight, from, half_way, -1, halvings - 1) &&
           every_vertex_clear(body, flight, half_way, to, striking, halvings - 1);
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
    return every_vertex_clear(body, flight, start, end, nearest.vertex, 1);
}

/// Where the search for the vertex begins: the centre back at its first distance. False if that is not found.
template <class T>
[[gnu::always_inline]] inline bool instant_of_return(const Flight<T>& flight, const CirclePath<T>& path,
                                                     const CircleGap<T>& leaving, Instant<T>& at) {
    using std::fabs;
    T guess = return_guess(leaving);
    if (!(guess > 0 && guess <= T(longest_guess))) guess = sampled_guess(path);
    if (!(guess > 0)) return false;
    TurnedMoment<T> near = moment_near(guess);
    T closer = householder(series_along(path, near));
    if (!(fabs(closer) <= T(longest_step) && near.time + closer > 0)) [[unlikely]] {
        guess = sampled_guess(path);
        if (!(guess > 0)) return false;
        near = moment_near(guess);
        closer = householder(series_along(path, near));
        if (!(fabs(closer) <= T(longest_step))) return false;
    }
    at = instant_after(flight, near, turn_minus_one(T(flight.spin * near.time)), closer);
    return true;
}

/// From there to a moment so close to the contact of the vertex nearest to the wall that `correction`, the way left,
/// needs no further look. False if there is none.
template <class T>
[[gnu::always_inline]] inline bool seek_vertex(const Body<T>& body, const Flight<T>& flight, Instant<T>& at,
                                               Candidate<T>& nearest, T& correction, int& steps) {
    using std::fabs;
    const T fourth = derivative_bounds<4, Shape::polygon>(body, flight).vertex;
    while (true) {  // ends: converged, or gives up
        if (++steps > correction_limit) return false;
        nearest.vertex = vertex_towards(body, at.centre, at.arm);
        nearest.arm = body.turned_to_vertex(at.arm, nearest.vertex);
        nearest.gap = gap_of(body, flight, at, nearest);
        const Gap<T>& g = nearest.gap;
        correction = householder(g.value, g.rate, T(T(0.5) * g.bend), T(fraction<T>(1, 6) * g.jerk));
        if (!(g.rate > 0 && fabs(correction) <= T(longest_correction))) return false;
        if (is_converged(g, correction, at.time, fourth)) return at.time + correction > 0;
        advance<Shape::polygon>(flight, at, correction);
    }
}

/// The circle's return leads to the vertex nearest to the wall there; its root is sought, then the whole flight proven
/// clear. False if anything fails; the advance by safe steps then decides.
template <class T>
[[gnu::always_inline]] inline bool direct_contact_polygon(const Body<T>& body, const Flight<T>& flight,
                                                          FirstContact<T>& contact) {
    const CirclePath<T> path = circle_path(flight, Vec2<T>(flight.beta * flight.phase));
    const CircleGap<T> start = gap_at_start(path);
    Instant<T> at;
    Candidate<T> nearest;
    T correction;
    if (!instant_of_return(flight, path, start, at)) return false;
    if (!seek_vertex(body, flight, at, nearest, correction, contact.steps)) return false;

    const Gap<T> struck = struck_gap_at_start(flight);
    if (!(struck.rate < -rate_rounding(body, flight))) return false;  // it may not leave at all
    const Gap<T> leaving{dot(flight.centre, flight.centre) - body.inner * body.inner, start.rate, start.bend,
                         start.jerk};
    if (!clear_by_circumcircle(body, flight, leaving, struck, at, nearest, correction)) [[unlikely]] {
        const Instant<T> here = at;  // copies, so that the others stay in registers
        const Candidate<T> vertex = nearest;
        if (!clear_by_derivatives(body, flight, leaving, struck, here, vertex, T(correction))) return false;
    }
    advance<Shape::polygon>(flight, at, correction);
    contact.outcome = FirstContactOutcome::contact;
    contact.at = at;
    contact.vertex = nearest.vertex;
    contact.arm = body.turned_to_vertex(at.arm, nearest.vertex);
    return true;
}

}  // namespace detail

}  // namespace swirl
