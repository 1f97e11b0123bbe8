// Extreme scales: two vertices at once, decaying orbits, speeds far from the swirl's.
#include "map/orbit/orbit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace swirl {
namespace {

Scene<double> scene_of(int sides, double alpha, double beta, double mu, double e, Law law = Law::poisson) {
    return {sides, alpha, beta, mu, e, law, uniform_inertia_factor<double>(sides)};
}

/// The states just after the first impacts, and the orbit's outcome then.
struct Followed {
    std::vector<LabState<double>> states;
    std::vector<bool> simultaneous;
    Outcome outcome = Outcome::completed;
};

Followed follow(const Scene<double>& scene, const LabStart<double>& start, int impacts) {
    return with_collision_map(scene, [&](const auto& map) {
        Followed followed;
        Orbit orbit(map, start);
        while (orbit.impacts() < impacts && orbit.advance()) {
            followed.states.push_back(orbit.lab());
            followed.simultaneous.push_back(orbit.collision().simultaneous);
        }
        followed.outcome = orbit.outcome();
        return followed;
    });
}

TEST(TwoVerticesAtOnce, AreNoChatter) {
    // Head-on with an edge: one vertex strikes, the other at the same moment, then both leave.
    for (const int sides : {3, 4, 6})
        for (const double e : {0.5, 0.9})
            for (const double offset : {-1e-9, 0.0, 1e-16, 1e-9}) {
                const LabStart<double> start{0, 0, 1, 0, M_PI / sides + offset, 0};
                const auto followed = follow(scene_of(sides, 0.4, 0, 0.5, e), start, 12);
                EXPECT_EQ(followed.outcome, Outcome::completed) << sides << " sides, e = " << e << ", " << offset;
                EXPECT_EQ(followed.states.size(), 12U);
                EXPECT_EQ(followed.simultaneous.front(), std::abs(offset) < 1e-12) << offset;
            }
}

TEST(TwoVerticesAtOnce, ThatRockLoseEnergyAndGoOn) {
    // Without friction and with e < 1 J falls at every impact (contact between them keeps it to its 1e-13 margins), and
    // a polygon ends on a vertex or rocks on an edge for long.
    long ended = 0, impacts = 0;
    for (const int sides : {3, 4, 5, 12})
        for (int i = 0; i < 10; ++i) {
            const auto scene = scene_of(sides, 0.4, 0.5, 0, 0.3);
            with_collision_map(scene, [&](const auto& map) {
                Orbit orbit(map, LabStart<double>{0.5, 0, 0.3 * std::cos(i), 0.3 * std::sin(i), 0.1 * i, 0});
                double jacobi = HUGE_VAL;
                while (orbit.impacts() < 5'000 && orbit.advance()) {
                    const double now = jacobi_of(map.body(), orbit.post_impact());
                    ASSERT_LE(now, jacobi + 1e-12) << sides << " sides, start " << i << ", impact " << orbit.impacts();
                    jacobi = now;
                }
                EXPECT_TRUE(orbit.outcome() == Outcome::in_contact || orbit.frame().time.unwound() > 100)
                    << sides << " sides, start " << i << ": " << name_of(orbit.outcome());
                ended += orbit.outcome() == Outcome::in_contact;
                impacts += orbit.impacts();
            });
        }
    std::printf("%ld of 40 end in contact, after %ld impacts in all\n", ended, impacts);
}

TEST(DyingOrbit, AtRestTheContainerHasNoScaleOfTime) {
    // β = 0: slower by a power of two is the same orbit, later. Rounding alone differs, and grows with the orbit.
    for (const int sides : {disk_sides, 3, 6, 1000})
        for (const int power : {20, 60, 200}) {
            const Scene<double> scene = scene_of(sides, 0.3, 0, 0.5, 0.8);
            const double slow = std::ldexp(1.0, -power);
            const auto quick = follow(scene, {0.1, 0.05, 0.8, 0.5, 0.2, 0.7}, 12);
            const auto late = follow(scene, {0.1, 0.05, 0.8 * slow, 0.5 * slow, 0.2, 0.7 * slow}, 12);
            ASSERT_EQ(quick.states.size(), late.states.size());
            for (std::size_t i = 0; i < quick.states.size(); ++i) {
                EXPECT_NEAR(late.states[i].x, quick.states[i].x, 1e-9) << sides << " sides, 2^-" << power << ", " << i;
                EXPECT_NEAR(late.states[i].y, quick.states[i].y, 1e-9);
                EXPECT_NEAR(late.states[i].t * slow, quick.states[i].t, 1e-9 * (1 + quick.states[i].t));
                EXPECT_NEAR(late.states[i].spin / slow, quick.states[i].spin, 1e-8);
            }
        }
}

TEST(DyingOrbit, TimeGoesForwardUntilItRests) {
    for (const Law law : {Law::poisson, Law::newton, Law::stronge})
        for (const int sides : {disk_sides, 3, 4, 5, 7}) {
            const auto followed = follow(scene_of(sides, 0.4, 0, 1.5, 0.5, law), {0, 0, 0.14, 0.02, 0.3, 0}, 20'000);
            // A disk that rolls, or a vertex that is pressed on, may end in contact instead.
            EXPECT_TRUE(followed.outcome == Outcome::resting || followed.outcome == Outcome::in_contact)
                << name_of(followed.outcome) << ", " << sides << " sides, " << name_of(law);
            for (std::size_t i = 1; i < followed.states.size(); ++i)
                ASSERT_GE(followed.states[i].t, followed.states[i - 1].t) << i;
        }
}

TEST(Simultaneous, IsMeasuredOnTheFlightsOwnScale) {
    // At V = 1e15 a whole flight takes 1e-15: short is not simultaneous.
    const auto followed = follow(scene_of(6, 0.4, 0.5, 0.5, 1), {0.5, 0, 1e15, 0.3e15, 0.1, 0}, 200);
    ASSERT_EQ(followed.outcome, Outcome::completed);
    EXPECT_EQ(std::count(followed.simultaneous.begin(), followed.simultaneous.end(), true), 0);
}

/// Scenes whose inertia factor is so small that the powers of its reciprocal overflow, found by fuzzing: an impact
/// after contact, and the first of all in flight, would be NaN.
struct NoNumber {
    Scene<double> scene;
    LabStart<double> start;
};
const NoNumber no_numbers[] = {
    {{6, 0.9999999983512327, 2.5100829905920012e-58, 0.002424327201173087, 0, Law::newton, 7.53609227111714e-62},
     {2.5100829905920012e-58, 0, -1.3157074751973064e-09, -6.872796495853828e-09, -1.4533550802013793,
      -5.449849613638402e-12}},
    {{3, 2.2653658627711155e-06, 1.3833531105652338e-44, 1.259709553248775, 1.1092548275540864e-307, Law::stronge,
      1e-75},
     {1.3833531105652338e-44, 0, -3.887925141037954e-40, -1.000005120619432e-75, 1.1918018572032452e-08,
      0.4490206358022988}}};

TEST(AnImpactThatIsNoNumber, EndsTheOrbitBeforeIt) {
    for (const NoNumber& known : no_numbers)
        with_collision_map(known.scene, [&](const auto& map) {
            const ReturnMap returns(map);
            ReturnStep<double> step = returns.advance(flight_from(map.body(), known.start));
            Outcome outcome = step.outcome;
            while (outcome == Outcome::completed) outcome = returns.advance(step);
            EXPECT_EQ(outcome, Outcome::diverged);
            const PostImpactState<double>& after = step.collision.after;
            EXPECT_TRUE(std::isfinite(after.vn + after.vt + after.spin + after.psi.x + after.chi.x));
        });
}

/// The collision map of a scene, one of whose impacts, counted from 0, is no number.
struct FailingMap {
    using Number = double;
    using Scenes = CollisionMap<double, Shape::polygon, ImpactRule::poisson>;
    static constexpr Shape shape = Scenes::shape;
    static constexpr ImpactRule rule = Scenes::rule;

    const Scene<double>& scene() const { return map.scene(); }
    const Body<double>& body() const { return map.body(); }
    void advance(const Flight<double>& flight, Collision<double>& collision) const {
        map.advance(flight, collision);
        if (made++ >= fails) collision.after.vn = std::nan("");
    }
    void advance(const PostImpactState<double>& from, Collision<double>& collision) const {
        advance(flight_from(body(), from), collision);
    }
    Collision<double> advance(const Flight<double>& flight) const {
        Collision<double> collision;
        advance(flight, collision);
        return collision;
    }
    void strike(const Flight<double>& flight, const Instant<double>& at, const Vec2<double>& arm, int vertex,
                Collision<double>& collision) const {
        map.strike(flight, at, arm, vertex, collision);
    }

    Scenes map;
    long fails;
    mutable long made = 0;
};

TEST(AnImpactThatIsNoNumber, LeavesTheStateBeforeItInPlace) {
    const FailingMap map{FailingMap::Scenes(scene_of(6, 0.4, 0.5, 0.5, 0.9)), 7};
    const ReturnMap<FailingMap> returns(map);
    ReturnStep<double> step = returns.advance(flight_from(map.body(), LabStart<double>{0.5, 0, 0.1, 0.2, 0.3, 0.1}));
    PostImpactState<double> last;
    Outcome outcome = step.outcome;
    for (int i = 0; i < 100 && outcome == Outcome::completed; ++i) {
        last = step.collision.after;
        outcome = returns.advance(step);
    }
    EXPECT_EQ(outcome, Outcome::diverged);
    EXPECT_GT(map.made, map.fails);
    EXPECT_EQ(step.collision.after.vn, last.vn);
    EXPECT_EQ(step.collision.after.spin, last.spin);
    EXPECT_EQ(step.collision.after.psi.x, last.psi.x);
}

TEST(Start, NumbersWhosePowersCannotBeHeldAreRefused) {
    const auto scene = scene_of(6, 0.4, 0.5, 0.5, 1);
    EXPECT_THROW(follow(scene, {0.5, 0, 1e-300, 0, 0, 0}, 1), std::invalid_argument);
    EXPECT_THROW(follow(scene, {0.5, 0, 1e80, 0, 0, 0}, 1), std::invalid_argument);
    EXPECT_THROW(validated(scene_of(6, 1e-200, 0.5, 0.5, 1)), std::invalid_argument);
    EXPECT_THROW(validated(scene_of(6, 0.4, 1e-80, 0.5, 1)), std::invalid_argument);
    EXPECT_THROW(validated(scene_of(6, 0.4, 0.5, 1e300, 1)), std::invalid_argument);
    EXPECT_EQ(follow(scene, {0.5, 0, 1e-70, 0, 0, 0}, 1).outcome, Outcome::completed);
}

}  // namespace
}  // namespace swirl
