// Proofs that nothing touched the wall before a contact that was found without guarantee, over a floor that drags: as
// map/first_contact/vertex_proofs.hpp and certain_disk.hpp without.
#pragma once

#include "map/dragged/dragged_bounds.hpp"
#include "map/first_contact/certificate.hpp"
#include "map/first_contact/circle_path.hpp"
#include "map/first_contact/vertex_proofs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl::detail {

/// What is found: a moment so close to a root that `correction`, the way left, needs no further look.
template <class T>
struct DraggedRoot {
    DraggedInstant<T> moment;
    Gap<T> gap;
    T correction{};
};

/// Bounds |g⁽⁶⁾| of any vertex while nothing is outside: |a⁽ᵏ⁾| ≤ αS(S + ½kγ_r)ᵏ⁻¹.
template <class T>
inline T vertex_sixth(const Body<T>& body, const DraggedFlight<T>& flight) {
    using std::fabs;
    const T g = flight.floor.drag, r = flight.floor.spin_drag, b = flight.start.beta;
    const T s = fabs(flight.start.spin), arm = body.alpha * s;
    T u = fabs(flight.stream.x) + fabs(flight.stream.y);
    T bound[7] = {T(1)};
    const T turning[7] = {T(0),
                          T(1),
                          s + r,
                          power<2>(T(s + T(1.5) * r)),
                          power<3>(T(s + T(2) * r)),
                          power<4>(T(s + T(2.5) * r)),
                          power<5>(T(s + T(3) * r))};
    for (int k = 1; k <= 6; ++k) {
        bound[k] = u + b + arm * turning[k];
        u = g * u;
    }
    return T(2) * bound[6] + T(12) * bound[1] * bound[5] + T(30) * bound[2] * bound[4] + T(20) * bound[3] * bound[3];
}

/// A disk's gap between two moments, or on either half of that interval.
template <class T>
bool circle_clear(const Body<T>& body, const DraggedFlight<T>& flight, const Gap<T>& before, const Gap<T>& after,
                  const T& from, const T& to, const T& sixth, int halvings) {
    if (clear_between(before, after, T(to - from), sixth)) return true;
    if (halvings == 0) return false;
    const T time = T(0.5) * (from + to);
    const Gap<T> half_way = centre_gap(body, flight, dragged_instant<Shape::disk>(flight, time));
    return circle_clear(body, flight, before, half_way, from, time, sixth, halvings - 1) &&
           circle_clear(body, flight, half_way, after, time, to, sixth, halvings - 1);
}

template <class T>
inline EveryGap<T> every_gap(const Body<T>& body, const DraggedFlight<T>& flight, const DraggedInstant<T>& moment) {
    EveryGap<T> gaps;
    for (int k = 0; k < body.sides; ++k)
        gaps[static_cast<std::size_t>(k)] =
            vertex_gap(body, flight, moment, body.turned_to_vertex(moment.at.arm, k), k);
    return gaps;
}

/// The neighbour of a vertex on the side of X, at a moment.
template <class T>
inline Gap<T> gap_of_neighbour(const Body<T>& body, const DraggedFlight<T>& flight, const DraggedInstant<T>& moment,
                               int vertex, const Vec2<T>& arm) {
    const int k = body.vertex_number(vertex + (cross(arm, moment.at.centre) >= 0 ? 1 : -1));
    return vertex_gap(body, flight, moment, body.turned_to_vertex(moment.at.arm, k), k);
}

/// Tried where the circumscribed circle proves nothing: both vertices' own derivatives, then the quintics of all.
/// False, too, if the neighbour touches within rounding of the same time.
///   end  the moment of the contact
template <class T>
[[gnu::noinline]] bool clear_by_derivatives(const Body<T>& body, const DraggedFlight<T>& flight,
                                            const CircleGap<T>& circle, const Gap<T>& struck,
                                            const Candidate<T>& nearest, const DraggedInstant<T>& end) {
    const Vec2<T> arm = body.turned_to_vertex(end.at.arm, nearest.vertex);
    if (!is_nearest(body, end.at.centre, arm)) return false;
    Gap<T> striking = vertex_gap(body, flight, end, arm, nearest.vertex);
    striking.value = T(0);
    const Gap<T> neighbour = gap_of_neighbour(body, flight, end, nearest.vertex, arm);
    const T time = end.at.time;
    if (touch_together(striking, neighbour, time)) return false;
    const DraggedInstant<T> start = dragged_instant<Shape::polygon>(flight, T(0));
    const DraggedBounds<T> bounds = bounds_from<Shape::polygon>(body, flight, start);
    const Gap<T> leaving{circle_gap(body, flight.start.centre), circle.rate, circle.curvature, circle.jerk};
    const ClosedBetween<T> ring =
        closed_between(leaving, centre_gap(body, flight, end), time, centre_sixth(body, flight));
    const T longest = std::max(ring.out, ring.in);
    if (ring.proven &&
        longest * (bounds.spin * body.inner + T(2) * bounds.drift) <= T(0.5) * body.spacing * body.inner &&
        T(2) * longest * bounds.drift <= body.inner) {
        const Gap<T> other = gap_of_neighbour(body, flight, start, 0, flight.start.arm);
        if (is_nearest(body, flight.start.centre, flight.start.arm) &&
            pairs_keep_inside(ring, struck, other, striking, neighbour, bounds.vertex_third))
            return true;
    }
    if (body.sides > few_sides) return false;
    EveryGap<T> after = every_gap(body, flight, end);
    T& at_wall = after[static_cast<std::size_t>(nearest.vertex)].value;
    at_wall = std::min(at_wall, T(0));
    const auto gaps_at = [&](const T& t) {
        return every_gap(body, flight, dragged_instant<Shape::polygon>(flight, t));
    };
    return every_vertex_clear(static_cast<std::size_t>(body.sides), gaps_at, every_gap(body, flight, start), after,
                              T(0), time, vertex_sixth(body, flight), most_halvings);
}

}  // namespace swirl::detail
