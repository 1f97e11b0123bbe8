// Every flight that the search in double calls proven, proven again in interval arithmetic; and what it cannot decide.
#include "tests/map/certainty/contact_check.hpp"
#include "tests/map/certainty/sampled_flights.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace swirl::tests {
namespace {

struct Tally {
    std::array<std::array<long, seen_kinds>, flight_kinds> seen{};
    std::array<long, flight_kinds> without{};  ///< no contact is claimed, or nothing
    long claimed = 0, direct = 0, direct_grazes = 0, unresolved = 0, flagged = 0, swapped_unflagged = 0, pieces = 0;
    std::array<std::array<long, 16>, flight_kinds> by_distance{};  ///< by decades of their distance to the border
    double latest = 0, deepest = 0, closest_decided = 1;
};

void describe(const char* what, const SampledFlight& sample, const Claim& claim, const Check& check) {
    const Flight<double>& f = sample.flight;
    std::printf(
        "%s: %s, N %d, alpha %.17g, beta %.17g, centre %.17g,%.17g, velocity %.17g,%.17g, phase %.17g,%.17g, arm "
        "%.17g,%.17g, spin %.17g: claims vertex %d at %.17g (%s%s); vertex %d, gap %.3g at %.17g, apart %.3g\n",
        what, name_of(sample.kind), sample.scene.sides, sample.scene.alpha, sample.scene.beta, f.centre.x, f.centre.y,
        f.velocity.x, f.velocity.y, f.phase.x, f.phase.y, f.arm.x, f.arm.y, f.spin, claim.contact.vertex,
        claim.contact.at.time, claim.direct ? "direct" : "by safe steps",
        claim.contact.simultaneous ? ", simultaneous" : "", check.vertex, check.depth, check.where, check.apart);
}

/// How long a flight is followed for which no contact is claimed.
constexpr double long_enough = 10;

void check_one(const SampledFlight& sample, Tally& tally) {
    const Claim claim = claim_of(sample.scene, sample.flight);
    const auto outcome = claim.contact.outcome;
    const std::size_t kind = static_cast<std::size_t>(sample.kind);
    if (outcome == FirstContactOutcome::unresolved || outcome == FirstContactOutcome::sustained) {
        ++tally.unresolved;  // nothing is claimed, and the outcome says so
        return;
    }
    const bool none = outcome == FirstContactOutcome::no_contact;
    const Check check = none ? check_none(sample.scene, sample.flight, long_enough)
                             : check_contact(sample.scene, sample.flight, claim.contact);
    ++tally.claimed;
    tally.direct += claim.direct;
    tally.flagged += claim.contact.simultaneous;
    tally.without[kind] += none;
    tally.pieces += check.pieces;
    ++tally.seen[kind][static_cast<std::size_t>(check.seen)];
    tally.latest = std::max(tally.latest, check.late);
    if (sample.width > 0) {
        const double decade = std::clamp(-std::log10(sample.width), 0.0, 15.9);
        ++tally.by_distance[kind][static_cast<std::size_t>(decade)];
    }
    if (check.seen == Seen::tie && !claim.contact.simultaneous)
        tally.closest_decided = std::min(tally.closest_decided, check.apart);
    if (check.seen == Seen::graze) {
        tally.deepest = std::max(tally.deepest, check.depth);
        tally.direct_grazes += claim.direct;
    }
    if (check.seen == Seen::swapped && !claim.contact.simultaneous) {
        ++tally.swapped_unflagged;
        describe("the later of two, not flagged", sample, claim, check);
    }
    if (check.seen == Seen::refuted || check.seen == Seen::undecided)
        describe(name_of(check.seen), sample, claim, check);
}

void print(const Tally& tally) {
    std::printf("%-10s", "");
    for (int s = 0; s < seen_kinds; ++s) std::printf(" %9s", name_of(static_cast<Seen>(s)));
    std::printf("  (of these without contact)\n");
    for (std::size_t k = 0; k < flight_kinds; ++k) {
        std::printf("%-10s", name_of(static_cast<FlightKind>(k)));
        for (const long n : tally.seen[k]) std::printf(" %9ld", n);
        std::printf("  %ld\n", tally.without[k]);
    }
    for (const FlightKind kind : {FlightKind::graze, FlightKind::tie}) {
        std::printf("%s by its distance to the border, 1e0 ... 1e-16:", name_of(kind));
        for (const long n : tally.by_distance[static_cast<std::size_t>(kind)]) std::printf(" %ld", n);
        std::printf("\n");
    }
    std::printf(
        "%ld claims, %ld of them by the direct proof; %ld flagged as simultaneous; nothing claimed of %ld\n"
        "contacts at most %.2f epsilon (way/g' + time) late or early; grazes passed at most %.2g deep, %ld of them by "
        "the direct proof\nthe closest order decided without a flag %.2g; %ld pieces of time\n"
        "0 of %ld refuted: fewer than %.2g of such flights, with 95 %% confidence\n",
        tally.claimed, tally.direct, tally.flagged, tally.unresolved, tally.latest, tally.deepest, tally.direct_grazes,
        tally.closest_decided, tally.pieces, tally.claimed, 3.0 / static_cast<double>(tally.claimed));
}

long count_of(const Tally& tally, Seen seen) {
    long count = 0;
    for (const auto& row : tally.seen) count += row[static_cast<std::size_t>(seen)];
    return count;
}

Tally check_flights(std::uint64_t seed, long count) {
    Random random(seed);
    Tally tally;
    while (tally.claimed + tally.unresolved < count)
        for (const auto& sample : next_flights(random)) check_one(sample, tally);
    print(tally);
    EXPECT_EQ(count_of(tally, Seen::refuted), 0);
    EXPECT_EQ(count_of(tally, Seen::undecided), 0);
    EXPECT_EQ(tally.swapped_unflagged, 0);
    EXPECT_GT(tally.claimed, 0.99 * static_cast<double>(count)) << "too much is left unresolved";
    return tally;
}

TEST(Certainty, WhatDoubleProvesIsProvenInBallsOnAThousandFlights) {
    check_flights(13, sample_count(1000));
}
TEST(CertaintyNightly, WhatDoubleProvesIsProvenInBallsOnAHundredThousandFlights) {
    const Tally tally = check_flights(14, sample_count(100'000));
    for (const FlightKind kind : {FlightKind::graze, FlightKind::tie})
        for (std::size_t decade = 1; decade < 16; ++decade)
            EXPECT_GT(tally.by_distance[static_cast<std::size_t>(kind)][decade], 0)
                << name_of(kind) << " at a distance of 1e-" << decade;
}

/// The claim of another flight's contact, at that vertex' own root on this one.
FirstContact<double> claim_instead(const SampledFlight& sample, FirstContact<double> contact) {
    const FlightInBalls flight(sample.scene, sample.flight);
    for (int i = 0; i < 8; ++i) {
        const auto gap = flight.gap(flight.at(Ball(contact.at.time)), contact.vertex);
        contact.at.time -= intervals::middle(gap.value) / intervals::middle(gap.rate);
    }
    return contact;
}

/// Of two flights beside a border the claim of the later contact for the one that ends earlier.
Check check_of_later_contact(const std::vector<SampledFlight>& pair) {
    const auto first = claim_of(pair[0].scene, pair[0].flight).contact;
    const auto second = claim_of(pair[1].scene, pair[1].flight).contact;
    const bool first_is_earlier = first.at.time < second.at.time;
    const SampledFlight& earlier = pair[first_is_earlier ? 0 : 1];
    return check_contact(earlier.scene, earlier.flight, claim_instead(earlier, first_is_earlier ? second : first));
}

// The check must be able to fail: on the side where a vertex grazes the contact after it is refuted, down to depths of
// some 10⁻¹⁰ (far above rounding, far below what is seen by sampling).
TEST(Certainty, AContactThatIsNotTheFirstIsRefuted) {
    Random random(5);
    long passed = 0, refuted = 0;
    double shallowest = 1;
    while (passed < sample_count(40)) {
        const auto pair = next_border(random);
        if (pair[0].kind != FlightKind::graze || pair[0].width < 1e-9) continue;
        const Check check = check_of_later_contact(pair);
        ++passed;
        if (check.seen == Seen::refuted) {
            ++refuted;
            if (check.depth > 0) shallowest = std::min(shallowest, check.depth);
        }
    }
    std::printf("%ld of %ld contacts behind a graze refuted, the shallowest seen at a gap of %.2g\n", refuted, passed,
                shallowest);
    EXPECT_EQ(refuted, passed);
}

TEST(Certainty, AContactAtAnotherTimeIsRefuted) {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const SampledFlight sample = next_flights(random).front();
        auto contact = claim_of(sample.scene, sample.flight).contact;
        if (sample.kind != FlightKind::orbit || contact.outcome != FirstContactOutcome::contact) continue;
        if (contact.at.time < 0.01) continue;  // where 10⁻⁶ of it is within rounding
        const double time = contact.at.time;
        for (const double factor : {1 - 1e-6, 1 + 1e-6}) {
            contact.at.time = time * factor;
            EXPECT_EQ(check_contact(sample.scene, sample.flight, contact).seen, Seen::refuted) << i << ", " << factor;
        }
    }
}

}  // namespace
}  // namespace swirl::tests
