// Where an orbit meets the section first, and how it ends if it does.
#pragma once

#include "apps/command_line/start_options.hpp"
#include "map/orbit.hpp"

namespace swirl::apps {

/// The orbit's first state on the section, and how its end is called if it ends within `limit` impacts.
template <class Map>
Outcome ending_of(const Map& map, const Start<double>& start, long long limit, SectionPoint<double>& first,
                  long long& impacts) {
    return std::visit(
        [&](const auto& s) {
            Orbit orbit(map, s);
            if constexpr (std::is_same_v<std::decay_t<decltype(s)>, SectionPoint<double>>) first = s;
            bool known = std::is_same_v<std::decay_t<decltype(s)>, SectionPoint<double>>;
            while (orbit.impacts() < limit && orbit.advance()) {
                if (!known) first = section_point(orbit.launch());
                known = true;
            }
            impacts = orbit.impacts();
            return orbit.outcome();
        },
        start);
}

}  // namespace swirl::apps
