// A disk's contact over a floor with dry friction: its motions against Newton's equations in 18 digits, what is known
// in closed form, rest and how it ends, and chatter that ends in contact.
#include "map/contact/contact_run.hpp"
#include "map/dry/wall_contact.hpp"
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

Scene<double> disk_over(double deceleration, Floor floor = Floor::dish) {
    Scene<double> scene = tests::scene_over_dry_floor(deceleration, disk_sides, floor);
    scene.restitution = 0.5;
    return scene;
}

Scene<double> drawn_scene(Draw& draw) {
    return tests::drawn_over_dry_floor(draw, disk_sides);
}

TEST(DryContact, MotionsAreThoseOfNewtonsEquations) {
    std::map<std::string, int> events;
    double worst = 0;
    const nlohmann::json reference = tests::read_reference("dry_contact.json");
    for (const auto& entry : reference["cases"]) {
        Scene<double> scene = tests::scene_from<double>(entry);
        scene.floor_friction = number<double>(entry["floor_friction"]);
        scene.gravity_ratio = number<double>(entry["gravity_ratio"]);
        scene.floor = entry["floor"].get<std::string>() == "table" ? Floor::table : Floor::dish;
        const OnWall disk(scene);
        const auto start = [&](std::size_t i) { return number<double>(entry["start"][i]); };
        const auto end = [&](std::size_t i) { return number<double>(entry["end"][i]); };
        const ContactPhase<double> phase =
            disk.followed(Support::rim, {start(0), 0, start(1), start(2)}, number<double>(entry["duration"]));
        ASSERT_FALSE(phase.segments.empty()) << entry.dump();
        const ContactSegment& piece = phase.segments.front();
        const std::string event = entry["event"].get<std::string>();
        EXPECT_EQ(name_of(piece.finish), event == "rest" ? "stick" : event) << entry.dump();
        const double off =
            std::max({std::abs(piece.end - end(0)), std::abs(std::remainder(piece.to.psi - end(1), 2 * pi<double>())),
                      std::abs(piece.to.ut - end(2)), std::abs(piece.to.spin - end(3))});
        EXPECT_LT(off, 2e-12) << entry.dump();
        worst = std::max(worst, off);
        ++events[(scene.floor == Floor::dish ? "dish " : "table ") + event];
    }
    for (const auto& [event, count] : events) std::printf("  %s: %d\n", event.c_str(), count);
    std::printf("  off by %.1e at most\n", worst);
    EXPECT_GE(events.size(), 8U);
}

// |U| = α|S|: the means are 8/3π and 8α/9π, and of the swirl's pull 32 a_f/9π is lost.
TEST(DryContact, ADiskLocksToTheSwirlWhereThirtyTwoNinthsOfPiSay) {
    for (const double part : {0.2, 0.8, 0.999}) {
        Scene<double> scene = disk_over(0);
        scene.mu = 10;
        scene.floor_friction = part * scene.beta * 9 * pi<double>() / 32;
        const OnWall disk(scene);
        const double psi = -std::asin(part), spin = -(1 - scene.alpha) / scene.alpha;
        const ContactPhase<double> phase = disk.followed(Support::rim, {psi, 0, 0, spin}, 100);
        ASSERT_EQ(phase.segments.size(), 1U);
        // ψ swings about its place, or stays: rounding grows by no more than the time.
        EXPECT_NEAR(phase.segments[0].to.psi, psi, 1e-11) << part;
        EXPECT_NEAR(phase.segments[0].to.spin, spin, 1e-11) << part;
    }
    Scene<double> scene = disk_over(0);
    scene.mu = 10;
    scene.floor_friction = 1.3 * scene.beta * 9 * pi<double>() / 32;
    const OnWall disk(scene);
    const ContactPhase<double> phase = disk.followed(Support::rim, {0, 0, 0, -0.75}, 300);
    ASSERT_FALSE(phase.segments.empty());
    EXPECT_EQ(phase.segments[0].finish, ContactEvent::stick);  // nowhere is the pull enough: it comes to rest
}

/// Along a smooth wall without spin the floor's friction is a_f against the motion, whichever way it goes.
TEST(DryContact, ADiskThatSlidesWithoutSpinIsSlowedEitherWay) {
    for (const double along : {0.3, -0.3}) {
        Scene<double> scene = disk_over(0.02);
        scene.beta = 0;
        scene.mu = 0;
        const OnWall disk(scene);
        const ContactPhase<double> phase = disk.followed(Support::rim, {0.2, 0, along, 0}, 100);
        ASSERT_EQ(phase.segments.size(), 2U);
        EXPECT_NEAR(phase.segments[0].end, 15, 1e-12);
        // −t + ∫ρν′/ρ
        EXPECT_NEAR(phase.segments[0].to.psi, 0.2 - 15 + (along > 0 ? 1 : -1) * 0.5 * 0.3 * 15 / 0.6, 1e-12);
        EXPECT_TRUE(rests_in_dish(phase.segments[1]));
    }
}

/// With so little friction of the wall that rest ends within rounding of where it would without.
TEST(DryContact, ARestWithHardlyAnyFrictionOfTheWallEndsInAMotion) {
    int ends = 0;
    for (int seed = 0; seed < 200; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = drawn_scene(draw);
        scene.mu = std::pow(10, draw(-8, -3));
        scene.floor_friction = scene.beta * draw(0.1, 0.95);
        scene.floor = Floor::dish;
        const OnWall disk(scene);
        const ContactPhase<double> phase = disk.followed(Support::rim, {0, 0, 0, 0}, 7);
        ASSERT_GE(phase.segments.size(), 2U)
            << seed << " mu " << scene.mu << " alpha " << scene.alpha << " beta " << scene.beta << " a "
            << scene.floor_deceleration() << " ended " << phase.sums.time << " resolved " << phase.resolved;
        EXPECT_TRUE(phase.resolved) << seed << " mu " << scene.mu;
        EXPECT_TRUE(rests_in_dish(phase.segments[0]));
        // a_f + μ w_n of pull without spin, if a little less than that
        const double psi = phase.segments[0].to.psi,
                     held = scene.floor_deceleration() + scene.mu * scene.beta * std::cos(psi);
        EXPECT_LT(scene.beta * std::abs(std::sin(psi)), held + 1e-8);
        EXPECT_GT(scene.beta * std::abs(std::sin(psi)), scene.floor_deceleration());
        ++ends;
    }
    EXPECT_EQ(ends, 200);
}

/// Rolling one way, the floor's friction is a constant force: ½(1 + κ)ρψ′² − β cos ψ + (32/9π) a_f ψ is kept.
TEST(DryContact, RollingOneWayKeepsItsEnergy) {
    Scene<double> scene = disk_over(0.2);
    scene.mu = 10;
    const OnWall disk(scene);
    const double rho = 1 - scene.alpha, lost = 32 / (9 * pi<double>()) * 0.2;
    const auto energy = [&](const ContactState<double>& z) {
        const double rate = -scene.alpha * z.spin / rho - 1;
        return 0.75 * rho * rate * rate - scene.beta * std::cos(z.psi) + lost * z.psi;
    };
    const ContactState<double> start{-0.3, 0, 0, -1.9};
    double worst = 0;
    const ContactPhase<double> phase = disk.followed(
        Support::rim, start, 1000, [&](const auto&, Support, ContactMotion, const ContactState<double>& z) {
            worst = std::max(worst, std::abs(energy(z) - energy(start)));
        });
    EXPECT_EQ(phase.segments.size(), 1U);
    std::printf("  energy off by %.1e in 1,000 time units\n", worst);
    EXPECT_LT(worst, 1e-11);  // 8,000 steps of 1e-14, at random
}

/// What friction does in the container's frame: energy falls by at least what the swirl gives.
TEST(DryContact, FrictionGivesNoEnergy) {
    long pieces = 0;
    for (int seed = 0; seed < 60; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = drawn_scene(draw);
        scene.floor = Floor::dish;
        const OnWall disk(scene);
        const double rho = 1 - scene.alpha, inertia = disk.wall.contact.body.inertia;
        ContactState<double> last{draw(-1, 1), 0, draw(-1, 1), draw(-2, 2)};
        double time = 0;
        const auto energy = [&](const ContactState<double>& z) {
            const double along = z.ut - scene.alpha * z.spin;
            return 0.5 * along * along + 0.5 * inertia * z.spin * z.spin;
        };
        disk.followed(Support::rim, last, 30,
                      [&](const ContactSums<double>& sums, Support, ContactMotion, const ContactState<double>& z) {
                          // The swirl's power −β sin ψ ρν′ between two looks, by the trapezium: error below h³/12 of
                          // its second derivative.
                          const double h = sums.time - time;
                          const auto power = [&](const ContactState<double>& y) {
                              return -scene.beta * std::sin(y.psi) * (y.ut - scene.alpha * y.spin);
                          };
                          const double given = 0.5 * h * (power(last) + power(z)),
                                       speed = 1 + std::abs(z.spin) + std::abs(z.ut);
                          const double error = h * h * h * scene.beta * speed * speed * speed / rho / rho;
                          EXPECT_LE(energy(z) - energy(last), given + error + 1e-13 * speed * speed)
                              << seed << " at " << sums.time;
                          last = z;
                          time = sums.time;
                          ++pieces;
                      });
    }
    EXPECT_GT(pieces, 10'000);
}

/// A disk that is held moves in no way, unless the floor wedges it against the wall: then it might slip, too, and rest
/// goes on. One that is not held moves in a way that its own forces drive.
TEST(DryContact, RestEndsWhereAMotionBegins) {
    int borders = 0, rolls = 0, slips = 0, wedged = 0;
    for (int seed = 0; seed < 200; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = drawn_scene(draw);
        scene.floor = Floor::dish;
        const OnWall disk(scene);
        for (int k = 0; k < 60; ++k) {
            const double psi = -pi<double>() + 2 * pi<double>() * (k + 0.5) / 60;
            const ContactState<double> still{psi, 0, 0, 0};
            const HeldAtRest held = held_at_rest(disk.wall, Support::rim, still);
            const double reserve = disk.wall.deceleration - held.least;
            if (std::abs(reserve) < 1e-6 || std::cos(psi) < 0) continue;
            const DryChoice next = choose_dry_motion(disk.wall, Support::rim, still, 0, ContactEvent::slip);
            const bool stays = next.choice.stays && !next.motion.rests;
            const bool is_wedged = held.normal > scene.beta * std::cos(psi) * (1 + 1e-9);
            if (reserve < 0 || !is_wedged) {
                EXPECT_EQ(stays, reserve < 0) << seed << " psi " << psi << " reserve " << reserve;
            }
            wedged += reserve > 0 && is_wedged && stays;
            if (!stays || reserve > 0) continue;
            ++borders;
            ++(next.motion.sticks() ? rolls : slips);
        }
    }
    std::printf("  %d places where it is not held: %d roll, %d slip; %d where it is wedged\n", borders, rolls, slips,
                wedged);
    EXPECT_GT(rolls, 100);
    EXPECT_GT(slips, 100);
}

TEST(DryContact, WithoutFrictionOfTheFloorItIsTheContactWithoutIt) {
    const ContactState<double> start{0.4, 0, 0, -1.7};
    Scene<double> scene = disk_over(0);
    const ContactScene<double> smooth =
        contact_scene(make_body(scene), scene.mu, scene.restitution, ImpactRule::poisson);
    const ContactEnd<double> known = run_contact(smooth, Support::rim, ContactMotion::sticking, start, 5.0);
    ASSERT_EQ(known.event, ContactEvent::horizon);
    for (const double deceleration : {1e-4, 1e-8, 1e-12}) {
        scene.floor_friction = deceleration;
        const OnWall disk(scene);
        const ContactPhase<double> phase = disk.followed(Support::rim, start, 5.0);
        ASSERT_EQ(phase.segments.size(), 1U);
        const ContactState<double>& end = phase.segments[0].to;
        const double off = std::max(std::abs(end.psi - known.state.psi), std::abs(end.spin - known.state.spin));
        EXPECT_LT(off, 30 * deceleration + 1e-13);  // 5 time units of a force 32/9π of it
        EXPECT_GT(off, 0.1 * deceleration);
    }
}

/// One impact more before its chatter is summed up changes no more than the second order of the time that it lasts.
TEST(DryContact, ChatterEndsWhereOneImpactMoreLeads) {
    double worst = 0;
    int landings = 0;
    for (int seed = 0; seed < 200; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        Scene<double> scene = drawn_scene(draw);
        scene.mu = draw(0.02, 0.8);
        scene.restitution = draw(0.3, 0.8);
        const DryMap<double, Shape::disk, ImpactRule::poisson> map(scene);
        const OnWall disk(scene);
        const ContactScene<double>& contact = disk.wall.contact;
        PostImpactState<double> z =
            post_impact_state(contact, ContactState<double>{draw(-1, 1), 0, draw(0.2, 1), draw(-2, 2)});
        z.vn -= 1e-6;  // T is some 10⁻⁶, T² v 10⁻¹⁸
        const Collision<double> next = map.advance(z);
        if (next.outcome != FirstContactOutcome::contact || next.flight_time > 1e-4) continue;
        const auto landed = [&](const PostImpactState<double>& from, double horizon) {
            const ContactScene<double> pushed = scene_at(disk.wall, from);
            const ChatterCompletion<double> rim{true, Support::rim, {}, 0, 0, 0};
            return disk.followed(Support::rim, landed_like(pushed, from, rim, from), horizon);
        };
        const ContactPhase<double> first = landed(z, 0.5), second = landed(next.after, 0.5 - next.flight_time);
        if (first.segments.size() != 1 || second.segments.size() != 1 || first.finish != ContactEvent::horizon)
            continue;
        const ContactState<double>&a = first.segments[0].to, &b = second.segments[0].to;
        const double off = std::max({std::abs(std::remainder(a.psi - b.psi, 2 * pi<double>())), std::abs(a.ut - b.ut),
                                     std::abs(a.spin - b.spin) * scene.alpha});
        worst = std::max(worst, off);
        ++landings;
    }
    std::printf("  %d landings from u_n = -1e-6: off by %.1e at most\n", landings, worst);
    EXPECT_GT(landings, 50);
    EXPECT_LT(worst, 1e-10);  // first order, were the friction of what is removed left out: 10⁻⁶
}

TEST(DryContact, OrbitsEndWithNames) {
    std::map<std::string, int> endings;
    for (int seed = 0; seed < 100; ++seed) {
        Draw draw{std::mt19937_64(static_cast<unsigned>(seed))};
        const Scene<double> scene = drawn_scene(draw);
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
            while (impacts < 200 && orbit.advance(30)) ++impacts;
            ++endings[std::string(name_of(orbit.outcome()))];
            EXPECT_NE(orbit.outcome(), Outcome::unresolved) << seed;
            EXPECT_NE(orbit.outcome(), Outcome::contact_cut) << seed;
        });
    }
    for (const auto& [ending, count] : endings) std::printf("  %s: %d\n", ending.c_str(), count);
    EXPECT_GT(endings["in-contact"], 50);
}

/// Of the trajectory between impacts, in flight and in contact.
TEST(DryContact, PathsStayOnTheWallAndJoin) {
    Scene<double> scene = disk_over(0.2);
    scene.mu = 0.1;
    const LabStart<double> start{0.5, 0, 0.3, 0.1, 0.1, 0.5};
    const DryMap<double, Shape::disk, ImpactRule::poisson> map(scene);
    Orbit orbit(map, start);
    TrajectorySegmenter cutter(scene, start);
    cutter.take_paths_from(dry_paths(scene));
    Moment last{};
    double last_time = 0;
    long looks = 0, slipping = 0;
    bool begun = false;
    for (bool goes_on = true; goes_on;) {
        goes_on = orbit.advance(50, cutter.sink());
        for (const TrajectorySegment& segment : cutter.passed(orbit, goes_on)) {
            for (int k = 0; k <= 4; ++k) {
                const double t = segment.start + (segment.end - segment.start) * k / 4;
                const Moment now = moment_at(cutter.scene(), segment, t);
                const double off = std::hypot(now.centre.x - 0.5 * std::cos(t), now.centre.y - 0.5 * std::sin(t)) - 0.6;
                EXPECT_LT(off, 1e-12);
                if (segment.in_contact) {
                    EXPECT_GT(off, -1e-12);
                    EXPECT_GE(now.normal_force, -1e-12);
                    EXPECT_LE(std::abs(now.friction), scene.mu * now.normal_force + 1e-9);
                    slipping += std::abs(now.slip) > 1e-3;
                    ++looks;
                }
                if (begun) {
                    EXPECT_LT(std::hypot(now.centre.x - last.centre.x, now.centre.y - last.centre.y),
                              3 * (t - last_time) + 1e-11);
                }
                last = now;
                last_time = t;
                begun = true;
            }
        }
    }
    EXPECT_EQ(orbit.outcome(), Outcome::in_contact);
    EXPECT_GT(looks, 1'000);
    EXPECT_GT(slipping, 20);
}

}  // namespace
}  // namespace swirl
