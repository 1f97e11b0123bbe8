// A parameter of the scene and the range that it runs over.
#pragma once

#include "map/model/parameter.hpp"

#include <optional>
#include <string>
#include <vector>

namespace swirl::studies {

struct ParameterRange {
    std::string name;                    ///< alpha, beta, mu, restitution, inertia-factor; of a family S or tau
    std::optional<Parameter> parameter;  ///< empty: S or tau, the members of a family
    double low = 0, high = 0;
    std::vector<double> columns = {};  ///< of a diagram
    bool falling = false;              ///< the columns come by falling values
};

}  // namespace swirl::studies
