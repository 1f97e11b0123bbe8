// A ball with its partial derivatives, forward-mode automatic differentiation: the derivatives of a composed function
// over a box are enclosed by the chain rule over balls. The same over another sort of enclosed number (sloped.hpp).
#pragma once

#include "map/intervals/ball.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace swirl::intervals {

template <std::size_t D, class S = Ball>
struct Dual {
    S value;
    std::array<S, D> by;  ///< ∂/∂x_i

    Dual() = default;
    explicit Dual(S v) : value(std::move(v)) {}
    explicit Dual(double v) : value(v) {}
    explicit Dual(int v) : value(v) {}
    /// The i-th variable.
    static Dual variable(S v, std::size_t i) {
        Dual result(std::move(v));
        result.by[i] = S(1);
        return result;
    }

    Dual& operator+=(const Dual& x) { return *this = *this + x; }
    Dual& operator-=(const Dual& x) { return *this = *this - x; }
    void add_product(const Dual& x, const Dual& y) { *this += x * y; }
};

/// So that duals over duals, which have second derivatives, read as duals over balls do.
template <std::size_t D, class S>
bool is_exact_zero(const Dual<D, S>& x) {
    if (!is_exact_zero(x.value)) return false;
    for (const S& d : x.by)
        if (!is_exact_zero(d)) return false;
    return true;
}
template <std::size_t D, class S>
decltype(auto) values_of(const Dual<D, S>& x) {
    return values_of(x.value);
}

namespace detail {

/// f(x) from its value and its derivative f′.
template <std::size_t D, class S>
Dual<D, S> chained(S value, const S& slope, const Dual<D, S>& x) {
    Dual<D, S> result(std::move(value));
    for (std::size_t i = 0; i < D; ++i)
        if (!is_exact_zero(x.by[i])) result.by[i] = slope * x.by[i];
    return result;
}

}  // namespace detail

template <std::size_t D, class S>
Dual<D, S> operator+(Dual<D, S> a, const Dual<D, S>& b) {
    a.value += b.value;
    for (std::size_t i = 0; i < D; ++i) a.by[i] += b.by[i];
    return a;
}
template <std::size_t D, class S>
Dual<D, S> operator-(Dual<D, S> a, const Dual<D, S>& b) {
    a.value -= b.value;
    for (std::size_t i = 0; i < D; ++i) a.by[i] -= b.by[i];
    return a;
}
template <std::size_t D, class S>
Dual<D, S> operator-(const Dual<D, S>& a) {
    return detail::chained(-a.value, S(-1), a);
}
template <std::size_t D, class S>
Dual<D, S> operator*(const Dual<D, S>& a, const Dual<D, S>& b) {
    Dual<D, S> result(a.value * b.value);
    for (std::size_t i = 0; i < D; ++i) {
        if (!is_exact_zero(a.by[i])) result.by[i].add_product(a.by[i], b.value);
        if (!is_exact_zero(b.by[i])) result.by[i].add_product(a.value, b.by[i]);
    }
    return result;
}
template <std::size_t D, class S>
Dual<D, S> operator/(const Dual<D, S>& a, const Dual<D, S>& b) {
    Dual<D, S> result(a.value / b.value);
    for (std::size_t i = 0; i < D; ++i)
        if (!is_exact_zero(a.by[i]) || !is_exact_zero(b.by[i]))
            result.by[i] = (a.by[i] - result.value * b.by[i]) / b.value;
    return result;
}
template <std::size_t D, class S>
Dual<D, S> operator+(Dual<D, S> a, const S& b) {
    a.value += b;
    return a;
}
template <std::size_t D, class S>
Dual<D, S> operator-(Dual<D, S> a, const S& b) {
    a.value -= b;
    return a;
}
template <std::size_t D, class S>
Dual<D, S> operator*(const S& a, const Dual<D, S>& b) {
    return detail::chained(a * b.value, a, b);
}

template <std::size_t D, class S>
Dual<D, S> square(const Dual<D, S>& x) {
    return detail::chained(square(x.value), S(2) * x.value, x);
}
template <std::size_t D, class S>
Dual<D, S> sqrt(const Dual<D, S>& x) {
    const S root = sqrt(x.value);
    return detail::chained(root, S(0.5) / root, x);
}
template <std::size_t D, class S>
struct DualSineCosine {
    Dual<D, S> sine, cosine;
};
template <std::size_t D, class S>
DualSineCosine<D, S> sine_cosine(const Dual<D, S>& x) {
    const auto at = sine_cosine(x.value);
    return {detail::chained(at.sine, at.cosine, x), detail::chained(at.cosine, -at.sine, x)};
}
template <std::size_t D, class S>
Dual<D, S> atan2(const Dual<D, S>& y, const Dual<D, S>& x) {
    Dual<D, S> result(atan2(y.value, x.value));
    const S length = square(x.value) + square(y.value);
    for (std::size_t i = 0; i < D; ++i)
        if (!is_exact_zero(x.by[i]) || !is_exact_zero(y.by[i]))
            result.by[i] = (x.value * y.by[i] - y.value * x.by[i]) / length;
    return result;
}
/// Values and derivatives of either: what a function that is continuous across a kink may have.
template <std::size_t D, class S>
Dual<D, S> hull(const Dual<D, S>& a, const Dual<D, S>& b) {
    Dual<D, S> result(hull(a.value, b.value));
    for (std::size_t i = 0; i < D; ++i) result.by[i] = hull(a.by[i], b.by[i]);
    return result;
}

/// The value without its derivatives, so that one function serves balls and duals.
inline const Ball& value_of(const Ball& x) {
    return x;
}
template <std::size_t D, class S>
const S& value_of(const Dual<D, S>& x) {
    return x.value;
}

}  // namespace swirl::intervals
