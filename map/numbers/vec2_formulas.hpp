// Vectors of the plane, read as complex numbers where that is shorter, and products with a scene's constants.
//
// A text without namespace, as all *_formulas.hpp: the header of its name reads it for numbers, and lanes read it once
// for each instruction set (map/batch/README.md, "One text"). SWIRL_INLINED: `constexpr`; in lanes inlined by force.

template <class T>
struct Vec2 {
    T x{};
    T y{};
};

template <class T>
SWIRL_INLINED Vec2<T> operator+(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x + b.x, a.y + b.y};
}
template <class T>
SWIRL_INLINED Vec2<T> operator-(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x - b.x, a.y - b.y};
}
template <class T>
SWIRL_INLINED Vec2<T> operator*(const T& s, const Vec2<T>& a) {
    return {s * a.x, s * a.y};
}

template <class T>
SWIRL_INLINED T dot(const Vec2<T>& a, const Vec2<T>& b) {
    return a.x * b.x + a.y * b.y;
}
/// a × b = a_x b_y − a_y b_x: positive when b is counter-clockwise of a.
template <class T>
SWIRL_INLINED T cross(const Vec2<T>& a, const Vec2<T>& b) {
    return a.x * b.y - a.y * b.x;
}
/// ẑ × a: a turned by a quarter, counter-clockwise (i a).
template <class T>
SWIRL_INLINED Vec2<T> quarter_turned(const Vec2<T>& a) {
    return {-a.y, a.x};
}
/// The product of complex numbers: b scaled by |a| and turned by arg a.
template <class T>
SWIRL_INLINED Vec2<T> times(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
/// ā b: b seen from axes along a.
template <class T>
SWIRL_INLINED Vec2<T> seen_from(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x};
}
template <class T>
SWIRL_INLINED Vec2<T> conjugate(const Vec2<T>& a) {
    return {a.x, -a.y};
}
/// ½(1 − |a|²) of a vector that is a unit vector but for rounding: the shortfall of |a| from 1, to first order. Formed
/// as ½ − x² + ½ − y², of which one difference is exact and the other no larger than ½.
template <class T>
SWIRL_INLINED T missing_length(const Vec2<T>& a) {
    return T(0.5) * ((T(0.5) - a.x * a.x) + (T(0.5) - a.y * a.y));
}
/// A vector that is a unit vector but for rounding, brought back by one Newton step for 1/√|a|²: the error d of |a|
/// becomes 1.5 d², so that products of rotations do not drift in length however many are taken. The correction is
/// added: multiplying by a factor near 1 instead would shorten more often than lengthen, since doubles are twice as
/// dense below 1 as above, and this bias would accumulate.
template <class T>
SWIRL_INLINED Vec2<T> renormalised(const Vec2<T>& a) {
    const T missing = missing_length(a);
    return a + missing * a;
}
/// Renormalised and turned by a small angle, to first order.
template <class T>
SWIRL_INLINED Vec2<T> renormalised(const Vec2<T>& a, const T& angle) {
    return a + times(Vec2<T>{missing_length(a), angle}, a);
}

/// A constant c that multiplies numbers at every impact, as c₁ + c₂ with c₁ = 1.001248… c.
///
/// A constant of few digits rounds more to one side than to the other. The product with 1/(1 − 0.4) = 5/3 ends in
/// multiples of a sixth of its last place, ties among them, and which way a tie goes is decided by how 5/3 was rounded:
/// always the same way, and J drifts by some ε/70 per impact (map/README.md, "Section coordinates"). c₁ has no
/// such structure: c₁x is rounded up as often as down, its error is spread evenly over the last place, and so the sum
/// c₁x + c₂x is rounded without bias, too. Its error is some 1½ ulp at most (a product's ½). Cost: a product and a sum.
template <class T>
struct UnbiasedFactor {
    T first, second;
};

template <class T>
SWIRL_INLINED T operator*(const UnbiasedFactor<T>& c, const T& x) {
    return c.first * x + c.second * x;
}
template <class T>
SWIRL_INLINED Vec2<T> operator*(const UnbiasedFactor<T>& c, const Vec2<T>& v) {
    return {c * v.x, c * v.y};
}
