// Bounds along a flight over a floor that drags, from a moment on. map/dragged/README.md, "First contact".
//
// |U e^{−γτ}| and S only fall and |h w| is constant, so that from any moment on, with u = |U e^{−γτ}| and b = |h|β
// then,
//     |X′| ≤ u + b      |X″| ≤ γu + b      |X‴| ≤ γ²u + b      |a′| ≤ αS      |a″| ≤ αS(S + γ_r)      …
#pragma once

#include "map/dragged/dragged_flight.hpp"

#include <cmath>

namespace swirl::detail {

/// From a moment to the end of the flight, while nothing is outside.
template <class T>
struct DraggedBounds {
    T drift;         ///< |X′|
    T spin;          ///< |S|
    T centre_third;  ///< |g‴| of the centre's gap
    T vertex_third;  ///< |g‴| of any vertex
    T apart;         ///< half of the second derivative of the difference between neighbours' gaps, 2 X·(a₂ − a₁)
};

template <Shape shape, class T>
[[gnu::always_inline]] inline DraggedBounds<T> bounds_from(const Body<T>& body, const DraggedFlight<T>& flight,
                                                           const Vec2<T>& stream, const T& spin) {
    using std::fabs;
    const T &g = flight.floor.drag, &r = flight.floor.spin_drag;
    const T u = fabs(stream.x) + fabs(stream.y);
    const T b = flight.start.beta;  // |h| ≤ 1
    const T second = g * u + b, third = g * g * u + b;
    DraggedBounds<T> bounds;
    bounds.drift = u + b;
    bounds.spin = fabs(spin);
    bounds.centre_third = T(2) * (T(3) * bounds.drift * second + body.outer * third);
    bounds.vertex_third = bounds.centre_third;
    bounds.apart = T(0);
    if constexpr (shape == Shape::polygon) {
        // (2 X·a)‴ = 2 (X‴·a + 3 X″·a′ + 3 X′·a″ + X·a‴)
        const T s = bounds.spin;
        const T turning = s * (s + r);
        bounds.vertex_third = bounds.centre_third + T(2) * body.alpha *
                                                        (third + s * T(3) * second + T(3) * bounds.drift * turning +
                                                         body.outer * s * (s * (s + T(3) * r) + r * r));
        bounds.apart = body.side * (second + T(2) * s * bounds.drift + turning * body.outer);
    }
    return bounds;
}

template <Shape shape, class T>
[[gnu::always_inline]] inline DraggedBounds<T> bounds_from(const Body<T>& body, const DraggedFlight<T>& flight,
                                                           const DraggedInstant<T>& moment) {
    return bounds_from<shape>(body, flight, moment.stream, moment.spin);
}

/// Bounds |g⁽⁶⁾| of the centre's gap from the start on: Σ C(6, k) |X⁽ᵏ⁾||X⁽⁶⁻ᵏ⁾|, |X⁽ᵏ⁾| ≤ γᵏ⁻¹u + b.
template <class T>
[[gnu::always_inline]] inline T centre_sixth(const Body<T>& body, const DraggedFlight<T>& flight) {
    using std::fabs;
    const T g = flight.floor.drag;
    const T u = fabs(flight.stream.x) + fabs(flight.stream.y);
    const T b = flight.start.beta;
    const T g2 = g * g, g3 = g2 * g;
    const T first = u + b, second = g * u + b, third = g2 * u + b, fourth = g3 * u + b, fifth = g2 * g2 * u + b,
            sixth = g2 * g3 * u + b;
    return T(2) * body.outer * sixth + T(12) * first * fifth + T(30) * second * fourth + T(20) * third * third;
}

}  // namespace swirl::detail
