// Products of power series, of one or two at a time.
#pragma once

#include "map/sustained/contact_series.hpp"

#include <array>

namespace swirl {

/// Two numbers side by side: what multiplies both is read once.
template <class T>
struct Two {
    T first{}, second{};

    Two() = default;
    Two(const T& a, const T& b) : first(a), second(b) {}

    T operator[](int i) const { return i == 0 ? first : second; }
    Two& operator+=(const Two& o) {
        first += o.first;
        second += o.second;
        return *this;
    }
    friend Two operator+(const Two& a, const Two& b) { return {a.first + b.first, a.second + b.second}; }
    friend Two operator*(const Two& a, const Two& b) { return {a.first * b.first, a.second * b.second}; }
    friend Two operator*(const T& a, const Two& b) { return {a * b.first, a * b.second}; }
};

/// In double they share a register: stored one by one and loaded together, they would have to wait for the store.
template <>
struct Two<double> {
    using Register [[gnu::vector_size(16)]] = double;
    Register both{};

    Two() = default;
    Two(Register r) : both(r) {}
    Two(double a, double b) : both{a, b} {}

    double operator[](int i) const { return both[i]; }
    Two& operator+=(const Two& o) {
        both += o.both;
        return *this;
    }
    friend Two operator+(const Two& a, const Two& b) { return a.both + b.both; }
    friend Two operator*(const Two& a, const Two& b) { return a.both * b.both; }
    friend Two operator*(double a, const Two& b) { return a * b.both; }
};

template <class T>
using TwoSeries = std::array<Two<T>, series_order<T> + 1>;

/// Σ a[i] b[k − i] for i from 0 to k, of a series and one or two: in four sums, as each addition waits for the one
/// before it, and the newest coefficients, a[k] and b[k], last.
template <class A, class B, class E = typename B::value_type>
E product(const A& a, const B& b, int k) {
    if (k == 0) return a[0] * b[0];
    E s0 = E{}, s1 = s0, s2 = s0, s3 = s0;
    int i = 1;
    for (; i + 3 < k; i += 4) {
        s0 += a[i] * b[k - i];
        s1 += a[i + 1] * b[k - i - 1];
        s2 += a[i + 2] * b[k - i - 2];
        s3 += a[i + 3] * b[k - i - 3];
    }
    if (i < k) s0 += a[i] * b[k - i];
    if (i + 1 < k) s1 += a[i + 1] * b[k - i - 1];
    if (i + 2 < k) s2 += a[i + 2] * b[k - i - 2];
    return ((s0 + s1) + (s2 + s3)) + (a[0] * b[k] + a[k] * b[0]);
}

/// The k-th coefficient of the square of one or two series.
template <class A, class E = typename A::value_type>
E square(const A& a, int k) {
    E s0 = E{}, s1 = s0;
    int i = 0;
    for (; 2 * i + 2 < k; i += 2) {
        s0 += a[i] * a[k - i];
        s1 += a[i + 1] * a[k - i - 1];
    }
    if (2 * i < k) s0 += a[i] * a[k - i];
    s0 += s1;
    s0 += s0;
    if (k % 2 == 0) s0 += a[k / 2] * a[k / 2];
    return s0;
}

}  // namespace swirl
