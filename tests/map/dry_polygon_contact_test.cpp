// A polygon's contact over a floor with dry friction: its motions against Newton's equations in 18 digits, rest on a
// vertex and on an edge, energy, the limit without friction, orbits through contact and the trajectory in it.
#include "map/contact/contact_run.hpp"
#include "map/orbit/dry_path.hpp"
#include "map/orbit/dry_return.hpp"
#include "map/orbit/orbit.hpp"
#include "map/orbit/trajectory_segment.hpp"
#include "tests/map/on_wall.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <random>
#include <string>

namespace swirl {
namespace {

using tests::Draw, tests::number, tests::OnWall;

constexpr int sides_drawn[] = {rod_sides, 3, 4, 5, 6, 12};

int drawn_sides(int seed) {
    return sides_drawn[static_cast<std::size_t>(seed) % std::size(sides_drawn)];
}

TEST(DryPolygonContact, MotionsAreThoseOfNewtonsEquations) {
    std::map<std::string, int> events;
    double worst = 0;
    const nlohmann::json reference = tests::read_reference("dry_wall.json");
    for (const auto& entry : reference["cases"]) {
        Scene<double> scene = tests::scene_from<double>(entry);
        scene.floor_friction = number<double>(entry["floor_friction"]);
        scene.gravity_ratio = number<double>(entry["gravity_ratio"]);
        scene.floor = entry["floor"].get<std::string>() == "table" ? Floor::table : Floor::dish;
        const OnWall body(scene);
        const std::string on = entry["support"].get<std::string>(), event = entry["event"].get<std::string>();
        const Support support = on == "edge" ? Support::edge : Support::vertex;
        const auto start = [&](std::size_t i) { return number<double>(entry["start"][i]); };
        const auto end = [&](std::size_t i) { return number<double>(entry["end"][i]); };
        ContactState<double> z{start(0), start(1), start(2), start(3)};
        if (support == Support::edge) z.chi = -body.wall.contact.widest_chi;
        const ContactPhase<double> phase = body.followed(support, z, number<double>(entry["duration"]));
        ASSERT_FALSE(phase.segments.empty()) << entry.dump();
        const ContactSegment& piece = phase.segments.front();
        const std::string name = event == "rest" ? "stick" : event.ends_with("lift") ? "lift" : event;
        EXPECT_EQ(name_of(piece.finish), name) << entry.dump();
        const double speed = 1 + std::abs(end(3)) + std::abs(end(4));
        const double off =
            std::max({std::abs(piece.end - end(0)), std::abs(std::remainder(piece.to.psi - end(1), 2 * pi<double>())),
                      std::abs(piece.to.chi - end(2)), std::abs(piece.to.ut - end(3)),
                      std::abs(piece.to.spin - end(4))}) /
            speed;
        EXPECT_LT(off, 2e-12) << entry.dump();
        worst = std::max(worst, off);
        ++events[(scene.floor == Floor::dish ? "dish " : "table ") + on + " " + event];
    }
    for (const auto& [event, count] : events) std::printf("  %s: %d\n", event.c_str(), count);
    std::printf("  off by %.1e at most\n", worst);
    EXPECT_GE(events.size(), 14U);
}

/// The least push of the floor that holds a body is what the wall's force within its cone needs: no less would do,
/// since a motion that the wall lets go is pushed by more; and no more is needed, since these forces balance.
TEST(DryPolygonContact, RestIsHeldByForcesThatBalance) {
    int held = 0, free = 0;
    double worst = 0;
    for (int seed = 0; seed < 600; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = tests::drawn_over_dry_floor(draw, drawn_sides(seed));
        scene.floor = Floor::dish;
        const OnWall body(scene);
        const Body<double>& b = body.wall.contact.body;
        const ContactState<double> z{draw(-3, 3), draw(-0.99, 0.99) * body.wall.contact.widest_chi, 0, 0};
        const HeldAtRest rest = held_at_rest(body.wall, Support::vertex, z);
        const double bound = 1e-7 * scene.beta;  // of a minimum, whose place is known to √ε
        EXPECT_GE(rest.normal, -bound) << seed;
        EXPECT_LE(std::abs(rest.friction), scene.mu * rest.normal + bound) << seed;
        // The floor's push that balances them lies on its limit surface: with its torque no motion takes more of it.
        const Vec2<double> arm = arm_on_wall(b.alpha, Support::vertex, z.chi);
        const Vec2<double> push{-scene.beta * std::cos(z.psi) + rest.normal,
                                scene.beta * std::sin(z.psi) - rest.friction};
        const double torque = -(arm.x * rest.friction + arm.y * rest.normal);
        double most = 0;
        for (int i = 0; i < 20'000; ++i) {
            const double u = draw(-1, 1), angle = draw(-pi<double>(), pi<double>()), flat = std::sqrt(1 - u * u);
            const Vec2<double> velocity{flat * std::cos(angle), flat * std::sin(angle)};
            const double spin = u / scene.alpha;
            const MeanSlip<double> mean = body.pressure->mean_slip(b, velocity, spin, arm);
            const double speed = dot(velocity, mean.direction) + spin * mean.moment;
            most = std::max(most, std::abs(dot(velocity, push) + spin * torque) / speed);
        }
        EXPECT_LE(most, rest.least + bound) << seed;
        EXPECT_GE(most, rest.least * (1 - 1e-2)) << seed;  // as near as 20,000 motions drawn come to the one
        worst = std::max(worst, most / rest.least - 1);
        ++(rest.normal < bound ? free : held);
    }
    std::printf("  %d held by wall and floor, %d by the floor alone; limit surface passed by %.1e\n", held, free,
                worst);
    EXPECT_GT(held, 100);
    EXPECT_GT(free, 100);
}

/// A body that is not held moves in a way that its own forces drive.
TEST(DryPolygonContact, WhatIsNotHeldMoves) {
    std::map<std::string, int> begins;
    for (int seed = 0; seed < 900; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = tests::drawn_over_dry_floor(draw, drawn_sides(seed));
        scene.floor = Floor::dish;
        const OnWall body(scene);
        for (const Support support : {Support::vertex, Support::edge}) {
            if (support == Support::edge && scene.sides == rod_sides) continue;
            ContactState<double> z{draw(-3, 3), draw(-0.99, 0.99) * body.wall.contact.widest_chi, 0, 0};
            if (support == Support::edge) z.chi = -body.wall.contact.widest_chi;
            const double reserve = rest_reserve(body.wall, support, z);
            if (std::abs(reserve) < 1e-6) continue;
            const DryChoice next = choose_dry_motion(body.wall, support, z, 0, ContactEvent::stick);
            EXPECT_TRUE(next.choice.resolved) << seed << " sides " << scene.sides << " reserve " << reserve;
            EXPECT_EQ(next.choice.stays && next.motion.rests, reserve > 0) << seed;
            const std::string on = support == Support::edge ? "edge " : "vertex ";
            if (!next.choice.stays)
                ++begins[on + "leaves"];
            else if (next.motion.rests)
                ++begins[on + "rests"];
            else if (support == Support::edge && next.choice.support == Support::vertex)
                ++begins[on + "lifts"];
            else
                ++begins[on + (next.motion.sticks() ? "turns" : "slips")];
        }
    }
    for (const auto& [name, count] : begins) std::printf("  %s: %d\n", name.c_str(), count);
    for (const char* name : {"vertex leaves", "vertex rests", "vertex turns", "vertex slips", "edge leaves",
                             "edge rests", "edge lifts", "edge slips"})
        EXPECT_GT(begins[name], 10) << name;
}

/// Without friction of the floor it is the contact without one.
TEST(DryPolygonContact, WithoutFrictionOfTheFloorItIsTheContactWithoutIt) {
    int compared = 0;
    for (int seed = 0; seed < 60; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = tests::drawn_over_dry_floor(draw, drawn_sides(seed));
        scene.floor_friction = 0;
        const ContactScene<double> smooth =
            contact_scene(make_body(scene), scene.mu, scene.restitution, ImpactRule::poisson);
        const ContactState<double> start{draw(-2, 2), draw(-0.9, 0.9) * smooth.widest_chi, draw(-1, 1), draw(-2, 2)};
        const ContactMotion motion =
            start.ut < 0 && scene.mu > 0 ? ContactMotion::sliding_backward : ContactMotion::sliding_forward;
        const ContactEnd<double> known = run_contact(smooth, Support::vertex, motion, start, 1.0);
        if (known.sums.time < 0.05) continue;
        for (const double deceleration : {1e-4, 1e-8, 1e-12}) {
            scene.floor_friction = deceleration;
            const ContactPhase<double> phase = OnWall(scene).followed(Support::vertex, start, 1.0);
            ASSERT_FALSE(phase.segments.empty());
            const ContactSegment& piece = phase.segments.front();
            EXPECT_EQ(piece.finish, known.event) << seed;
            const double off =
                std::max({std::abs(piece.end - known.sums.time), std::abs(piece.to.psi - known.state.psi),
                          std::abs(piece.to.chi - known.state.chi), std::abs(piece.to.spin - known.state.spin)});
            // What the force makes of the event's time depends on how steeply the condition falls.
            EXPECT_LT(off, 3e3 * deceleration + 1e-11) << seed << " " << deceleration;
        }
        ++compared;
    }
    EXPECT_GT(compared, 20);
}

/// What friction does in the container's frame: energy falls by at least what the swirl gives, on a dish.
TEST(DryPolygonContact, FrictionGivesNoEnergy) {
    long looks = 0;
    for (int seed = 0; seed < 120; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = tests::drawn_over_dry_floor(draw, drawn_sides(seed));
        scene.floor = Floor::dish;
        const OnWall body(scene);
        const Body<double>& b = body.wall.contact.body;
        const auto rate_of_centre = [&](const ContactState<double>& z) {
            return centre_on_wall_rate(arm_on_wall(b.alpha, Support::vertex, z.chi), z.ut, z.spin);
        };
        const auto energy = [&](const ContactState<double>& z) {
            const Vec2<double> v = rate_of_centre(z);
            return 0.5 * dot(v, v) + 0.5 * b.inertia * z.spin * z.spin;
        };
        const auto power = [&](const ContactState<double>& z) {
            const Vec2<double> v = rate_of_centre(z);
            return scene.beta * (std::cos(z.psi) * v.x - std::sin(z.psi) * v.y);
        };
        ContactState<double> last{draw(-1, 1), draw(-0.9, 0.9) * body.wall.contact.widest_chi, draw(-1, 1),
                                  draw(-2, 2)};
        double time = 0;
        body.followed(Support::vertex, last, 30,
                      [&](const ContactSums<double>& sums, Support, ContactMotion, const ContactState<double>& z) {
                          // The swirl's power between two looks, by the trapezium: error below h³/12 of its second
                          // derivative. Where the vertex in contact is another now energy and power are the same.
                          const double h = sums.time - time, speed = 1 + std::abs(z.spin) + std::abs(z.ut);
                          const double given = 0.5 * h * (power(last) + power(z));
                          const double error = 4 * h * h * h * (1 + scene.beta) * speed * speed * speed / b.inertia;
                          EXPECT_LE(energy(z) - energy(last), given + error + 1e-12 * speed * speed)
                              << seed << " at " << sums.time;
                          last = z;
                          time = sums.time;
                          ++looks;
                      });
    }
    EXPECT_GT(looks, 3'000);
}

TEST(DryPolygonContact, OrbitsGoThroughContact) {
    std::map<std::string, int> endings, motions;
    int unresolved = 0;
    for (int seed = 0; seed < 150; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        const Scene<double> scene = tests::drawn_over_dry_floor(draw, drawn_sides(seed));
        const double reach = draw(0, 0.9) * (1 - scene.alpha), direction = draw(-3, 3);
        const LabStart<double> start{scene.beta + reach * std::cos(direction),
                                     reach * std::sin(direction),
                                     draw(-1, 1),
                                     draw(-1, 1),
                                     0.1,
                                     draw(-2, 2)};
        with_dry_map(scene, [&](const auto& map) {
            ReducedOrbit orbit(map, start);
            int impacts = 0;
            while (impacts < 200 && orbit.advance(30)) {
                ++impacts;
                for (const ContactSegment& piece : orbit.contacts())
                    ++motions[rests_in_dish(piece) ? "resting" : std::string(name_of(piece.support, piece.motion))];
            }
            ++endings[std::string(name_of(orbit.outcome()))];
            // Where the floor nearly holds it against the swirl what is apart from riding falls too slowly.
            const bool nearly_held = std::abs(scene.floor_deceleration() / scene.beta - 1) < 1e-2;
            unresolved += orbit.outcome() == Outcome::unresolved && !nearly_held;
            EXPECT_NE(orbit.outcome(), Outcome::contact_cut) << seed;
        });
    }
    for (const auto& [ending, count] : endings) std::printf("  %s: %d\n", ending.c_str(), count);
    for (const auto& [motion, count] : motions) std::printf("  %s: %d\n", motion.c_str(), count);
    EXPECT_EQ(unresolved, 0);
    EXPECT_GT(endings["in-contact"], 20);
}

/// Of the trajectory between impacts, in flight and in contact.
TEST(DryPolygonContact, PathsStayInsideAndJoin) {
    long looks = 0;
    for (int seed = 0; seed < 24; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = tests::drawn_over_dry_floor(draw, drawn_sides(seed));
        const LabStart<double> start{scene.beta, 0, 0.3, 0.1, 0.1, 0.5};
        with_dry_map(scene, [&](const auto& map) {
            Orbit orbit(map, start);
            TrajectorySegmenter cutter(scene, start);
            cutter.take_paths_from(dry_paths(scene));
            Moment last{};
            double last_time = 0;
            bool begun = false;
            int impacts = 0;
            for (bool goes_on = true; goes_on && impacts < 60; ++impacts) {
                goes_on = orbit.advance(20, cutter.sink());
                for (const TrajectorySegment& segment : cutter.passed(orbit, goes_on)) {
                    for (int k = 0; k <= 4; ++k) {
                        const double t = segment.start + (segment.end - segment.start) * k / 4;
                        const Moment now = moment_at(cutter.scene(), segment, t);
                        double farthest = 0;
                        for (int v = 0; v < scene.sides; ++v) {
                            const double angle = now.angle + 2 * pi<double>() * v / scene.sides;
                            const double x = now.centre.x - scene.beta * std::cos(t) + scene.alpha * std::cos(angle);
                            const double y = now.centre.y - scene.beta * std::sin(t) + scene.alpha * std::sin(angle);
                            farthest = std::max(farthest, std::hypot(x, y));
                        }
                        EXPECT_LT(farthest, 1 + 1e-10) << seed << " at " << t;
                        if (segment.in_contact) {
                            EXPECT_GT(farthest, 1 - 1e-10) << seed << " at " << t;
                            EXPECT_GE(now.normal_force, -1e-9) << seed << " at " << t;
                            ++looks;
                        }
                        if (begun) {
                            EXPECT_LT(std::hypot(now.centre.x - last.centre.x, now.centre.y - last.centre.y),
                                      5 * (t - last_time) + 1e-10)
                                << seed << " at " << t;
                        }
                        last = now;
                        last_time = t;
                        begun = true;
                    }
                }
            }
        });
    }
    EXPECT_GT(looks, 1'000);
}

}  // namespace
}  // namespace swirl
