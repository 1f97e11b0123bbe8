// Where an orbit meets the section first, and how it ends if it does.
#pragma once

#include "apps/command_line/start_options.hpp"
#include "map/orbit/orbit.hpp"
#include "map/orbit/speed_limits.hpp"

namespace swirl::apps {

/// The orbit's first state on the section, and how its end is called if it ends within `limit` impacts.
template <class Map>
Outcome ending_of(const Map& map, const Start<double>& start, long long limit, SectionPoint<double>& first,
                  long long& impacts) {
    return std::visit(
        [&](const auto& s) {
            ReducedOrbit orbit(map, s);
            if constexpr (std::is_same_v<std::decay_t<decltype(s)>, SectionPoint<double>>) first = s;
            bool known = std::is_same_v<std::decay_t<decltype(s)>, SectionPoint<double>>;
            while (orbit.impacts() < limit && orbit.advance()) {
                if (!known) first = section_point(orbit.post_impact());
                known = true;
            }
            impacts = orbit.impacts();
            return orbit.outcome();
        },
        start);
}

/// How an orbit ends whose last state on the section has no next one (`alive` false), bit for bit: the same orbit
/// followed in the laboratory parts from this one by rounding, and may end elsewhere. One more impact if it dies away
/// or diverges.
template <class System>
Outcome ending_at(const System& system, const typename System::State& last, long long& impacts) {
    const auto return_step = system.return_map().advance(post_impact_state(System::point_of(last)));
    if (return_step.outcome != Outcome::completed) return return_step.outcome;
    ++impacts;
    if (has_come_to_rest(system.map().body(), return_step.collision.after)) return Outcome::resting;
    if (has_diverged(system.map().body(), return_step.collision.after)) return Outcome::diverged;
    return Outcome::unresolved;  // a coordinate is not finite
}

}  // namespace swirl::apps
