
#include <algorithm>
#include <cmath>
// The vertices of a polygon near the wall, and proofs from them, for numbers and for lanes (numbers/vec2_formulas.hpp
// says how).

/// atan2 to 2·10⁻⁶: enough to number the vertices of a polygon that has a table of them.
template <class T>
[[gnu::always_inline]] inline T rough_angle(const T& y, const T& x) {
    using std::fabs;
    using std::max;
    using std::min;
    const T a = fabs(x), b = fabs(y);
    const T t = min(a, b) / max(a, b);
    const T s = t * t, s2 = s * s;
    T angle = t * ((T(0.99997726) - T(0.33262347) * s) +
                   s2 * ((T(0.19354346) - T(0.11643287) * s) + s2 * (T(0.05265332) - T(0.01172120) * s)));
    angle = choose(b > a, T(T(M_PI / 2) - angle), angle);
    angle = choose(x < 0, T(T(M_PI) - angle), angle);
    return choose(y < 0, T(-angle), angle);
}

/// True if no vertex's arm is nearer to X: |X × a| ≤ tan(π/N) X·a.
template <class T>
[[gnu::always_inline]] inline Truth<T> is_nearest(const Body<T>& body, const Vec2<T>& centre, const Vec2<T>& arm) {
    using std::fabs;
    return fabs(cross(arm, centre)) <= body.half_slope * dot(arm, centre);
}

/// g of a vertex whose place is x₀ + d, d = a₀(cis(2πk/N) − 1), from that of the vertex that has struck:
///     g = g₀ + 2x₀·d + |d|².
/// Between neighbours g is of the order of d² where the body lies along the wall; as |x|² − 1 it would be known to ε
/// only, this way to ε|d|, which is what a rounding of χ changes it by.
///   turn  cis(2πk/N) − 1
template <class T>
[[gnu::always_inline]] inline T short_side_value(const Instant<T>& at, const Vec2<T>& turn) {
    const Vec2<T> moved = at.moved + at.arm_moved;
    const Vec2<T> apart = times(at.arm, turn);
    return struck_value(at) + (T(2) * apart.x + dot(apart, apart) + T(2) * dot(moved, apart));
}

/// True if both touch within rounding of the same time. A gap is known to some ε `size` and so its root to that by g′,
/// beside the rounding of the time itself.
template <class T>
[[gnu::always_inline]] inline Truth<T> touch_together(const Gap<T>& first, const Gap<T>& second, const T& time,
                                                      const T& size = T(1)) {
    using std::fabs;
    using std::max;
    // |g₁/g₁′ − g₂/g₂′| ≤ 16ε (size/min g′ + τ), without the divisions
    const T apart = fabs(first.value * second.rate - second.value * first.rate);
    return first.rate > 0 && second.rate > 0 &&
           apart <= T(16) * epsilon<T>() * (size * max(first.rate, second.rate) + first.rate * second.rate * time);
}

/// The gap a small time d later by its own derivatives.
template <class T>
[[gnu::always_inline]] inline Gap<T> gap_after(const Gap<T>& gap, const T& d) {
    const T curvature = gap.curvature + d * gap.jerk;
    return {gap.value + d * (gap.rate + T(0.5) * d * (gap.curvature + fraction<T>(1, 3) * d * gap.jerk)),
            gap.rate + T(0.5) * d * (gap.curvature + curvature), curvature, gap.jerk};
}

/// The circumscribed circle's gap at the start.
template <class T>
[[gnu::always_inline]] inline Gap<T> leaving_gap(const Body<T>& body, const Flight<T>& flight,
                                                 const CircleGap<T>& start) {
    return {circle_gap(body, flight.centre), start.rate, start.curvature, start.jerk};
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
[[gnu::always_inline]] inline Truth<T> two_suffice(const Body<T>& body, const Flight<T>& flight, const T& drift,
                                                   const T& t, const T& distance) {
    using std::fabs;
    return t * (fabs(flight.spin) * distance + T(2) * drift) <= T(0.5) * body.spacing * distance &&
           T(2) * t * drift <= distance;
}

/// Proof for one end of a flight from one vertex alone: for `t` after a moment when the vertex at `arm` is at the wall
/// it stays inside (g′ = −`rate`, g″ ≤ `curvature`), and the one second nearest to the centre's direction, at an angle
/// of 2π/N to it, is farther inside. `drift` = W and `spin` = S; both change sign backwards in time, for a vertex that
/// arrives.
template <class T>
[[gnu::always_inline]] inline Truth<T> only_one_at_wall(const Body<T>& body, const VertexBounds<T>& bounds,
                                                        const Vec2<T>& centre, const Vec2<T>& drift, const T& spin,
                                                        const Vec2<T>& arm, const T& rate, const T& curvature,
                                                        const T& t, const T& slack) {
    using std::copysign;
    using std::fabs;
    const T across = cross(arm, centre);
    const T along = dot(arm, centre);
    const Vec2<T> side = times(arm, Vec2<T>{body.next_turn.x, T(copysign(body.next_turn.y, across))});  // a₂ − a₁
    const T behind = T(2) * dot(centre, side);
    const T slope = T(2) * (dot(drift, side) - spin * cross(centre, side));
    return fabs(across) <= body.half_slope * along && rate > 0 &&
           t * (curvature + fraction<T>(1, 3) * bounds.third * t) <= T(2) * rate && rate * behind + slack <= 0 &&
           rate * (behind + t * (slope + t * bounds.apart)) + slack <= 0;
}

/// Proves that nothing touched between the start and a contact `correction` after `at`, where the vertex at `arm`
/// strikes. Between the ends the circumscribed circle stays clear of the wall but for two short times, and during these
/// only one vertex can be at the wall. False: not proven.
///   arriving, striking  the gaps of the circle and of that vertex at `at`
template <class T>
[[gnu::always_inline]] inline Truth<T> clear_by_circumcircle(const Body<T>& body, const Flight<T>& flight,
                                                             const Gap<T>& leaving, const Gap<T>& arriving,
                                                             const Gap<T>& struck, const Instant<T>& at,
                                                             const Gap<T>& striking, const Vec2<T>& arm,
                                                             const T& correction) {
    using std::fabs;
    using std::max;
    const VertexBounds<T> bounds = vertex_bounds(body, flight);
    const ClosedBetween<T> ring = closed_between(leaving, arriving, at.time, bounds.centre_sixth);
    const T shift = fabs(correction);
    const T in = ring.in + shift;
    // At the contact itself. `slack`: the gap within which `touch_together` calls two times the same, and the motion
    // between `at` and the contact.
    const T rate = striking.rate - shift * (fabs(striking.curvature) + bounds.third * shift);
    const T curvature = striking.curvature + bounds.third * shift;
    const T fastest = T(2) * (bounds.drift + body.alpha * fabs(flight.spin));  // |g′| of any vertex
    const T slack = T(32) * epsilon<T>() * (T(1) + fastest) * (T(1) + fastest * at.time) +
                    rate * shift * T(2) * body.side * (bounds.drift + body.outer * fabs(flight.spin));
    const Vec2<T> start_drift = flight.velocity - quarter_turned(Vec2<T>(flight.beta * flight.phase));
    return ring.proven &&
           two_suffice(body, flight, bounds.drift, max(ring.out, in), T(body.inner - bounds.drift * shift)) &&
           only_one_at_wall(body, bounds, flight.centre, start_drift, flight.spin, flight.arm, T(-struck.rate),
                            struck.curvature, ring.out, T(0)) &&
           only_one_at_wall(body, bounds, at.centre, Vec2<T>{-at.drift.x, -at.drift.y}, T(-flight.spin), arm, rate,
                            curvature, in, slack);
}

/// True if both vertices at either end keep inside where the circle does not prove it (`ring`).
///   third  bounds their |g‴|
template <class T>
[[gnu::always_inline]] inline Truth<T> pairs_keep_inside(const ClosedBetween<T>& ring, const Gap<T>& struck,
                                                         const Gap<T>& other, const Gap<T>& striking,
                                                         const Gap<T>& neighbour, const T& third) {
    return nonpositive_until(struck.value, struck.rate, struck.curvature, ring.out, third) &&
           nonpositive_until(other.value, other.rate, other.curvature, ring.out, third) &&
           nonpositive_until(striking.value, T(-striking.rate), striking.curvature, ring.in, third) &&
           nonpositive_until(neighbour.value, T(-neighbour.rate), neighbour.curvature, ring.in, third);
}
