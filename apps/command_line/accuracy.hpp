// --accuracy, by name.
#pragma once

#include "apps/command_line/plain_names.hpp"
#include "apps/studies/scene_map/accuracy.hpp"

#include <limits>
#include <string>
#include <vector>

namespace swirl::apps {

/// The accuracy of that name.
///   extended_bits  of long double's significand
/// @throws BadInput for a name that is none, and for "extended" where long double has no more bits than double
Accuracy accuracy_from(const std::string& name, int extended_bits = std::numeric_limits<long double>::digits);

/// Those names, whether or not this machine has the arithmetic.
std::vector<std::string> accuracy_names();

/// What --help says of the names.
std::string accuracy_help();

}  // namespace swirl::apps
