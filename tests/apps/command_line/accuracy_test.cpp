// The scene's map in another arithmetic, or with another search: each step computed there and rounded to double.
#include "apps/command_line/accuracy.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/studies/scene_map/in_digits.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/scene_orbit.hpp"
#include "map/model/parameter.hpp"
#include "map/numbers/quad.hpp"
#include "tests/apps/studies/scene_map/scene_of.hpp"
#include "tests/map/same_bits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace swirl::apps {
namespace {

using tests::same_bits, tests::scene_of;
using State = PostImpactState<double>;

/// Every shape and impact rule, without contact.
const Scene<double> scenes[] = {scene_of(6, 0.3, 0.5, 0.5, 1.0),
                                scene_of(6, 0.3, 0.5, 0.5, 0.95, Law::newton),
                                scene_of(6, 0.3, 0.5, 0.5, 0.95, Law::stronge),
                                scene_of(5, 0.4, 0.5, 0.0, 1.0),
                                scene_of(disk_sides, 0.3, 0.1, 0.5, 1.0),
                                scene_of(disk_sides, 0.3, 0.1, 0.0, 1.0)};
constexpr Accuracy others[] = {Accuracy::extended, Accuracy::quad, Accuracy::paper, Accuracy::brent,
                               Accuracy::fixed_step};

double distance(const State& a, const State& b) {
    const double d[] = {a.psi.x - b.psi.x, a.psi.y - b.psi.y, a.chi.x - b.chi.x, a.chi.y - b.chi.y,
                        a.vn - b.vn,       a.vt - b.vt,       a.spin - b.spin};
    double largest = 0;
    for (const double x : d) largest = std::max(largest, std::fabs(x));
    return largest;
}

/// A state of the scene's orbit, past its first impacts.
State some_state(const Scene<double>& scene) {
    return with_scene_map(scene, [&](const auto& map) {
        State z = begin_orbit(map, random_start(scene.beta, paper_speed, 1, 0)).state;
        analysis::follow(map, z, 50);
        return z;
    });
}

TEST(Accuracy, NamesReadBackAndOthersAreRefused) {
    for (const Accuracy accuracy : others) EXPECT_EQ(accuracy_from(std::string(name_of(accuracy))), accuracy);
    EXPECT_EQ(accuracy_from("double"), Accuracy::double_precision);
    for (const char* wrong : {"", "half", "Double", "double ", "fixed_step"})
        EXPECT_THROW(accuracy_from(wrong), BadInput);
}

TEST(Accuracy, ExtendedIsRefusedWhereLongDoubleIsDouble) {
    EXPECT_EQ(accuracy_from("extended", 64), Accuracy::extended);
    EXPECT_EQ(accuracy_from("quad", 53), Accuracy::quad);
    try {
        accuracy_from("extended", 53);
        FAIL() << "53 bits are double's";
    } catch (const BadInput& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("53 bits"), std::string::npos) << text;
        EXPECT_NE(text.find("double, quad, paper, brent, fixed-step"), std::string::npos) << text;
    }
}

// One step in quad, rounded, is the same as in extended but for a last bit; double errs more, and by a few of them.
TEST(Accuracy, AStepInMoreDigitsIsRoundedOnce) {
    double extended_apart = 0, double_apart = 0;
    for (const auto& scene : scenes) {
        State z = some_state(scene);
        for (int i = 0; i < 20; ++i) {
            const auto step_in = [&](Accuracy accuracy) {
                return with_scene_map(
                    scene, [&](const auto& map) { return map.return_step(z); }, contact_horizon, accuracy);
            };
            const auto quad = step_in(Accuracy::quad), extended = step_in(Accuracy::extended),
                       plain = step_in(Accuracy::double_precision);
            ASSERT_EQ(quad.outcome, Outcome::completed);
            ASSERT_EQ(extended.collision.vertex_step, quad.collision.vertex_step);
            ASSERT_EQ(extended.collision.impulse.mode, quad.collision.impulse.mode);
            extended_apart = std::max(extended_apart, distance(extended.collision.after, quad.collision.after));
            double_apart = std::max(double_apart, distance(plain.collision.after, quad.collision.after));
            z = plain.collision.after;
        }
    }
    EXPECT_GT(double_apart, extended_apart) << "double is what it would be without the option";
    EXPECT_LT(extended_apart, 5e-16) << "a last bit of numbers below 2";
    EXPECT_LT(double_apart, 1e-12);
}

// u_n = 0 after an impact without restitution: rounded to double, half of such states would leave into the wall.
TEST(Accuracy, WhatLeavesWithoutRestitutionIsAStateInMoreDigitsToo) {
    int into_wall = 0;
    for (const Law law : {Law::poisson, Law::newton, Law::stronge}) {
        const Scene<double> scene = scene_of(6, 0.4, 0.9, 0.1, 0, law);
        const Body<Quad> body = make_body(scene_in<Quad>(scene));
        State z = some_state(scene);
        with_scene_map(scene, [&](const auto& map) {
            for (int i = 0; i < 20; ++i) {
                into_wall += contact_kinematics(body, state_in<Quad>(z)).un > Quad(0);
                EXPECT_LE(contact_kinematics(body, begin_in<Quad>(body, z)).un, epsilon<Quad>());
                ASSERT_EQ(analysis::follow(map, z, 1), 1);
            }
        });
    }
    EXPECT_GT(into_wall, 0) << "what would be wrong without it is not tried";
}

TEST(Accuracy, FollowingIsStepAfterStep) {
    for (const auto& scene : scenes)
        for (const Accuracy accuracy : others)
            with_scene_map(
                scene,
                [&](const auto& map) {
                    const State z = some_state(scene);
                    State followed = z, stepped = z;
                    const std::int64_t steps = analysis::follow(map, followed, 10);
                    for (std::int64_t i = 0; i < steps; ++i) {
                        const auto step = map.linearise(stepped);
                        ASSERT_TRUE(step.alive);
                        ASSERT_TRUE(step.derivative.allFinite());
                        stepped = step.state;
                    }
                    EXPECT_TRUE(same_bits(followed, stepped));
                    if (accuracy == Accuracy::paper && steps < 10)  // it may find no contact where there is one
                        EXPECT_FALSE(map.advance(stepped).alive);
                    else
                        EXPECT_EQ(steps, 10) << name_of(accuracy);
                },
                contact_horizon, accuracy);
}

// With another search in double nothing is rounded: simulate's orbit is the same.
TEST(Accuracy, ABaselinesOrbitIsThatOfSimulate) {
    for (const auto& scene : scenes)
        for (const Accuracy accuracy : {Accuracy::paper, Accuracy::brent, Accuracy::fixed_step}) {
            const LabStart<double> start = random_start(scene.beta, paper_speed, 1, 0);
            SceneOrbit<double> orbit(scene, start, baseline_of(accuracy));
            with_scene_map(
                scene,
                [&](const auto& map) {
                    ASSERT_TRUE(orbit.advance());
                    State z = begin_orbit(map, start).state;
                    ASSERT_TRUE(same_bits(z, orbit.post_impact()));
                    for (int i = 0; i < 30 && orbit.advance(); ++i) {
                        z = map.advance(z).state;
                        ASSERT_TRUE(same_bits(z, orbit.post_impact())) << name_of(accuracy) << ", impact " << i + 2;
                    }
                },
                contact_horizon, accuracy);
        }
}

TEST(Accuracy, AMapWithOtherNumbersKeepsIt) {
    const Scene<double> scene = scenes[0];
    Scene<double> other = scene;
    other.beta = 0.4;
    const State z = some_state(other);
    const SceneMap<polygon_dimension> map =
        SceneMap<polygon_dimension>(scene, contact_horizon, Accuracy::fixed_step).with(other);
    const SceneMap<polygon_dimension> same(other, contact_horizon, Accuracy::fixed_step), exact(other);
    EXPECT_TRUE(same_bits(map.advance(z).state, same.advance(z).state));
    EXPECT_FALSE(same_bits(map.advance(z).state, exact.advance(z).state));
}

}  // namespace
}  // namespace swirl::apps
