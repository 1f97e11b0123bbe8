// The usual flight of a polygon from wall to wall: a root sought without care, then the proof that it is the first.
#pragma once

#include "map/certificate.hpp"
#include "map/circle_path.hpp"
#include "map/contact.hpp"
#include "map/vertices.hpp"

namespace swirl {

namespace detail {

/// Polygons with no more sides have every vertex looked at where the two nearest are not enough.
inline constexpr int few_sides = 8;

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
    return {gap.value + d * (gap.rate + T(0.5) * d * (gap.bend + T(1.0 / 3) * d * gap.jerk)),
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

/// What the proof looks at: the circumscribed circle's gap and the two nearest vertices' at both ends.
template <class T>
struct FlightEnds {
    T time;              ///< from the start to the contact
    T correction;        ///< the pair at the contact was chosen this long before it (after it, if negative)
    Gap<T> leaving;      ///< the circle's at the start
    Gap<T> arriving;     ///< the circle's at the contact
    Gap<T> struck, other;        ///< the vertices' at the start
    Gap<T> striking, neighbour;  ///< and at the contact
};

/// Proves that nothing touched on the way. Between the ends the circumscribed circle stays clear of the wall but for two
/// short times, and for these the two vertices nearest to the centre's direction do.
template <class T>
[[gnu::always_inline]] inline bool clear_flight(const Body<T>& body, const Flight<T>& flight, const FlightEnds<T>& ends) {
    using std::fabs;
    const T speed = fabs(flight.velocity.x) + fabs(flight.velocity.y);
    const T drift = speed + body.beta;
    const T sixth = derivative_bounds<6, Shape::disk>(body, flight).centre;
    const ClosedBetween<T> ring = closed_between(ends.leaving, ends.arriving, ends.time, sixth);
    if (!ring.proven) return false;
    // `two_are_enough` with |X| at the moments when the pairs were chosen: at a contact it is 1 − α at least
    const T shift = fabs(ends.correction);
    const T longest = std::max(ring.out, ring.in + shift);
    const T distance = body.inner - drift * shift;
    if (!(longest * (fabs(flight.spin) * distance + T(2) * drift) <= T(0.5) * body.spacing * distance &&
          T(2) * longest * drift <= distance))
        return false;
    const T third = vertex_third(body, flight, drift);
    return stays_closed(ends.struck.value, ends.struck.rate, ends.struck.bend, ring.out, third) &&
           stays_closed(ends.other.value, ends.other.rate, ends.other.bend, ring.out, third) &&
           stays_closed(ends.striking.value, T(-ends.striking.rate), ends.striking.bend, ring.in, third) &&
           stays_closed(ends.neighbour.value, T(-ends.neighbour.rate), ends.neighbour.bend, ring.in, third);
}

/// Every vertex clear between two moments, or between each and the moment half-way.
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

/// The circle's return leads to the vertex nearest to the wall there; its root is sought, then the whole flight proven
/// clear. False if anything fails; the advance by safe steps then decides.
template <class T>
[[gnu::always_inline]] inline bool direct_contact_polygon(const Body<T>& body, const Flight<T>& flight,
                                                          Contact<T>& contact) {
    using std::fabs;
    const CirclePath<T> path = circle_path(flight, Vec2<T>(flight.beta * flight.phase), T(0));
    const CircleGap<T> leaving = gap_at_start(path);
    const T guess = return_guess(leaving);
    if (!(guess > 0 && guess <= T(longest_guess))) return false;
    const TurnedMoment<T> near = moment_near(guess);
    const Vec2<T> spun = turn_minus_one(T(flight.spin * near.time));
    const T closer = householder(series_along(path, near));
    if (!(fabs(closer) <= T(longest_correction) && near.time + closer > 0)) return false;
    Instant<T> at = instant_after(flight, near, spun, closer);

    const T fourth = derivative_bounds<4, Shape::polygon>(body, flight).vertex;
    Candidate<T> nearest;
    T correction;
    while (true) {  // ends: converged, or gives up
        if (++contact.steps > correction_limit) return false;
        nearest.vertex = vertex_towards(body, at.centre, at.arm);
        nearest.arm = body.turned_to_vertex(at.arm, nearest.vertex);
        nearest.gap = gap_of(body, flight, at, nearest);
        const Gap<T>& g = nearest.gap;
        correction = householder(g.value, g.rate, T(T(0.5) * g.bend), T(T(1.0 / 6) * g.jerk));
        if (!(g.rate > 0 && fabs(correction) <= T(longest_correction))) return false;
        if (is_converged(g, correction, at.time, fourth)) break;
        advance<Shape::polygon>(flight, at, correction);
    }
    if (!(is_nearest(body, at.centre, nearest.arm) && at.time + correction > 0)) return false;

    FlightEnds<T> ends;
    ends.time = at.time + correction;
    ends.correction = correction;
    ends.leaving = leaving;
    ends.leaving.value = dot(flight.centre, flight.centre) - body.inner * body.inner;
    ends.arriving = gap_after(centre_gap(body, flight, at), correction);
    const Instant<T> start = instant_at_start(flight);
    const Candidate<T> struck{0, flight.arm, vertex_gap(flight, start, flight.arm)};
    ends.struck = struck.gap;
    ends.struck.value = T(0);
    if (!(ends.struck.rate < -rate_rounding(body, flight))) return false;  // it may not leave at all
    ends.other = neighbour_of(body, flight, start, struck).gap;
    ends.striking = gap_after(nearest.gap, correction);
    ends.striking.value = T(0);
    ends.neighbour = gap_after(neighbour_of(body, flight, at, nearest).gap, correction);
    const bool clear = clear_flight(body, flight, ends);
    advance<Shape::polygon>(flight, at, correction);
    if (!clear && !(body.sides <= few_sides && every_vertex_clear(body, flight, start, at, nearest.vertex, 1))) return false;

    contact.outcome = ContactOutcome::contact;
    contact.at = at;
    contact.vertex = nearest.vertex;
    contact.arm = body.turned_to_vertex(at.arm, nearest.vertex);
    contact.simultaneous = touch_together(ends.striking, ends.neighbour, ends.time);
    return true;
}

}  // namespace detail

}  // namespace swirl
