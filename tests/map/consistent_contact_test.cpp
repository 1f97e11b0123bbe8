// Contact held against what it must be, whatever the way it was found: no vertex outside, λ ≥ 0, |f| ≤ μλ at every
// moment shown, in every number type; what an independent computation in 200 bits found (November 2026) where there is
// one.
#include "map/contact/motion_choice.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "map/orbit/orbit.hpp"
#include "map/orbit/trajectory_segment.hpp"
#include "tests/map/contact_scenes.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/references/references.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace swirl {
namespace {

/// What an orbit shows of its contacts.
struct Seen {
    Outcome outcome = Outcome::completed;
    long moments = 0, edges = 0;
    double outside = 0;  ///< of the farthest vertex, in contact and in flight
    double pulled = 0;   ///< −λ
    double beyond = 0;   ///< |f| − μλ
    double spin_at = 0;  ///< S at the time asked for
    double time = 0;     ///< followed to
};

double outside_of(const ContactScene<double>& scene, const Moment& now, double t) {
    const Vec2<double> x = now.centre - scene.body.beta * cis(t);
    double farthest = 0;
    for (int k = 0; k < scene.body.sides; ++k) {
        const Vec2<double> vertex = x + scene.body.alpha * cis(now.angle + k * scene.body.spacing);
        farthest = std::max(farthest, std::hypot(vertex.x, vertex.y));
    }
    return farthest - 1;
}

void look_at(const ContactScene<double>& scene, const TrajectorySegment& segment, double asked, Seen& seen) {
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double t = segment.start + share * (segment.end - segment.start);
        const Moment now = moment_at(scene, segment, t);
        ++seen.moments;
        seen.outside = std::max(seen.outside, outside_of(scene, now, t));
        if (!segment.in_contact || !(segment.end > segment.start)) continue;  // strikes in turn: no contact between
        seen.edges += segment.support == Support::edge;
        const double scale = 1 + std::abs(now.normal_force);
        seen.pulled = std::max(seen.pulled, -now.normal_force / scale);
        if (segment.support == Support::edge) continue;  // f is the sum of two that may be opposite
        seen.beyond = std::max(seen.beyond, (std::abs(now.friction) - scene.mu * now.normal_force) / scale);
    }
    if (segment.start <= asked && asked <= segment.end) seen.spin_at = moment_at(scene, segment, asked).spin;
}

template <class T>
Seen follow(const Scene<double>& scene, const LabStart<double>& start, double until, double asked = -1,
            long most = 2000) {
    const Scene<T> in_t = tests::scene_in<T>(scene);
    return with_collision_map(in_t, [&](const auto& map) {
        const LabStart<T> from{T(start.x), T(start.y), T(start.vx), T(start.vy), T(start.angle), T(start.spin)};
        Seen seen;
        Orbit orbit(map, from);
        TrajectorySegmenter cutter(in_t, from);
        const ContactSink sink = cutter.sink();
        while (seen.time < until && orbit.impacts() < most) {
            const bool struck = orbit.advance(until - seen.time, sink);
            for (const TrajectorySegment& segment : cutter.passed(orbit, struck))
                look_at(cutter.scene(), segment, asked, seen);
            if (!struck) {
                seen.outcome = orbit.outcome();
                break;
            }
            seen.time = static_cast<double>(orbit.frame().time.unwound());
        }
        return seen;
    });
}

void expect_consistent(const Seen& seen) {
    EXPECT_NE(seen.outcome, Outcome::unresolved);
    EXPECT_GT(seen.moments, 0);
    EXPECT_LE(seen.outside, 1e-11);
    EXPECT_LE(seen.pulled, 1e-9);
    EXPECT_LE(seen.beyond, 1e-9);
}

LabStart<double> start_of(const nlohmann::json& initial) {
    const auto of = [&](const char* name) { return tests::number<double>(initial[name]); };
    return {of("x"), of("y"), of("vx"), of("vy"), of("angle"), of("spin")};
}

/// The largest difference of S from the reference's.
template <class T>
double off_by(const nlohmann::json& entry) {
    const Scene<double> scene = tests::scene_from<double>(entry);
    const LabStart<double> start = start_of(entry["initial"]);
    double most = 0;
    for (const auto& sample : entry["samples"]) {
        const double t = tests::number<double>(sample["t"]);
        const Seen seen = follow<T>(scene, start, t + 0.01, t);
        expect_consistent(seen);
        most = std::max(most, std::abs(seen.spin_at - tests::number<double>(sample["spin"])));
    }
    return most;
}

// Squares at e = 0 whose edge can neither rest nor slide once their rocking has come to rest: one vertex sticks, and
// the other one lifts. S of an independent computation in 60 digits, a quarter of a unit of time apart.
TEST(ConsistentContact, RockingThatComesToRestLeavesOneVertexThatSticks) {
    const nlohmann::json reference = tests::read_reference("contact_orbits.json");
    ASSERT_GE(reference["cases"].size(), 4U);
    for (const auto& entry : reference["cases"]) {
        const double in_double = off_by<double>(entry), in_64_bits = off_by<long double>(entry);
        std::printf("S is off by %.1e in double, %.1e in 64 bits\n", in_double, in_64_bits);
        EXPECT_LE(in_double, 1e-14);   // measured: 6e-16 = 3 ε at most
        EXPECT_LE(in_64_bits, 1e-15);  // measured: 3e-16, the rounding of scene and start to double
    }
}

// An edge at rest ends as the vertex that lifts is about to: χ″ there is rounding, of either sign.
TEST(ConsistentContact, AnEdgeThatCeasesToRestLiftsAVertex) {
    const Scene<double> scene =
        tests::uniform_scene(5, 0.84738488061485717, 3.8749398389487189, 1.7406249006534926, 0, Law::newton);
    const LabStart<double> start{3.8207480134033047,  0.011628506301064795, 0.076687601517019033,
                                 0.29732363758308467, -1.5819577729235332,  0.23064362226587398};
    const Seen in_double = follow<double>(scene, start, 2, 1.99), in_quad = follow<Quad>(scene, start, 2, 1.99);
    expect_consistent(in_double);
    expect_consistent(in_quad);
    EXPECT_GT(in_double.edges, 0);
    // Pendulum about the vertex, from rest at ψ that does not depend on the digits of the rocking before.
    EXPECT_NEAR(in_double.spin_at, in_quad.spin_at, 1e-12);
    EXPECT_LT(in_quad.spin_at, -0.09);  // it has left the edge
}

// e = 0 is the limit of e -> 0, also where the wall presses by a = 5e-5 alone and a flight of 2v/a is long until v,
// e times 1, is some 1e-10.
TEST(ConsistentContact, WithoutRestitutionItIsTheLimitWhereContactIsHardlyPressed) {
    Scene<double> scene =
        tests::uniform_scene(5, 0.58658613951052774, 3.381392554635096, 3.9955840397070057, 0, Law::newton);
    const LabStart<double> start{3.2036923833306745,  0.16699138260580151, 0.29094615621634834,
                                 0.35875336544175007, 1.0891927634844274,  -0.1235865142610264};
    const auto spin_at = [&](double e) {
        scene.restitution = e;
        return follow<double>(scene, start, 0.6, 0.55).spin_at;
    };
    const double limit = spin_at(0);
    EXPECT_NEAR(limit, -1.5637, 5e-5);  // it sticks, from 0.5348 to 0.5488
    for (const double e : {1e-14, 1e-12, 1e-11}) EXPECT_NEAR(spin_at(e), limit, 1e-9 + 10 * e) << e;
    EXPECT_NEAR(spin_at(1e-8), -1.5147, 5e-5);  // it flies: the acceleration has turned before it is back
}

TEST(ConsistentContact, SamplesInMoreDigitsAreThoseOfDouble) {
    const Scene<double> scene = tests::uniform_scene(4, 0.561079, 0.587934, 0.162745, 0, Law::newton);
    const LabStart<double> start{1.07135129, 0.19448745, 0.00111957, 0.58838442, -0.40278362, -0.02840519};
    const Seen in_double = follow<double>(scene, start, 1.5, 1.375),
               extended = follow<long double>(scene, start, 1.5, 1.375);
    expect_consistent(in_double);
    expect_consistent(extended);
    EXPECT_NEAR(extended.spin_at, in_double.spin_at, 1e-12);
}

TEST(ConsistentContact, AJamIsReachedToRounding) {
    // Stronge's law takes a root of what is left of B₂ − sμB₃. S after it, independently.
    Scene<double> scene = tests::uniform_scene(3, 0.104716, 1.369342, 1.477224, 0.123051, Law::stronge);
    const LabStart<double> start{1.46859533, -0.93631304, 0.00875815, 1.28672139, -2.51959508, 0.10288252};
    for (const Law law : {Law::stronge, Law::poisson, Law::newton}) {
        scene.law = law;
        const Seen a = follow<double>(scene, start, 0.52, 0.51), b = follow<long double>(scene, start, 0.52, 0.51);
        if (law == Law::stronge) {
            EXPECT_NEAR(a.spin_at, -3.27496148898, 1e-11);
        }
        EXPECT_NEAR(a.spin_at, b.spin_at, 1e-12);
    }
}

TEST(ConsistentContact, AWedgeIsLeftAsInTheLimitOfNoRestitution) {
    Scene<double> scene = tests::uniform_scene(3, 0.786617, 0.065133, 1.521689, 0, Law::newton);
    const LabStart<double> start{0.1536093, -0.0249839, -0.370210, -0.255716, 3.287857, -0.302182};
    const Seen without = follow<double>(scene, start, 2);
    expect_consistent(without);
    EXPECT_EQ(without.edges, 0);
    scene.restitution = 1e-6;
    EXPECT_EQ(follow<double>(scene, start, 2).edges, 0);
}

struct Ends {
    long abrupt = 0;
    double late = 0;  ///< the largest difference of the moments in double and in 64 bits
};

/// Sticking on a vertex that ends in flight, since no slip is consistent (Painlevé).
Ends ends_in_flight(long count, std::uint64_t seed) {
    tests::Random random(seed);
    Ends ends;
    for (long i = 0; i < count; ++i) {
        const int sides = random.one_of({3, 4, 5});
        const double alpha = random.between(0.1, 0.6), beta = random.between(0.1, 1.5), mu = random.between(1.2, 4);
        const Scene<double> scene = tests::uniform_scene(sides, alpha, beta, mu, 0.3);
        const auto contact = tests::contact_of(scene);
        const auto wide = tests::contact_of(tests::scene_in<long double>(scene));
        const double psi = random.between(-2, 2), chi = contact.widest_chi * random.between(-1, 1);
        const ContactState<double> z{psi, chi, 0, random.between(-0.5, 0.5)};
        const ContactState<long double> w{z.psi, z.chi, 0, z.spin};
        if (choose_motion(contact, Support::vertex, z, 0).motion != ContactMotion::sticking) continue;
        const auto end = run_contact(contact, Support::vertex, ContactMotion::sticking, z, 5.0);
        if (end.event != ContactEvent::slip || end.sums.time < 1e-3) continue;
        if (choose_motion(contact, Support::vertex, end.state, 0, ContactEvent::slip).stays) continue;
        const auto exact = run_contact(wide, Support::vertex, ContactMotion::sticking, w, 5.0L);
        if (exact.event != ContactEvent::slip) continue;
        ++ends.abrupt;
        ends.late = std::max(ends.late, std::abs(end.sums.time - static_cast<double>(exact.sums.time)));
    }
    return ends;
}

TEST(ConsistentContact, StickingThatEndsInFlightEndsInTime) {
    const Ends ends = ends_in_flight(tests::sample_count(2000), 7);
    std::printf("%ld ends, late by %.1e\n", ends.abrupt, ends.late);
    EXPECT_GT(ends.abrupt, 5);
    EXPECT_LE(ends.late, 2e-14);  // 100 ε: of rounding, over the rate at which friction's reserve falls
}

/// Random scenes of the sort in which the edges of polygons are landed on; the worst of them is reported.
void check_random(long count, std::uint64_t seed) {
    tests::Random random(seed);
    long moments = 0, edges = 0, unresolved = 0, wrong = 0;
    Seen worst;
    for (long i = 0; i < count; ++i) {
        const int sides = random.one_of({3, 4, 5, 6});
        const double mu = random.chance(0.1) ? 0 : random.between(0.02, 2),
                     e = random.chance(0.6) ? 0 : random.between(0, 0.6);
        const Law law = random.chance(0.4) ? Law::newton : random.chance(0.5) ? Law::stronge : Law::poisson;
        Scene<double> scene = tests::random_scene(random, sides, mu, e, law);
        if (random.chance(0.3)) scene.alpha = random.between(0.9, 0.98);
        const double room = 0.9 * (1 - scene.alpha), x = scene.beta + room * random.between(-0.7, 0.7),
                     y = room * random.between(-0.7, 0.7), vx = random.between(-1, 1), vy = random.between(-1, 1);
        const double angle = random.angle(), spin = random.between(-0.5, 0.5);
        const LabStart<double> start{x, y, vx, vy, angle, spin};
        const Seen seen = i % 2 == 0 ? follow<double>(scene, start, 4) : follow<long double>(scene, start, 4);
        moments += seen.moments;
        edges += seen.edges;
        unresolved += seen.outcome == Outcome::unresolved;
        const bool bad = seen.outside > 1e-11 || seen.pulled > 1e-9 || seen.beyond > 1e-9;
        wrong += bad;
        if (bad || seen.outcome == Outcome::unresolved)
            ADD_FAILURE() << "scene " << i << ": " << name_of(seen.outcome) << " outside " << seen.outside
                          << " -lambda " << seen.pulled << " |f| - mu lambda " << seen.beyond << " N " << sides
                          << " alpha " << scene.alpha << " beta " << scene.beta << " mu " << mu << " e " << e << ' '
                          << name_of(law) << " start " << x << ' ' << y << ' ' << vx << ' ' << vy << ' ' << angle << ' '
                          << spin;
        worst.outside = std::max(worst.outside, seen.outside);
        worst.pulled = std::max(worst.pulled, seen.pulled);
        worst.beyond = std::max(worst.beyond, seen.beyond);
    }
    std::printf(
        "%ld scenes, %ld moments, %ld on edges: %ld unresolved, %ld wrong; outside %.1e, -lambda %.1e, |f| - mu "
        "lambda %.1e\n",
        count, moments, edges, unresolved, wrong, worst.outside, worst.pulled, worst.beyond);
    EXPECT_GT(edges, 0);
}

TEST(ConsistentContact, RandomScenesKeepTheWallAndFriction) {
    check_random(tests::sample_count(200), 11);
}
TEST(ConsistentContactNightly, ThousandsOfRandomScenesKeepTheWallAndFriction) {
    check_random(tests::sample_count(10'000), 12);
}

}  // namespace
}  // namespace swirl
