// Arithmetics that differ in the search for the contact alone (map/baselines): there to be compared with.
#pragma once

#include "apps/studies/tradeoff/arithmetic_in.hpp"
#include "map/baselines/baseline_map.hpp"

namespace swirl::studies::tradeoff {

/// Double with another search.
template <BaselineSearch search>
struct WithSearch {
    using Number = double;

    template <class Use>
    static auto with_map(const Scene<double>& scene, Use&& use) {
        return with_collision_map(scene, [&](const auto& exact) {
            using Exact = std::decay_t<decltype(exact)>;
            return use(BaselineMap<Exact::shape, Exact::rule>(exact, search));
        });
    }

    template <class Map>
    using Follower = InNumbers<double>::Follower<Map>;
};

}  // namespace swirl::studies::tradeoff
