// The first contact of bodies that are slow against the swirl, in double against 113 bits.
#include "map/first_contact/first_contact.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/extremes/one_step.hpp"
#include "tests/map/random_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace swirl {
namespace {

using tests::Random;

struct SlowCase {
    int sides;
    double alpha, beta;
    double vx, vy, spin, angle;
};

template <class T>
FirstContact<T> contact_of(const SlowCase& c) {
    const Scene<T> scene{c.sides, T(c.alpha), T(c.beta), T(0), T(1), Law::newton, uniform_inertia_factor<T>(c.sides)};
    const Body<T> body = make_body(scene);
    Flight<T> flight;
    flight.centre = {T(-c.beta), T(0)};  // at the swirl's centre
    flight.velocity = {T(c.vx), T(c.vy)};
    flight.phase = {T(1), T(0)};
    flight.arm = {T(c.alpha * std::cos(c.angle)), T(c.alpha * std::sin(c.angle))};
    flight.spin = T(c.spin);
    flight.beta = T(c.beta);
    return first_contact<Shape::polygon>(body, flight);
}

struct Compared {
    double time = 0;     ///< in double
    double late = 0;     ///< relative to the time in quad
    double outside = 0;  ///< |x| − 1
};

Compared compare(const SlowCase& c) {
    const FirstContact<double> found = contact_of<double>(c);
    const FirstContact<Quad> exact = contact_of<Quad>(c);
    EXPECT_EQ(found.outcome, FirstContactOutcome::contact);
    EXPECT_EQ(exact.outcome, FirstContactOutcome::contact);
    const double time = static_cast<double>(exact.at.time);
    return {found.at.time, found.at.time / time - 1, detail::magnitude(found.at.centre + found.arm) - 1};
}

// It was found 12 % late: the sheltered flight's G′ was a difference of numbers of the size of β, whose rounding was
// larger than the body's speed.
TEST(SlowSearch, ABodyOfSpeedTenToTheMinusTwentyIsFoundAtTheWall) {
    for (const double vx : {-1e-20, 1e-20}) {
        const Compared c = compare({11, .49957939246289707, .01, vx, 0, 0, 0});
        EXPECT_LE(std::abs(c.late), 1e-13);
        EXPECT_LE(c.outside, 4e-16);
    }
}

// From the swirl's centre the body moves straight on; the wall reaches the vertex within a turn or two of |y| = 1 − β,
// which is known to some ε. A flight of 10⁹ turns and more ends at that turn: relative 10⁻⁸ for the shortest.
TEST(SlowSearch, DrawnSlowBodiesAreFoundAtTheWallWhenTheyComeToIt) {
    Random random(20261123);
    double latest = 0, outside = 0, longest = 0;
    constexpr int count = 80;
    for (int i = 0; i < count; ++i) {
        SlowCase c{random.one_of({3, 4, 5, 6, 7, 8, 11, 50}), random.between(0.05, 0.9), 0, 0, 0, 0, random.angle()};
        c.beta = (1 - c.alpha) * random.between(0.01, 0.9);
        const double speed = random.log_between(1e-60, 1e-10), direction = random.angle();
        c.vx = speed * std::cos(direction);
        c.vy = speed * std::sin(direction);
        if (random.chance(0.7)) c.spin = random.sign() * speed * random.log_between(0.01, 3);
        const Compared found = compare(c);
        // Two turns of the swirl beside rounding: which of its passages touches is decided by the last digits of G.
        const double allowed = 1e-13 + 4 * M_PI / found.time;
        EXPECT_LE(std::abs(found.late), allowed)
            << c.sides << " sides, alpha " << c.alpha << ", beta " << c.beta << ", v " << c.vx << ' ' << c.vy
            << ", spin " << c.spin << ", angle " << c.angle;
        latest = std::max(latest, std::abs(found.late) / allowed);
        outside = std::max(outside, found.outside);
        longest = std::max(longest, found.time);
    }
    std::printf("%d flights of at most %.1e: the contact at most %.2g of what is allowed off, %.2g outside\n", count,
                longest, latest, outside);
    EXPECT_LE(outside, 1e-14);
    EXPECT_GT(longest, 1e40);
}

/// A disk with little room, in a wide swirl: after `ordinary_steps` steps it was taken to be at the wall within the
/// rounding of what it had moved, where g is that times the room it has: up to 39 % early.
TEST(SlowSearch, ADiskThatAllButFillsTheContainerIsFoundAtTheWall) {
    Random random(9);
    double worst = 0;
    int found = 0;
    for (int drawn = 0; drawn < 100'000 && found < 300; ++drawn) {
        const double room = random.log_between(1e-12, 1e-8), speed = random.log_between(1e-14, 1e-2);
        const Scene<double> scene{disk_sides, 1 - room, random.between(0.05, 3), 0, 1, Law::poisson, 0.5};
        const double leaving = speed * random.log_between(1e-9, 1);
        const auto z = post_impact_state(tests::random_point(random, scene, leaving, speed, 3.0));
        const Body<double> body = make_body(scene);
        const auto contact = detail::certain_contact_disk(body, flight_from(body, z));
        if (contact.outcome != FirstContactOutcome::contact || contact.steps <= detail::ordinary_steps) continue;
        const Body<Quad> wide = make_body(tests::widened(scene));
        const Flight<Quad> flight = flight_from(wide, tests::widened(z));
        const Quad gap = centre_gap(wide, flight, instant_at<Shape::disk>(flight, Quad(contact.at.time))).value;
        // g = 2X₀·moved + |moved|², |X₀| the room: some ε of either term.
        const double moved = contact.at.time * (std::abs(z.vn) + std::abs(z.vt) + scene.beta);
        const double allowed = 16 * 0x1p-52 * moved * (room + moved);
        worst = std::max(worst, std::abs(static_cast<double>(gap)) / allowed);
        ++found;
    }
    std::printf("%d flights of more than %d steps: g at the contact at most %.2g of what is allowed\n", found,
                detail::ordinary_steps, worst);
    EXPECT_EQ(found, 300);
    EXPECT_LE(worst, 1);
}

}  // namespace
}  // namespace swirl
