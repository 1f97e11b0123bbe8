// Dual numbers for the map: Ceres' Jets carry derivatives along. map/ includes <ceres/jet.h> here alone, so that no
// file computes with Jets without their traits.
#pragma once

#include "map/numbers/real.hpp"

#include <ceres/jet.h>

namespace swirl {

template <class T, int D>
struct NumberTraits<ceres::Jet<T, D>> {
    using PlainNumber = T;
    static const T& plain(const ceres::Jet<T, D>& value) { return value.a; }
};

}  // namespace swirl
