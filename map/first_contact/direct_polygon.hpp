// The usual flight of a polygon from wall to wall: a root sought without guarantee, then the proof that it is the
// first.
#pragma once

#include "map/first_contact/certificate.hpp"
#include "map/first_contact/circle_path.hpp"
#include "map/first_contact/vertex_proofs.hpp"
#include "map/first_contact/vertices.hpp"

#include <algorithm>
#include <cmath>

namespace swirl {

namespace detail {

/// Corrections of the guess beyond this are rejected; radians of swirl.
inline constexpr double longest_step = 0.125;

/// A contact before this share of the latest moment of its search is not taken: what the body has moved was summed up
/// on the way there and back, so that its rounding is that of the longer way.
inline constexpr double nearest_share = 0.25;

/// Where the search for the vertex begins: the centre back at its first distance. False if that is not found.
///   latest  the latest moment of the search so far
template <class T>
[[gnu::always_inline]] inline bool instant_of_return(const Flight<T>& flight, const CirclePath<T>& path,
                                                     const CircleGap<T>& leaving, Instant<T>& at, T& latest) {
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
    at = instant_after(flight, near, cis_minus_one(T(flight.spin * near.time)), closer);
    latest = std::max(near.time, at.time);
    return true;
}

/// From there to a moment so close to the contact of the vertex nearest to the wall that `correction`, the way left,
/// needs no further look. False if there is none, or it lies too long before the `latest` moment of the search
/// (`nearest_share`).
template <Sides sides, class T>
[[gnu::always_inline]] inline bool seek_vertex(const Body<T>& body, const Flight<T>& flight, T& latest, Instant<T>& at,
                                               Candidate<T>& nearest, T& correction, int& steps) {
    using std::fabs;
    const T fourth = derivative_bounds<4, Shape::polygon>(body, flight).vertex;
    while (true) {  // ends: converged, or gives up
        if (++steps > correction_limit) return false;
        // Nearly always the one of the look before: that is quicker to see than the nearest to find.
        const bool seen = steps > 1 && is_nearest(body, at.centre, body.turned_to_vertex(at.arm, nearest.vertex));
        if (!seen) nearest.vertex = vertex_towards(body, at.centre, at.arm);
        nearest.arm = body.turned_to_vertex(at.arm, nearest.vertex);
        nearest.gap = gap_of<sides>(body, flight, at, nearest);
        const Gap<T>& g = nearest.gap;
        correction = householder(g);
        if (!(g.rate > 0 && fabs(correction) <= T(longest_correction))) return false;
        if (is_converged(g, correction, at.time, fourth)) return at.time + correction > T(nearest_share) * latest;
        advance<Shape::polygon>(flight, at, correction);
        latest = std::max(latest, at.time);
    }
}

/// The moment `correction` after `at`, at which `vertex` strikes.
template <class T>
[[gnu::always_inline]] inline void strike_after(const Body<T>& body, const Flight<T>& flight, Instant<T>& at,
                                                const T& correction, int vertex, FirstContact<T>& contact) {
    advance<Shape::polygon>(flight, at, correction);
    contact.outcome = FirstContactOutcome::contact;
    contact.at = at;
    contact.vertex = vertex;
    contact.arm = body.turned_to_vertex(at.arm, vertex);
}

/// The circle's return leads to the vertex nearest to the wall there; its root is sought, then the whole flight proven
/// clear. False if anything fails; the two searches below and the advance by safe steps then decide.
template <Sides sides, class T>
[[gnu::always_inline]] inline bool direct_contact_polygon(const Body<T>& body, const Flight<T>& flight,
                                                          FirstContact<T>& contact) {
    const CirclePath<T> path = circle_path(flight, Vec2<T>(flight.beta * flight.phase));
    const CircleGap<T> start = gap_at_start(path);
    Instant<T> at;
    Candidate<T> nearest;
    T correction, latest;
    if (!instant_of_return(flight, path, start, at, latest)) return false;
    if (!seek_vertex<sides>(body, flight, latest, at, nearest, correction, contact.steps)) return false;

    const Gap<T> struck = struck_gap_at_start(flight);
    if (!(struck.rate < -rate_rounding(body, flight))) return false;  // it may not leave at all
    const Gap<T> leaving = leaving_gap(body, flight, start);
    if (!clear_by_circumcircle(body, flight, leaving, centre_gap(body, flight, at), struck, at, nearest.gap,
                               nearest.arm, correction)) [[unlikely]] {
        const Instant<T> here = at;  // copies, so that the others stay in registers
        const Candidate<T> vertex = nearest;
        if (!clear_by_derivatives(body, flight, leaving, struck, here, vertex, T(correction))) return false;
    }
    strike_after(body, flight, at, correction, nearest.vertex, contact);
    return true;
}

/// The same of a polygon whose sides are short.
/// @return `no_contact` if anything fails
template <class T>
[[gnu::noinline]] FirstContact<T> direct_contact_of_short_sides(const Body<T>& body, const Flight<T>& flight) {
    FirstContact<T> contact;
    direct_contact_polygon<Sides::any>(body, flight, contact);
    return contact;
}

/// What the proofs need of a start.
template <class T>
struct StartOnTheWall {
    CirclePath<T> path;
    CircleGap<T> circle;
    Gap<T> struck;
};

template <class T>
[[gnu::always_inline]] inline StartOnTheWall<T> start_on_the_wall(const Flight<T>& flight) {
    const CirclePath<T> path = circle_path(flight, Vec2<T>(flight.beta * flight.phase));
    return {path, gap_at_start(path), struck_gap_at_start(flight)};
}

/// A vertex has struck, and leaves with a normal velocity beyond rounding.
template <class T>
[[gnu::always_inline]] inline bool starts_off_the_wall(const Body<T>& body, const Flight<T>& flight,
                                                       const StartOnTheWall<T>& start) {
    return flight.struck && start.struck.rate < -rate_rounding(body, flight);
}

/// The contact of one vertex, `next.vertex`: its root is sought from a moment on, and the whole flight proven clear.
///   latest  the latest moment of the search so far; no contact long before it is taken (`nearest_share`)
/// `contact` stays without one where the root is not found, or not proven the first.
template <class T>
[[gnu::always_inline]] inline void strike_by_vertex(const Body<T>& body, const Flight<T>& flight,
                                                    const StartOnTheWall<T>& start, T& latest, Instant<T>& at,
                                                    Candidate<T>& next, FirstContact<T>& contact) {
    using std::fabs;
    const T fourth = derivative_bounds<4, Shape::polygon>(body, flight).vertex;
    for (int look = 1; look <= correction_limit; ++look) {
        ++contact.steps;
        next.arm = body.turned_to_vertex(at.arm, next.vertex);
        next.gap = gap_of(body, flight, at, next);
        const Gap<T>& g = next.gap;
        const T correction = householder(g);
        if (!(g.rate > 0 && fabs(correction) <= T(longest_correction))) return;
        if (is_converged(g, correction, at.time, fourth)) {
            if (at.time + correction > T(nearest_share) * latest &&
                clear_by_derivatives(body, flight, leaving_gap(body, flight, start.circle), start.struck, at, next,
                                     correction))
                strike_after(body, flight, at, correction, next.vertex, contact);
            return;
        }
        advance<Shape::polygon>(flight, at, correction);
        latest = std::max(latest, at.time);
    }
}

/// The vertex that comes to where another is now, by the spin.
template <class T>
[[gnu::always_inline]] inline int vertex_behind(const Body<T>& body, const Flight<T>& flight, int vertex) {
    return body.vertex_number(vertex + (flight.spin > 0 ? -1 : 1));
}

/// Where the circle returns but the vertex nearest to the wall recedes, the one behind it comes next: its root is
/// sought from that moment on. For flights that keep near the wall, which the search above does not decide.
/// @return `no_contact` if the flight is none of these, or the root is not found, or not proven the first
template <class T>
[[gnu::noinline]] FirstContact<T> contact_of_vertex_behind(const Body<T>& body, const Flight<T>& flight) {
    FirstContact<T> contact;
    const StartOnTheWall<T> start = start_on_the_wall(flight);
    if (!starts_off_the_wall(body, flight, start)) return contact;
    Instant<T> at;
    Candidate<T> next;
    T correction, latest;
    if (!instant_of_return(flight, start.path, start.circle, at, latest)) return contact;
    if (seek_vertex<Sides::any>(body, flight, latest, at, next, correction, contact.steps) || !(next.gap.rate <= 0))
        return contact;
    next.vertex = vertex_behind(body, flight, next.vertex);
    strike_by_vertex(body, flight, start, latest, at, next, contact);
    return contact;
}

/// The vertex behind the one that has struck, sought from the start: it may strike before the circle returns, or the
/// circle may not return at all. Of the flights of a chaotic hexagon that both searches above leave it decides two
/// thirds.
/// @return `no_contact` if the root is not found, or not proven the first
template <class T>
[[gnu::noinline]] FirstContact<T> contact_of_next_vertex(const Body<T>& body, const Flight<T>& flight) {
    FirstContact<T> contact;
    const StartOnTheWall<T> start = start_on_the_wall(flight);
    if (!starts_off_the_wall(body, flight, start)) return contact;
    Instant<T> at = instant_at_start(flight);
    Candidate<T> next;
    T latest(0);
    next.vertex = vertex_behind(body, flight, 0);
    strike_by_vertex(body, flight, start, latest, at, next, contact);
    return contact;
}

}  // namespace detail

}  // namespace swirl
