// The searches that are there to compare with: right where a flight is simple, wrong where their method is, and never
// without an end.
#include "map/baselines/baseline_map.hpp"
#include "map/orbit/laboratory.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace swirl {
namespace {

using tests::Random;
using tests::uniform_scene;

constexpr BaselineSearch all[] = {BaselineSearch::paper, BaselineSearch::brent, BaselineSearch::fixed_step};

FirstContact<double> exact_contact(const Body<double>& body, const Flight<double>& flight) {
    return body.sides == disk_sides ? first_contact<Shape::disk>(body, flight)
                                    : first_contact<Shape::polygon>(body, flight);
}

/// From wall to wall across a container at rest, without spin: every gap is a parabola in time, with one root after 0.
Flight<double> simple_flight(Random& random, const Body<double>& body, const Scene<double>& scene) {
    SectionPoint<double> z = tests::random_point(random, scene, random.between(0.2, 1), 0.3, 0);
    z.spin = 0;
    return flight_from(body, post_impact_state(z));
}

/// |x| of the point that touches, 1 on the wall.
double distance_of(const Body<double>& body, const FirstContact<double>& contact) {
    return detail::magnitude(body.sides == disk_sides ? body.inverse_inner * contact.at.centre
                                                      : contact.at.centre + contact.arm);
}

/// A body that spins in the middle of a container and drifts slowly to its wall: the vertex that first reaches it is
/// outside for a short time only, since it turns away again.
Flight<double> slow_and_spinning(const Body<double>& body, double speed, double angle, double spin) {
    return flight_from(body, LabStart<double>{body.beta, 0, speed, 0, angle, spin});
}

TEST(Baselines, AgreeWithTheExactSearchOnSimpleFlights) {
    Random random(1);
    const long count = tests::sample_count(2000);
    double largest_paper = 0, largest_brent = 0, latest = 0;
    for (long i = 0; i < count; ++i) {
        const int sides = random.one_of({disk_sides, 3, 4, 6, 50});
        const Scene<double> scene = uniform_scene(sides, random.between(0.1, 0.8), 0, 0.5, 0.9);
        const Body<double> body = make_body(scene);
        const Flight<double> flight = simple_flight(random, body, scene);
        const FirstContact<double> exact = exact_contact(body, flight);
        const FirstContact<double> paper = paper_contact(body, flight), brent = brent_contact(body, flight);
        const FirstContact<double> stepped = fixed_step_contact(body, flight);
        for (const auto* contact : {&exact, &paper, &brent, &stepped})
            ASSERT_EQ(contact->outcome, FirstContactOutcome::contact) << "flight " << i;
        largest_paper = std::max(largest_paper, std::fabs(paper.at.time - exact.at.time));
        largest_brent = std::max(largest_brent, std::fabs(brent.at.time - exact.at.time));
        ASSERT_GE(stepped.at.time, exact.at.time - 1e-12) << "flight " << i;
        latest = std::max(latest, stepped.at.time - exact.at.time);
        ASSERT_NEAR(distance_of(body, stepped), 1, 4e-16) << "put back onto the wall, flight " << i;
    }
    std::printf("of %ld flights: paper's largest error in time %.1e, brent's %.1e, fixed-step's %.1e\n", count,
                largest_paper, largest_brent, latest);
    // A gap's rounding is some 4ε, its slope at least 0.06 (the chord that leaves with u_n = 0.2): 1e-13 for the
    // paper's tolerance comes on top.
    EXPECT_LE(largest_brent, 1e-13);
    EXPECT_LE(largest_paper, 4e-12);
    EXPECT_LE(latest, fixed_step_length);
    EXPECT_GT(latest, 0.9 * fixed_step_length) << "late by as much as a step";
}

TEST(Baselines, ContactsComeLateByAnErrorOfTheOrderOfTheStep) {
    const Scene<double> scene = uniform_scene(6, 0.4, 0.5, 0.5, 0.9);
    const Body<double> body = make_body(scene);
    Random random(2);
    std::vector<Flight<double>> flights;
    flights.reserve(100);
    for (int i = 0; i < 100; ++i)
        flights.push_back(flight_from(body, post_impact_state(tests::random_point(random, scene, 0.5))));
    double coarse = 0, fine = 0;
    for (const auto& flight : flights) {
        const double time = brent_contact(body, flight, 1e-3).at.time;
        coarse += std::fabs(fixed_step_contact(body, flight, 1e-2).at.time - time);
        fine += std::fabs(fixed_step_contact(body, flight, 1e-3).at.time - time);
    }
    EXPECT_NEAR(coarse / fine, 10, 3);
}

// Two roots lie in one of their intervals: each passes a contact that the exact search has, and that is there.
TEST(Baselines, PaperAndBrentPassContactsOfAFastVertex) {
    const Body<double> body = make_body(uniform_scene(6, 0.4, 0.3, 0.5, 0.9));
    Random random(3);
    int paper_missed = 0, brent_missed = 0, flights = 0;
    for (; flights < 50; ++flights) {
        const Flight<double> flight = slow_and_spinning(body, 0.05, random.angle(), 60);
        const FirstContact<double> exact = exact_contact(body, flight);
        ASSERT_EQ(exact.outcome, FirstContactOutcome::contact);
        // The contact is real: that vertex is on the wall there and moves outward, and samples a hundredth as far apart
        // see it, too.
        ASSERT_NEAR(distance_of(body, exact), 1, 1e-14);
        ASSERT_GT(dot(exact.at.centre + exact.arm, exact.at.drift + flight.spin * quarter_turned(exact.arm)), 0);
        ASSERT_NEAR(brent_contact(body, flight, brent_spacing / 100).at.time, exact.at.time, 1e-9);
        const FirstContact<double> paper = paper_contact(body, flight), brent = brent_contact(body, flight);
        ASSERT_GE(brent.at.time, exact.at.time - 1e-9) << "no root lies before the first";
        paper_missed += paper.outcome != FirstContactOutcome::contact || paper.at.time > exact.at.time + 1e-3;
        brent_missed += brent.at.time > exact.at.time + 1e-3;
    }
    std::printf("of %d flights: paper misses %d contacts, brent %d\n", flights, paper_missed, brent_missed);
    EXPECT_GE(paper_missed, 10);
    EXPECT_GE(brent_missed, 10);
    EXPECT_LT(brent_missed, flights) << "some are outside for longer than the spacing";
}

// The wall comes round to a slow disk once a turn; the guesses treat it as at rest.
TEST(Baselines, PaperPassesContactsOfASlowDisk) {
    const Body<double> body = make_body(uniform_scene(disk_sides, 0.4, 0.3, 0, 1));
    Random random(4);
    int missed = 0;
    for (int i = 0; i < 100; ++i) {
        const Flight<double> flight = slow_and_spinning(body, random.between(0.005, 0.02), 0, 0);
        const FirstContact<double> exact = exact_contact(body, flight), brent = brent_contact(body, flight, 1e-3);
        ASSERT_NEAR(brent.at.time, exact.at.time, 1e-9);
        const FirstContact<double> paper = paper_contact(body, flight);
        ASSERT_NE(paper.outcome, FirstContactOutcome::no_contact);
        missed += paper.outcome != FirstContactOutcome::contact || paper.at.time > exact.at.time + 0.1;
    }
    std::printf("of 100 flights of a slow disk: paper misses %d\n", missed);
    EXPECT_GE(missed, 10);
}

TEST(Baselines, EndWithANameHoweverSlowOrFast) {
    long most = 0;
    for (const int sides : {disk_sides, 3, 50})
        for (const double beta : {0.0, 1e-70, 0.5, 1000.0})
            for (const double speed : {0.0, 1e-70, 1e-12, 1e8, 1e70})
                for (const double spin : {0.0, 1e8, 1e70}) {
                    const bool slow = speed < 1;  // as much work as there may be
                    const bool tried = beta == 0.5 ? sides == 3 : sides != 50 && speed == 0 && spin == 0;
                    if (slow && spin != 1e8 && (!tried || tests::sample_count(20) < 20)) continue;
                    const Body<double> body = make_body(uniform_scene(sides, 0.4, beta, 0.5, 0.9));
                    const Flight<double> flight = slow_and_spinning(body, speed, 0.3, spin);
                    for (const auto search : all) {
                        const FirstContact<double> contact = baseline_contact(search, body, flight);
                        ASSERT_NE(contact.outcome, FirstContactOutcome::sustained);
                        // A body at rest inside is touched by no wall that stays, or moves by 10⁻⁷⁰.
                        const bool none = contact.outcome == FirstContactOutcome::no_contact;
                        ASSERT_TRUE(!none || (beta < 0.5 && speed == 0));
                        ASSERT_TRUE(none || !(beta == 0 && speed == 0));
                        if (contact.outcome == FirstContactOutcome::contact) {
                            ASSERT_TRUE(std::isfinite(contact.at.time) && contact.at.time > 0);
                        }
                        most = std::max(most, static_cast<long>(contact.steps));
                    }
                }
    std::printf("at most %ld moments\n", most);
    EXPECT_LE(most, 1'010'000);
}

TEST(Baselines, TheImpactIsTheMapsOwn) {
    const Scene<double> scene = uniform_scene(6, 0.4, 0.5, 0.5, 0.9);
    const CollisionMap<double, Shape::polygon, ImpactRule::poisson> exact(scene);
    const BaselineMap<Shape::polygon, ImpactRule::poisson> brent(scene, BaselineSearch::brent);
    Random random(5);
    int compared = 0;
    for (int i = 0; i < 200; ++i) {
        const PostImpactState<double> z = post_impact_state(tests::random_point(random, scene, 0.5));
        const Collision<double> a = exact.advance(z), b = brent.advance(z);
        if (a.vertex_step != b.vertex_step || std::fabs(a.flight_time - b.flight_time) > 1e-12) continue;
        ++compared;
        ASSERT_EQ(a.impulse.mode, b.impulse.mode);
        ASSERT_NEAR(a.after.vn, b.after.vn, 1e-11);
        ASSERT_NEAR(a.after.vt, b.after.vt, 1e-11);
        ASSERT_NEAR(a.after.spin, b.after.spin, 1e-10);
        ASSERT_NEAR(a.jacobi_friction, b.jacobi_friction, 1e-10);
    }
    EXPECT_GE(compared, 190);
}

// A vertex that stays on the wall, or a body that nothing reaches, is not the search's to decide.
TEST(Baselines, DecideTheStartAsTheExactSearchDoes) {
    const Scene<double> scene = uniform_scene(disk_sides, 0.4, 0.5, 0, 0);
    const Body<double> body = make_body(scene);
    SectionPoint<double> z;
    z.psi = 0;  // at rest in the frame that turns with the swirl: pressed to the wall
    z.vt = scene.beta + body.inner;
    const Flight<double> pressed = flight_from(body, post_impact_state(z));
    ASSERT_EQ(exact_contact(body, pressed).outcome, FirstContactOutcome::sustained);
    const Flight<double> apart = slow_and_spinning(make_body(uniform_scene(6, 0.3, 0.4, 0.5, 0.9)), 0, 0, 3);
    const Body<double> hexagon = make_body(uniform_scene(6, 0.3, 0.4, 0.5, 0.9));
    for (const auto search : all) {
        EXPECT_EQ(baseline_contact(search, body, pressed).outcome, FirstContactOutcome::sustained);
        EXPECT_NE(baseline_contact(search, hexagon, apart).outcome, FirstContactOutcome::sustained);
    }
}

// A disk that the swirl presses to the wall lands: chatter and contact are the return map's own.
TEST(Baselines, ReturnMapsGoThroughContact) {
    const Scene<double> scene = uniform_scene(disk_sides, 0.4, 0.5, 0.2, 0.1);
    const CollisionMap<double, Shape::disk, ImpactRule::poisson> exact(scene);
    const ReturnMap exact_return(exact);
    Random random(6);
    int in_contact = 0;
    for (int i = 0; i < 50; ++i) {
        SectionPoint<double> z = tests::random_point(random, scene, 1e-6);
        z.psi = random.between(-0.5, 0.5);
        // So slow that the rest of its rebounds is below rounding: 2 v²/(a (1 − e)) ≤ 16 ε.
        z.vn = -1e-9 + scene.beta * std::sin(z.psi);
        const ReturnStep<double> a = exact_return.advance(post_impact_state(z));
        if (a.contacts.empty()) continue;
        ++in_contact;
        for (const auto search : all) {
            const BaselineMap<Shape::disk, ImpactRule::poisson> map(scene, search);
            const ReturnStep<double> b = ReturnMap(map).advance(post_impact_state(z));
            ASSERT_EQ(b.outcome, a.outcome);
            ASSERT_EQ(b.contacts.size(), a.contacts.size());
            ASSERT_EQ(b.contacts.back().end, a.contacts.back().end);
        }
    }
    EXPECT_GE(in_contact, 10);
}

}  // namespace
}  // namespace swirl
