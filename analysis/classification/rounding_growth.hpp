// How far rounding is carried along a cycle that forgets its past.
#pragma once

#include "analysis/section_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace swirl::analysis {

/// What an error of ε becomes along the k steps from z: ε max ‖DF_m … DF_j‖ over m, j being the first step after the last
/// that annihilated every direction (or the first of all). A cycle may return to the bit, as annihilation undoes
/// whatever was before, and yet lead through chaos in between: from about 1 on where it closes is an accident of
/// rounding. Infinite if the map ends on the way. Cost: k derivatives.
template <SectionMap M>
double rounding_growth(const M& map, Vector<M::dimension> z, std::int64_t k) {
    constexpr double rank_tolerance = 1e-13;  // as LyapunovOptions
    Matrix<M::dimension> product = Matrix<M::dimension>::Identity();
    double grown = 0, largest = 0;  // logarithms
    for (std::int64_t i = 0; i < k; ++i) {
        const auto step = map.linearise(z);
        if (!step.alive || !step.derivative.allFinite()) return std::numeric_limits<double>::infinity();
        const Matrix<M::dimension> next = step.derivative * product;
        const double size = next.norm();
        if (size > rank_tolerance * step.derivative.norm()) {
            grown += std::log(size);
            product = next / size;
        } else {
            grown = 0;
            product.setIdentity();
        }
        largest = std::max(largest, grown);
        z = step.state;
    }
    return std::numeric_limits<double>::epsilon() * std::exp(largest);
}

}  // namespace swirl::analysis
