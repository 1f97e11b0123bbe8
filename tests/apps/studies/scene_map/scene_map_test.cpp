// A scene's map as analyses see it: the orbit that `simulate` follows, to the bit; its derivative; its letters.
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/apps/studies/scene_map/scene_of.hpp"
#include "tests/map/same_bits.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::studies {
namespace {

using tests::same_bits, tests::scene_of;
using State = PostImpactState<double>;

/// Every shape and impact rule; chaos, cycles, chatter with sustained contact.
const Scene<double> scenes[] = {scene_of(6, 0.3, 0.5, 0.5, 0.95),
                                scene_of(6, 0.3, 0.5, 0.5, 0.9, Law::newton),
                                scene_of(6, 0.3, 0.5, 0.5, 0.9, Law::stronge),
                                scene_of(5, 0.4, 0.5, 0.0, 1.0),
                                scene_of(6, 0.4, 0.5, 0.5, 0.9),
                                scene_of(4, 0.3, 0.98, 0.46, 0.02),
                                scene_of(disk_sides, 0.3, 0.1, 0.5, 1.0),
                                scene_of(disk_sides, 0.3, 0.1, 0.0, 1.0)};

/// The first impacts of the orbit from random start 1, as `simulate` follows it; the last is where it ended.
std::vector<State> simulated(const Scene<double>& scene, std::size_t most) {
    return with_collision_map(scene, [&](const auto& map) {
        Orbit orbit(map, random_start(scene.beta, paper_speed, 1, 0));
        std::vector<State> states;
        while (states.size() < most && orbit.advance()) states.push_back(orbit.post_impact());
        return states;
    });
}

TEST(SceneMap, FollowsTheOrbitOfSimulateBitForBit) {
    for (const auto& scene : scenes) {
        SCOPED_TRACE(testing::Message() << "sides " << scene.sides << ", alpha " << scene.alpha << ", mu " << scene.mu
                                        << ", restitution " << scene.restitution);
        const std::vector<State> states = simulated(scene, 3000);
        ASSERT_GT(states.size(), 20u);
        with_scene_map(scene, [&](const auto& map) {
            const OrbitBegin begin = begin_orbit(map, random_start(scene.beta, paper_speed, 1, 0));
            ASSERT_EQ(begin.impacts, 1);
            ASSERT_TRUE(same_bits(begin.state, states.front()));
            State one_by_one = begin.state, with_derivatives = begin.state;
            for (std::size_t i = 1; i < states.size(); ++i) {
                const auto step = map.advance(one_by_one);
                ASSERT_TRUE(step.alive && same_bits(step.state, states[i])) << "impact " << i + 1;
                one_by_one = step.state;
                if (i > 200) continue;
                with_derivatives = map.linearise(with_derivatives).state;
                ASSERT_TRUE(same_bits(with_derivatives, states[i])) << "impact " << i + 1;
            }
            // What repeats itself is left out, and what has no next impact ends: both without another bit.
            State all_at_once = begin.state;
            const auto steps = static_cast<std::int64_t>(states.size()) - 1;
            EXPECT_EQ(analysis::follow(map, all_at_once, steps), steps);
            EXPECT_TRUE(same_bits(all_at_once, states.back()));
            if (states.size() < 3000) {
                EXPECT_EQ(analysis::follow(map, all_at_once, 10), 0);
            }
        });
    }
}

/// A step that an orbit has taken is not taken again for its derivative, which is that of `linearise` to rounding; one
/// through contact is.
TEST(SceneMap, LinearisesStepsThatAreKnown) {
    int flights = 0, through_contact = 0;
    for (const auto& scene : scenes) {
        SCOPED_TRACE(testing::Message() << "sides " << scene.sides << ", alpha " << scene.alpha << ", mu " << scene.mu
                                        << ", restitution " << scene.restitution);
        with_scene_map(scene, [&](const auto& map) {
            State z = begin_orbit(map, random_start(scene.beta, paper_speed, 1, 0)).state;
            for (int i = 0; i < 200; ++i) {
                const auto step = map.linearise(z);
                if (!step.alive) break;
                const auto known = map.linearise(z, {step.state, step.duration, step.letter});
                ASSERT_TRUE(known.alive && same_bits(known.state, step.state));
                EXPECT_EQ(known.duration, step.duration);
                EXPECT_EQ(known.letter, step.letter);
                EXPECT_EQ(known.integral, step.integral);
                EXPECT_EQ(known.cost, step.letter < 0 ? step.cost : 1) << "impact " << i + 2;
                ++(step.letter < 0 ? through_contact : flights);
                const double off = (known.derivative - step.derivative).norm();
                EXPECT_LE(off, step.letter < 0 ? 0 : 1e-11 * step.derivative.norm()) << "impact " << i + 2;
                z = step.state;
            }
        });
    }
    EXPECT_GT(flights, 1000);
    EXPECT_GT(through_contact, 30);
}

TEST(SceneMap, ItsCoordinatesLeadBackToTheStateToRounding) {
    for (const auto& scene : scenes)
        with_scene_map(scene, [&](const auto& map) {
            for (const State& z : simulated(scene, 100)) {
                const State back = map.state_at(map.coordinates(z));
                EXPECT_NEAR(back.psi.x, z.psi.x, 4e-16);
                EXPECT_NEAR(back.psi.y, z.psi.y, 4e-16);
                EXPECT_NEAR(back.chi.x, z.chi.x, 4e-16);
                EXPECT_NEAR(back.chi.y, z.chi.y, 4e-16);
                EXPECT_EQ(back.vn, z.vn);
                EXPECT_EQ(back.vt, z.vt);
                EXPECT_EQ(back.spin, z.spin);
            }
        });
}

TEST(SceneMap, StopsWhenItIsTold) {
    with_scene_map(scenes[0], [&](const auto& map) {
        State z = begin_orbit(map, random_start(0.5, paper_speed, 1, 0)).state;
        int asked = 0;
        const auto steps = analysis::follow(map, z, 1'000'000'000, [&] { return ++asked == 3; });
        EXPECT_GT(steps, 0);
        EXPECT_LT(steps, 100'000);
    });
}

TEST(Letter, IsOneNumber) {
    for (const int vertex_step : {0, 1, 5, 200})
        for (int mode = 0; mode < 6; ++mode)
            for (const bool through_contact : {false, true}) {
                const Letter back =
                    letter_from(number_of(Letter{vertex_step, static_cast<ContactMode>(mode), through_contact}));
                EXPECT_EQ(back.vertex_step, vertex_step);
                EXPECT_EQ(static_cast<int>(back.mode), mode);
                EXPECT_EQ(back.through_contact, through_contact);
            }
}

}  // namespace
}  // namespace swirl::studies
