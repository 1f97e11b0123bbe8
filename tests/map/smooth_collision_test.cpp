// Impacts at a given time (timed_collision.hpp) and of a given vertex (itinerary_collision.hpp), against the map, which
// searches for its contact, and against differences of themselves.
#include "map/derivative/itinerary_collision.hpp"
#include "map/derivative/timed_collision.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

namespace swirl {
namespace {

using tests::Random;

// A central difference over 2h has an error of h² times the third derivative and of ε/h: some 10⁻⁹ each.
constexpr double h = 1e-5;
constexpr double difference_error = 1e-7;  // a hundred times that, for third derivatives of some tens

/// A flight of the map that ends in an impact well above grazing.
template <class Map, class Check>
void over_impacts(std::uint64_t seed, int sides, double mu, Check&& check) {
    Random random(seed);
    int count = 0;
    for (int i = 0; i < 200 && count < 20; ++i) {
        const Scene<double> scene = tests::random_scene(random, sides, mu, 0.8, Law::poisson);
        const SectionPoint<double> z = tests::random_point(random, scene, random.between(0.2, 1));
        const Map map(scene);
        const Collision<double> collision = map.advance(post_impact_state(z));
        if (collision.outcome != FirstContactOutcome::contact || collision.simultaneous) continue;
        const ContactKinematics<double> after = contact_kinematics(map.body(), collision.after);
        const double p = collision.impulse.normal, q = collision.impulse.tangential;
        if (after.un + after.b2() * p + after.b3() * q < 0.2) continue;
        ++count;
        check(scene, z, collision);
    }
    EXPECT_EQ(count, 20);
}

template <class Map>
class SmoothCollision : public testing::Test {};

using Maps = testing::Types<
    CollisionMap<double, Shape::disk, ImpactRule::frictionless>, CollisionMap<double, Shape::disk, ImpactRule::poisson>,
    CollisionMap<double, Shape::polygon, ImpactRule::frictionless>,
    CollisionMap<double, Shape::polygon, ImpactRule::poisson>, CollisionMap<double, Shape::polygon, ImpactRule::newton>,
    CollisionMap<double, Shape::polygon, ImpactRule::stronge>>;
TYPED_TEST_SUITE(SmoothCollision, Maps);

template <class Map>
constexpr int sides_of = Map::shape == Shape::disk ? disk_sides : 5;
template <class Map>
constexpr double friction_of = Map::rule == ImpactRule::frictionless ? 0 : 0.4;

template <class Map>
auto coordinates_of(const PostImpactState<double>& state) {
    return coordinates<Map::shape>(section_point(state));
}

TYPED_TEST(SmoothCollision, AtTheTimeOfTheMapsContactIsItsImpact) {
    constexpr int dimension = section_dimension<TypeParam::shape>;
    over_impacts<TypeParam>(1, sides_of<TypeParam>, friction_of<TypeParam>,
                            [](const auto& scene, const auto& z, const auto& known) {
                                const auto timed = collide_at(TypeParam(scene), z, known.flight_time);
                                const auto itinerary = collide_by_itinerary<double, TypeParam::shape, TypeParam::rule>(
                                    scene, Parameter::alpha, Parameter::beta, z, known.flight_time, known.vertex_step);
                                ASSERT_TRUE(timed.possible);
                                EXPECT_EQ(timed.collision.vertex_step, known.vertex_step);
                                EXPECT_EQ(timed.collision.flight_time, known.flight_time);
                                EXPECT_EQ(timed.collision.impulse.mode, known.impulse.mode);
                                EXPECT_EQ(itinerary.mode, known.impulse.mode);
                                EXPECT_LT(std::fabs(timed.gap), 1e-13);  // rounding of a position of size 1, squared
                                EXPECT_LT(std::fabs(itinerary.touch.gap), 1e-13);
                                const auto wanted = coordinates_of<TypeParam>(known.after);
                                const auto found = coordinates_of<TypeParam>(timed.collision.after);
                                for (std::size_t i = 0; i < dimension; ++i) {
                                    EXPECT_NEAR(found[i], wanted[i], 1e-12) << i;
                                    EXPECT_NEAR(itinerary.after[i], wanted[i], 1e-12) << i;
                                }
                            });
}

TYPED_TEST(SmoothCollision, OfAVertexThatLeavesIsImpossibleAtAGivenTime) {
    over_impacts<TypeParam>(1, sides_of<TypeParam>, friction_of<TypeParam>,
                            [](const auto& scene, const auto& z, const auto&) {
                                const bool possible = collide_at(TypeParam(scene), z, 0.0).possible;
                                EXPECT_FALSE(possible);
                            });
}

TYPED_TEST(SmoothCollision, DerivativesAreItsDifferences) {
    constexpr int dimension = section_dimension<TypeParam::shape>;
    double worst = 0;
    const auto compare = [&](double derivative, double above, double below, double size) {
        const double error = std::fabs(derivative - (above - below) / (2 * h)) / (1 + size);
        worst = std::max(worst, error);
        EXPECT_LE(error, difference_error);
    };
    over_impacts<TypeParam>(
        2, sides_of<TypeParam>, friction_of<TypeParam>, [&](const auto& scene, const auto& z, const auto& known) {
            constexpr Parameter first = Parameter::inertia_factor, second = Parameter::beta;
            const auto itinerary_at = [&](const Scene<double>& s, const SectionPoint<double>& from, double time) {
                return collide_by_itinerary<double, TypeParam::shape, TypeParam::rule>(s, first, second, from, time,
                                                                                       known.vertex_step);
            };
            const auto timed_at = [&](const SectionPoint<double>& from, double time) {
                return collide_at(TypeParam(scene), from, time);
            };
            const auto itinerary = itinerary_at(scene, z, known.flight_time);
            const auto timed = timed_at(z, known.flight_time);
            const double size =
                itinerary.after_by.cwiseAbs().maxCoeff() + itinerary.touch.rate_by.cwiseAbs().maxCoeff();
            for (int i = 0; i < dimension + 3; ++i) {
                const auto moved = [&](double step) {
                    auto c = coordinates<TypeParam::shape>(z);
                    Scene<double> s = scene;
                    double time = known.flight_time;
                    if (i < dimension) c[static_cast<std::size_t>(i)] += step;
                    if (i == dimension) time += step;
                    if (i == dimension + 1) number_of(s, first) += step;
                    if (i == dimension + 2) number_of(s, second) += step;
                    const SectionPoint<double> from = section_point<TypeParam::shape>(c);
                    return std::pair(itinerary_at(s, from, time), timed_at(from, time));
                };
                const auto above = moved(h), below = moved(-h);
                if (above.first.mode != itinerary.mode || below.first.mode != itinerary.mode) continue;  // DF jumps
                compare(itinerary.touch.gap_by[i], above.first.touch.gap, below.first.touch.gap, size);
                compare(itinerary.touch.rate_by[i], above.first.touch.rate, below.first.touch.rate, size);
                for (int k = 0; k < dimension; ++k) {
                    const auto row = static_cast<std::size_t>(k);
                    if (std::fabs(above.first.after[row] - below.first.after[row]) > 1) continue;  // an angle past π
                    compare(itinerary.after_by(k, i), above.first.after[row], below.first.after[row], size);
                    if (i > dimension) continue;
                    const auto up = coordinates_of<TypeParam>(above.second.collision.after);
                    const auto down = coordinates_of<TypeParam>(below.second.collision.after);
                    compare(timed.derivative(k, i), up[row], down[row], size);
                }
                if (i <= dimension) compare(timed.derivative(dimension, i), above.second.gap, below.second.gap, size);
                if (!itinerary.margins.stops || !above.first.margins.stops || !below.first.margins.stops) continue;
                compare(itinerary.margins.slip_by[i], above.first.margins.slip, below.first.margins.slip,
                        size + itinerary.margins.slip_by.cwiseAbs().maxCoeff());
                compare(itinerary.margins.late_by[i], above.first.margins.late, below.first.margins.late,
                        size + itinerary.margins.late_by.cwiseAbs().maxCoeff());
                compare(itinerary.margins.held_by[i], above.first.margins.held, below.first.margins.held,
                        size + itinerary.margins.held_by.cwiseAbs().maxCoeff());
            }
        });
    std::printf("largest relative difference %.2e\n", worst);
}

TYPED_TEST(SmoothCollision, MarginsAreThoseOfTheVelocitiesBeforeTheImpact) {
    if (TypeParam::rule == ImpactRule::frictionless) return;
    int reversed_slip = 0, stopped = 0;
    over_impacts<TypeParam>(
        3, sides_of<TypeParam>, friction_of<TypeParam>, [&](const auto& scene, const auto& z, const auto& known) {
            const auto margins = collide_by_itinerary<double, TypeParam::shape, TypeParam::rule>(
                                     scene, Parameter::alpha, Parameter::beta, z, known.flight_time, known.vertex_step)
                                     .margins;
            // The state before: the same place, the flight's velocity in the axes of the contact, the flight's spin.
            PostImpactState<double> before = known.after;
            const Vec2<double> velocity = seen_from(known.normal, Vec2<double>{z.vn, z.vt});
            before.vn = velocity.x;
            before.vt = velocity.y;
            before.spin = z.spin;
            const ContactKinematics<double> u = contact_kinematics(make_body(scene), before);
            const double sign = u.ut < 0 ? -1 : 1;
            reversed_slip += u.ut < 0;
            EXPECT_NEAR(margins.held, std::fabs(u.b3()) - scene.mu * u.b1(), 1e-12 * u.b1());
            EXPECT_EQ(margins.stops, scene.mu * u.b1() > sign * u.b3());
            if (!margins.stops) return;
            ++stopped;
            const double kink = std::fabs(u.ut) / (scene.mu * u.b1() - sign * u.b3());
            const double scale = 1e-11 * (1 + kink * u.b2());
            EXPECT_NEAR(margins.slip, kink - known.impulse.normal, scale);
            EXPECT_NEAR(margins.late, (u.b2() - scene.mu * sign * u.b3()) * kink - u.un, scale);
        });
    EXPECT_GT(reversed_slip, 0);
    EXPECT_GT(stopped, 0);
}

}  // namespace
}  // namespace swirl
