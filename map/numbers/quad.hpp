// 113-bit arithmetic for the map: libquadmath's where the compiler has it, Boost's own elsewhere (slower, the same
// precision).
#pragma once

#include "map/numbers/real.hpp"

#include <boost/math/constants/constants.hpp>
#if defined(SWIRL_HAS_QUADMATH)
#include <boost/multiprecision/float128.hpp>
#else
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <ios>
#include <string>

namespace swirl {

#if defined(SWIRL_HAS_QUADMATH)
using Quad = boost::multiprecision::float128;
#else
using Quad = boost::multiprecision::cpp_bin_float_quad;
#endif

template <>
struct NumberTraits<Quad> {
    using PlainNumber = Quad;
    static const Quad& plain(const Quad& value) { return value; }
    static Quad pi() { return boost::math::constants::pi<Quad>(); }
    static std::string text(const Quad& value) { return value.str(17, std::ios_base::fmtflags{}); }
};

}  // namespace swirl
