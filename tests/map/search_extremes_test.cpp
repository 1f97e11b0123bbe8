// The search for the first contact at the limits of its range: very fast, very small, many sides, wider number types.
#include "map/collision_map.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <type_traits>
#include <utility>

namespace swirl {
namespace {

using tests::Random;

Scene<double> scene_of(int sides, double alpha, double beta, double mu = 0.5, double e = 1, Law law = Law::poisson) {
    return {sides, alpha, beta, mu, e, law, uniform_inertia_factor<double>(sides)};
}

template <class T, class From>
Outcome outcome_after(const Scene<T>& scene, const From& start, long long impacts, long long& made) {
    return with_collision_map(scene, [&](const auto& map) {
        ReducedOrbit orbit(map, start);
        while (orbit.impacts() < impacts && orbit.advance()) {
        }
        made = orbit.impacts();
        return orbit.outcome();
    });
}

/// A flight from the wall of a container at rest, faster by a power of two.
template <class Map>
Flight<double> scaled_flight(const Map& map, SectionPoint<double> z, double scale) {
    z.vn *= scale;
    z.vt *= scale;
    z.spin *= scale;
    return flight_from(map.body(), post_impact_state(z));
}

// At these speeds S⁶ overflows: the proof must fail, not succeed.
TEST(SearchAtExtremes, NoProofFromNumbersThatOverflow) {
    Random random(41);
    long direct = 0, later = 0;
    for (const int power : {0, 60, 185, 195, 240})
        for (int i = 0; i < 20'000; ++i) {
            const Scene<double> scene = scene_of(random.one_of({3, 4, 5, 6, 7, 8}), random.between(0.3, 0.95), 0, 0);
            const SectionPoint<double> z = tests::random_point(random, scene, random.log_between(0.01, 1), 1, 8);
            with_collision_map(scene, [&](const auto& map) {
                constexpr Shape shape = std::decay_t<decltype(map)>::shape;
                const Flight<double> flight = scaled_flight(map, z, std::ldexp(1.0, power));
                FirstContact<double> found;
                if (!detail::direct_contact<shape>(map.body(), flight, found))
                    if constexpr (shape == Shape::polygon) found = detail::contact_of_vertex_behind(map.body(), flight);
                if (found.outcome != FirstContactOutcome::contact)
                    if constexpr (shape == Shape::polygon) found = detail::contact_of_next_vertex(map.body(), flight);
                if (found.outcome != FirstContactOutcome::contact) return;
                const auto certain = detail::certain_contact<shape>(map.body(), flight);
                ++direct;
                if (certain.outcome == FirstContactOutcome::contact && found.at.time <= certain.at.time * (1 + 1e-9))
                    return;
                ++later;
                std::printf("2^%d, %d sides, alpha %.17g, point %.17g,%.17g,%.17g,%.17g,%.17g: %.17g after %.17g\n",
                            power, scene.sides, scene.alpha, z.psi, z.chi, z.vn, z.vt, z.spin, found.at.time,
                            certain.at.time);
            });
        }
    std::printf("%ld flights found directly, %ld of them later than by safe steps\n", direct, later);
    EXPECT_GT(direct, 10'000);
    EXPECT_EQ(later, 0);
}

// The ring in which vertices can touch is thinner than rounding: ¼(1 − (1 − α(1 − cos π/N))²) < ε.
TEST(SearchAtExtremes, PolygonsThatAreAllButCirclesFindTheWall) {
    for (const auto& [sides, alpha] : {std::pair{1'000'000, 1e-5}, {100'000, 1e-7}, {1'000'000, 1e-9}})
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Random random(seed);
            const LabStart<double> start{0.1, 0, random.between(-1, 1), random.between(-1, 1), random.angle(), 0.3};
            long long made = 0;
            EXPECT_EQ(outcome_after(scene_of(sides, alpha, 0.1), start, 200, made), Outcome::completed)
                << sides << " sides, alpha " << alpha << ", " << made << " impacts";
        }
}

TEST(SearchAtExtremes, AStepThatIsNoNumberProvesNothing) {
    long long made = 0;
    const LabStart<double> start{0, 0, 1e70, 0, 0.4, 0};
    EXPECT_EQ(outcome_after(scene_of(3, 1e-40, 0.1), start, 5, made), Outcome::diverged);
}

// S = ½ and a triangle: the same to the container after two turns, 2 · ½ · 3 being whole.
TEST(SearchAtExtremes, ABodyAtRestThatSpinsByAFractionHasNoContact) {
    long long made = 0;
    EXPECT_EQ(outcome_after(scene_of(3, 0.4, 0.3, 0), LabStart<double>{0.31, 0, 0, 0, 1, 0.5}, 5, made),
              Outcome::no_contact);
}

/// A vertex that leaves with u_n = 0, exactly in every number type, with speeds of 2⁻⁴⁰ in a swirl of 2⁻⁸⁰.
template <class T>
Flight<T> leaving_flight() {
    Flight<T> flight;
    flight.arm = {T(0.3), T(0.4)};
    flight.centre = {T(1) - flight.arm.x, -flight.arm.y};
    flight.spin = T(std::ldexp(1.0, -40));
    flight.velocity = {flight.spin * flight.arm.y, T(std::ldexp(-0.75, -40))};
    flight.phase = {T(-1), T(0)};
    flight.beta = T(std::ldexp(1.0, -80));
    flight.struck = true;
    return flight;
}

// Plainly formed, the gap is rounding until τ = ε/2⁻⁴⁰ = 2⁻¹² and has half of its digits at τ = 2¹⁴ only.
TEST(SearchAtExtremes, AVertexThatLeavesSlowlyKeepsTheDigitsOfItsGap) {
    const Body<double> body = make_body(scene_of(5, 0.5, std::ldexp(1.0, -80)));
    const auto flight = leaving_flight<double>();
    const auto exact_flight = leaving_flight<Quad>();
    detail::Candidate<double> vertex{0, flight.arm, struck_gap_at_start(flight)};
    const auto departure = detail::departure_of(body, flight, instant_at_start(flight), vertex, false);
    ASSERT_TRUE(departure.leaves);
    for (const double time : {1e-6, 1e-3, 0.1, 0.24, 0.26, 1.0, 3.0, 10.0, 1e3, 1e6, 1e9}) {
        const auto at = instant_at<Shape::polygon>(flight, time);
        const auto exact = struck_gap(exact_flight, instant_at<Shape::polygon>(exact_flight, Quad(time)));
        vertex.arm = at.arm;
        vertex.gap = struck_gap(flight, at);
        const double size = detail::gap_of_departure(flight, departure, at, vertex);
        const double value = static_cast<double>(exact.value), rate = static_cast<double>(exact.rate);
        EXPECT_LT(value, 0) << time;
        EXPECT_LE(std::abs(vertex.gap.value - value), 1e-13 * size) << time;
        EXPECT_LE(std::abs(vertex.gap.value - value), 1e-12 * std::abs(value)) << time;
        EXPECT_LE(std::abs(vertex.gap.rate - rate), 1e-12 * std::abs(rate)) << time;
    }
}

// A body that spins 10¹² times faster than it moves meets the wall after 10¹¹ units of time, each known to 10⁻⁵.
TEST(SearchAtExtremes, FastSpinAfterALongFlightPutsTheVertexOnTheWall) {
    for (const int sides : {3, 5, 8})
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Random random(seed);
            const LabStart<double> start{0, 0, 1e-12, 0, random.angle(), random.log_between(1e2, 1e4)};
            with_collision_map(scene_of(sides, 0.6, 0), [&](const auto& map) {
                constexpr Shape shape = std::decay_t<decltype(map)>::shape;
                const auto contact = first_contact<shape>(map.body(), flight_from(map.body(), start));
                ASSERT_EQ(contact.outcome, FirstContactOutcome::contact);
                const Vec2<double> x = contact.at.centre + contact.arm;
                EXPECT_NEAR(std::sqrt(dot(x, x)), 1, 1e-14) << sides << " sides, seed " << seed;
            });
        }
}

/// The farthest that any vertex is outside at `samples` moments before a contact, from the definition of the gap.
template <class T>
double farthest_before(const Body<T>& body, const Flight<T>& flight, const T& contact, int samples) {
    T farthest(-1);
    for (int i = 1; i < samples; ++i) {
        const auto at = instant_at<Shape::polygon>(flight, T(contact * T(i) / T(samples)));
        for (int k = 0; k < body.sides; ++k) {
            const Vec2<T> x = at.centre + body.turned_to_vertex(at.arm, k);
            farthest = std::max(farthest, T(dot(x, x) - T(1)));
        }
    }
    return static_cast<double>(farthest);
}

// α = 1 − 10⁻⁹ … 1 − 10⁻⁴: the body goes along with the container at a speed far below the swirl's, and steps bounded
// by |V| + β were up to 10⁶ a flight. None may be so long that a contact is passed.
TEST(SearchAtExtremes, ABodyWithLittleRoomFindsTheFirstContactInFewSteps) {
    using T = Quad;  // so that the gap of a sample is not rounding
    Random random(97);
    int most = 0;
    long searched = 0;
    for (int i = 0; i < 300; ++i) {
        const double room = random.log_between(1e-9, 1e-4);
        const int sides = random.one_of({3, 5, 8, 12, 40});
        const double beta = random.log_between(1e-3, 3), spin = random.sign() * random.log_between(1e-3, 1e4);
        const double speed = room * random.log_between(1e-2, 1e2), direction = random.angle(), angle = random.angle();
        const Scene<T> scene{sides, T(1 - room), T(beta), T(0), T(1), Law::poisson, uniform_inertia_factor<T>(sides)};
        const LabStart<T> start{T(beta),  T(0),   T(speed * std::cos(direction)), T(beta + speed * std::sin(direction)),
                                T(angle), T(spin)};
        with_collision_map(scene, [&](const auto& map) {
            if constexpr (std::decay_t<decltype(map)>::shape == Shape::polygon) {
                const Flight<T> flight = flight_from(map.body(), start);
                const auto contact = detail::certain_contact<Shape::polygon>(map.body(), flight);
                ASSERT_EQ(contact.outcome, FirstContactOutcome::contact) << sides << " sides, room " << room;
                most = std::max(most, contact.steps);
                ++searched;
                const double outside = farthest_before(map.body(), flight, contact.at.time, 400);
                EXPECT_LE(outside, 1e-30) << sides << " sides, room " << room << ", spin " << spin;
            }
        });
    }
    std::printf("%ld flights with little room: at most %d steps\n", searched, most);
    EXPECT_LT(most, 400);  // 200 ordinary ones, then the longer
}

template <class T>
T worst_gap(int sides) {
    using std::fabs;
    Random random(7);
    T worst(0);
    int found = 0;
    for (int i = 0; i < 300; ++i) {
        const Scene<double> plain = tests::random_scene(random, sides, 0.5, 1, Law::poisson);
        const Scene<T> scene{
            sides, T(plain.alpha), T(plain.beta), T(0.5), T(1), Law::poisson, uniform_inertia_factor<T>(sides)};
        const SectionPoint<double> z = tests::random_point(random, plain, random.log_between(0.01, 1));
        const SectionPoint<T> start{T(z.psi), T(z.chi), T(z.vn), T(z.vt), T(z.spin)};
        with_collision_map(scene, [&](const auto& map) {
            constexpr Shape shape = std::decay_t<decltype(map)>::shape;
            const Flight<T> flight = flight_from(map.body(), post_impact_state(start));
            FirstContact<T> contact;
            if (!detail::direct_contact<shape>(map.body(), flight, contact)) return;
            ++found;
            const Vec2<T> x = contact.at.centre;
            const Vec2<T> touching = shape == Shape::disk ? x : Vec2<T>(x + contact.arm);
            const T radius = shape == Shape::disk ? map.body().inner : T(1);
            const T way = T(1) + (T(fabs(flight.velocity.x)) + T(fabs(flight.velocity.y)) + T(fabs(flight.spin))) *
                                     contact.at.time;
            worst = std::max(worst, T(fabs(dot(touching, touching) - radius * radius) / (epsilon<T>() * way)));
        });
    }
    EXPECT_GT(found, 100);
    return worst;
}

// The direct search finds a contact to the rounding of its number type, whose precision its constants must have: 8 ε of
// the way gone is allowed.
TEST(SearchAtExtremes, ContactsAreExactInEveryNumberType) {
    for (const int sides : {disk_sides, 6}) {
        const double in_double = worst_gap<double>(sides);
        const double in_extended = static_cast<double>(worst_gap<long double>(sides));
        const double in_quad = static_cast<double>(worst_gap<Quad>(sides));
        std::printf("%d sides (0: disk): gap at the contact at most %.2f, %.2f, %.2f epsilon a way gone\n", sides,
                    in_double, in_extended, in_quad);
        EXPECT_LE(in_double, 8);
        EXPECT_LE(in_extended, 8);
        EXPECT_LE(in_quad, 8);
    }
}

// Under Poisson's law friction that holds the vertex lowers the normal velocity: at e = 1 every u_n is 0.35 of the one
// before. The orbit must go on in contact, to further impacts.
TEST(SearchAtExtremes, AnElasticPolygonThatFrictionHoldsGoesOnInContact) {
    const Scene<double> scene = scene_of(3, 0.60411159285897598, 1.0766343219893793, 1.1370511546409519, 1);
    const CollisionMap<double, Shape::polygon, ImpactRule::poisson> map(scene);
    long contacts = 0;
    for (int i = 0; i < 10; ++i) {
        Orbit orbit(map, LabStart<double>{0.9, 0, -0.4, 0.3, 0.1 * i, 0.2});
        while (orbit.impacts() < 20'000 && orbit.advance()) contacts += !orbit.contacts().empty();
        EXPECT_EQ(orbit.outcome(), Outcome::completed) << name_of(orbit.outcome());
    }
    std::printf("ten orbits of 20,000 impacts: %ld times in contact in between\n", contacts);
    EXPECT_GT(contacts, 0);
}

// The flight after contact must begin on the wall in the wider type's digits.
TEST(SearchAtExtremes, WiderTypesGoOnAfterARelease) {
    const SectionPoint<double> start{-0.7660487341864468, 0, -2.828050828744203, -1.0937463400211522,
                                     2.3751268390572786};
    const Scene<double> scene{disk_sides,
                              3.859921592962973e-05,
                              4.079155844212444,
                              5.286795197606876,
                              0.6383614267269445,
                              Law::poisson,
                              uniform_inertia_factor<double>(disk_sides)};
    long long in_double = 0, in_extended = 0;
    EXPECT_EQ(outcome_after(scene, start, 6, in_double), Outcome::completed);
    const Scene<long double> wide{disk_sides,
                                  scene.alpha,
                                  scene.beta,
                                  scene.mu,
                                  scene.restitution,
                                  Law::poisson,
                                  uniform_inertia_factor<long double>(disk_sides)};
    const SectionPoint<long double> same{start.psi, 0, start.vn, start.vt, start.spin};
    EXPECT_EQ(outcome_after(wide, same, 6, in_extended), Outcome::completed);
    EXPECT_EQ(in_extended, in_double);
}

}  // namespace
}  // namespace swirl
