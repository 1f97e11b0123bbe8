// Moments of a flight and the gaps then, for numbers and for lanes (numbers/vec2_formulas.hpp says how).

/// The start of a flight.
template <class T>
struct Flight {
    Vec2<T> centre;       ///< X₀
    Vec2<T> velocity;     ///< V, in the laboratory
    Vec2<T> phase;        ///< cis φ₀, the direction of the swirl's arm
    Vec2<T> arm;          ///< a₀: from the centre to the reference vertex (disk: to the rim's point on the wall)
    T spin{};             ///< S
    T beta{};             ///< β, the length of the swirl's arm
    bool struck = false;  ///< the reference vertex has just struck: X₀ + a₀ = (1, 0), its gap is zero by identity
};

/// A moment of a flight.
template <class T>
struct Instant {
    T time{};           ///< τ
    Vec2<T> phase;      ///< cis(φ₀ + τ)
    Vec2<T> arm;        ///< a of the reference vertex; not set for the disk
    Vec2<T> moved;      ///< X − X₀
    Vec2<T> arm_moved;  ///< a − a₀; not set for the disk
    Vec2<T> centre;     ///< X
    Vec2<T> swirl;      ///< w; the centre's acceleration in the container's frame, X″ = w
    Vec2<T> drift;      ///< W = X′ = V − i w
};

/// Fills in what follows from `moved` and `phase`.
template <class T>
[[gnu::always_inline]] inline void complete(const Flight<T>& flight, Instant<T>& at) {
    at.centre = flight.centre + at.moved;
    at.swirl = flight.beta * at.phase;
    at.drift = flight.velocity - quarter_turned(at.swirl);
}

/// The start itself.
template <class T>
[[gnu::always_inline]] inline Instant<T> instant_at_start(const Flight<T>& flight) {
    Instant<T> at;
    at.phase = flight.phase;
    at.arm = flight.arm;
    at.centre = flight.centre;
    at.swirl = flight.beta * flight.phase;
    at.drift = flight.velocity - quarter_turned(at.swirl);
    return at;
}

/// The moment τ, from the start; `turn` = E(τ).
template <Shape shape, class T>
[[gnu::always_inline]] inline Instant<T> instant_at(const Flight<T>& flight, const T& time, const Vec2<T>& turn) {
    Instant<T> at;
    at.time = time;
    at.moved = time * flight.velocity - flight.beta * times(flight.phase, turn);
    at.phase = turned(flight.phase, turn);
    complete(flight, at);
    if constexpr (shape == Shape::polygon) {
        at.arm_moved = times(flight.arm, cis_minus_one(T(flight.spin * time)));
        at.arm = flight.arm + at.arm_moved;
    }
    return at;
}

/// The moment τ, from the start.
template <Shape shape, class T>
[[gnu::always_inline]] inline Instant<T> instant_at(const Flight<T>& flight, const T& time) {
    return instant_at<shape>(flight, time, cis_minus_one(time));
}

/// The moment `step` later (or earlier, if negative).
template <Shape shape, class T>
[[gnu::always_inline]] inline void advance(const Flight<T>& flight, Instant<T>& at, const T& step) {
    const Vec2<T> turn = cis_minus_one(step);
    at.time = at.time + step;
    at.moved = at.moved + (step * flight.velocity - times(at.swirl, turn));
    at.phase = turned(at.phase, turn);
    complete(flight, at);
    if constexpr (shape == Shape::polygon) {
        const Vec2<T> arm_step = times(at.arm, cis_minus_one(T(flight.spin * step)));
        at.arm = at.arm + arm_step;
        at.arm_moved = at.arm_moved + arm_step;
    }
}

/// The disk's moment a tiny step later, to third order of the step: no series, and little left to do after it is known.
template <class T>
[[gnu::always_inline]] inline void advance_slightly(const Flight<T>& flight, Instant<T>& at, const T& step) {
    const T half = T(0.5) * step * step;
    at.time = at.time + step;
    at.moved = at.moved + (step * at.drift + half * at.swirl);
    at.phase = turned(at.phase, Vec2<T>{-half, step});
    complete(flight, at);
}

/// A gap and its first three derivatives in time.
template <class T>
struct Gap {
    T value;      ///< g
    T rate;       ///< g′
    T curvature;  ///< g″
    T jerk;       ///< g‴
};

/// |X|² − (1 − α)²: a disk's gap, and that of a polygon's circumscribed circle.
template <class T>
[[gnu::always_inline]] inline T circle_gap(const Body<T>& body, const Vec2<T>& centre) {
    return dot(centre, centre) - body.inner * body.inner;
}

/// That gap with its derivatives, where it has the value `value`. X″ = w, X‴ = i w.
template <class T>
[[gnu::always_inline]] inline Gap<T> centre_gap_of(const T& value, const Instant<T>& at) {
    return {value, T(2) * dot(at.centre, at.drift), T(2) * (dot(at.drift, at.drift) + dot(at.centre, at.swirl)),
            T(2) * (T(3) * dot(at.drift, at.swirl) - cross(at.centre, at.swirl))};
}

/// g = |x|² − 1 of the vertex at x = X + a; x′ = W + iSa, x″ = w − S²a, x‴ = i(w − S³a).
template <class T>
[[gnu::always_inline]] inline Gap<T> vertex_gap(const Flight<T>& flight, const Instant<T>& at, const Vec2<T>& arm) {
    const T spin2 = flight.spin * flight.spin;
    const Vec2<T> x = at.centre + arm;
    const Vec2<T> rate = at.drift + flight.spin * quarter_turned(arm);
    const Vec2<T> acceleration = at.swirl - spin2 * arm;
    const Vec2<T> jerk = quarter_turned(at.swirl - (spin2 * flight.spin) * arm);
    return {dot(x, x) - T(1), T(2) * dot(x, rate), T(2) * (dot(rate, rate) + dot(x, acceleration)),
            T(2) * (T(3) * dot(rate, acceleration) + dot(x, jerk))};
}

/// g of the vertex that began the flight: |(1, 0) + d|² − 1 = 2 d_x + |d|², with d what it has moved.
template <class T>
[[gnu::always_inline]] inline T struck_value(const Instant<T>& at) {
    const Vec2<T> moved = at.moved + at.arm_moved;
    return T(2) * moved.x + dot(moved, moved);
}

/// Its gap with the derivatives at the start, where it is at (1, 0).
template <class T>
[[gnu::always_inline]] inline Gap<T> struck_gap_at_start(const Flight<T>& flight) {
    const Vec2<T> swirl = flight.beta * flight.phase;
    const Vec2<T> rate = flight.velocity + quarter_turned(Vec2<T>(flight.spin * flight.arm - swirl));
    const T spin2 = flight.spin * flight.spin;
    const Vec2<T> acceleration = swirl - spin2 * flight.arm;
    return {T(0), T(2) * rate.x, T(2) * (dot(rate, rate) + acceleration.x),
            T(2) * (T(3) * dot(rate, acceleration) - (swirl.y - spin2 * flight.spin * flight.arm.y))};
}
