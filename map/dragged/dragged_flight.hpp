// Flight over a floor that drags, in closed form. map/dragged/README.md, "Flight".
//
// With h, D and E(τ) = cis τ − 1 as there, w the swirl's arm and U = V₀ − γh w₀ (a table: V₀)
//     X(τ) = X₀ + U D(τ) − h w₀ E(τ)      X′ = U e^{−γτ} − i h w      a(τ) = a₀ cis(S₀ D_r(τ))      S = S₀ e^{−γ_r τ}
// X the body's centre from the container's, a the arm to a vertex: a flight without drag, but for D and h.
#pragma once

#include "map/first_contact/vertices.hpp"
#include "map/model/flight.hpp"
#include "map/model/floor_drag.hpp"
#include "map/numbers/turn.hpp"

#include <cmath>
#include <type_traits>

namespace swirl {

/// The start of a flight and what is constant on it. `start.beta` is β.
template <class T>
struct DraggedFlight {
    Flight<T> start;
    FloorDrag<T> floor;
    Vec2<T> stream;  ///< U: what of the velocity decays
    Vec2<T> ridden;  ///< h w₀: the arm of the circle on which the body is left
};

template <class T>
[[gnu::always_inline]] inline DraggedFlight<T> dragged_flight(const FloorDrag<T>& floor, const Flight<T>& start) {
    const Vec2<T> swirl = start.beta * start.phase;
    return {start, floor, start.velocity - times(floor.carrying, swirl), times(floor.response, swirl)};
}

/// A moment of it.
template <class T>
struct DraggedInstant {
    Instant<T> at;               ///< time, places, the swirl's arm w, `drift` X′
    T length{};                  ///< D(τ)
    T spin_length{};             ///< D_r(τ)
    T decay{}, spin_decay{};     ///< e^{−γτ}, e^{−γ_r τ}
    Vec2<T> stream;              ///< U e^{−γτ}
    Vec2<T> ridden;              ///< h w
    Vec2<T> acceleration, jerk;  ///< X″, X‴
    T spin{};                    ///< S
};

/// e^y − 1 for y ≤ 0: in double down to −½ by Taylor's polynomial, whose first term left out is below 2⁻⁵³ of the sum
/// and which takes a third of the library's time.
template <class T>
[[gnu::always_inline]] inline T lost_until(const T& y) {
    using std::expm1;
    if constexpr (std::is_same_v<T, double>) {
        if (y >= -0.5) {
            const double y2 = y * y, y4 = y2 * y2, y8 = y4 * y4;
            const double low = (1 + y * 0.5) + y2 * (1.0 / 6 + y * (1.0 / 24));
            const double middle = (1.0 / 120 + y * (1.0 / 720)) + y2 * (1.0 / 5040 + y * (1.0 / 40320));
            const double high = (1.0 / 362880 + y * (1.0 / 3628800)) + y2 * (1.0 / 39916800 + y * (1.0 / 479001600)) +
                                y4 * (1.0 / 6227020800 + y * (1.0 / 87178291200));
            return y * (low + (y4 * middle + y8 * high));
        }
    }
    return expm1(y);
}

/// e^{−rate τ} − 1 of both rates at once where they are equal, as they are by default.
template <class T>
[[gnu::always_inline]] inline void decay_until(const FloorDrag<T>& floor, const T& time, DraggedInstant<T>& moment) {
    const auto decay = [&time](const T& rate, T& length, T& left) {
        if (!(rate > T(0))) {
            length = time;
            left = T(1);
            return;
        }
        const T lost = lost_until(T(-rate * time));
        length = -lost / rate;
        left = T(1) + lost;
    };
    decay(floor.drag, moment.length, moment.decay);
    if (floor.spin_drag == floor.drag) {
        moment.spin_length = moment.length;
        moment.spin_decay = moment.decay;
    } else {
        decay(floor.spin_drag, moment.spin_length, moment.spin_decay);
    }
}

/// The moment τ, of which D and E are known.
template <Shape shape, class T>
[[gnu::always_inline]] inline void complete(const DraggedFlight<T>& flight, const Vec2<T>& turn,
                                            DraggedInstant<T>& moment) {
    Instant<T>& at = moment.at;
    const T& drag = flight.floor.drag;
    at.moved = moment.length * flight.stream - times(flight.ridden, turn);
    at.phase = turned(flight.start.phase, turn);
    at.centre = flight.start.centre + at.moved;
    at.swirl = flight.start.beta * at.phase;
    moment.stream = moment.decay * flight.stream;
    moment.ridden = turned(flight.ridden, turn);
    const Vec2<T> slowing = drag * moment.stream;
    at.drift = moment.stream - quarter_turned(moment.ridden);
    moment.acceleration = moment.ridden - slowing;
    moment.jerk = quarter_turned(moment.ridden) + drag * slowing;
    if constexpr (shape == Shape::polygon) {
        at.arm_moved = times(flight.start.arm, cis_minus_one(T(flight.start.spin * moment.spin_length)));
        at.arm = flight.start.arm + at.arm_moved;
        moment.spin = moment.spin_decay * flight.start.spin;
    }
}

/// Cost: one or two expm1, two rotations (a disk: one).
template <Shape shape, class T>
[[gnu::always_inline]] inline DraggedInstant<T> dragged_instant(const DraggedFlight<T>& flight, const T& time) {
    DraggedInstant<T> moment;
    moment.at.time = time;
    decay_until(flight.floor, time, moment);
    complete<shape>(flight, cis_minus_one(time), moment);
    return moment;
}

/// V in the laboratory, and V′.
template <class T>
[[gnu::always_inline]] inline Vec2<T> laboratory_velocity(const DraggedFlight<T>& flight,
                                                          const DraggedInstant<T>& moment) {
    return moment.stream + times(flight.floor.carrying, moment.at.swirl);
}

/// The flight as the impact at its end needs it: with the velocities there.
template <class T>
[[gnu::always_inline]] inline Flight<T> arriving(const DraggedFlight<T>& flight, const DraggedInstant<T>& moment) {
    Flight<T> end = flight.start;
    end.velocity = laboratory_velocity(flight, moment);
    end.spin = moment.spin_decay * flight.start.spin;
    return end;
}

/// The disk's gap, and that of a polygon's circumscribed circle. Of a body that began on the wall, by what it has
/// moved: |X|² − (1 − α)² = g₀ + 2X₀·d + |d|², g₀ = 0 of a disk and 2(α − a₀ₓ) of a polygon's circle.
template <class T>
[[gnu::always_inline]] inline T centre_value(const Body<T>& body, const Flight<T>& start, const Instant<T>& at) {
    if (!start.struck) return circle_gap(body, at.centre);
    if (body.sides == disk_sides) return T(2) * (body.unbiased_inner * at.moved.x) + dot(at.moved, at.moved);
    const Vec2<T>& arm = start.arm;
    const T at_start = T(2) * (arm.x > T(0) ? T(arm.y * arm.y / (body.alpha + arm.x)) : T(body.alpha - arm.x));
    return at_start + (T(2) * dot(start.centre, at.moved) + dot(at.moved, at.moved));
}

/// With its derivatives.
template <class T>
[[gnu::always_inline]] inline Gap<T> centre_gap(const Body<T>& body, const DraggedFlight<T>& flight,
                                                const DraggedInstant<T>& moment) {
    const Instant<T>& at = moment.at;
    return {centre_value(body, flight.start, at), T(2) * dot(at.centre, at.drift),
            T(2) * (dot(at.drift, at.drift) + dot(at.centre, moment.acceleration)),
            T(2) * (T(3) * dot(at.drift, moment.acceleration) + dot(at.centre, moment.jerk))};
}

/// g = |x|² − 1 of a vertex at X + a, with a′ = iSa, a″ = −(S² + iγ_rS)a, a‴ = (3γ_rS² + i(γ_r²S − S³))a.
///   value  g itself
template <class T>
[[gnu::always_inline]] inline Gap<T> vertex_gap(const DraggedFlight<T>& flight, const DraggedInstant<T>& moment,
                                                const Vec2<T>& arm, const T& value) {
    const Instant<T>& at = moment.at;
    const T &s = moment.spin, &slowing = flight.floor.spin_drag;
    const Vec2<T> across = quarter_turned(arm);
    const Vec2<T> x = at.centre + arm;
    const Vec2<T> rate = at.drift + s * across;
    const Vec2<T> acceleration = moment.acceleration - s * (s * arm + slowing * across);
    const Vec2<T> jerk = moment.jerk + s * (T(3) * slowing * s * arm + (slowing * slowing - s * s) * across);
    return {value, T(2) * dot(x, rate), T(2) * (dot(rate, rate) + dot(x, acceleration)),
            T(2) * (T(3) * dot(rate, acceleration) + dot(x, jerk))};
}

/// g by the vertex's number from the one that began the flight, whose gap is exact to rounding.
template <class T>
[[gnu::always_inline]] inline T vertex_value(const Body<T>& body, const Flight<T>& start, const Instant<T>& at,
                                             const Vec2<T>& arm, int vertex) {
    if (start.struck && vertex == 0) return struck_value(at);
    if (start.struck && body.short_sides) return detail::short_side_gap(body, at, vertex);
    const Vec2<T> x = at.centre + arm;
    return (dot(x, x) - T(1)) + T(2) * dot(x, body.residual_of_vertex(at.arm, vertex));
}

/// With its derivatives.
template <class T>
[[gnu::always_inline]] inline Gap<T> vertex_gap(const Body<T>& body, const DraggedFlight<T>& flight,
                                                const DraggedInstant<T>& moment, const Vec2<T>& arm, int vertex) {
    return vertex_gap(flight, moment, arm, vertex_value(body, flight.start, moment.at, arm, vertex));
}

}  // namespace swirl
