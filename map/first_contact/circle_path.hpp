// The centre's gap along a flight as a scalar function of time, for searches on the critical path.
//
// In the laboratory the centre is at P(τ) = P₀ + Vτ from the swirl's centre, and X = P − w. So
//     |X|² − |X₀|² = 2τ V·X₀ + τ²|V|² − 2 (A c + B s),   E(τ) = (c, s),
// with A = P·w₀ and B = P·(i w₀) linear in τ: six numbers per flight, and every derivative from the same products. B
// begins as X₀·(i w₀), since w₀·(i w₀) = 0: formed from P₀ = X₀ + w₀ it would lose X₀ where that is small against β.
// For the disk this is the gap, for a polygon the centre's distance against that at the start.
#pragma once

#include "map/first_contact/gap_series.hpp"
#include "map/numbers/turn_table.hpp"

namespace swirl::detail {

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
    if (!(slope > 0 && left > T(0.25) * slope && left < T(4) * slope)) [[unlikely]]
        return n / d;
    return n * left / (d * slope);
}

/// A guess without the start's derivatives, for long or curved flights of double: the gap is sampled at tabled moments,
/// first 1/32, from ¼ on four times per radian, and the line through the two samples between which g changes its sign
/// gives the time. −1 if g stays negative.
template <class T>
[[gnu::noinline]] inline T sampled_guess(const CirclePath<T>& path) {
    if constexpr (std::is_same_v<T, double>) {
        double before = 0;
        std::size_t step = 2;
        for (std::size_t k = step; k < sixty_fourths; k += step) {
            const double time = static_cast<double>(k) / 64;
            const Vec2<double>& turn = turns_of_sixty_fourths[k].value;
            const double gap = time * (path.slope + path.speed2 * time) -
                               2 * ((path.a0 + path.a1 * time) * turn.x + (path.b0 + path.b1 * time) * turn.y);
            if (gap > 0) return time - static_cast<double>(step) / 64 * gap / (gap - before);
            before = gap;
            if (step < 16) step = k;
        }
    }
    return T(-1);
}

}  // namespace swirl::detail
