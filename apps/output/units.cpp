#include "apps/output/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace swirl::apps {

std::optional<double> physical_scale(const Units& units, const std::string& unit) {
    std::istringstream factors(unit);
    double scale = 1;
    bool any = false;
    for (std::string factor; factors >> factor; any = true) {
        const bool divides = factor.rfind("1/", 0) == 0;
        if (divides) factor.erase(0, 2);
        const auto caret = factor.find('^');
        const double power = caret == std::string::npos ? 1 : std::strtod(factor.c_str() + caret + 1, nullptr);
        factor.resize(std::min(caret, factor.size()));
        if (factor != "R_c" && factor != "omega_s" && factor != "m") return std::nullopt;
        const double one = factor == "R_c" ? units.length : factor == "m" ? units.mass : 1 / units.time;
        scale *= std::pow(one, divides ? -power : power);
    }
    return any ? std::optional(scale) : std::nullopt;
}

std::string units_in_words(const std::optional<Units>& units) {
    return units ? fmt::format("in your units: R_c = {:g}, 1/omega_s = {:g}, m = {:g}\n", units->length, units->time,
                               units->mass)
                 : "";
}

}  // namespace swirl::apps
