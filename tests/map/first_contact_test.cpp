// No missed contact: random flights against an independent scan, with near-grazing and near-simultaneous contacts
// over-represented.
#include "map/orbit/laboratory.hpp"
#include "tests/map/container_scan.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <type_traits>

namespace swirl {
namespace {

using tests::Random;
using tests::Real;
using tests::ScannedFlight;

constexpr double eps = 0x1p-52;

enum Kind { generic, grazing, two_at_once, large_spin, wide_swirl, large_body, slow, kinds };
constexpr const char* kind_names[kinds] = {"generic",    "grazing",    "two at once", "large spin",
                                           "wide swirl", "large body", "slow"};

/// A flight as the map takes it, and as the scan does.
struct Case {
    Scene<double> scene;
    std::optional<SectionPoint<double>> point;  ///< begins with an impact
    LabStart<double> start;                     ///< or in flight
    ScannedFlight flight;
};

Scene<double> scene_of(Random& random, Kind kind) {
    const int sides = random.one_of({disk_sides, 3, 3, 4, 5, 6, 7, 8, 12, 30, 100, 1000, 10000, 100000});
    Scene<double> scene = tests::random_scene(random, sides, 0, 1, Law::poisson);
    if (kind == wide_swirl) scene.beta = 5;
    if (kind == large_body) scene.alpha = random.chance(0.5) ? 0.99 : random.between(0.95, 0.9999);
    if (random.chance(0.05)) scene.beta = 0;
    return scene;
}

double spin_of(Random& random, Kind kind) {
    return kind == large_spin ? random.sign() * random.log_between(10, 1000) : random.between(-4, 4);
}

double speed_of(Random& random, Kind kind) {
    return kind == slow ? random.log_between(1e-6, 1e-2) : random.log_between(0.01, 4);
}

/// Just after an impact; u_n from grazing to hard.
Case struck_case(Random& random, Kind kind) {
    Case c;
    c.scene = scene_of(random, kind);
    const double leaving = kind == grazing ? random.log_between(1e-9, 1e-3) : speed_of(random, kind);
    SectionPoint<double> z = tests::random_point(random, c.scene, leaving, speed_of(random, kind));
    const double spin = spin_of(random, kind);
    z.vn += c.scene.alpha * (spin - z.spin) * std::sin(z.chi);
    z.spin = spin;
    if (kind == two_at_once) {  // a neighbour all but touches as well
        const double chi = random.sign() * tests::largest_chi(c.scene) * (1 - random.log_between(1e-12, 1e-2));
        z.vn += c.scene.alpha * z.spin * (std::sin(chi) - std::sin(z.chi));
        z.chi = chi;
    }
    c.point = z;
    const Real chi = z.chi, psi = z.psi;
    c.flight = {c.scene.sides,
                c.scene.alpha,
                c.scene.beta,
                1 - c.scene.alpha * std::cos(chi),
                -c.scene.alpha * std::sin(chi),
                z.vn,
                z.vt,
                -psi,
                chi,
                z.spin,
                true};
    return c;
}

/// In flight, and aimed: `t` later vertex 0 would be where it grazes (u_n = 0, or close to it), or where it and its
/// neighbour arrive together; laid back in time from there. Nothing if the body would not begin inside.
std::optional<Case> aimed_case(Random& random, Kind kind) {
    Case c;
    c.scene = scene_of(random, kind);
    const double spin = spin_of(random, kind);
    const double chi =
        tests::largest_chi(c.scene) *
        (kind == two_at_once ? random.sign() * (1 - random.log_between(1e-15, 1e-6)) : random.between(-1, 1));
    const double psi = random.angle();
    const double un = kind == grazing ? random.sign() * random.log_between(1e-12, 1e-3) : speed_of(random, kind);
    const double ut = kind == grazing ? random.between(-0.3, 0.3) : random.between(-1, 1) * speed_of(random, kind);
    const double beta = c.scene.beta, alpha = c.scene.alpha;
    const double vn = un + alpha * spin * std::sin(chi) + beta * std::sin(psi);
    const double vt = ut - alpha * spin * std::cos(chi) + beta * std::cos(psi);
    const double depth = kind == grazing ? random.sign() * random.log_between(1e-15, 1e-4) : 0;
    const double back = random.log_between(1e-3, 2);
    // In the axes of that moment the swirl's arm is at −ψ; at the start at −ψ − back, and the laboratory's axes go
    // along it.
    const double x = 1 - depth - alpha * std::cos(chi) + beta * std::cos(psi) - vn * back;
    const double y = -alpha * std::sin(chi) - beta * std::sin(psi) - vt * back;
    const double turn = psi + back;
    const double co = std::cos(turn), si = std::sin(turn);
    c.start = {co * x - si * y, si * x + co * y, co * vn - si * vt, si * vn + co * vt, chi - spin * back + turn, spin};
    c.flight = {c.scene.sides, alpha, beta, Real(c.start.x) - Real(beta), c.start.y, c.start.vx, c.start.vy, 0,
                c.start.angle, spin,  false};
    if (c.flight.gap(0) > -1e-10L) return std::nullopt;
    return c;
}

struct Tally {
    std::array<long, kinds> flights{};
    long aimed = 0, contacts = 0, none = 0, scanned = 0, unresolved = 0, most_steps = 0, simultaneous = 0;
    double worst_outside = 0, worst_early = 0;  ///< in units of what is allowed
    long moments = 0;
};

void check(const Case& c, Kind kind, bool scanning, Tally& tally) {
    with_collision_map(c.scene, [&](const auto& map) {
        const Flight<double> flight =
            c.point ? flight_from(map.body(), post_impact_state(*c.point)) : flight_from(map.body(), c.start);
        const auto contact = first_contact<std::decay_t<decltype(map)>::shape>(map.body(), flight);
        ++tally.flights[kind];
        if (!c.point) ++tally.aimed;
        tally.most_steps = std::max<long>(tally.most_steps, contact.steps);
        if (contact.simultaneous) ++tally.simultaneous;
        const bool found = contact.outcome == FirstContactOutcome::contact;
        const double time = found ? contact.at.time : 30;
        // What a gap may be by rounding of the positions, 10⁻¹² and 8 ε of the ways gone; a gap is twice a depth.
        const Real allowed = 2 * (1e-12L + 8 * eps * (1 + c.flight.speed() * time + std::fabs(c.flight.spin) * time));
        if (contact.outcome == FirstContactOutcome::sustained || contact.outcome == FirstContactOutcome::unresolved) {
            ++tally.unresolved;
            ADD_FAILURE() << "outcome " << static_cast<int>(contact.outcome) << " after " << contact.steps << " steps";
            return;
        }
        if (found) {
            ++tally.contacts;
            const Real gap = c.flight.gap(time);
            EXPECT_LE(gap, allowed) << kind_names[kind] << ": outside at its contact, N = " << c.scene.sides;
            EXPECT_GE(gap, -allowed) << kind_names[kind] << ": not at the wall, N = " << c.scene.sides;
            tally.worst_outside = std::max(tally.worst_outside, static_cast<double>(gap / allowed));
            tally.worst_early = std::max(tally.worst_early, static_cast<double>(-gap / allowed));
        } else {
            ++tally.none;
        }
        if (!scanning) return;
        ++tally.scanned;
        const tests::Scan scan = tests::scan(c.flight, time, allowed);
        tally.moments += scan.moments;
        EXPECT_TRUE(scan.clear) << kind_names[kind] << ": contact missed at t = " << scan.earliest << " before " << time
                                << ", N = " << c.scene.sides << ", alpha " << c.scene.alpha << ", beta " << c.scene.beta
                                << ", S " << c.flight.spin;
    });
}

/// Flights of all kinds, two in five of them aimed where that can be; every `scan_every`-th scanned.
void check_flights(std::uint64_t seed, long count, long scan_every) {
    Random random(seed);
    Tally tally;
    for (long i = 0; i < count && !testing::Test::HasFailure(); ++i) {
        const Kind kind = static_cast<Kind>(random.one_of({0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6}));
        std::optional<Case> c;
        if (random.chance(0.4))
            for (int tries = 0; tries < 20 && !c; ++tries) c = aimed_case(random, kind);
        if (!c) c = struck_case(random, kind);
        check(*c, kind, i % scan_every == 0, tally);
    }
    for (int k = 0; k < kinds; ++k) std::printf("  %-12s %8ld flights\n", kind_names[k], tally.flights[k]);
    std::printf(
        "%ld begin in flight, the others on the wall; %ld contacts, %ld without, %ld simultaneous, most moments "
        "looked at %ld\n",
        tally.aimed, tally.contacts, tally.none, tally.simultaneous, tally.most_steps);
    EXPECT_GE(tally.aimed, count / 5);
    std::printf(
        "%ld flights scanned in long double (%ld moments); at its contact no vertex more outside than %.3f, more "
        "inside than %.3f of what is allowed\n",
        tally.scanned, tally.moments, tally.worst_outside, tally.worst_early);
    EXPECT_EQ(tally.contacts + tally.none, count);
}

TEST(FirstContact, NoneIsMissedOnAHundredThousandFlights) {
    check_flights(1, tests::sample_count(100'000), 10);
}
TEST(FirstContactNightly, NoneIsMissedOnAMillionFlights) {
    check_flights(1, tests::sample_count(1'000'000), 10);
}
TEST(FirstContactNightly, NoneIsMissedOnAMillionScannedFlights) {
    check_flights(2, tests::sample_count(1'000'000), 1);
}

/// Flights of a chaotic hexagon that the direct search leaves; what the further searches find is the first contact.
struct Undecided {
    long all = 0, behind = 0, next = 0;
};

Undecided undecided_flights(long impacts) {
    const Scene<double> scene{6, 0.3, 0.5, 0.5, 1, Law::poisson, uniform_inertia_factor<double>(6)};
    const CollisionMap<double, Shape::polygon, ImpactRule::poisson> map(scene);
    const auto check = [&](const Flight<double>& flight, const FirstContact<double>& found, long& count) {
        if (found.outcome != FirstContactOutcome::contact) return false;
        const auto certain = detail::certain_contact<Shape::polygon>(map.body(), flight);
        EXPECT_EQ(found.vertex, certain.vertex);
        EXPECT_NEAR(found.at.time, certain.at.time, 1e-9 * (1 + certain.at.time));  // some ε/u_n
        ++count;
        return true;
    };
    Undecided flights;
    auto z = map.advance(flight_from(map.body(), LabStart<double>{0.5, 0, 0.1, 0.2, 0.3, 0.1})).after;
    for (long k = 0; k < impacts; ++k) {
        const Flight<double> flight = flight_from(map.body(), z);
        FirstContact<double> direct;
        if (!detail::direct_contact<Shape::polygon>(map.body(), flight, direct)) {
            ++flights.all;
            if (!check(flight, detail::contact_of_vertex_behind(map.body(), flight), flights.behind))
                check(flight, detail::contact_of_next_vertex(map.body(), flight), flights.next);
        }
        z = map.advance(z).after;
    }
    return flights;
}

TEST(FurtherSearches, DecideMostFlightsThatTheDirectOneLeaves) {
    const Undecided flights = undecided_flights(100'000);
    std::printf("%ld of 100,000 flights left: %ld by the vertex behind, %ld by the next one\n", flights.all,
                flights.behind, flights.next);
    EXPECT_GT(flights.all, 1000);
    EXPECT_GT(5 * flights.behind, flights.all);
    EXPECT_GT(3 * flights.next, 2 * (flights.all - flights.behind));
}

/// Of a chaotic disk without friction. Both are good to some ε/(u_n): between them lie 10⁻¹³ at most.
TEST(FurtherSearches, FindTheLongAndCurvedFlightsOfADisk) {
    for (const double beta : {0.5, 0.1}) {
        const Scene<double> scene{disk_sides, 0.3, beta, 0, 1, Law::poisson, 0.5};
        const CollisionMap<double, Shape::disk, ImpactRule::frictionless> map(scene);
        long left = 0, found = 0;
        auto z = map.advance(flight_from(map.body(), LabStart<double>{beta, 0, 0.1, 0.2, 0.3, 0.1})).after;
        for (long k = 0; k < tests::sample_count(20'000); ++k) {
            const Flight<double> flight = flight_from(map.body(), z);
            FirstContact<double> direct;
            if (!detail::direct_contact<Shape::disk>(map.body(), flight, direct)) {
                ++left;
                const auto sampled = detail::sampled_contact_disk(map.body(), flight);
                if (sampled.outcome == FirstContactOutcome::contact) {
                    ++found;
                    const auto certain = detail::certain_contact<Shape::disk>(map.body(), flight);
                    EXPECT_EQ(certain.outcome, FirstContactOutcome::contact);
                    EXPECT_NEAR(sampled.at.time, certain.at.time, 1e-12 * (1 + certain.at.time));
                }
            }
            z = map.advance(flight).after;
        }
        std::printf("beta %.1f: of %ld flights the direct search leaves %ld, of which samples lead to %ld\n", beta,
                    tests::sample_count(20'000), left, found);
        EXPECT_GT(left, 10);
        EXPECT_GT(found, left * 3 / 4);
    }
}

/// From anywhere on the wall with any velocity, also where the disk grazes the wall between two samples: what is found
/// is the first contact, and nothing where the proof does not hold.
TEST(FurtherSearches, FindNothingButADisksFirstContact) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    long found = 0, not_found = 0;
    for (long k = 0; k < tests::sample_count(50'000); ++k) {
        const double alpha = 0.05 + 0.9 * uniform(random), beta = uniform(random), psi = 6.283 * uniform(random);
        const Scene<double> scene{disk_sides, alpha, beta, 0, 1, Law::poisson, 0.5};
        const CollisionMap<double, Shape::disk, ImpactRule::frictionless> map(scene);
        PostImpactState<double> z;
        z.psi = {std::cos(psi), std::sin(psi)};
        z.chi = {1, 0};
        z.vn = beta * std::sin(psi) - 0.5 * uniform(random);  // from the moving wall
        z.vt = 2 * uniform(random) - 1;
        z.spin = 0;
        const Flight<double> flight = flight_from(map.body(), z);
        const auto sampled = detail::sampled_contact_disk(map.body(), flight);
        const auto certain = detail::certain_contact<Shape::disk>(map.body(), flight);
        if (sampled.outcome != FirstContactOutcome::contact) {
            ++not_found;
            continue;
        }
        ++found;
        ASSERT_EQ(certain.outcome, FirstContactOutcome::contact) << k;
        ASSERT_NEAR(sampled.at.time, certain.at.time, 1e-7 * (1 + certain.at.time)) << k;  // ε/u_n of grazing ones
    }
    std::printf("samples lead to the contact of %ld flights of %ld\n", found, found + not_found);
    EXPECT_GT(found, 4 * not_found);  // the others are longer than eight radians, or graze the wall
    EXPECT_GT(not_found, 0);
}

/// The scan itself must be able to fail: it finds an excursion through the wall however short.
TEST(ContainerScan, SeesAShortExcursion) {
    // A disk at rest in the laboratory, β = 0.2: the wall comes nearest at t = π, to 10⁻⁹ beyond the disk.
    const Real beta = 0.2L, alpha = 0.5L;
    const Real x = 1 - alpha - 2 * beta + 1e-9L;
    const ScannedFlight flight{disk_sides, alpha, beta, x, 0, 0, 0, 0, 0, 0, false};
    const tests::Scan seen = tests::scan(flight, 6, 1e-12L);
    EXPECT_FALSE(seen.clear);
    EXPECT_NEAR(static_cast<double>(seen.earliest), M_PI, 1e-3);
    EXPECT_TRUE(tests::scan(flight, 6, 2e-9L).clear);
}

}  // namespace
}  // namespace swirl
