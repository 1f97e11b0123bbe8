// Rotations as cis δ − 1, for numbers and for lanes (numbers/vec2_formulas.hpp says how).

/// The composition of two turns given as cis − 1: (1 + a)(1 + b) − 1.
template <class T>
SWIRL_INLINED Vec2<T> compose(const Vec2<T>& a, const Vec2<T>& b) {
    return a + (b + times(a, b));
}
/// The first from a table, which has left out `rest`.
template <class T>
SWIRL_INLINED Vec2<T> compose(const Vec2<T>& a, const Vec2<T>& rest, const Vec2<T>& b) {
    return a + (b + (rest + times(a, b)));
}

/// cis δ − 1 of a tabled cis δ.
template <class T>
SWIRL_INLINED Vec2<T> minus_one(const Vec2<T>& direction, const Vec2<T>& rest) {
    return {(direction.x - T(1)) + rest.x, direction.y + rest.y};
}

/// v turned: v + v·(cis δ − 1).
template <class T>
SWIRL_INLINED Vec2<T> turned(const Vec2<T>& v, const Vec2<T>& turn) {
    return v + times(v, turn);
}

/// cis δ − 1 in double by Taylor polynomials for |δ| ≤ ¼; the first terms left out are below 2⁻⁵⁶ of the sum.
template <class T>
[[gnu::always_inline]] inline Vec2<T> small_turn_minus_one(const T& d) {
    const T s = d * d;
    const T s2 = s * s;
    const T sine =
        (T(-1.0 / 6) + s * T(1.0 / 120)) + s2 * ((T(-1.0 / 5040) + s * T(1.0 / 362880)) + s2 * T(-1.0 / 39916800));
    const T cosine = (T(-0.5) + s * T(1.0 / 24)) +
                     s2 * ((T(-1.0 / 720) + s * T(1.0 / 40320)) + s2 * (T(-1.0 / 3628800) + s * T(1.0 / 479001600)));
    return {s * cosine, d + d * (s * sine)};
}
/// For |δ| ≤ 2⁻¹³, where two terms are enough: the last correction of a search is that small.
template <class T>
[[gnu::always_inline]] inline Vec2<T> tiny_turn_minus_one(const T& d) {
    const T s = d * d;
    return {s * (T(-0.5) + s * T(1.0 / 24)), d + d * (s * T(-1.0 / 6))};
}

/// A moment with E(τ) = cis τ − 1 and what rounding left out of that.
template <class T>
struct TurnedMoment {
    T time;
    Vec2<T> turn;
    Vec2<T> rest;
};
