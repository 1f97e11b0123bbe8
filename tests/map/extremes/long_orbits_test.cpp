// One orbit of very many impacts: J walks as rounding does, nothing leaves the container, and the swirl's phase keeps
// its digits.
#include "map/orbit/laboratory.hpp"
#include "map/orbit/maps_in_quad.hpp"
#include "tests/map/container_scan.hpp"
#include "tests/sample_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace swirl {
namespace {

using tests::Real;

/// True if something is outside on the flight from z until its contact, scanned in long double.
bool leaves_the_container(const Scene<double>& scene, const PostImpactState<double>& z, double time) {
    const Real alpha = scene.alpha, chi = std::atan2(Real(z.chi.y), Real(z.chi.x));
    const Real psi = std::atan2(Real(z.psi.y), Real(z.psi.x));
    const tests::ScannedFlight flight{
        scene.sides, alpha,  scene.beta, 1 - alpha * std::cos(chi), -alpha * std::sin(chi), z.vn, z.vt, -psi,
        chi,         z.spin, true};
    // A state is known to a few ε of its terms, its speeds below 4: 10⁻¹⁴ of a gap is far above that.
    return !tests::scan(flight, time, 1e-14L).clear;
}

struct LongOrbit {
    long impacts = 0, scanned = 0, outside = 0;
    double drift = 0, rms_step = 0;
    Real phase = 0;       ///< the largest difference of the two ways to the contact's direction, in radians
    double time_off = 0;  ///< of the swirl's phase from the sum of the flight times in 113 bits, the largest
};

/// How far a phase is from that of a time, in radians.
double off_by(const Quad& time, double phase) {
    const Quad turn = 2 * pi<Quad>();
    const Quad apart = Quad(phase) - time;
    return std::fabs(static_cast<double>(apart - turn * round(apart / turn)));
}

/// Without friction and with e = 1. The direction of the contact is followed in two ways: as the sum of the wall's
/// advances, and as the swirl's phase (the sum of the flight times) + ψ.
template <class Map>
LongOrbit follow(const Map& map, const SectionPoint<double>& start, long impacts) {
    LongOrbit orbit;
    auto frame = LabFrame<double>::at_section(start);
    WoundAngle<double> direction;
    direction.add(start.psi);
    Collision<double> step;
    step.after = post_impact_state(start);
    const double first = jacobi_of(map.body(), step.after);
    double before = first, square = 0;
    Quad time = 0;
    for (; orbit.impacts < impacts; ++orbit.impacts) {
        const PostImpactState<double> z = step.after;
        map.advance(z, step);
        if (step.outcome != FirstContactOutcome::contact) break;
        const double now = jacobi_of(map.body(), step.after);
        square += (now - before) * (now - before);
        before = now;
        frame.time.add(step.flight_time);
        time += Quad(step.flight_time);
        direction.add(std::atan2(step.normal.y, step.normal.x));
        if (orbit.impacts % 10'000 != 0) continue;
        ++orbit.scanned;
        orbit.outside += leaves_the_container(map.scene(), z, step.flight_time);
        const double apart = frame.time.phase + section_point(step.after).psi - direction.phase;
        orbit.phase = std::max(orbit.phase, std::fabs(wrapped_angle(Real(apart))));
        orbit.time_off = std::max(orbit.time_off, off_by(time, frame.time.phase));
    }
    orbit.drift = before - first;
    orbit.rms_step = std::sqrt(square / static_cast<double>(impacts));
    return orbit;
}

void check(int sides, long impacts) {
    const Scene<double> scene{
        sides, 0.41239847562913, 0.53129847561, 0, 1, Law::poisson, uniform_inertia_factor<double>(sides)};
    const SectionPoint<double> start{0.3, 0, -0.9, 0.4, 0.2};
    const LongOrbit orbit = with_collision_map(scene, [&](const auto& map) { return follow(map, start, impacts); });
    const double n = static_cast<double>(impacts), eps = epsilon<double>();
    std::printf(
        "%d sides (0: disk), %ld impacts: J drifts by %.3g, %.2f of a walk of its steps (%.2f epsilon each); "
        "%ld flights scanned, %ld outside; time's phase off by %.3g from the sum in 113 bits, by %.3g from the "
        "contact's "
        "direction at most, %.2f epsilon sqrt(n)\n",
        sides, orbit.impacts, orbit.drift, orbit.drift / (orbit.rms_step * std::sqrt(n)), orbit.rms_step / eps,
        orbit.scanned, orbit.outside, orbit.time_off, static_cast<double>(orbit.phase),
        static_cast<double>(orbit.phase) / (eps * std::sqrt(n)));
    EXPECT_EQ(orbit.impacts, impacts);
    EXPECT_EQ(orbit.outside, 0);
    // As in jacobi_test.cpp: six times a random walk, and a bias of ε/40 an impact.
    EXPECT_LE(std::fabs(orbit.drift), 6 * orbit.rms_step * std::sqrt(n) + n * eps / 40);
    EXPECT_LE(orbit.time_off, 4 * eps);  // one rounding of a number below 8
    // ψ's own rounding, and that of the wall's advances, each of an angle below π: a walk, and a bias.
    EXPECT_LE(orbit.phase, 6 * 4 * eps * std::sqrt(n) + n * eps / 40);
}

TEST(LongOrbits, KeepTheirInvariantAndTheirPhase) {
    check(disk_sides, tests::sample_count(10'000'000));
    check(3, tests::sample_count(1'000'000));
}
TEST(LongOrbitsNightly, AThousandMillionImpacts) {
    check(disk_sides, tests::sample_count(1'000'000'000));
    check(3, tests::sample_count(100'000'000));
}

}  // namespace
}  // namespace swirl
