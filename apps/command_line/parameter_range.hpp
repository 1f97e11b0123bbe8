// --along NAME=A:B[:COUNT], and, with columns, NAME=A:B:COUNT:log and NAME=V,V,…: the parameter that a branch or a
// diagram runs over; --plane NAME=A:B.
#pragma once

#include "apps/command_line/errors.hpp"
#include "map/derivative/parameter.hpp"

#include <string>
#include <vector>

namespace swirl::apps {

struct ParameterRange {
    std::string name;                    ///< as given
    std::optional<Parameter> parameter;  ///< empty: S or tau, the members of a family
    double low = 0, high = 0;
    std::vector<double> columns;  ///< of a diagram; empty without COUNT
    bool falling = false;         ///< A > B
};

/// @throws BadInput naming the value and what is allowed
///   counted   COUNT is wanted
///   families  S and tau are allowed
///   flag      that it was given by
ParameterRange parameter_range_from(const std::string& text, bool counted, bool families,
                                    const std::string& flag = "along");

/// "alpha=", ...: with what such a range begins. `families` as above.
std::vector<std::string> parameters_to_offer(bool families = false);

}  // namespace swirl::apps
