#include "apps/modes/steady_share_table.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace swirl::apps {

Table<SteadyShare> steady_share_table(const std::string& dimension) {
    return {{dimension},
            {{"S", &SteadyShare::spin, "1", "S of the attracting steady mode"},
             {"period", [](const SteadyShare&) { return std::int64_t{1}; }, "1", "of a fixed point, 1"},
             {"share", &SteadyShare::share, "1", "share of the starts that came to it"},
             {"flight_time", &SteadyShare::flight_time, "1/omega_s", "from impact to impact"},
             {"multiplier", &SteadyShare::multiplier, "1", "its largest |multiplier|"}}};
}

std::vector<double> filled(std::span<const SteadyShare> modes, double SteadyShare::*member, std::size_t length) {
    std::vector<double> values(length, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < modes.size() && i < length; ++i) values[i] = modes[i].*member;
    return values;
}

}  // namespace swirl::apps
