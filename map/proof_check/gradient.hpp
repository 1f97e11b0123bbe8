// A ball, or another enclosed number, with its derivatives by the coordinates of two neighbouring points of a cycle and
// the time between them.
#pragma once

#include "map/intervals/ball.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace swirl::proof_check {

using intervals::Ball;

/// ψ, χ, v_n, v_t, S, τ of a step, then ψ, χ, v_n, v_t, S of the next, then one of the scene's numbers.
inline constexpr std::size_t variables = 12;
inline constexpr std::size_t scene_variable = 11;

template <class S>
struct GradientOver {
    S f;
    std::array<S, variables> d;

    GradientOver() = default;
    explicit GradientOver(S value) : f(std::move(value)) {}
    explicit GradientOver(double value) : f(value) {}
    explicit GradientOver(int value) : f(value) {}
    GradientOver(S value, std::size_t index) : f(std::move(value)) { d[index] = S(1); }

    GradientOver& operator+=(const GradientOver& x) { return *this = *this + x; }
    void add_product(const GradientOver& x, const GradientOver& y) { *this += x * y; }
};
using Gradient = GradientOver<Ball>;
/// With second derivatives: those of the first.
using SecondGradient = GradientOver<Gradient>;

template <class S>
bool is_exact_zero(const GradientOver<S>& x) {
    if (!is_exact_zero(x.f)) return false;
    for (const S& d : x.d)
        if (!is_exact_zero(d)) return false;
    return true;
}

/// a x + b y for balls a and b; all linear operations are this one.
template <class S>
GradientOver<S> combined(const S& value, const S& a, const GradientOver<S>& x, const S& b, const GradientOver<S>& y) {
    GradientOver<S> result(value);
    for (std::size_t i = 0; i < variables; ++i) {
        if (!is_exact_zero(x.d[i])) result.d[i].add_product(a, x.d[i]);
        if (!is_exact_zero(y.d[i])) result.d[i].add_product(b, y.d[i]);
    }
    return result;
}
template <class S>
GradientOver<S> operator+(const GradientOver<S>& x, const GradientOver<S>& y) {
    return combined(x.f + y.f, S(1), x, S(1), y);
}
template <class S>
GradientOver<S> operator-(const GradientOver<S>& x, const GradientOver<S>& y) {
    return combined(x.f - y.f, S(1), x, S(-1), y);
}
template <class S>
GradientOver<S> operator*(const GradientOver<S>& x, const GradientOver<S>& y) {
    return combined(x.f * y.f, y.f, x, x.f, y);
}
template <class S>
GradientOver<S> operator/(const GradientOver<S>& x, const GradientOver<S>& y) {
    const S ratio = x.f / y.f;
    return combined(ratio, S(1) / y.f, x, -(ratio / y.f), y);
}
template <class S>
GradientOver<S> operator*(const S& a, const GradientOver<S>& x) {
    return combined(a * x.f, a, x, S(0), x);
}
template <class S>
GradientOver<S> operator+(const S& a, const GradientOver<S>& x) {
    return combined(a + x.f, S(1), x, S(0), x);
}
template <class S>
GradientOver<S> operator-(const GradientOver<S>& x) {
    return S(-1) * x;
}
template <class S>
GradientOver<S> sine(const GradientOver<S>& x) {
    const auto at = sine_cosine(x.f);
    return combined(at.sine, at.cosine, x, S(0), x);
}
template <class S>
GradientOver<S> cosine(const GradientOver<S>& x) {
    const auto at = sine_cosine(x.f);
    return combined(at.cosine, -at.sine, x, S(0), x);
}
template <class S>
GradientOver<S> square(const GradientOver<S>& x) {
    return x * x;
}
template <class S>
struct GradientSineCosine {
    GradientOver<S> sine, cosine;
};
template <class S>
GradientSineCosine<S> sine_cosine(const GradientOver<S>& x) {
    return {sine(x), cosine(x)};
}
/// All its values.
template <class S>
Ball values_of(const GradientOver<S>& x) {
    return values_of(x.f);
}
/// A number without its derivatives, if it has any.
template <class S>
const S& scalar_of(const S& x) {
    return x;
}
template <class S>
const S& scalar_of(const GradientOver<S>& x) {
    return x.f;
}
/// Either, with the derivatives of both.
template <class S>
GradientOver<S> either(const GradientOver<S>& x, const GradientOver<S>& y) {
    GradientOver<S> result(hull(x.f, y.f));
    for (std::size_t i = 0; i < variables; ++i) result.d[i] = hull(x.d[i], y.d[i]);
    return result;
}

template <class S>
GradientOver<S> hull(const GradientOver<S>& x, const GradientOver<S>& y) {
    return either(x, y);
}
template <class S>
GradientOver<S> abs(const GradientOver<S>& x) {
    if (is_positive(values_of(x))) return x;
    return is_negative(values_of(x)) ? -x : either(x, -x);
}

}  // namespace swirl::proof_check
