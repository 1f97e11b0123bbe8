// --along NAME=A:B[:COUNT], and, with columns, NAME=A:B:COUNT:log and NAME=V,V,…: the parameter that a branch or a
// diagram runs over; --plane NAME=A:B.
#pragma once

#include "apps/command_line/errors.hpp"
#include "apps/command_line/plain_names.hpp"
#include "apps/studies/scene_map/parameter_range.hpp"

#include <string>
#include <vector>

namespace swirl::apps {

/// @throws BadInput naming the value and what is allowed
///   counted   COUNT is wanted
///   families  S and tau are allowed
///   flag      that it was given by
ParameterRange parameter_range_from(const std::string& text, bool counted, bool families,
                                    const std::string& flag = "along");

/// What a range may be over.
enum class RangesOver {
    plain_scenes,  ///< the parameters of a scene without drag and tangential restitution
    scenes,        ///< those of every scene
    families,      ///< those, and S and tau
};

/// "alpha, beta, ...", for help and messages.
std::string parameters_in_words(RangesOver over);

/// "alpha=", ...: with what such a range begins.
std::vector<std::string> parameters_to_offer(RangesOver over);

}  // namespace swirl::apps
