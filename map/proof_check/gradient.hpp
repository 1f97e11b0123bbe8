// A ball with its derivatives by the coordinates of two neighbouring points of a cycle and the time between them.
#pragma once

#include "map/intervals/ball.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace swirl::proof_check {

using intervals::Ball;

/// ψ, χ, v_n, v_t, S, τ of a step, then ψ, χ, v_n, v_t, S of the next.
inline constexpr std::size_t variables = 11;

struct Gradient {
    Ball f;
    std::array<Ball, variables> d;

    Gradient() = default;
    explicit Gradient(Ball value) : f(std::move(value)) {}
    Gradient(Ball value, std::size_t index) : f(std::move(value)) { d[index] = Ball(1); }
};

/// a x + b y for balls a and b; all linear operations are this one.
inline Gradient combined(const Ball& value, const Ball& a, const Gradient& x, const Ball& b, const Gradient& y) {
    Gradient result(value);
    for (std::size_t i = 0; i < variables; ++i) {
        if (!is_exact_zero(x.d[i])) result.d[i].add_product(a, x.d[i]);
        if (!is_exact_zero(y.d[i])) result.d[i].add_product(b, y.d[i]);
    }
    return result;
}
inline Gradient operator+(const Gradient& x, const Gradient& y) {
    return combined(x.f + y.f, Ball(1), x, Ball(1), y);
}
inline Gradient operator-(const Gradient& x, const Gradient& y) {
    return combined(x.f - y.f, Ball(1), x, Ball(-1), y);
}
inline Gradient operator*(const Gradient& x, const Gradient& y) {
    return combined(x.f * y.f, y.f, x, x.f, y);
}
inline Gradient operator/(const Gradient& x, const Gradient& y) {
    const Ball ratio = x.f / y.f;
    return combined(ratio, Ball(1) / y.f, x, -(ratio / y.f), y);
}
inline Gradient operator*(const Ball& a, const Gradient& x) {
    return combined(a * x.f, a, x, Ball(0), x);
}
inline Gradient operator+(const Ball& a, const Gradient& x) {
    return combined(a + x.f, Ball(1), x, Ball(0), x);
}
inline Gradient sine(const Gradient& x) {
    const auto at = intervals::sine_cosine(x.f);
    return combined(at.sine, at.cosine, x, Ball(0), x);
}
inline Gradient cosine(const Gradient& x) {
    const auto at = intervals::sine_cosine(x.f);
    return combined(at.cosine, -at.sine, x, Ball(0), x);
}
/// Either, with the derivatives of both.
inline Gradient either(const Gradient& x, const Gradient& y) {
    Gradient result(hull(x.f, y.f));
    for (std::size_t i = 0; i < variables; ++i) result.d[i] = hull(x.d[i], y.d[i]);
    return result;
}

}  // namespace swirl::proof_check
