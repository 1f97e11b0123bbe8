// NaN and infinity, under one name each.
#pragma once

#include <limits>

namespace swirl::analysis {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();  ///< what is not known
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace swirl::analysis
