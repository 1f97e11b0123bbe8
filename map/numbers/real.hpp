// The number types that the map is written for, and the functions that differ between them.
#pragma once

#include <boost/math/constants/constants.hpp>
#if defined(SWIRL_HAS_QUADMATH)
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif
#include <ceres/jet.h>

#include <cmath>
#include <limits>

namespace swirl {

/// 113-bit arithmetic: libquadmath's where the compiler has it, Boost's own elsewhere (slower, the same precision).
#if defined(SWIRL_HAS_QUADMATH)
using Quad = boost::multiprecision::float128;
#else
using Quad = boost::multiprecision::cpp_bin_float_quad;
#endif

/// The plain number below a type: T itself, or what a Jet differentiates.
template <class T>
struct PlainOf {
    using type = T;
};
template <class T, int D>
struct PlainOf<ceres::Jet<T, D>> {
    using type = T;
};
template <class T>
using Plain = typename PlainOf<T>::type;

/// The value of a number without its derivatives.
template <class T>
inline const T& plain(const T& value) {
    return value;
}
template <class T, int D>
inline const T& plain(const ceres::Jet<T, D>& value) {
    return value.a;
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
    return boost::math::constants::pi<Plain<T>>();
}

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

}  // namespace swirl
