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
/// A vector that is a unit vector but for rounding, brought back by one Newton step for 1/√|a|²: the error d of |a|
/// becomes 1.5 d², so that products of rotations do not drift in length however many are taken. 1 − |a|² is formed as
/// (1 − x)(1 + x) − y² and the correction added: multiplying by a factor near 1 instead would shorten more often than
/// lengthen, since doubles are twice as dense below 1 as above, and that is a bias that adds up.
template <class T>
constexpr Vec2<T> renormalised(const Vec2<T>& a) {
    const T missing = T(0.5) * ((T(1) - a.x) * (T(1) + a.x) - a.y * a.y);
    return a + missing * a;
}

}  // namespace swirl
