#include "apps/classify/classify_command.hpp"
#include "apps/section_system.hpp"
#include "map/orbit.hpp"

namespace swirl::apps {

namespace {

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

}  // namespace

NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& settings) {
    return with_collision_map(scene, [&](const auto& map) {
        NamedMode named;
        SectionPoint<double> first{};
        named.outcome = ending_of(map, start, 1, first, named.impacts);
        if (named.impacts == 0) {
            named.verdict.ended = true;
            return named;
        }
        const SectionSystem system(map);
        named.verdict = analysis::classify(system, system.state_of(first), system.dimension - 1, settings);
        named.impacts += named.verdict.steps;
        if (named.verdict.ended) named.outcome = ending_of(map, start, named.impacts + 1, first, named.impacts);
        return named;
    });
}

}  // namespace swirl::apps
