// Numbers that depend on a few others, each between two bounds: to first order, with a bound of the rest.
//
//     x = mid + Σ by_i e_i + r,   |e_i| ≤ 1,  |r| ≤ rest,   for every choice of the e_i
//
// A Sloped stands for a function of e. The first order of a composed function is kept, so that its bounds err by terms
// of second order in the ranges alone, where intervals err by those of first order. (Affine arithmetic: Stolfi & de
// Figueiredo 1997; a Taylor model of order 1: Makino & Berz 2003.) Numbers are doubles, rounded to nearest; `rest`
// takes in every rounding: an operation errs by at most 2⁻⁵³ of its result, or by 2⁻¹⁰⁷⁴. Functions are evaluated at
// `mid` by Arb, and beyond that by Taylor's formula with the largest second derivative in range. What has no bounds has
// an infinite or no `rest`; nothing is certain of it.
#pragma once

#include "map/intervals/ball.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

namespace swirl::intervals {

namespace detail {

inline constexpr double unit_roundoff = 0x1p-53;
inline constexpr double least_rest = 0x1p-1000;  ///< far above what underflows lose

/// A sum of non-negative terms, no more than 30 of them, rounded to nearest: no smaller than the true sum.
inline double at_least(double sum) {
    return sum * (1 + 0x1p-47) + least_rest;
}

/// A function's value at a double, within `error`.
struct AtPoint {
    double value = 0, error = 0;
};
AtPoint at_point(const Ball& x);
struct SineCosineAtPoint {
    AtPoint sine, cosine;
};
SineCosineAtPoint sine_cosine_at(double x);
AtPoint direction_at(double y, double x);  ///< the angle of (x, y)
/// ∫₀¹ uᵏ cos(xu) du and ∫₀¹ uᵏ sin(xu) du; k = 0, 1, 2.
AtPoint cosine_moment_at(double x, int k);
AtPoint sine_moment_at(double x, int k);

}  // namespace detail

/// A number that lies no farther from its middle than it reaches: Sloped, Curved.
template <class X>
concept Centred = requires(const X& x) {
    { x.mid } -> std::convertible_to<double>;
    { x.reach() } -> std::convertible_to<double>;
};

namespace detail {

template <Centred X>
X unbounded() {
    X x;
    x.rest = std::numeric_limits<double>::infinity();
    return x;
}

}  // namespace detail

template <Centred X>
X& operator-=(X& x, const X& y) {
    return x += -y;
}
template <Centred X>
X operator+(X x, const X& y) {
    return x += y;
}
template <Centred X>
X operator-(X x, const X& y) {
    return x += -y;
}
template <Centred X>
X operator/(const X& x, const X& y) {
    return x * reciprocal(y);
}

/// Bounds: certainly no larger, no smaller.
template <Centred X>
double lower(const X& x) {
    return std::nextafter(x.mid - x.reach(), -std::numeric_limits<double>::infinity());
}
template <Centred X>
double upper(const X& x) {
    return std::nextafter(x.mid + x.reach(), std::numeric_limits<double>::infinity());
}
template <Centred X>
double middle(const X& x) {
    return x.mid;
}
template <Centred X>
bool is_positive(const X& x) {
    return lower(x) > 0;
}
template <Centred X>
bool is_negative(const X& x) {
    return upper(x) < 0;
}
template <Centred X>
bool is_finite(const X& x) {
    return std::isfinite(x.mid) && std::isfinite(x.reach());
}
template <Centred X>
bool contains_zero(const X& x) {
    return !is_positive(x) && !is_negative(x);
}
template <Centred X>
const X& value_of(const X& x) {
    return x;
}

/// The angle of (x, y), counted on from that of the middles; not known where (x, y) may lie across from those.
template <Centred X>
X atan2(const X& y, const X& x) {
    const double length = std::hypot(x.mid, y.mid);
    if (!(length > 0 && std::isfinite(length))) return detail::unbounded<X>();
    const double c = x.mid / length, s = y.mid / length;
    const X along = X(c) * x + X(s) * y, across = X(c) * y - X(s) * x;
    if (!is_positive(along)) return detail::unbounded<X>();
    X turned = across / along;  // its middle is rounding: atan t = t within |t|³/3
    const double away = std::abs(turned.mid) + turned.reach();
    turned.rest = detail::at_least(turned.rest + away * away * away * (1.0 / 3) * (1 + 0x1p-40));
    const detail::AtPoint start = detail::direction_at(s, c);
    X from(start.value);
    from.rest = start.error;
    return from + turned;
}
template <Centred X>
X asin(const X& x) {
    return atan2(x, sqrt(X(1) - square(x)));
}
template <Centred X>
X abs(const X& x) {
    if (is_positive(x)) return x;
    return is_negative(x) ? -x : hull(x, -x);
}

template <std::size_t K>
struct Sloped {
    double mid = 0;
    std::array<double, K> by{};
    double rest = 0;

    Sloped() = default;
    explicit Sloped(double value) : mid(value) {}
    explicit Sloped(int value) : mid(value) {}
    explicit Sloped(const Ball& x) {
        const detail::AtPoint at = detail::at_point(x);
        mid = at.value;
        rest = at.error;
    }
    /// Every number between the two, as e_i goes from −1 to 1.
    static Sloped variable(double low, double high, std::size_t i) {
        Sloped x(0.5 * low + 0.5 * high);
        x.by[i] = detail::at_least(std::max(high - x.mid, x.mid - low));
        return x;
    }

    /// |first order| at most.
    double slopes() const {
        double sum = 0;
        for (const double b : by) sum += std::abs(b);
        return sum;
    }
    /// |x − mid| at most.
    double reach() const { return detail::at_least(slopes() + rest); }

    Sloped& operator+=(const Sloped& x) {
        mid += x.mid;
        double size = std::abs(mid);
        for (std::size_t i = 0; i < K; ++i) size += std::abs(by[i] += x.by[i]);
        rest = detail::at_least(rest + x.rest + detail::unit_roundoff * size);
        return *this;
    }
    void add_product(const Sloped& x, const Sloped& y) { *this += x * y; }

    friend Sloped operator-(Sloped x) {
        x.mid = -x.mid;
        for (double& b : x.by) b = -b;
        return x;
    }
    friend Sloped operator*(const Sloped& x, const Sloped& y) {
        Sloped product(x.mid * y.mid);
        double size = std::abs(product.mid), wide_x = 0, wide_y = 0;
        for (std::size_t i = 0; i < K; ++i) {
            const double a = x.mid * y.by[i], b = y.mid * x.by[i];
            product.by[i] = a + b;
            size += std::abs(a) + std::abs(b);
            wide_x += std::abs(x.by[i]);
            wide_y += std::abs(y.by[i]);
        }
        // The first order errs by three roundings, the rest holds what is of second order.
        product.rest = detail::at_least(std::abs(x.mid) * y.rest + std::abs(y.mid) * x.rest +
                                        (wide_x + x.rest) * (wide_y + y.rest) + 4 * detail::unit_roundoff * size);
        return product;
    }
};

namespace detail {

/// f(x) from f(mid), f′(mid) and a bound of |f(x) − f(mid) − f′(mid)(x − mid)|.
template <std::size_t K>
Sloped<K> by_taylor(const Sloped<K>& x, const AtPoint& value, const AtPoint& slope, double beyond) {
    Sloped<K> result(value.value);
    double size = 0;
    for (std::size_t i = 0; i < K; ++i) size += std::abs(result.by[i] = slope.value * x.by[i]);
    result.rest = at_least(value.error + slope.error * x.reach() + std::abs(slope.value) * x.rest + beyond +
                           unit_roundoff * size);
    return result;
}

}  // namespace detail

template <std::size_t K>
bool is_exact_zero(const Sloped<K>& x) {
    return x.mid == 0 && x.rest == 0 && x.slopes() == 0;
}
/// Its values, whatever the e_i; all numbers where it has no bounds.
template <std::size_t K>
Ball values_of(const Sloped<K>& x) {
    return is_finite(x) ? between(lower(x), upper(x)) : around(0, std::numeric_limits<double>::infinity());
}

template <std::size_t K>
Sloped<K> reciprocal(const Sloped<K>& x) {
    const double away = x.reach(), least = std::abs(x.mid) - away;
    if (!(least > 0)) return detail::unbounded<Sloped<K>>();
    const double value = 1 / x.mid, slope = -(value * value);
    const double tight = 1 - 0x1p-40;  // the bounds below are quotients of rounded numbers
    // 1/x = 1/m − (x − m)/m² + (x − m)²/(m² x)
    return detail::by_taylor(x, {value, 2 * detail::unit_roundoff * std::abs(value)},
                             {slope, 8 * detail::unit_roundoff * std::abs(slope)},
                             away * away * (-slope) / (least * tight));
}

/// x², narrower than x·x.
template <std::size_t K>
Sloped<K> square(const Sloped<K>& x) {
    const double value = x.mid * x.mid, away = x.reach(), half = 0.5 * away * away;
    // (x − m)² lies between 0 and its largest
    Sloped<K> result = detail::by_taylor(x, {value, 2 * detail::unit_roundoff * value}, {2 * x.mid, 0}, half);
    result.mid += half;
    result.rest = detail::at_least(result.rest + 2 * detail::unit_roundoff * (std::abs(result.mid) + half));
    return result;
}

template <std::size_t K>
Sloped<K> sqrt(const Sloped<K>& x) {
    const double away = x.reach(), least = x.mid - away;
    if (!(least > 0)) return detail::unbounded<Sloped<K>>();
    const double root = std::sqrt(x.mid), slope = 0.5 / root, sum = (std::sqrt(least) + root) * (1 - 0x1p-40);
    return detail::by_taylor(x, {root, 2 * detail::unit_roundoff * root}, {slope, 4 * detail::unit_roundoff * slope},
                             away * away * slope / (sum * sum));
}

template <std::size_t K>
struct SlopedSineCosine {
    Sloped<K> sine, cosine;
};
template <std::size_t K>
SlopedSineCosine<K> sine_cosine(const Sloped<K>& x) {
    const auto at = detail::sine_cosine_at(x.mid);
    const double away = x.reach(), half = 0.5 * away * away;
    const auto largest = [away](const detail::AtPoint& f) {  // |f″| in range
        return std::min(1.0, detail::at_least(std::abs(f.value) + f.error + away));
    };
    const detail::AtPoint less{-at.sine.value, at.sine.error};
    return {detail::by_taylor(x, at.sine, at.cosine, half * largest(at.sine)),
            detail::by_taylor(x, at.cosine, less, half * largest(at.cosine))};
}

/// sin x / x and (1 − cos x)/x, also at 0: ∫₀¹ cos(xu) du, ∫₀¹ sin(xu) du, whose second derivatives are ≤ 1/3.
template <std::size_t K>
Sloped<K> sinc(const Sloped<K>& x) {
    const double away = x.reach();
    detail::AtPoint slope = detail::sine_moment_at(x.mid, 1);
    slope.value = -slope.value;
    return detail::by_taylor(x, detail::cosine_moment_at(x.mid, 0), slope, away * away * (1.0 / 6) * (1 + 0x1p-40));
}
template <std::size_t K>
Sloped<K> versine_rate(const Sloped<K>& x) {
    const double away = x.reach();
    return detail::by_taylor(x, detail::sine_moment_at(x.mid, 0), detail::cosine_moment_at(x.mid, 1),
                             away * away * (1.0 / 6) * (1 + 0x1p-40));
}

/// All values that lie between those of both, for each e.
template <std::size_t K>
Sloped<K> hull(const Sloped<K>& a, const Sloped<K>& b) {
    Sloped<K> result(0.5 * a.mid + 0.5 * b.mid);
    double apart = std::abs(0.5 * a.mid - 0.5 * b.mid), size = std::abs(result.mid);
    for (std::size_t i = 0; i < K; ++i) {
        size += std::abs(result.by[i] = 0.5 * a.by[i] + 0.5 * b.by[i]);
        apart += std::abs(0.5 * a.by[i] - 0.5 * b.by[i]);
    }
    result.rest = detail::at_least(apart + std::max(a.rest, b.rest) + 4 * detail::unit_roundoff * (size + apart));
    return result;
}

}  // namespace swirl::intervals
