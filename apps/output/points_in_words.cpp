#include "apps/output/points_in_words.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace swirl::apps {

std::string point_heading(std::size_t coordinates, const std::optional<Units>& units) {
    return fmt::format("{}{}", coordinates == 4 ? "psi,vn,vt,S" : "psi,chi,vn,vt,S",
                       units ? " (vn and vt in m/s)" : "");
}

std::string point_in_words(std::vector<double> point, const std::optional<Units>& units) {
    for (const std::size_t i : {point.size() - 3, point.size() - 2})
        point[i] = in_units(point[i], units, "R_c omega_s");
    std::string digits;
    for (const double x : point) digits += fmt::format("{}{:.12g}", digits.empty() ? "" : ",", x);
    return digits;
}

}  // namespace swirl::apps
