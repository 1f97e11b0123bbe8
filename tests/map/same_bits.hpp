// Equality to the bit: zero is not minus zero, and NaN is itself.
#pragma once

#include "map/model/section.hpp"

#include <bit>
#include <cstdint>

namespace swirl::tests {

inline bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bits(const PostImpactState<double>& a, const PostImpactState<double>& b) {
    return same_bits(a.psi.x, b.psi.x) && same_bits(a.psi.y, b.psi.y) && same_bits(a.chi.x, b.chi.x) &&
           same_bits(a.chi.y, b.chi.y) && same_bits(a.vn, b.vn) && same_bits(a.vt, b.vt) && same_bits(a.spin, b.spin);
}

}  // namespace swirl::tests
