// The functions in which the number types of the map differ: double and long double here, 113 bits in quad.hpp, dual
// numbers in jets.hpp. A file that computes with one of the latter includes its header.
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>

namespace swirl {

/// What a number type is to the map: the plain number below it (T itself, or what a Jet differentiates), π, and the
/// text of a value: a double's shortest that reads back the same, 17 digits of a longer number.
template <class T>
struct NumberTraits {
    using PlainNumber = T;
    static const T& plain(const T& value) { return value; }
    static T pi() { return std::numbers::pi_v<T>; }
    static std::string text(T value) {
        char digits[32];  // 24 characters at most
        char* const last = digits + sizeof digits;
        if constexpr (std::is_same_v<T, long double>)
            return {digits, std::to_chars(digits, last, value, std::chars_format::general, 17).ptr};
        else
            return {digits, std::to_chars(digits, last, value).ptr};
    }
};

/// The plain number below a type: T itself, or what a Jet differentiates.
template <class T>
using Plain = typename NumberTraits<T>::PlainNumber;

/// The value of a number without its derivatives.
template <class T>
inline const Plain<T>& plain(const T& value) {
    return NumberTraits<T>::plain(value);
}

/// Unit roundoff spacing ε of T: 2⁻⁵² for double.
template <class T>
inline Plain<T> epsilon() {
    return std::numeric_limits<Plain<T>>::epsilon();
}

/// A tolerance of rounding: `in_double` for double, and for T as many of its own ε.
template <class T>
inline Plain<T> tolerance(double in_double) {
    return Plain<T>(in_double) * (epsilon<T>() / Plain<T>(epsilon<double>()));
}

/// p/q, rounded once in T's own precision.
template <class T>
constexpr Plain<T> fraction(int p, int q) {
    return Plain<T>(p) / Plain<T>(q);
}

template <class T>
inline Plain<T> pi() {
    return NumberTraits<Plain<T>>::pi();
}

/// What a comparison of numbers gives: one answer, and in lanes one for each.
template <class T>
using Truth = bool;

/// φ reduced to (−π, π].
template <class T>
inline T wrapped_angle(const T& angle) {
    using std::floor;
    const Plain<T> turn = 2 * pi<T>();
    const Plain<T> turns = floor((plain(angle) + pi<T>()) / turn);
    T reduced = angle - T(turns * turn);
    if (plain(reduced) <= -pi<T>()) reduced = reduced + T(turn);
    return reduced;
}

namespace detail {

/// One of two values; in lanes each takes its own.
template <class T>
[[gnu::always_inline]] constexpr T choose(bool condition, const T& yes, const T& otherwise) {
    return condition ? yes : otherwise;
}

}  // namespace detail

}  // namespace swirl
