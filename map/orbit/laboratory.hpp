// The laboratory's frame: starts given there, and orbits of the section followed back into it.
#pragma once

#include "map/collision_map.hpp"
#include "map/numbers/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace swirl {

/// A start in the laboratory at t = 0, when the container's centre is at (β, 0).
template <class T = double>
struct LabStart {
    T x{}, y{};    ///< the body's centre, in R_c, from the swirl's centre
    T vx{}, vy{};  ///< its velocity, in R_c ω_s
    T angle{};     ///< vertex 0's direction, in radians
    T spin{};      ///< S
};

/// In the body's units (Body::unit).
/// @throws std::invalid_argument if a vertex is outside the container, or the disk or a rounded corner overlaps its
/// wall
template <class T>
Flight<T> flight_from(const Body<T>& body, const LabStart<T>& start) {
    using std::sqrt;
    const T* values[] = {&start.x, &start.y, &start.vx, &start.vy, &start.angle, &start.spin};
    const char* names[] = {"x", "y", "vx", "vy", "angle", "spin"};
    for (int i = 0; i < 6; ++i) detail::require_finite(names[i], *values[i]);
    detail::require_speed(speed_of(body, start.vx, start.vy, start.spin));
    Flight<T> flight;
    const bool rounded = body.corner != T(0);
    flight.centre =
        rounded ? Vec2<T>{start.x / body.unit - body.beta, start.y / body.unit} : Vec2<T>{start.x - body.beta, start.y};
    flight.velocity = rounded ? Vec2<T>{start.vx / body.unit, start.vy / body.unit} : Vec2<T>{start.vx, start.vy};
    flight.phase = {T(1), T(0)};
    flight.beta = body.beta;
    flight.arm = body.alpha * cis(start.angle);
    flight.spin = start.spin;
    T reach = detail::magnitude(flight.centre) + body.alpha;
    if (body.sides != disk_sides && reach > T(1)) {
        detail::NearestTwo<T> pair;
        detail::look_around(body, flight, instant_at_start(flight), pair);
        reach = sqrt(std::max(pair.first.gap.value, pair.second.gap.value) + T(1));
    }
    if (rounded && reach > T(1)) reach = body.unit * (reach + body.corner);
    if (reach > T(1))
        detail::out_of_range("start: distance of the farthest point from the container's centre", reach, "at most 1");
    return flight;
}

/// An angle kept as (its value in [0, 2π), whole turns), so that precision does not decay on long runs: the sum of any
/// number of changes is off by their own errors and by one rounding.
template <class T>
struct WoundAngle {
    T phase{};
    T turns{};       ///< an integer, held in T: the times of a decaying orbit (β = 0, e < 1) exceed every integer type
    T more_turns{};  ///< what rounding left out of it beyond 2⁵³ turns, where one turn more may not change it
    T more_phase{};  ///< what rounding left out of `phase`

    void add(const T& change) {
        using std::fmod;
        using std::round;
        const ExactSum<T> sum = exact_sum(phase, change);
        phase = fmod(sum.sum, turn());  // exact, however many turns
        more_phase = more_phase + sum.rest;
        wind(round((sum.sum - phase) / turn()));
        if (phase < 0) unwind_by(T(-1));
        if (!(phase < turn())) unwind_by(T(1));  // −tiny + 2π rounds to 2π …
        if (phase < 0) {                         // … and is −tiny again: within rounding of a whole turn
            more_phase = more_phase + phase;
            phase = T(0);
        }
    }
    /// The whole angle, which grows with `phase` and `turns`. Beyond 10⁶ turns it is rounded once: two roundings may be
    /// longer than a flight, and time would fall by one.
    T unwound() const {
        using std::fabs;
        const T whole = turn() * turns;
        const T rest = rest_of_turn() * turns;
        if constexpr (std::is_floating_point_v<T>)
            if (fabs(turns) > T(1 << 20))
                return whole + (phase + ((std::fma(turn(), turns, -whole) + turn() * more_turns) + rest));
        return (phase + rest) + whole;
    }

private:
    static T turn() { return T(2 * pi<T>()); }
    /// 2π less its rounding: sin is −x near a whole turn. Without it the phase would lose 2.4·10⁻¹⁶ a turn in double.
    static T rest_of_turn() {
        using std::sin;
        return T(-sin(turn()));
    }

    /// Counts turns whose rounded length the phase is without.
    void wind(const T& more) {
        using std::fmod;
        if (more != 0) more_phase = more_phase - fmod(T(more * rest_of_turn()), turn());
        const ExactSum<T> in_all = exact_sum(turns, T(more_turns + more));
        turns = in_all.sum;
        more_turns = in_all.rest;
        const ExactSum<T> total = exact_sum(phase, more_phase);
        phase = total.sum;
        more_phase = total.rest;
    }
    /// Takes one turn from the phase, or adds one to it.
    void unwind_by(const T& one) {
        const ExactSum<T> total = exact_sum(phase, T(-one * turn()));
        phase = total.sum;
        more_phase = more_phase + total.rest;
        wind(one);
    }
};

/// Where an orbit of the section is in the laboratory.
template <class T>
struct LabFrame {
    WoundAngle<T> time;   ///< t: (swirl phase, turns)
    WoundAngle<T> angle;  ///< vertex 0's direction
    int vertex = 0;       ///< the vertex that struck last
    T direction{};        ///< of the axes that the next flight begins in: arg n of the last contact

    /// Flights longer than this: rounding of t is a thousand times that of an angle.
    static T long_flight() { return T(1024); }

    /// A start in flight.
    static LabFrame at_start(const T& angle) {
        LabFrame frame;
        frame.angle.add(angle);
        return frame;
    }
    /// A start on the section: t = 0 and vertex 0 has just struck.
    static LabFrame at_section(const SectionPoint<T>& z) {
        LabFrame frame = at_start(T(z.psi + z.chi));
        frame.direction = z.psi;
        return frame;
    }

    /// Advances to a collision; `turned` is ∫S dt since the one before.
    template <class Map>
    void follow(const Map& map, const Collision<T>& collision, const T& turned) {
        using std::atan2;
        const SectionPoint<T> z = section_point(collision.after);
        time.add(collision.flight_time);
        if (collision.flight_time > long_flight()) {
            // The rounding of so long a time spoils the swirl's phase: it is taken from the new contact, ψ = arg n − t.
            const T phase = direction + atan2(collision.normal.y, collision.normal.x) - z.psi;
            time.add(wrapped_angle(T(phase - time.phase)));
        }
        direction = time.phase + z.psi;
        angle.add(turned);
        if constexpr (Map::shape == Shape::polygon) {
            vertex = map.body().vertex_number(static_cast<long long>(vertex) + collision.vertex_step);
            // arg r − 2πk/N is vertex 0's direction too, and free of the sum's accumulated rounding.
            const T measured = time.phase + z.psi + z.chi - map.body().spacing * T(vertex);
            angle.add(wrapped_angle(T(measured - angle.phase)));
        }
    }
};

/// The state just after an impact, in the laboratory. t and the angle are unwound: when they are large they are known
/// to a few ε of themselves only, which may be a large angle. The last four keep every digit.
template <class T>
struct LabState {
    T t{}, x{}, y{}, vx{}, vy{}, angle{}, spin{};
    WoundAngle<T> time, direction;  ///< t and the angle of vertex 0 as (angle in [0, 2π), whole turns)
};

template <class T>
LabState<T> lab_state(const Body<T>& body, const LabFrame<T>& frame, const PostImpactState<T>& post_impact) {
    const Vec2<T> swirl = cis(frame.time.phase);
    const Vec2<T> n = times(swirl, post_impact.psi);
    const Vec2<T> r = body.alpha * times(n, post_impact.chi);
    const Vec2<T> velocity = times(n, Vec2<T>{post_impact.vn, post_impact.vt});
    const Vec2<T> own = body.beta * swirl + (n - r);
    const Vec2<T> position = body.corner == T(0) ? own : body.unit * own;
    return {frame.time.unwound(),  position.x,       position.y, velocity.x, velocity.y,
            frame.angle.unwound(), post_impact.spin, frame.time, frame.angle};
}

}  // namespace swirl
