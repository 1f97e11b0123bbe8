// Vectors of the plane and unbiased factors of numbers.
#pragma once

namespace swirl {

#define SWIRL_INLINED constexpr
#include "map/numbers/vec2_formulas.hpp"
#undef SWIRL_INLINED

/// c in two parts.
template <class T>
constexpr UnbiasedFactor<T> unbiased(const T& c) {
    const T first = T(1.0012484394506866) * c;
    return {first, c - first};  // exact: the two are near to each other
}

}  // namespace swirl
