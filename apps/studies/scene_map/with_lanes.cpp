#include "apps/studies/scene_map/dynamics_in_double.hpp"
#include "apps/studies/scene_map/lanes.hpp"
#include "map/batch/orbit_batch.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace swirl::studies {

namespace {

/// Where the steps of a batch go as they are made, orbit by orbit mixed.
template <class Map>
struct Keeper {
    std::span<LaneOrbit<section_dimension<Map::shape>>> orbits;
    const BatchedOrbit<Map>* first;
    std::vector<PostImpactState<double>>& before;

    std::size_t place_of(const BatchedOrbit<Map>& orbit) const { return static_cast<std::size_t>(&orbit - first); }
    bool wants(const BatchedOrbit<Map>& orbit) const { return orbits[place_of(orbit)].kept != nullptr; }

    void operator()(BatchedOrbit<Map>& orbit, const BatchedImpact& impact) const {
        const std::size_t i = place_of(orbit);
        auto& steps = orbits[i];
        if (impact.alone != nullptr) {
            steps.excess += cost_of(*impact.alone) - 1;
            steps.derivative_is_zero |= has_rested(*impact.alone);
            if (steps.excess > steps.most_excess) orbit.wanted = orbit.done;  // it goes on alone
        }
        if (steps.kept == nullptr) return;
        const KeptSteps& kept = *steps.kept;
        kept.states.push_back(before[i]);
        kept.durations.push_back(impact.flight_time);
        kept.integrals.push_back(impact.alone ? impact.alone->turned : before[i].spin * impact.flight_time);
        kept.letters.push_back(number_of(impact.alone ? letter_of(*impact.alone)
                                                      : Letter{impact.vertex_step, impact.impulse.mode, false}));
        detail::copy_state(orbit.state, before[i]);
    }
};

void forget(KeptSteps& kept, std::size_t size) {
    kept.states.resize(size);
    kept.durations.resize(size);
    kept.integrals.resize(size);
    kept.letters.resize(size);
}

}  // namespace

bool has_lanes() {
    return true;
}

template <Shape shape, ImpactRule rule>
void follow_together(std::span<LaneOrbit<section_dimension<shape>>> orbits) {
    using Map = CollisionMap<double, shape, rule>;
    using Dynamics = DynamicsInDouble<Map>;
    std::vector<BatchedOrbit<Map>> batch;
    std::vector<PostImpactState<double>> before;
    std::vector<std::size_t> sizes;
    for (const auto& orbit : orbits) {
        const auto& dynamics = static_cast<const Dynamics&>(*orbit.dynamics);
        batch.push_back({&dynamics.return_map(), orbit.z, orbit.most_excess < 0 ? 0 : orbit.count});
        before.push_back(orbit.z);
        sizes.push_back(orbit.kept ? orbit.kept->states.size() : 0);
    }
    follow_batch(std::span(batch), Keeper<Map>{orbits, batch.data(), before});
    for (std::size_t i = 0; i < batch.size(); ++i) {
        auto& orbit = orbits[i];
        orbit.taken =
            batch[i].outcome == Outcome::completed && batch[i].done == orbit.count && orbit.excess <= orbit.most_excess;
        if (orbit.taken)
            orbit.z = batch[i].state;
        else if (orbit.kept)
            forget(*orbit.kept, sizes[i]);
    }
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_LANES, double)

}  // namespace swirl::studies
