// Section points as people read them and give them to --from, --near and --point.
#pragma once

#include "apps/output/units.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps {

/// "psi,chi,vn,vt,S", of a disk's four coordinates "psi,vn,vt,S"; in SI units with " (vn and vt in m/s)".
std::string point_heading(std::size_t coordinates, const std::optional<Units>& units);

/// The numbers of a point, in 12 digits, in the units in which flags take them.
std::string point_in_words(std::vector<double> point, const std::optional<Units>& units);

}  // namespace swirl::apps
