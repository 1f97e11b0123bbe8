// Numbers that depend on a few others to second order: sloped.hpp with one order more.
//
//     x = mid + Σ by_i e_i + Σ_{i ≤ j} two_ij e_i e_j + r,   |e_i| ≤ 1,  |r| ≤ rest,   for every choice of the e_i
//
// Bounds of a composed function err by terms of third order in the ranges. (A Taylor model of order 2: Makino & Berz
// 2003.) Functions are expanded at `mid`, with the largest third derivative in range; roundings are in `rest`.
#pragma once

#include "map/intervals/sloped.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace swirl::intervals {

template <std::size_t K>
struct Curved {
    static constexpr std::size_t pairs = K * (K + 1) / 2;
    double mid = 0;
    std::array<double, K> by{};
    std::array<double, pairs> two{};  ///< (0, 0), (0, 1), …, (1, 1), …
    double rest = 0;

    Curved() = default;
    explicit Curved(double value) : mid(value) {}
    explicit Curved(int value) : mid(value) {}
    explicit Curved(const Ball& x) {
        const detail::AtPoint at = detail::at_point(x);
        mid = at.value;
        rest = at.error;
    }
    static Curved variable(double low, double high, std::size_t i) {
        const auto sloped = Sloped<K>::variable(low, high, i);
        Curved x(sloped.mid);
        x.by = sloped.by;
        return x;
    }
    /// The place of e_i e_j.
    static constexpr std::size_t place(std::size_t i, std::size_t j) {
        return i <= j ? i * K - i * (i + 1) / 2 + j : place(j, i);
    }

    double slopes() const {
        double sum = 0;
        for (const double b : by) sum += std::abs(b);
        return sum;
    }
    double curves() const {
        double sum = 0;
        for (const double c : two) sum += std::abs(c);
        return sum;
    }
    double reach() const { return detail::at_least(slopes() + curves() + rest); }
    /// The same with the terms of second order in `rest`.
    Sloped<K> sloped() const {
        Sloped<K> x(mid);
        x.by = by;
        x.rest = detail::at_least(curves() + rest);
        return x;
    }

    Curved& operator+=(const Curved& x) {
        mid += x.mid;
        double size = std::abs(mid);
        for (std::size_t i = 0; i < K; ++i) size += std::abs(by[i] += x.by[i]);
        for (std::size_t i = 0; i < pairs; ++i) size += std::abs(two[i] += x.two[i]);
        rest = detail::at_least(rest + x.rest + detail::unit_roundoff * size);
        return *this;
    }
    void add_product(const Curved& x, const Curved& y) { *this += x * y; }

    friend Curved operator-(Curved x) {
        x.mid = -x.mid;
        for (double& b : x.by) b = -b;
        for (double& c : x.two) c = -c;
        return x;
    }
    friend Curved operator*(const Curved& x, const Curved& y) {
        Curved product(x.mid * y.mid);
        double size = std::abs(product.mid);
        for (std::size_t i = 0; i < K; ++i) {
            const double a = x.mid * y.by[i], b = y.mid * x.by[i];
            product.by[i] = a + b;
            size += std::abs(a) + std::abs(b);
        }
        for (std::size_t i = 0; i < K; ++i)
            for (std::size_t j = i; j < K; ++j) {
                const std::size_t k = place(i, j);
                const double a = x.mid * y.two[k], b = y.mid * x.two[k], c = x.by[i] * y.by[j],
                             d = i == j ? 0 : x.by[j] * y.by[i];
                product.two[k] = (a + b) + (c + d);
                size += std::abs(a) + std::abs(b) + std::abs(c) + std::abs(d);
            }
        const double lx = x.slopes(), ly = y.slopes(), qx = x.curves(), qy = y.curves();
        // Terms of third and fourth order, what `rest` makes of the others, and up to five roundings a coefficient.
        product.rest =
            detail::at_least(lx * qy + qx * ly + qx * qy + x.rest * (std::abs(y.mid) + ly + qy) +
                             y.rest * (std::abs(x.mid) + lx + qx) + x.rest * y.rest + 6 * detail::unit_roundoff * size);
        return product;
    }
};

namespace detail {

/// f(x) from f, f′, f″ at mid and a bound of what is beyond, |x − mid|³ |f‴|/6.
template <std::size_t K>
Curved<K> by_taylor(const Curved<K>& x, const AtPoint& value, const AtPoint& slope, const AtPoint& curvature,
                    double beyond) {
    Curved<K> away = x;
    away.mid = 0;
    const double reach = x.reach();
    Curved<K> result = Curved<K>(slope.value) * away + Curved<K>(0.5 * curvature.value) * (away * away);
    result += Curved<K>(value.value);
    result.rest = at_least(result.rest + value.error + slope.error * reach + curvature.error * reach * reach + beyond);
    return result;
}

}  // namespace detail

template <std::size_t K>
bool is_exact_zero(const Curved<K>& x) {
    return x.mid == 0 && x.rest == 0 && x.slopes() == 0 && x.curves() == 0;
}
template <std::size_t K>
Ball values_of(const Curved<K>& x) {
    return values_of(x.sloped());
}

template <std::size_t K>
Curved<K> reciprocal(const Curved<K>& x) {
    const double away = x.reach(), least = std::abs(x.mid) - away;
    if (!(least > 0)) return detail::unbounded<Curved<K>>();
    const double value = 1 / x.mid, square_of = value * value, u = detail::unit_roundoff;
    // 1/x = 1/m − d/m² + d²/m³ − d³/(m³ x)
    return detail::by_taylor(x, {value, 2 * u * std::abs(value)}, {-square_of, 8 * u * square_of},
                             {2 * square_of * value, 16 * u * square_of * std::abs(value)},
                             away * away * away * square_of * std::abs(value) / (least * (1 - 0x1p-40)));
}

template <std::size_t K>
Curved<K> square(const Curved<K>& x) {
    return x * x;
}

template <std::size_t K>
Curved<K> sqrt(const Curved<K>& x) {
    const double away = x.reach(), least = x.mid - away;
    if (!(least > 0)) return detail::unbounded<Curved<K>>();
    const double root = std::sqrt(x.mid), slope = 0.5 / root, curvature = -0.5 * slope / x.mid,
                 u = detail::unit_roundoff;
    // |f‴| = (3/8) x^(−5/2), largest at the least x
    const double third = 0.375 / (least * least * std::sqrt(least)) * (1 + 0x1p-40);
    return detail::by_taylor(x, {root, 2 * u * root}, {slope, 4 * u * slope}, {curvature, 8 * u * std::abs(curvature)},
                             away * away * away * third / 6);
}

template <std::size_t K>
struct CurvedSineCosine {
    Curved<K> sine, cosine;
};
template <std::size_t K>
CurvedSineCosine<K> sine_cosine(const Curved<K>& x) {
    const auto at = detail::sine_cosine_at(x.mid);
    const double away = x.reach(), sixth = away * away * away * (1.0 / 6) * (1 + 0x1p-40);
    const detail::AtPoint less_sine{-at.sine.value, at.sine.error}, less_cosine{-at.cosine.value, at.cosine.error};
    return {detail::by_taylor(x, at.sine, at.cosine, less_sine, sixth),
            detail::by_taylor(x, at.cosine, less_sine, less_cosine, sixth)};
}

/// As in sloped.hpp: third derivatives are ≤ 1/4.
template <std::size_t K>
Curved<K> sinc(const Curved<K>& x) {
    const double away = x.reach();
    detail::AtPoint slope = detail::sine_moment_at(x.mid, 1), curvature = detail::cosine_moment_at(x.mid, 2);
    slope.value = -slope.value;
    curvature.value = -curvature.value;
    return detail::by_taylor(x, detail::cosine_moment_at(x.mid, 0), slope, curvature,
                             away * away * away * (1.0 / 24) * (1 + 0x1p-40));
}
template <std::size_t K>
Curved<K> versine_rate(const Curved<K>& x) {
    const double away = x.reach();
    detail::AtPoint curvature = detail::sine_moment_at(x.mid, 2);
    curvature.value = -curvature.value;
    return detail::by_taylor(x, detail::sine_moment_at(x.mid, 0), detail::cosine_moment_at(x.mid, 1), curvature,
                             away * away * away * (1.0 / 24) * (1 + 0x1p-40));
}

/// All values that lie between those of both, for each e.
template <std::size_t K>
Curved<K> hull(const Curved<K>& a, const Curved<K>& b) {
    Curved<K> half = Curved<K>(0.5) * (a + b), apart = Curved<K>(0.5) * (a - b);
    half.rest = detail::at_least(half.rest + std::abs(apart.mid) + apart.reach() + a.rest + b.rest);
    return half;
}

}  // namespace swirl::intervals
