// The closed forms of the impact against integration in p, the change of energy, and when B₂ − sμB₃ can be negative.
#include "map/model/impact.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/impulse_integration.hpp"
#include "tests/map/random_scenes.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace swirl {
namespace {

using tests::IntegratedImpulse;
using tests::Random;
using tests::sample_count;

constexpr int mode_count = 6;

struct Sample {
    ContactKinematics<double> approach;
    double mu, restitution;
};

/// A contact of a random polygon; one in twenty begins without slip.
Sample random_sample(Random& random) {
    const Scene<double> scene =
        tests::random_scene(random, random.one_of({3, 3, 4, 4, 5, 6, 8, 12}), 0, 1, Law::poisson);
    const double chi = tests::largest_chi(scene) * random.between(-1, 1);
    Sample s;
    s.mu = random.log_between(0.01, 10);
    s.restitution = random.chance(0.1) ? 1 : random.chance(0.1) ? 0 : random.unit();
    s.approach = {random.log_between(1e-3, 5), random.sign() * random.log_between(1e-4, 5), scene.alpha * std::cos(chi),
                  scene.alpha * std::sin(chi), scene.inertia_factor * scene.alpha * scene.alpha};
    if (random.chance(0.05)) s.approach.ut = 0;
    return s;
}

ContactMode mode_of(const IntegratedImpulse& r, double ut) {
    const bool kink = r.kinks > 0 || ut == 0;
    const bool early = r.kinks == 0 || r.kink_in_compression;
    if (!kink) return ContactMode::sliding;
    if (r.sticks) return early ? ContactMode::c_sticking : ContactMode::r_sticking;
    return early ? ContactMode::c_reversed : ContactMode::r_reversed;
}

struct Tally {
    std::array<long, mode_count> count{};
    std::array<double, mode_count> worst{};
    long negative_slope = 0;   ///< B₂ − sμB₃ < 0
    double largest_gain = -1;  ///< of energy, relative to that of the approach
};

/// The kinetic energy of the contact, ½ u·B⁻¹u with u = (C, u_t) and B = (B₂ B₃; B₃ B₁): the scale for gains.
double energy_of(const ContactKinematics<double>& a) {
    const double determinant = a.b1() * a.b2() - a.b3() * a.b3();
    const double c = -a.un;
    return 0.5 * (a.b1() * c * c - 2 * a.b3() * c * a.ut + a.b2() * a.ut * a.ut) / determinant;
}

template <ImpactRule rule>
void compare(const Sample& s, Law law, long wanted, Tally& tally) {
    const ContactKinematics<double>& a = s.approach;
    const Impulse<double> closed = impulse<rule>(a, s.mu, s.restitution);
    const auto mode = static_cast<std::size_t>(closed.mode);
    if (tally.count[mode] >= wanted) return;
    const IntegratedImpulse reference = tests::integrate_impulse(a, s.mu, s.restitution, law);
    const auto expected = a.ut == 0 && reference.kinks == 0 && std::fabs(a.b3()) > s.mu * a.b1() ? ContactMode::sliding
                          : a.ut == 0 ? ContactMode::c_sticking
                                      : mode_of(reference, a.ut);
    const double scale = static_cast<double>(std::hypot(reference.p, reference.q));
    const double error =
        static_cast<double>(std::hypot(closed.normal - reference.p, closed.tangential - reference.q)) / scale;
    // p's relative error is that of the slopes B₂ − sμB₃ …, which cancel: by how much says the sum of their sizes.
    const double slope = a.b2() - (a.ut > 0 ? s.mu : -s.mu) * a.b3();
    const double after = closed.mode == ContactMode::sliding ? slope
                         : reference.sticks || a.ut == 0     ? a.b2() - a.b3() * a.b3() / a.b1()
                                                             : a.b2() + s.mu * std::fabs(a.b3());
    const double size = a.b2() + (s.mu + std::fabs(a.b3() / a.b1())) * std::fabs(a.b3());
    const double condition = (1 + s.mu) * size / after;
    if (slope < 0) ++tally.negative_slope;
    const double border = 64 * 0x1p-52 * condition * std::max(1.0, size / std::fabs(slope));
    EXPECT_LE(error, border) << name_of(closed.mode) << " mu " << s.mu << " e " << s.restitution << " un " << a.un
                             << " ut " << a.ut << " rn " << a.rn << " rt " << a.rt << " I " << a.inertia;
    EXPECT_EQ(name_of(closed.mode), name_of(expected))
        << " mu " << s.mu << " e " << s.restitution << " un " << a.un << " ut " << a.ut;
    ++tally.count[mode];
    tally.worst[mode] = std::max(tally.worst[mode], error);

    const double p = closed.normal, q = closed.tangential;
    const double work = p * (-a.un + 0.5 * (a.b2() * p + a.b3() * q)) + q * (a.ut + 0.5 * (a.b3() * p + a.b1() * q));
    const double energy = energy_of(a);
    tally.largest_gain = std::max(tally.largest_gain, work / energy);
    EXPECT_NEAR(work, static_cast<double>(reference.normal_work + reference.tangential_work),
                border * (p * p * a.b2() + q * q * a.b1() + p * a.un + std::fabs(q * a.ut)));
}

template <ImpactRule rule>
Tally compare_all(Law law, long full) {
    const long wanted = sample_count(full);
    Random random(91 + static_cast<unsigned>(law));
    Tally tally;
    const auto done = [&] {
        for (int mode = 1; mode < mode_count; ++mode)
            if (tally.count[mode] < wanted) return false;
        return true;
    };
    for (long i = 0; i < 400 * wanted && !done() && !testing::Test::HasFailure(); ++i)
        compare<rule>(random_sample(random), law, wanted, tally);
    for (int mode = 1; mode < mode_count; ++mode) {
        std::printf("%-8s %-11s %ld contacts, largest relative difference %.1e\n", std::string(name_of(law)).c_str(),
                    std::string(name_of(static_cast<ContactMode>(mode))).c_str(), tally.count[mode], tally.worst[mode]);
        EXPECT_EQ(tally.count[mode], wanted) << name_of(static_cast<ContactMode>(mode));
    }
    std::printf("%-8s %ld contacts with B2 - s mu B3 < 0; largest gain of energy %.3g of what the contact has\n",
                std::string(name_of(law)).c_str(), tally.negative_slope, tally.largest_gain);
    EXPECT_GE(tally.negative_slope, wanted / 100);
    return tally;
}

/// Contacts of each mode that are compared with the integral of Routh's equations.
constexpr long few = 25'000, many = 100'000;

TEST(Impact, PoissonIsTheIntegralAndCreatesNoEnergy) {
    EXPECT_LE(compare_all<ImpactRule::poisson>(Law::poisson, few).largest_gain, 1e-13);
}

TEST(Impact, StrongeIsTheIntegralAndCreatesNoEnergy) {
    EXPECT_LE(compare_all<ImpactRule::stronge>(Law::stronge, few).largest_gain, 1e-13);
}

/// Newton's law is known to create energy with friction; the test requires that it does, and prints by how much.
TEST(Impact, NewtonIsTheIntegralAndCanCreateEnergy) {
    EXPECT_GT(compare_all<ImpactRule::newton>(Law::newton, few).largest_gain, 0);
}

TEST(ImpactNightly, EveryLawIsTheIntegralOnFourTimesAsMany) {
    EXPECT_LE(compare_all<ImpactRule::poisson>(Law::poisson, many).largest_gain, 1e-13);
    EXPECT_LE(compare_all<ImpactRule::stronge>(Law::stronge, many).largest_gain, 1e-13);
    EXPECT_GT(compare_all<ImpactRule::newton>(Law::newton, many).largest_gain, 0);
}

TEST(Impact, AllLawsAgreeInSlidingForTheDiskAndWithoutFriction) {
    Random random(17);
    const long count = sample_count(100'000);
    long sliding = 0;
    for (long i = 0; i < count; ++i) {
        Sample s = random_sample(random);
        const auto p = impulse<ImpactRule::poisson>(s.approach, s.mu, s.restitution);
        const auto n = impulse<ImpactRule::newton>(s.approach, s.mu, s.restitution);
        const auto t = impulse<ImpactRule::stronge>(s.approach, s.mu, s.restitution);
        if (p.mode == ContactMode::sliding && n.mode == p.mode && t.mode == p.mode) {
            ++sliding;
            EXPECT_NEAR(n.normal, p.normal, 1e-14 * p.normal);
            EXPECT_NEAR(t.normal, p.normal, 1e-14 * p.normal);
        }
        s.approach.rt = 0;  // a disk
        const auto disk = impulse<ImpactRule::poisson>(s.approach, s.mu, s.restitution);
        for (const auto& other : {impulse<ImpactRule::newton>(s.approach, s.mu, s.restitution),
                                  impulse<ImpactRule::stronge>(s.approach, s.mu, s.restitution)}) {
            EXPECT_NEAR(other.normal, disk.normal, 1e-14 * disk.normal);
            EXPECT_NEAR(other.tangential, disk.tangential, 1e-14 * disk.normal * (1 + s.mu));
        }
        EXPECT_NEAR(disk.normal, (1 + s.restitution) * s.approach.un, 1e-14 * disk.normal);
        // The frictionless rule is the limit μ = 0.
        const auto smooth = impulse<ImpactRule::frictionless>(s.approach, 0.0, s.restitution);
        EXPECT_NEAR(smooth.normal, (1 + s.restitution) * s.approach.un / s.approach.b2(), 1e-14 * smooth.normal);
        EXPECT_EQ(smooth.tangential, 0);
    }
    std::printf("%ld contacts, %ld of them sliding under every law\n", count, sliding);
    EXPECT_GE(sliding, count / 5);
}

/// μ ≥ κ/T + (1 + κ)T, T = min(√(κ/(1 + κ)), tan χ_m): from there B₂ − sμB₃ < 0 is possible (map/README.md, "Impact").
double threshold(const Scene<double>& scene) {
    const double kappa = scene.inertia_factor;
    const double t = std::min(std::sqrt(kappa / (1 + kappa)), std::tan(tests::largest_chi(scene)));
    return kappa / t + (1 + kappa) * t;
}

// A vertex that grazes is found at the wall with a u_n that may be negative by rounding. The wall can't pull.
TEST(Impact, WhatRecedesGetsNoImpulse) {
    Random random(17);
    long none = 0;
    const auto check = [&](const Impulse<double>& j, bool negative_slope) {
        EXPECT_GE(j.normal, 0);
        EXPECT_TRUE(std::isfinite(j.tangential));
        if (negative_slope) return;  // without a unique force: the impulse that stops the slip
        EXPECT_EQ(j.normal, 0);
        EXPECT_EQ(j.tangential, 0);
        ++none;
    };
    for (long i = 0; i < sample_count(20'000); ++i) {
        Sample s = random_sample(random);
        s.approach.un = -random.log_between(1e-17, 1e-6);
        const double sign = s.approach.ut > 0 ? 1 : -1;
        const bool negative = s.approach.b2() - sign * s.mu * s.approach.b3() <= 0;
        check(impulse<ImpactRule::frictionless>(s.approach, 0.0, s.restitution), false);
        check(impulse<ImpactRule::poisson>(s.approach, s.mu, s.restitution), negative);
        check(impulse<ImpactRule::newton>(s.approach, s.mu, s.restitution), negative);
        check(impulse<ImpactRule::stronge>(s.approach, s.mu, s.restitution), negative);
        check(disk_impulse(s.approach.un, s.approach.ut, 1 / s.approach.b1(), s.mu, s.restitution), false);
    }
    EXPECT_GT(none, sample_count(20'000));
}

template <ImpactRule rule>
double error_against_quad(const Sample& s) {
    const ContactKinematics<double>& a = s.approach;
    const ContactKinematics<Quad> wide{a.un, a.ut, a.rn, a.rt, a.inertia};
    const Impulse<double> j = impulse<rule>(a, s.mu, s.restitution);
    const Impulse<Quad> exact = impulse<rule>(wide, Quad(s.mu), Quad(s.restitution));
    const double normal = static_cast<double>(exact.normal), tangential = static_cast<double>(exact.tangential);
    EXPECT_GE(j.normal, 0);
    EXPECT_EQ(name_of(j.mode), name_of(exact.mode));
    return std::hypot(j.normal - normal, j.tangential - tangential) / std::hypot(normal, tangential) / 0x1p-52;
}

// dC/dp while sticking is a sum, (1 + r²/I)/B₁: as a difference, B₂ − B₃²/B₁, it was rounding for κ below 10⁻¹⁶, and
// impulses came out negative. Friction that holds with a tenth to spare: μB₁ − |B₃| and what it divides
// lose a factor of 11 each.
TEST(Impact, HoldsForEveryMomentOfInertia) {
    Random random(19);
    double worst = 0;
    for (long i = 0; i < sample_count(20'000); ++i) {
        Sample s = random_sample(random);
        ContactKinematics<double>& a = s.approach;
        a.inertia = random.log_between(1e-100, 10) * (a.rn * a.rn + a.rt * a.rt);
        a.inverse_inertia = 1 / a.inertia;
        s.mu = std::max(s.mu, 1.1 * std::abs(a.b3() / a.b1()));
        worst = std::max({worst, error_against_quad<ImpactRule::poisson>(s), error_against_quad<ImpactRule::newton>(s),
                          error_against_quad<ImpactRule::stronge>(s)});
    }
    std::printf("impulse against 113 bits, kappa down to 1e-100: at most %.1f epsilon\n", worst);
    EXPECT_LE(worst, 400);
}

TEST(Impact, FirstSlopeTurnsNegativeAtTheThresholdOfFriction) {
    const auto scene_of = [](int sides, double alpha) {
        return Scene<double>{sides, alpha, 0.1, 0, 1, Law::poisson, uniform_inertia_factor<double>(sides)};
    };
    EXPECT_NEAR(threshold(scene_of(3, 0.4)), 1.118, 5e-4);  // map/README.md, "Impact"
    EXPECT_NEAR(threshold(scene_of(6, 0.4)), 1.721, 5e-4);
    for (const int sides : {3, 4, 5, 6, 7, 12, 100})
        for (const double alpha : {0.1, 0.4, 0.8}) {
            const Scene<double> scene = scene_of(sides, alpha);
            const double mu = threshold(scene), widest = tests::largest_chi(scene);
            double below = HUGE_VAL, above = HUGE_VAL;
            for (int i = 0; i <= 20000; ++i) {
                const double chi = widest * i / 20000;
                const ContactKinematics<double> a{1, 1, alpha * std::cos(chi), alpha * std::sin(chi),
                                                  scene.inertia_factor * alpha * alpha};
                below = std::min(below, a.b2() - mu * (1 - 1e-6) * a.b3());
                above = std::min(above, a.b2() - mu * (1 + 1e-6) * a.b3());
            }
            EXPECT_GT(below, 0) << sides << ' ' << alpha;
            EXPECT_LT(above, 0) << sides << ' ' << alpha;
        }
}

/// Where the first slope is negative slip stops before compression ends, so that every impulse is finite.
TEST(Impact, ANegativeFirstSlopeAlwaysMeansAKinkInCompression) {
    Random random(23);
    long count = 0;
    const long samples = sample_count(1'000'000);
    for (long i = 0; i < samples; ++i) {
        const Sample s = random_sample(random);
        const double slope = s.approach.b2() - (s.approach.ut > 0 ? s.mu : -s.mu) * s.approach.b3();
        if (slope >= 0 || s.approach.ut == 0) continue;
        ++count;
        const auto j = impulse<ImpactRule::stronge>(s.approach, s.mu, s.restitution);
        EXPECT_TRUE(j.mode == ContactMode::c_sticking || j.mode == ContactMode::c_reversed) << name_of(j.mode);
        EXPECT_TRUE(std::isfinite(j.normal) && j.normal > 0);
    }
    std::printf("%ld contacts with a negative first slope\n", count);
    EXPECT_GE(count, samples / 1000);
}

}  // namespace
}  // namespace swirl
