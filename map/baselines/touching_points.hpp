// What the baselines share: the points that may touch the wall, all of them, and what a start decides by itself.
#pragma once

#include "map/first_contact/first_contact.hpp"

#include <optional>

namespace swirl::detail {

/// How many points may touch: a polygon's vertices; the disk's rim counts as one.
inline int touching_points(const Body<double>& body) {
    return body.sides == disk_sides ? 1 : body.sides;
}

/// The moment τ, from the start.
inline Instant<double> moment_of(const Body<double>& body, const Flight<double>& flight, double time) {
    return body.sides == disk_sides ? instant_at<Shape::disk>(flight, time) : instant_at<Shape::polygon>(flight, time);
}

/// A point that may touch, in units in which the wall is at |x| = 1: a vertex, or X/(1 − α) of the disk.
struct TouchingPoint {
    Vec2<double> position;  ///< x
    Vec2<double> rate;      ///< x′
    double gap;             ///< |x|² − 1; of the vertex that began the flight from its displacement
};

/// Point k, 0 … touching_points − 1, at a moment.
inline TouchingPoint touching_point(const Body<double>& body, const Flight<double>& flight, const Instant<double>& at,
                                    int k) {
    TouchingPoint point;
    Vec2<double> moved;
    if (body.sides == disk_sides) {
        point.position = body.inverse_inner * at.centre;
        point.rate = body.inverse_inner * at.drift;
        moved = body.inverse_inner * at.moved;
    } else {
        const Vec2<double> arm = body.turned_to_vertex(at.arm, k);
        point.position = at.centre + arm;
        point.rate = at.drift + flight.spin * quarter_turned(arm);
        moved = at.moved + at.arm_moved;
    }
    point.gap = k == 0 && flight.struck ? 2 * moved.x + dot(moved, moved) : dot(point.position, point.position) - 1;
    return point;
}

/// True if the circumscribed circle is inside, and so every vertex.
inline bool all_inside(const Body<double>& body, const Instant<double>& at) {
    return body.sides != disk_sides && dot(at.centre, at.centre) < body.inner * body.inner;
}

/// The contact of point k at a moment.
inline FirstContact<double> contact_of(const Body<double>& body, const Instant<double>& at, int k, int steps) {
    FirstContact<double> contact;
    contact.outcome = FirstContactOutcome::contact;
    contact.at = at;
    contact.arm =
        body.sides == disk_sides ? (body.alpha * body.inverse_inner) * at.centre : body.turned_to_vertex(at.arm, k);
    contact.vertex = k;
    contact.steps = steps;
    return contact;
}

/// Nothing found within the work that a search may do.
inline FirstContact<double> given_up(int steps) {
    FirstContact<double> contact;
    contact.outcome = FirstContactOutcome::unresolved;
    contact.steps = steps;
    return contact;
}

/// What is decided at the start, as the exact search decides it: the vertex that began the flight stays on the wall
/// (`sustained`), or a body at rest is out of the container's reach for ever (`no_contact`). Empty if there is a
/// flight to search.
std::optional<FirstContact<double>> decided_at_start(const Body<double>& body, const Flight<double>& flight);

}  // namespace swirl::detail
