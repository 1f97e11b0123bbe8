// Batches of random orbits, each impact of which is compared with the scalar map's, bit for bit.
#pragma once

#include "map/batch/orbit_batch.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/map/same_bits.hpp"

#include <hwy/targets.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace swirl::tests {

/// Scenes of one map, with an orbit each.
template <class Map>
struct Orbits {
    std::deque<Map> maps;
    std::deque<ReturnMap<Map>> returns;
    std::vector<BatchedOrbit<Map>> orbits;

    void add(const Scene<double>& scene, const PostImpactState<double>& start, long long wanted) {
        maps.emplace_back(scene);
        returns.emplace_back(maps.back());
        orbits.push_back({&returns.back(), start, wanted});
    }
};

/// One step of the scalar code, ended as ReducedOrbit ends. @return there was an impact
template <class Map>
bool scalar_step(const ReturnMap<Map>& map, ReturnStep<double>& step, Outcome& outcome) {
    outcome = map.advance(step);
    if (outcome != Outcome::completed) return false;
    if (has_come_to_rest(map.map().body(), step.collision.after)) outcome = Outcome::resting;
    if (has_diverged(map.map().body(), step.collision.after)) outcome = Outcome::diverged;
    return true;
}

struct Compared {
    long long impacts = 0;
    long long by_lanes = 0;
    long long different = 0;
    BatchUse use;
};

/// Follows the orbits in a batch, and each of them by the scalar map beside it.
template <class Map>
Compared compare(std::vector<BatchedOrbit<Map>> orbits) {
    Compared result;
    std::vector<BatchedOrbit<Map>> unobserved = orbits;  // whose states are written at their ends alone
    follow_batch(std::span(unobserved));
    std::vector<ReturnStep<double>> scalar(orbits.size());
    std::vector<Outcome> outcomes(orbits.size(), Outcome::completed);
    for (std::size_t i = 0; i < orbits.size(); ++i) scalar[i].collision.after = orbits[i].state;
    result.use = follow_batch(std::span(orbits), [&](const BatchedOrbit<Map>& orbit, const BatchedImpact& impact) {
        const auto i = static_cast<std::size_t>(&orbit - orbits.data());
        const bool goes_on = outcomes[i] == Outcome::completed && scalar_step(*orbit.map, scalar[i], outcomes[i]);
        const Collision<double>& c = scalar[i].collision;
        const bool same = goes_on && same_bits(orbit.state, c.after) && same_bits(impact.flight_time, c.flight_time) &&
                          same_bits(impact.impulse.normal, c.impulse.normal) &&
                          same_bits(impact.impulse.tangential, c.impulse.tangential) &&
                          impact.impulse.mode == c.impulse.mode && impact.vertex_step == c.vertex_step &&
                          impact.steps == c.steps;
        ++result.impacts;
        result.by_lanes += impact.alone == nullptr;
        result.different += !same;
    });
    for (std::size_t i = 0; i < orbits.size(); ++i) {
        // One that ended early has no further impact in the scalar code either, and for the same reason.
        if (orbits[i].done < orbits[i].wanted && outcomes[i] == Outcome::completed)
            result.different += scalar_step(*orbits[i].map, scalar[i], outcomes[i]);
        result.different += orbits[i].outcome != outcomes[i];
        result.different += !same_bits(orbits[i].state, scalar[i].collision.after);
        result.different += !same_bits(unobserved[i].state, orbits[i].state) || unobserved[i].done != orbits[i].done ||
                            unobserved[i].outcome != orbits[i].outcome;
    }
    return result;
}

/// Random scenes of a family, each with its own number of vertices, friction and restitution; some elastic.
template <Shape shape, ImpactRule rule>
Orbits<CollisionMap<double, shape, rule>> random_orbits(std::uint64_t seed, int count, long long impacts) {
    Orbits<CollisionMap<double, shape, rule>> orbits;
    Random random(seed);
    for (int k = 0; k < count; ++k) {
        const int sides = shape == Shape::disk ? disk_sides : random.one_of({3, 4, 5, 6, 6, 7, 8, 9, 12, 100, 1024});
        const double mu = rule == ImpactRule::frictionless ? 0 : random.log_between(0.01, 2);
        const double restitution = random.chance(0.5) ? 1 : random.between(0.3, 1);
        const Law law = rule == ImpactRule::newton    ? Law::newton
                        : rule == ImpactRule::stronge ? Law::stronge
                                                      : Law::poisson;
        Scene<double> scene = random_scene(random, sides, mu, restitution, law);
        if (shape == Shape::disk && k % 3 == 0) scene.tangential_restitution = (k % 30) / 27.0;
        if (k % 10 == 9) scene.alpha = random.log_between(1e-6, 0.03);  // short sides, of few vertices too
        const SectionPoint<double> start = random_point(random, scene, random.log_between(0.01, 2));
        orbits.add(scene, post_impact_state(start), impacts);
    }
    return orbits;
}

/// Only this instruction set from here on, all of them again at the end.
class OnlySet {
public:
    explicit OnlySet(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
    ~OnlySet() { hwy::SetSupportedTargetsForTest(0); }
    OnlySet(const OnlySet&) = delete;
    OnlySet& operator=(const OnlySet&) = delete;
};

}  // namespace swirl::tests
