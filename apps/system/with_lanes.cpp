#include "apps/system/lanes.hpp"
#include "apps/system/scene_functions.hpp"
#include "map/batch/orbit_batch.hpp"

#include <cstddef>

namespace swirl::apps {

namespace {

template <class Map>
bool is_ordinary(const BatchedOrbit<Map>& orbit) {
    return !orbit.through_contact && orbit.most_looks <= ordinary_looks;
}

/// The steps of a batch as they are made, orbit by orbit mixed.
template <class Map>
struct Keeper {
    std::span<LaneOrbit> orbits;
    const BatchedOrbit<Map>* first;
    std::vector<PostImpactState<double>>& before;

    void operator()(BatchedOrbit<Map>& orbit, const BatchedImpact& impact) const {
        if (!is_ordinary(orbit)) orbit.wanted = orbit.done;  // it goes on alone
        const auto i = static_cast<std::size_t>(&orbit - first);
        if (orbits[i].kept == nullptr) return;
        const KeptSteps& kept = *orbits[i].kept;
        kept.states.push_back(before[i]);
        kept.durations.push_back(impact.flight_time);
        kept.integrals.push_back(before[i].spin * impact.flight_time);
        before[i] = orbit.state;
    }
};

void forget(KeptSteps& kept, std::size_t size) {
    kept.states.resize(size);
    kept.durations.resize(size);
    kept.integrals.resize(size);
}

}  // namespace

bool has_lanes() {
    return true;
}

template <Shape shape, ImpactRule rule>
void follow_together(std::span<LaneOrbit> orbits) {
    using Scenes = ConcreteScene<shape, rule>;
    using Map = typename Scenes::Map;
    std::vector<BatchedOrbit<Map>> batch;
    std::vector<PostImpactState<double>> before;
    std::vector<std::size_t> sizes;
    for (const LaneOrbit& orbit : orbits) {
        batch.push_back({&Scenes::of(orbit.map).return_map, orbit.z, orbit.count});
        before.push_back(orbit.z);
        sizes.push_back(orbit.kept ? orbit.kept->states.size() : 0);
    }
    follow_batch(std::span(batch), Keeper<Map>{orbits, batch.data(), before});
    for (std::size_t i = 0; i < batch.size(); ++i) {
        LaneOrbit& orbit = orbits[i];
        orbit.taken = batch[i].outcome == Outcome::completed && batch[i].done == orbit.count && is_ordinary(batch[i]);
        if (orbit.taken)
            orbit.z = batch[i].state;
        else if (orbit.kept)
            forget(*orbit.kept, sizes[i]);
    }
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_LANES, double)

}  // namespace swirl::apps
