// Vectors of the plane, read as complex numbers where that is shorter.
#pragma once

namespace swirl {

template <class T>
struct Vec2 {
    T x{};
    T y{};
};

template <class T>
constexpr Vec2<T> operator+(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x + b.x, a.y + b.y};
}
template <class T>
constexpr Vec2<T> operator-(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x - b.x, a.y - b.y};
}
template <class T>
constexpr Vec2<T> operator*(const T& s, const Vec2<T>& a) {
    return {s * a.x, s * a.y};
}

template <class T>
constexpr T dot(const Vec2<T>& a, const Vec2<T>& b) {
    return a.x * b.x + a.y * b.y;
}
/// a × b = a_x b_y − a_y b_x: positive when b is counter-clockwise of a.
template <class T>
constexpr T cross(const Vec2<T>& a, const Vec2<T>& b) {
    return a.x * b.y - a.y * b.x;
}
/// ẑ × a: a turned by a quarter, counter-clockwise (i a).
template <class T>
constexpr Vec2<T> quarter_turned(const Vec2<T>& a) {
    return {-a.y, a.x};
}
/// The product of complex numbers: b scaled by |a| and turned by arg a.
template <class T>
constexpr Vec2<T> times(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
/// ā b: b seen from axes along a.
template <class T>
constexpr Vec2<T> seen_from(const Vec2<T>& a, const Vec2<T>& b) {
    return {a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x};
}
template <class T>
constexpr Vec2<T> conjugate(const Vec2<T>& a) {
    return {a.x, -a.y};
}
/// ½(1 − |a|²) of a vector that is a unit vector but for rounding: the shortfall of |a| from 1, to first order. Formed
/// as ½ − x² + ½ − y², of which one difference is exact and the other no larger than ½.
template <class T>
constexpr T missing_length(const Vec2<T>& a) {
    return T(0.5) * ((T(0.5) - a.x * a.x) + (T(0.5) - a.y * a.y));
}
/// A vector that is a unit vector but for rounding, brought back by one Newton step for 1/√|a|²: the error d of |a|
/// becomes 1.5 d², so that products of rotations do not drift in length however many are taken. The correction is
/// added: multiplying by a factor near 1 instead would shorten more often than lengthen, since doubles are twice as
/// dense below 1 as above, and this bias would accumulate.
template <class T>
constexpr Vec2<T> renormalised(const Vec2<T>& a) {
    const T missing = missing_length(a);
    return a + missing * a;
}
/// A vector that is a unit vector but for rounding, brought back to length 1 and turned by a small angle, to first
/// order.
template <class T>
constexpr Vec2<T> renormalised(const Vec2<T>& a, const T& angle) {
    return a + times(Vec2<T>{missing_length(a), angle}, a);
}

}  // namespace swirl
