// Friction, flight, first contact, the map and its derivative over a floor with dry friction.
#include "map/dry/dry_derivative.hpp"
#include "map/dry/riding.hpp"
#include "map/orbit/dry_path.hpp"
#include "map/orbit/dry_return.hpp"
#include "map/orbit/laboratory.hpp"
#include "map/orbit/orbit.hpp"
#include "tests/map/dry_scene.hpp"
#include "tests/map/reference_error.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <type_traits>
#include <utility>

namespace swirl {
namespace {

using nlohmann::json;
using tests::number;

Scene<double> scene_over(double friction, int sides, Floor floor = Floor::dish) {
    return tests::scene_over_dry_floor(friction, sides, floor);
}

MeanSlip<double> mean_of(int sides, const Vec2<double>& velocity, double spin, double angle = 0.3) {
    const Body<double> body = make_body(scene_over(0, sides));
    return UniformPressure(sides).mean_slip(body, velocity, spin, 0.4 * cis(angle));
}

FlightBegin begin_of(const LabStart<double>& start) {
    return {0, {start.x, start.y}, {start.vx, start.vy}, start.angle, start.spin};
}

// By quadrature in polar coordinates about the point that does not slide, in 80-bit numbers (tests/references/dry.py).
TEST(Dry, MeansOverTheBodyAreThoseOfQuadrature) {
    struct Known {
        int sides;
        double spin, x, y, moment;
    };
    for (const Known& known : {Known{6, 2.3, 0.539840995503039406, 0.723901290530756669, 0.0816278031381232006},
                               Known{3, -7, 0.332029457697959992, 0.429121624583007197, -0.145702452871985129},
                               Known{0, 2.3, 0.526730143388123952, 0.702306857850831936, 0.101084407283583952},
                               Known{0, 5, 0.290306253378075491, 0.387075004504100655, 0.219099341908880544},
                               Known{0, 0.501, 0.596972674472116419, 0.795963565962821892, 0.0201078379393471065}}) {
        const MeanSlip<double> mean = mean_of(known.sides, {0.6, 0.8}, known.spin);
        EXPECT_NEAR(mean.direction.x, known.x, 1e-14);
        EXPECT_NEAR(mean.direction.y, known.y, 1e-14);
        EXPECT_NEAR(mean.moment, known.moment, 1e-14);
    }
}

/// Where |U| = 5α|S|; the closed form loses (|U|/αS)² ε there.
TEST(Dry, SeriesAndClosedFormMeet) {
    for (const int sides : {2, 3, 4, 5, 6, 12, 100, disk_sides})
        for (const double angle : {0.0, 0.3, 1.1}) {
            const auto near = mean_of(sides, {1.2 * (1 - 1e-15), 1.6 * (1 - 1e-15)}, -1, angle);
            const auto far = mean_of(sides, {1.2 * (1 + 1e-15), 1.6 * (1 + 1e-15)}, -1, angle);
            EXPECT_NEAR(near.direction.x, far.direction.x, 2e-14) << sides;
            EXPECT_NEAR(near.direction.y, far.direction.y, 2e-14) << sides;
            EXPECT_NEAR(near.moment, far.moment, 2e-14) << sides;
            EXPECT_LT(far.moment, 0);
        }
}

/// ⟨|u|⟩ = U·⟨û⟩ + S⟨ρ × û⟩ is at least |U|, and friction slows the spin.
TEST(Dry, FrictionTakesEnergyAndSlowsTheSpin) {
    std::mt19937_64 draw(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const int sides = (i % 12) == 1 ? disk_sides : std::max(2, i % 12);
        const Vec2<double> velocity{number(draw), number(draw)};
        const double spin = 8 * std::pow(number(draw), 3);
        const auto mean = mean_of(sides, velocity, spin, 3 * number(draw));
        EXPECT_GE(dot(velocity, mean.direction) + spin * mean.moment, std::sqrt(dot(velocity, velocity)) * (1 - 1e-13));
        EXPECT_GE(spin * mean.moment, 0);
        EXPECT_LE(dot(mean.direction, mean.direction), 1 + 1e-14);
    }
}

/// 13 digits are listed; an error grows with every impact, here at most 300 times in three.
TEST(Dry, ReferenceOrbitsAreReproduced) {
    const json references = tests::read_reference("dry_trajectories.json");
    int orbits = 0, impacts = 0;
    double worst = 0;
    for (const json& orbit : references["cases"]) {
        SCOPED_TRACE("orbit " + std::to_string(orbits++));
        Scene<double> scene = tests::scene_from<double>(orbit);
        scene.floor_friction = number<double>(orbit["floor_friction"]);
        scene.gravity_ratio = number<double>(orbit["gravity_ratio"]);
        scene.floor = orbit["floor"] == "table" ? Floor::table : Floor::dish;
        const json& i = orbit["initial"];
        const LabStart<double> start{number<double>(i["x"]),  number<double>(i["y"]),     number<double>(i["vx"]),
                                     number<double>(i["vy"]), number<double>(i["angle"]), number<double>(i["spin"])};
        with_dry_map(scene, [&](const auto& map) {
            Orbit<std::decay_t<decltype(map)>> followed(map, start);
            for (const json& row : orbit["collisions"]) {
                ASSERT_TRUE(followed.advance()) << name_of(followed.outcome());
                EXPECT_EQ(followed.frame().vertex, row["vertex"].template get<int>());
                const double error = tests::error_of(followed.lab(), followed.collision(), row);
                EXPECT_LE(error, 3e-11) << "impact " << followed.impacts();
                worst = std::max(worst, error);
                ++impacts;
            }
        });
    }
    std::printf("%d orbits, %d impacts, largest error %.1e\n", orbits, impacts, worst);
    EXPECT_EQ(orbits, 10);
    EXPECT_EQ(impacts, 30);
}

TEST(Dry, JoinsTheMapWithoutFriction) {
    for (const int sides : {2, 3, 6, disk_sides})
        for (const double friction : {1e-75, 1e-16, 1e-12, 1e-8, 1e-4})
            with_dry_map(scene_over(friction, sides), [&](const auto& map) {
                Collision<double> with, without;
                with.after = post_impact_state(SectionPoint<double>{0.3, sides == 0 ? 0.0 : 0.1, -0.8, 0.4, 0.7});
                for (int n = 0; n < 5; ++n) {
                    without.after = with.after;
                    map.impacts().advance(without.after, without);
                    map.advance(with.after, with);
                    ASSERT_EQ(with.outcome, FirstContactOutcome::contact);
                    const auto a = section_point(with.after), b = section_point(without.after);
                    // Friction moves the contact by a_f τ², times what an impact makes of it.
                    const double allowed = 2e-13 + 200 * friction;
                    EXPECT_NEAR(a.psi, b.psi, allowed);
                    EXPECT_NEAR(a.vn, b.vn, allowed);
                    EXPECT_NEAR(a.vt, b.vt, allowed);
                    EXPECT_NEAR(a.spin, b.spin, 10 * allowed);
                }
            });
}

/// Against central differences of steps of 10⁻⁵: errors of 10⁻¹⁰ F‴, and of 10⁻⁹ by rounding.
TEST(Dry, TheDerivativeIsThatOfTheMap) {
    int columns = 0;
    for (const Floor floor : {Floor::dish, Floor::table})
        for (const int sides : {3, 6, disk_sides})
            with_dry_map(scene_over(0.1, sides, floor), [&](const auto& map) {
                constexpr Shape shape = std::decay_t<decltype(map)>::shape;
                constexpr int dimension = section_dimension<shape>;
                Collision<double> c;
                c.after = post_impact_state(SectionPoint<double>{0.3, sides == 0 ? 0.0 : 0.1, -0.8, 0.4, 0.7});
                for (int n = 0; n < 10; ++n) {
                    const auto before = c.after;
                    map.advance(before, c);
                    ASSERT_EQ(c.outcome, FirstContactOutcome::contact);
                    const auto derivative = derivative_by_saltation(map, before, c);
                    const auto z = coordinates<shape>(section_point(before));
                    for (std::size_t j = 0; j < dimension; ++j) {
                        auto ahead = z, behind = z;
                        ahead[j] += 1e-5, behind[j] -= 1e-5;
                        const auto a = map.advance(post_impact_state(section_point<shape>(ahead)));
                        const auto b = map.advance(post_impact_state(section_point<shape>(behind)));
                        if (a.outcome != c.outcome || b.outcome != c.outcome || a.impulse.mode != b.impulse.mode ||
                            a.vertex_step != b.vertex_step)
                            continue;
                        const auto x = coordinates<shape>(section_point(a.after));
                        const auto y = coordinates<shape>(section_point(b.after));
                        const double size = 1 + derivative.col(static_cast<Eigen::Index>(j)).norm();
                        for (std::size_t i = 0; i < dimension; ++i)
                            EXPECT_NEAR(wrapped_angle(x[i] - y[i]) / 2e-5,
                                        derivative(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                                        1e-7 * size * size * size);
                        ++columns;
                    }
                }
            });
    EXPECT_GE(columns, 200);
}

/// |U|/α|S| of a disk that spins and slides over a table, where |U| + |S| R_c has fallen to these parts of the first S.
std::array<double, 3> ratios_at(double inertia_factor, double velocity, double spin,
                                const std::array<double, 3>& parts) {
    Scene<double> scene = scene_over(0.1, disk_sides, Floor::table);
    scene.inertia_factor = inertia_factor;
    const DryMap<double, Shape::disk, ImpactRule::poisson> map(scene);
    Flight<double> start;
    start.velocity = {velocity, 0};
    start.phase = {1, 0};
    start.beta = scene.beta;
    start.spin = spin;
    const auto flight = map.dry_flight(start);
    const auto sliding = [&](const Slowing<double>& y) { return std::hypot(velocity + y[2], y[3]); };
    const auto spinning = [&](const Slowing<double>& y) { return std::fabs(spin + y[5]); };
    std::array<double, 3> ratios{};
    DryCourse course(flight);
    for (std::size_t k = 0; k < parts.size() && !course.has_stopped();) {
        const double least = parts[k] * std::fabs(spin);
        if (sliding(course.station().y) + spinning(course.station().y) > least) {
            course.advance();
            continue;
        }
        double early = 0, late = course.step();
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (early + late);
            const Slowing<double> y = slowing_after(flight, course.before(), middle);
            (sliding(y) + spinning(y) > least ? early : late) = middle;
        }
        const Slowing<double> y = slowing_after(flight, course.before(), late);
        ratios[k++] = sliding(y) / (scene.alpha * spinning(y));
    }
    return ratios;
}

/// What it comes to as a power of the speed, by Aitken's formula. Speeds are known to some 10⁻¹⁵, so that the ratio at
/// the last, 10⁻⁷ of the spin, is known to 10⁻⁸.
double limit_ratio(double inertia_factor, double velocity, double spin) {
    const auto ratios = ratios_at(inertia_factor, velocity, spin, {1e-5, 1e-6, 1e-7});
    const double first = ratios[1] - ratios[0], second = ratios[2] - ratios[1];
    return ratios[2] - second * second / (second - first);
}

/// Farkas et al., PRL 90, 248302: 0.653 of a uniform disk, whatever the start; translation alone at the end of one with
/// κ < ¼, rotation alone with κ > ⅔.
TEST(Dry, SlidingAndSpinningEndTogether) {
    // d(U/αS) = 0: F/U = (moment/I)/S of the means
    const auto drift = [](double ratio) {
        const auto mean = mean_of(disk_sides, {0.4 * ratio, 0}, 1, 0);
        return mean.direction.x / (0.4 * ratio) - mean.moment / (0.5 * 0.16);
    };
    std::uintmax_t steps = 100;
    const auto between =
        boost::math::tools::toms748_solve(drift, 0.1, 3.0, boost::math::tools::eps_tolerance<double>(), steps);
    EXPECT_NEAR(between.first, 0.653, 5e-4);
    for (const auto& [velocity, spin] : {std::pair(1.0, 0.5), std::pair(0.26, 1.0), std::pair(-0.5, 2.0)})
        EXPECT_NEAR(limit_ratio(0.5, velocity, spin), between.first, 1e-7);
    std::printf("sliding and spinning end together at %.9f, by the drift at %.9f\n", limit_ratio(0.5, 0.5, 2),
                between.first);
}

/// Where U is much larger αS′/αS = U′/4κU, and where it is much smaller U′/U = 3κ/2 αS′/αS: |U|/α|S| goes as the speed
/// to the power 1 − 1/4κ, and 3κ/2 − 1, which change their sign at κ = ¼ and ⅔.
TEST(Dry, BeyondTheBordersOneEndsAlone) {
    const std::array<double, 3> late{1e-4, 1e-5, 1e-6};  // |U| + |S|, of which U and S are parts
    constexpr double alpha = 0.4;
    for (const double kappa : {0.15, 0.17, 0.2}) {
        const auto ratios = ratios_at(kappa, 0.5, 2, late);
        const auto sliding = [&](std::size_t i) { return late[i] / (1 + 1 / (alpha * ratios[i])); };
        const double power = std::log(ratios[2] / ratios[1]) / std::log(sliding(2) / sliding(1));
        EXPECT_NEAR(power, 1 - 1 / (4 * kappa), 1 / (ratios[1] * ratios[1])) << kappa;  // the means' next order
        EXPECT_GT(ratios[1], 5) << kappa;
    }
    for (const double kappa : {0.85, 0.9, 1.0}) {
        const auto ratios = ratios_at(kappa, 0.5, 2, late);
        const auto spinning = [&](std::size_t i) { return late[i] / (1 + alpha * ratios[i]); };
        const double power = std::log(ratios[2] / ratios[1]) / std::log(spinning(2) / spinning(1));
        EXPECT_NEAR(power, 1.5 * kappa - 1, ratios[1] * ratios[1]) << kappa;
        EXPECT_LT(ratios[1], 0.1) << kappa;
    }
}

/// No point of the body is outside at any of a thousand moments of a flight, and the vertex that strikes is on the wall
/// at its end.
TEST(Dry, TheFirstContactIsTheFirst) {
    std::mt19937_64 draw(5);
    std::uniform_real_distribution<double> number(-1, 1);
    int flights = 0;
    for (int i = 0; i < 60; ++i) {
        const int sides = (i % 8) == 1 ? disk_sides : std::max(2, i % 8);
        const Scene<double> scene =
            scene_over(std::pow(10, -2.0 + 1.5 * std::fabs(number(draw))), sides, i % 2 ? Floor::table : Floor::dish);
        with_dry_map(scene, [&](const auto& map) {
            constexpr Shape shape = std::decay_t<decltype(map)>::shape;
            const Body<double>& body = map.body();
            const LabStart<double> start{0.5 + 0.1 * number(draw), 0.1 * number(draw), 1.5 * number(draw),
                                         1.5 * number(draw),       number(draw),       3 * number(draw)};
            const auto collision = map.advance(flight_from(body, start));
            if (collision.outcome != FirstContactOutcome::contact) return;
            const double lasts = collision.flight_time;
            const auto path = dry_paths(scene).flight(begin_of(start), lasts);
            double last = 0;
            for (int k = 0; k <= 1000; ++k) {
                const auto place = path->at(lasts * k / 1000);
                const Vec2<double> centre = place.centre - scene.beta * cis(lasts * k / 1000);
                last = shape == Shape::disk ? detail::magnitude(centre) + body.alpha : 0;
                for (int vertex = 0; vertex < body.sides; ++vertex)
                    last = std::max(
                        last,
                        detail::magnitude(Vec2<double>(
                            centre + body.turned_to_vertex(body.alpha * cis(start.angle + place.turned), vertex))));
                EXPECT_LE(last, 1 + 1e-13) << k;
            }
            EXPECT_NEAR(last, 1, 1e-13);
            ++flights;
        });
    }
    EXPECT_GE(flights, 40);
}

/// A rod longer than ⅔ R_c reaches the wall wherever its centre is, and its circle shelters it at the container's
/// centre alone; κ far below rounding stops no body that slides.
TEST(Dry, LongRodsAndLightRimsAreFollowed) {
    Scene<double> rod = scene_over(0.01, 2);
    rod.alpha = 0.8;
    with_dry_map(rod, [&](const auto& map) {
        const auto found = map.advance(flight_from(map.body(), LabStart<double>{0.5, 0, 0.4, 0.1, 0, 0.2}));
        EXPECT_EQ(found.outcome, FirstContactOutcome::contact);
    });
    Scene<double> light = scene_over(0.6, disk_sides);
    light.inertia_factor = 1e-12;
    with_dry_map(light, [&](const auto& map) {
        const auto found = map.advance(flight_from(map.body(), LabStart<double>{0.9, 0, 0.9, 0, 0, 0}));
        EXPECT_NE(found.outcome, FirstContactOutcome::no_contact);
    });
}

/// A body that has stopped on a table is at rest in the laboratory when the wall comes.
TEST(Dry, ABodyAtRestOnATableIsTornLoose) {
    const Scene<double> scene = scene_over(0.5, 6, Floor::table);
    with_dry_map(scene, [&](const auto& map) {
        const LabStart<double> slow{0.45, 0.25, 0.1, 0.05, 0.2, 0.3};
        const auto flight = map.dry_flight(flight_from(map.body(), slow));
        DryCourse course(flight);
        while (!course.has_stopped()) course.advance();
        const auto collision = map.advance(flight.start);
        ASSERT_EQ(collision.outcome, FirstContactOutcome::contact);
        EXPECT_GT(collision.flight_time, course.station().time);
        const auto path = dry_paths(scene).flight(begin_of(slow), collision.flight_time);
        LabStart<double> still{};
        const auto rest = path->at(collision.flight_time);
        still.x = rest.centre.x, still.y = rest.centre.y, still.angle = slow.angle + rest.turned;
        const auto known = map.impacts().advance(flight_from(map.body(), still));
        EXPECT_NEAR(collision.flight_time, known.flight_time, 1e-13);
        EXPECT_NEAR(collision.impulse.normal, known.impulse.normal, 1e-12);
        EXPECT_NEAR(map.turned(flight.start, collision.flight_time), rest.turned, 1e-13);
    });
}

/// β ≤ a_f: at rest against the dish; β > a_f: on a circle of radius √(β² − a_f²), which Newton's law gives.
TEST(Dry, ADishCarriesABodyAlong) {
    for (const double friction : {0.6, 0.1}) {
        Scene<double> scene = scene_over(friction, 6);
        scene.beta = 0.2;
        with_dry_map(scene, [&](const auto& map) {
            const LabStart<double> start{0.25, 0.05, 0.02, 0.1, 0.2, 0.5};
            const auto flight = flight_from(map.body(), start);
            const auto collision = map.advance(flight);
            ASSERT_EQ(collision.outcome, FirstContactOutcome::no_contact);
            const auto riding = riding_over_dry_floor(scene, flight);
            ASSERT_TRUE(riding.has_value());
            EXPECT_GT(riding->room, 0);
            EXPECT_NEAR(riding->radius, friction > 0.2 ? 0 : std::sqrt(0.04 - friction * friction), 1e-15);
            const double late = 60;
            const auto path = dry_paths(scene).flight(begin_of(start), late);
            const auto at = path->at(late);
            const Vec2<double> in_dish = at.centre - scene.beta * cis(late);
            // What was left when it was said to ride is at most 10⁻³ of a speed below 0.2.
            EXPECT_NEAR(detail::magnitude(Vec2<double>(in_dish - riding->place)), riding->radius, 2e-3);
            EXPECT_NEAR(at.spin, 0, 1e-6);
        });
    }
}

}  // namespace
}  // namespace swirl
