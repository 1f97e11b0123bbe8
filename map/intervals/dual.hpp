// A ball with its partial derivatives, forward-mode automatic differentiation: the derivatives of a composed function
// over a box are enclosed by the chain rule over balls.
#pragma once

#include "map/intervals/ball.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace swirl::intervals {

template <std::size_t D>
struct Dual {
    Ball value;
    std::array<Ball, D> by;  ///< ∂/∂x_i

    Dual() = default;
    explicit Dual(Ball v) : value(std::move(v)) {}
    explicit Dual(double v) : value(v) {}
    explicit Dual(int v) : value(v) {}
    /// The i-th variable.
    static Dual variable(Ball v, std::size_t i) {
        Dual result(std::move(v));
        result.by[i] = Ball(1);
        return result;
    }
};

namespace detail {

/// f(x) from its value and its derivative f′.
template <std::size_t D>
Dual<D> chained(Ball value, const Ball& slope, const Dual<D>& x) {
    Dual<D> result(std::move(value));
    for (std::size_t i = 0; i < D; ++i)
        if (!is_exact_zero(x.by[i])) result.by[i] = slope * x.by[i];
    return result;
}

}  // namespace detail

template <std::size_t D>
Dual<D> operator+(Dual<D> a, const Dual<D>& b) {
    a.value += b.value;
    for (std::size_t i = 0; i < D; ++i) a.by[i] += b.by[i];
    return a;
}
template <std::size_t D>
Dual<D> operator-(Dual<D> a, const Dual<D>& b) {
    a.value -= b.value;
    for (std::size_t i = 0; i < D; ++i) a.by[i] -= b.by[i];
    return a;
}
template <std::size_t D>
Dual<D> operator-(const Dual<D>& a) {
    return detail::chained(-a.value, Ball(-1), a);
}
template <std::size_t D>
Dual<D> operator*(const Dual<D>& a, const Dual<D>& b) {
    Dual<D> result(a.value * b.value);
    for (std::size_t i = 0; i < D; ++i) {
        if (!is_exact_zero(a.by[i])) result.by[i].add_product(a.by[i], b.value);
        if (!is_exact_zero(b.by[i])) result.by[i].add_product(a.value, b.by[i]);
    }
    return result;
}
template <std::size_t D>
Dual<D> operator/(const Dual<D>& a, const Dual<D>& b) {
    Dual<D> result(a.value / b.value);
    for (std::size_t i = 0; i < D; ++i)
        if (!is_exact_zero(a.by[i]) || !is_exact_zero(b.by[i]))
            result.by[i] = (a.by[i] - result.value * b.by[i]) / b.value;
    return result;
}
template <std::size_t D>
Dual<D> operator+(Dual<D> a, const Ball& b) {
    a.value += b;
    return a;
}
template <std::size_t D>
Dual<D> operator-(Dual<D> a, const Ball& b) {
    a.value -= b;
    return a;
}
template <std::size_t D>
Dual<D> operator*(const Ball& a, const Dual<D>& b) {
    return detail::chained(a * b.value, a, b);
}

template <std::size_t D>
Dual<D> sqrt(const Dual<D>& x) {
    const Ball root = sqrt(x.value);
    return detail::chained(root, Ball(0.5) / root, x);
}
template <std::size_t D>
struct DualSineCosine {
    Dual<D> sine, cosine;
};
template <std::size_t D>
DualSineCosine<D> sine_cosine(const Dual<D>& x) {
    const SineCosine at = sine_cosine(x.value);
    return {detail::chained(at.sine, at.cosine, x), detail::chained(at.cosine, -at.sine, x)};
}
template <std::size_t D>
Dual<D> atan2(const Dual<D>& y, const Dual<D>& x) {
    Dual<D> result(atan2(y.value, x.value));
    const Ball length = square(x.value) + square(y.value);
    for (std::size_t i = 0; i < D; ++i)
        if (!is_exact_zero(x.by[i]) || !is_exact_zero(y.by[i]))
            result.by[i] = (x.value * y.by[i] - y.value * x.by[i]) / length;
    return result;
}
/// Values and derivatives of either: what a function that is continuous across a kink may have.
template <std::size_t D>
Dual<D> hull(const Dual<D>& a, const Dual<D>& b) {
    Dual<D> result(hull(a.value, b.value));
    for (std::size_t i = 0; i < D; ++i) result.by[i] = hull(a.by[i], b.by[i]);
    return result;
}

/// The value without its derivatives, so that one function serves balls and duals.
inline const Ball& value_of(const Ball& x) {
    return x;
}
template <std::size_t D>
const Ball& value_of(const Dual<D>& x) {
    return x.value;
}

}  // namespace swirl::intervals
