
#include <cmath>
// The centre's gap along a flight as a function of time, its Taylor polynomial and the root of that, for numbers and
// for lanes (numbers/vec2_formulas.hpp says how).

/// c[k] = g⁽ᵏ⁾/k!.
template <class T>
struct GapSeries {
    T c[11];
};

/// A root of the polynomial: `first` + `second` after its moment, `second` being the smaller by far.
template <class T>
struct SeriesRoot {
    T first, second;
    T value, rate;     ///< g and g′ at `first`
    T half_curvature;  ///< ½g″ there
};

/// Householder's correction of third order, δ = −g (g′² − ½gg″) / (g′³ − gg′g″ + g²g‴/6): the error d becomes O(d⁴).
template <class T>
[[gnu::always_inline]] inline T householder(const T& value, const T& rate, const T& half_curvature,
                                            const T& sixth_jerk) {
    const T square = rate * rate;
    const T curvature = half_curvature + half_curvature;
    return -(value * (square - value * half_curvature)) /
           (rate * (square - value * curvature) + value * (value * sixth_jerk));
}

template <class T>
[[gnu::always_inline]] inline T householder(const Gap<T>& g) {
    return householder(g.value, g.rate, T(T(0.5) * g.curvature), T(fraction<T>(1, 6) * g.jerk));
}

/// Householder's correction of fourth order: with A₀ = 1 and Aₖ = c₁Aₖ₋₁ − c₀c₂Aₖ₋₂ + c₀²c₃Aₖ₋₃ − …, the n-th is
/// −c₀Aₙ₋₁/Aₙ.
template <class T>
[[gnu::always_inline]] inline T householder(const GapSeries<T>& g) {
    const auto& c = g.c;
    const T square = c[1] * c[1];
    const T r = c[0] * c[2];
    const T t = c[0] * c[0] * c[3];
    const T third = c[1] * (square - (r + r)) + t;
    const T fourth =
        square * (square - c[0] * (T(3) * c[2])) + (r * r + (T(2) * c[1] * t - c[0] * c[0] * (c[0] * c[4])));
    return -(c[0] * third) / fourth;
}

template <class T>
[[gnu::always_inline]] inline SeriesRoot<T> root_of(const GapSeries<T>& g) {
    const auto& c = g.c;
    SeriesRoot<T> root;
    root.first = householder(g);
    const T d = root.first;
    const T d2 = d * d;
    const T d4 = d2 * d2;
    root.value = ((c[0] + c[1] * d) + d2 * (c[2] + c[3] * d)) +
                 d4 * (((c[4] + c[5] * d) + d2 * (c[6] + c[7] * d)) + d4 * ((c[8] + c[9] * d) + d2 * c[10]));
    root.rate = ((c[1] + T(2) * c[2] * d) + d2 * (T(3) * c[3] + T(4) * c[4] * d)) +
                d4 * (((T(5) * c[5] + T(6) * c[6] * d) + d2 * (T(7) * c[7] + T(8) * c[8] * d)) +
                      d4 * (T(9) * c[9] + T(10) * c[10] * d));
    root.half_curvature = ((c[2] + T(3) * c[3] * d) + d2 * (T(6) * c[4] + T(10) * c[5] * d)) +
                          d4 * ((T(15) * c[6] + T(21) * c[7] * d) + d2 * (T(28) * c[8] + T(36) * c[9] * d));
    root.second = -(root.value * root.rate) / (root.rate * root.rate - root.value * root.half_curvature);
    return root;
}

/// The gap at the root.
template <class T>
[[gnu::always_inline]] inline Gap<T> gap_at(const GapSeries<T>& g, const SeriesRoot<T>& root) {
    const T jerk = T(6) * (g.c[3] + T(4) * g.c[4] * root.first);
    return {T(0), root.rate + T(2) * root.second * root.half_curvature, T(2) * root.half_curvature + root.second * jerk,
            jerk};
}

/// True if both errors of the root are far below rounding, so that they do not accumulate either: O(d³) of the
/// polynomial's root after the second correction d (scale g′/g″), and the truncated term of the flight, |g⁽¹¹⁾| ≤
/// `eleventh`. The gap must be as small as the correction says: far from a root the correction can vanish too.
template <class T>
[[gnu::always_inline]] inline Truth<T> is_converged(const SeriesRoot<T>& root, const T& time, const T& eleventh) {
    using std::fabs;
    const T small = cube_root_of_epsilon<T>() / T(8);
    const T size = fabs(root.second);
    const T d = fabs(root.first);
    const T d2 = d * d;
    const T d4 = d2 * d2;
    return size <= small && size * fabs(root.half_curvature) <= small * root.rate &&
           fabs(root.value) <= T(2) * root.rate * size &&
           eleventh * (d4 * d4 * (d2 * d)) * fraction<T>(1, 39916800) <=
               fraction<T>(1, 1024) * epsilon<T>() * root.rate * time;
}

template <class T>
struct CirclePath {
    T slope;           ///< 2 V·X₀
    T speed2;          ///< |V|²
    T a0, a1, b0, b1;  ///< A = a0 + a1 τ, B = b0 + b1 τ
};

/// The gap and its derivatives up to the fifth.
template <class T>
struct CircleGap : Gap<T> {
    T fourth, fifth;
};

template <class T>
[[gnu::always_inline]] inline CirclePath<T> circle_path(const Flight<T>& flight, const Vec2<T>& swirl) {
    const Vec2<T> place = flight.centre + swirl;
    const Vec2<T> side = quarter_turned(swirl);
    return {T(2) * dot(flight.velocity, flight.centre),
            dot(flight.velocity, flight.velocity),
            dot(place, swirl),
            dot(flight.velocity, swirl),
            dot(flight.centre, side),
            dot(flight.velocity, side)};
}

/// The disk's that begins on the wall, X₀ = (1 − α, 0).
template <class T>
[[gnu::always_inline]] inline CirclePath<T> circle_path_from_wall(const Body<T>& body, const Flight<T>& flight,
                                                                  const Vec2<T>& swirl) {
    CirclePath<T> path = circle_path(flight, swirl);
    path.slope = T(2) * (body.unbiased_inner * flight.velocity.x);
    path.b0 = -(body.unbiased_inner * swirl.y);
    return path;
}

/// At the start, E = 0.
template <class T>
[[gnu::always_inline]] inline CircleGap<T> gap_at_start(const CirclePath<T>& path) {
    CircleGap<T> gap;
    gap.value = T(0);
    gap.rate = path.slope - T(2) * path.b0;
    gap.curvature = T(2) * (path.speed2 + (path.a0 - T(2) * path.b1));
    gap.jerk = T(2) * (path.b0 + T(3) * path.a1);
    gap.fourth = T(2) * (T(4) * path.b1 - path.a0);
    gap.fifth = T(-2) * (path.b0 + T(5) * path.a1);
    return gap;
}

/// The Taylor polynomial about a moment. (P·w)⁽ᵏ⁾ = P·(iᵏw) + k V·(iᵏ⁻¹w).
template <class T>
[[gnu::always_inline]] inline GapSeries<T> series_along(const CirclePath<T>& path, const TurnedMoment<T>& at) {
    const T& c = at.turn.x;
    const T& s = at.turn.y;
    const T a = path.a0 + path.a1 * at.time;
    const T b = path.b0 + path.b1 * at.time;
    // Few moments are tabled, so the rounding error of 1 + c would be the same at each use and accumulate.
    const T along = a + (a * c + b * s);                      // P·w
    const T across = b + (b * c - a * s);                     // P·(i w)
    const T v_along = path.a1 + (path.a1 * c + path.b1 * s);  // V·w
    const T v_across = path.b1 + (path.b1 * c - path.a1 * s);
    const T twice = path.speed2 * at.time;
    GapSeries<T> g;
    // The table's rounding error is below the last digit of the large terms; it is added to the small difference.
    g.c[0] = (at.time * (path.slope + twice) - T(2) * (a * c + b * s)) - T(2) * (a * at.rest.x + b * at.rest.y);
    g.c[1] = (path.slope + (twice + twice)) - T(2) * ((path.a1 * c + path.b1 * s) + across);
    g.c[2] = path.speed2 + (along - T(2) * v_across);
    g.c[3] = fraction<T>(1, 3) * (across + T(3) * v_along);
    g.c[4] = fraction<T>(1, 12) * (T(4) * v_across - along);
    g.c[5] = fraction<T>(-1, 60) * (across + T(5) * v_along);
    g.c[6] = fraction<T>(1, 360) * (along - T(6) * v_across);
    g.c[7] = fraction<T>(1, 2520) * (across + T(7) * v_along);
    g.c[8] = fraction<T>(1, 20160) * (T(8) * v_across - along);
    g.c[9] = fraction<T>(-1, 181440) * (across + T(9) * v_along);
    g.c[10] = fraction<T>(1, 1814400) * (along - T(10) * v_across);
    return g;
}

/// The time at which a gap with g = 0, g′ < 0 at the start returns to zero: the parabola's root s = n/d, then one
/// Newton step on the Taylor polynomial of fifth degree (divided by τ, since g = 0 at the start), written as one
/// quotient. Not positive if the parabola has no root.
template <class T>
[[gnu::always_inline]] inline T return_guess(const CircleGap<T>& start) {
    const T n = -start.rate;
    const T d = T(0.5) * start.curvature;
    const T n2 = n * n;
    const T d2 = d * d;
    const T cubic = fraction<T>(1, 6) * start.jerk * d2;
    const T quartic = fraction<T>(1, 24) * start.fourth * (n * d);
    const T quintic = fraction<T>(1, 120) * start.fifth * n2;
    const T slope = d2 * d2 + n * (T(2) * cubic + (T(3) * quartic + T(4) * quintic));  // of the polynomial, times d³
    const T value = n * (cubic + (quartic + quintic));                                 // its value, times d³/s
    const T left = slope - value;
    const auto usual = slope > 0 && left > T(0.25) * slope && left < T(4) * slope;
    return choose(usual, T(n * left), n) / choose(usual, T(d * slope), d);
}

/// The moment `later` after one whose rotations are known, that of the body by `spun`.
template <class T>
[[gnu::always_inline]] inline Instant<T> instant_after(const Flight<T>& flight, const TurnedMoment<T>& near,
                                                       const Vec2<T>& spun, const T& later) {
    Instant<T> at;
    const Vec2<T> turn = turn_after(near, later);
    at.time = near.time + later;
    at.moved = (near.time * flight.velocity + later * flight.velocity) - flight.beta * times(flight.phase, turn);
    at.phase = turned(flight.phase, turn);
    complete(flight, at);
    at.arm_moved = times(flight.arm, compose(spun, cis_minus_one(T(flight.spin * later))));
    at.arm = flight.arm + at.arm_moved;
    return at;
}

/// |X|² − |X₀|² at a time, E(τ) = `turn`.
template <class T>
[[gnu::always_inline]] inline T gap_along(const CirclePath<T>& path, const T& time, const Vec2<T>& turn) {
    return time * (path.slope + path.speed2 * time) -
           T(2) * ((path.a0 + path.a1 * time) * turn.x + (path.b0 + path.b1 * time) * turn.y);
}
