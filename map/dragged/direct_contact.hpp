// The usual flight from wall to wall over a floor that drags: a root sought without guarantee, then the proof that it
// is the first, as without drag (map/first_contact/direct_polygon.hpp, certain_disk.hpp).
#pragma once

#include "map/dragged/dragged_proofs.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/circle_path.hpp"
#include "map/first_contact/direct_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace swirl::detail {

/// The centre's gap at the start with its derivatives: X⁽ᵏ⁾ = (−γ)ᵏ⁻¹U + iᵏ⁻² h w.
template <class T>
[[gnu::always_inline]] inline CircleGap<T> gap_at_start(const DraggedFlight<T>& flight) {
    const T& g = flight.floor.drag;
    const Vec2<T>&x = flight.start.centre, &u = flight.stream, &r = flight.ridden;
    const Vec2<T> side = quarter_turned(r), u2 = g * u, u3 = g * u2, u4 = g * u3, u5 = g * u4;
    const Vec2<T> first = u - side, second = r - u2, third = u3 + side, fourth = T(-1) * (u4 + r), fifth = u5 - side;
    CircleGap<T> gap;
    gap.value = T(0);
    gap.rate = T(2) * dot(x, first);
    gap.curvature = T(2) * (dot(first, first) + dot(x, second));
    gap.jerk = T(2) * (T(3) * dot(first, second) + dot(x, third));
    gap.fourth = T(2) * (T(3) * dot(second, second) + T(4) * dot(first, third) + dot(x, fourth));
    gap.fifth = T(2) * (T(10) * dot(second, third) + T(5) * dot(first, fourth) + dot(x, fifth));
    return gap;
}

/// The gap at the start of the vertex that has struck, which is at (1, 0).
template <class T>
[[gnu::always_inline]] inline Gap<T> struck_gap_at_start(const DraggedFlight<T>& flight) {
    const T &g = flight.floor.drag, &slowing = flight.floor.spin_drag, &s = flight.start.spin;
    const Vec2<T>&arm = flight.start.arm, &r = flight.ridden;
    const Vec2<T> u2 = g * flight.stream, across = quarter_turned(arm);
    const Vec2<T> rate = (flight.stream - quarter_turned(r)) + s * across;
    const Vec2<T> acceleration = (r - u2) - s * (s * arm + slowing * across);
    const Vec2<T> jerk =
        (quarter_turned(r) + g * u2) + s * (T(3) * slowing * s * arm + (slowing * slowing - s * s) * across);
    return {T(0), T(2) * rate.x, T(2) * (dot(rate, rate) + acceleration.x),
            T(2) * (T(3) * dot(rate, acceleration) + jerk.x)};
}

/// Bounds |g⁗| of the centre's gap and, of a polygon, any vertex's, from the start on: |a⁽ᵏ⁾| ≤ αS(S + ½kγ_r)ᵏ⁻¹.
template <Shape shape, class T>
[[gnu::always_inline]] inline T fourth_bound(const Body<T>& body, const DraggedFlight<T>& flight) {
    using std::fabs;
    const T g = flight.floor.drag, b = flight.start.beta;
    const T u = fabs(flight.stream.x) + fabs(flight.stream.y);
    T first = u + b, second = g * u + b, third = g * g * u + b, fourth = g * g * g * u + b;
    if constexpr (shape == Shape::polygon) {
        const T s = fabs(flight.start.spin), arm = body.alpha * s, r = flight.floor.spin_drag;
        const T two = s + r, three = s + T(1.5) * r, four = s + T(2) * r;
        first = first + arm;
        second = second + arm * two;
        third = third + arm * (three * three);
        fourth = fourth + arm * (four * four * four);
    }
    return T(2) * (fourth + T(4) * first * third + T(3) * second * second);
}

/// The moment a correction later. One so small that third order is exact is added to the moment that is known.
template <Shape shape, class T>
[[gnu::always_inline]] inline void advance(const DraggedFlight<T>& flight, const T& correction,
                                           DraggedInstant<T>& moment) {
    using std::fabs;
    const T time = moment.at.time + correction;
    const T small = T(0x1p-14);
    if (!std::is_same_v<T, double> ||
        !(fabs(correction) * (T(1) + flight.floor.drag + flight.floor.spin_drag) < small)) {
        moment = dragged_instant<shape>(flight, time);
        return;
    }
    const auto decayed = [&correction](const T& rate) {
        const T x = rate * correction;
        return x * (T(1) - T(0.5) * x * (T(1) - fraction<T>(1, 3) * x));  // 1 − e^{−x}
    };
    const T half = T(0.5) * correction;
    const T share = T(fraction<T>(1, 3)) * correction;
    Instant<T>& at = moment.at;
    at.time = time;
    at.moved = at.moved + correction * (at.drift + half * (moment.acceleration + share * moment.jerk));
    const Vec2<T> turn = tiny_turn_minus_one(correction);
    at.phase = turned(at.phase, turn);
    at.swirl = flight.start.beta * at.phase;
    at.centre = flight.start.centre + at.moved;
    const T lost = decayed(flight.floor.drag);
    moment.length = moment.length + moment.decay * correction * (T(1) - half * flight.floor.drag);
    moment.decay = moment.decay - lost * moment.decay;
    moment.stream = moment.decay * flight.stream;
    moment.ridden = turned(moment.ridden, turn);
    const T spin_lost = decayed(flight.floor.spin_drag);
    if constexpr (shape == Shape::polygon) {
        const T turned_by = moment.spin * correction * (T(1) - half * flight.floor.spin_drag);
        const Vec2<T> arm_step = times(at.arm, cis_minus_one(turned_by));
        at.arm = at.arm + arm_step;
        at.arm_moved = at.arm_moved + arm_step;
        moment.spin = moment.spin - spin_lost * moment.spin;
    }
    moment.spin_decay = moment.spin_decay - spin_lost * moment.spin_decay;
}

/// A guess where the start's derivatives do not tell: the circle's gap against that at the start is sampled, first at
/// 1/32, from ¼ on four times per radian, up to its change of sign. −1 if it stays negative.
template <class T>
[[gnu::noinline]] T sampled_guess(const DraggedFlight<T>& flight) {
    T before(0), last(0);
    for (T time = T(1.0 / 32); time < T(longest_guess); time = time < T(0.25) ? T(2) * time : T(time + T(0.25))) {
        const DraggedInstant<T> moment = dragged_instant<Shape::disk>(flight, time);
        const Vec2<T>& moved = moment.at.moved;
        const T gap = T(2) * dot(flight.start.centre, moved) + dot(moved, moved);
        if (gap > 0) return time - (time - last) * gap / (gap - before);
        before = gap;
        last = time;
    }
    return T(-1);
}

/// A root of the centre's gap from a guess. False if none is found.
template <class T>
[[gnu::always_inline]] inline bool seek_disk_root(const Body<T>& body, const DraggedFlight<T>& flight, T time,
                                                  int& steps, DraggedRoot<T>& root) {
    using std::fabs;
    const T fourth = fourth_bound<Shape::disk>(body, flight);
    while (true) {  // ends: converged, or gives up
        if (!(time > 0 && time <= T(longest_guess)) || ++steps > correction_limit) return false;
        root.moment = dragged_instant<Shape::disk>(flight, time);
        root.gap = centre_gap(body, flight, root.moment);
        root.correction = householder(root.gap);
        if (!(root.gap.rate > 0 && fabs(root.correction) <= T(longest_correction))) return false;
        if (is_converged(root.gap, root.correction, time, fourth)) return time + root.correction > 0;
        time = time + root.correction;
    }
}

/// The usual flight of a disk. False if the root is not found, or not proven the first.
template <class T>
[[gnu::always_inline]] inline bool direct_contact(const Body<T>& body, const DraggedFlight<T>& flight,
                                                  const T& rounding, FirstContact<T>& found, DraggedRoot<T>& root) {
    const CircleGap<T> start = gap_at_start(flight);
    if (!(start.rate < -rounding)) return false;  // it may not leave at all
    if (!seek_disk_root(body, flight, return_guess(start), found.steps, root)) {
        found.steps = 0;
        if (!seek_disk_root(body, flight, sampled_guess(flight), found.steps, root)) return false;
    }
    Gap<T> end = gap_after(root.gap, root.correction);
    end.value = T(0);
    if (!circle_clear<T>(body, flight, start, end, T(0), T(root.moment.at.time + root.correction),
                         centre_sixth(body, flight), most_halvings))
        return false;
    advance<Shape::disk>(flight, root.correction, root.moment);
    found.outcome = FirstContactOutcome::contact;
    found.arm = (body.alpha / body.inner) * root.moment.at.centre;
    return true;
}

/// A root of the vertex nearest to the wall, from a moment on. False if there is none, or it is long before the latest
/// moment of the search (`nearest_share`).
template <class T>
[[gnu::always_inline]] inline bool seek_vertex(const Body<T>& body, const DraggedFlight<T>& flight, int& steps,
                                               Candidate<T>& nearest, DraggedRoot<T>& root) {
    using std::fabs;
    const T fourth = fourth_bound<Shape::polygon>(body, flight);
    while (true) {  // ends: converged, or gives up
        if (++steps > correction_limit) return false;
        const Instant<T>& at = root.moment.at;
        const bool seen = steps > 1 && is_nearest(body, at.centre, body.turned_to_vertex(at.arm, nearest.vertex));
        if (!seen) nearest.vertex = vertex_towards(body, at.centre, at.arm);
        nearest.arm = body.turned_to_vertex(at.arm, nearest.vertex);
        nearest.gap = vertex_gap(body, flight, root.moment, nearest.arm, nearest.vertex);
        root.correction = householder(nearest.gap);
        if (!(nearest.gap.rate > 0 && fabs(root.correction) <= T(longest_correction))) return false;
        const T time = at.time + root.correction;
        if (is_converged(nearest.gap, root.correction, at.time, fourth)) return time > T(0);
        if (!(time > T(0))) return false;
        root.moment = dragged_instant<Shape::polygon>(flight, time);
    }
}

/// Proof that nothing touched between the start and the contact: `clear_by_circumcircle` with this flight's bounds.
template <class T>
[[gnu::always_inline]] inline bool clear_by_circumcircle(const Body<T>& body, const DraggedFlight<T>& flight,
                                                         const CircleGap<T>& start, const Gap<T>& struck,
                                                         const Candidate<T>& striking, const DraggedRoot<T>& root) {
    using std::fabs;
    using std::max;
    const DraggedBounds<T> all = bounds_from<Shape::polygon>(body, flight, flight.stream, flight.start.spin);
    const VertexBounds<T> bounds{all.drift, all.apart, all.vertex_third, centre_sixth(body, flight)};
    const Instant<T>& at = root.moment.at;
    const Gap<T> leaving{circle_gap(body, flight.start.centre), start.rate, start.curvature, start.jerk};
    const ClosedBetween<T> ring =
        closed_between(leaving, centre_gap(body, flight, root.moment), at.time, bounds.centre_sixth);
    const T shift = fabs(root.correction);
    const T in = ring.in + shift;
    const Gap<T>& gap = striking.gap;
    const T rate = gap.rate - shift * (fabs(gap.curvature) + bounds.third * shift);
    const T curvature = gap.curvature + bounds.third * shift;
    const T fastest = T(2) * (bounds.drift + body.alpha * all.spin);
    const T slack = T(32) * epsilon<T>() * (T(1) + fastest) * (T(1) + fastest * at.time) +
                    rate * shift * T(2) * body.side * (bounds.drift + body.outer * all.spin);
    const T longest = max(ring.out, in), distance = body.inner - bounds.drift * shift;
    const Vec2<T> start_drift = flight.stream - quarter_turned(flight.ridden);
    return ring.proven && longest * (all.spin * distance + T(2) * bounds.drift) <= T(0.5) * body.spacing * distance &&
           T(2) * longest * bounds.drift <= distance &&
           only_one_at_wall(body, bounds, flight.start.centre, start_drift, flight.start.spin, flight.start.arm,
                            T(-struck.rate), struck.curvature, ring.out, T(0)) &&
           only_one_at_wall(body, bounds, at.centre, T(-1) * at.drift, T(-root.moment.spin), striking.arm, rate,
                            curvature, in, slack);
}

/// Where the search for the vertex begins: the centre back at its first distance, from a guess.
template <class T>
[[gnu::always_inline]] inline bool moment_of_return(const DraggedFlight<T>& flight, const T& guess,
                                                    DraggedInstant<T>& moment) {
    using std::fabs;
    if (!(guess > 0 && guess <= T(longest_guess))) return false;
    const DraggedInstant<T> near = dragged_instant<Shape::disk>(flight, guess);  // the circle needs no vertex
    const Vec2<T>&moved = near.at.moved, &centre = near.at.centre, &drift = near.at.drift;
    const Gap<T> circle{T(2) * dot(flight.start.centre, moved) + dot(moved, moved), T(2) * dot(centre, drift),
                        T(2) * (dot(drift, drift) + dot(centre, near.acceleration)),
                        T(2) * (T(3) * dot(drift, near.acceleration) + dot(centre, near.jerk))};
    const T closer = householder(circle);
    if (!(fabs(closer) <= T(longest_step) && guess + closer > 0)) return false;
    moment = dragged_instant<Shape::polygon>(flight, T(guess + closer));
    return true;
}

/// The usual flight of a polygon: the circle's return leads to the vertex.
template <class T>
[[gnu::always_inline]] inline bool direct_contact_of_vertex(const Body<T>& body, const DraggedFlight<T>& flight,
                                                            const T& rounding, FirstContact<T>& found,
                                                            DraggedRoot<T>& root) {
    using std::fabs;
    const Gap<T> struck = struck_gap_at_start(flight);
    if (!(struck.rate < -rounding)) return false;  // it may not leave at all
    const CircleGap<T> start = gap_at_start(flight);
    if (!moment_of_return(flight, return_guess(start), root.moment) &&
        !moment_of_return(flight, sampled_guess(flight), root.moment))
        return false;
    Candidate<T> nearest;
    if (!seek_vertex(body, flight, found.steps, nearest, root)) return false;
    const bool is_clear = clear_by_circumcircle(body, flight, start, struck, nearest, root);
    advance<Shape::polygon>(flight, root.correction, root.moment);
    if (!is_clear && !clear_by_derivatives(body, flight, start, struck, nearest, root.moment)) return false;
    found.outcome = FirstContactOutcome::contact;
    found.vertex = nearest.vertex;
    found.arm = body.turned_to_vertex(root.moment.at.arm, nearest.vertex);
    return true;
}

}  // namespace swirl::detail
