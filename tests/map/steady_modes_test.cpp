// The steady modes at e = 1 in closed form (map/README.md, "Steady modes"): ψ = χ = 0, v_n = −(2R/τ) sin²(τ/2), v_t = R
// sin τ/τ, with friction S = (β − v_t)/α, R = β + 1 − α.
#include "map/derivative/saltation.hpp"

#include <gtest/gtest.h>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace swirl {
namespace {

constexpr double two_pi = 6.283185307179586477;

Scene<double> elastic_scene(int sides, double alpha, double beta, double mu, Law law = Law::poisson) {
    return {sides, alpha, beta, mu, 1.0, law, uniform_inertia_factor<double>(sides)};
}

SectionPoint<double> steady_point(const Scene<double>& s, double time, double spin) {
    const double r = s.beta + 1 - s.alpha;
    const double half = std::sin(time / 2);
    return {0, 0, -2 * r / time * half * half, r * std::sin(time) / time, spin};
}

/// How far outside the body comes on its way, sampled; independent of the search for contacts. The ends are left out,
/// where it is 0 by construction; a mode is taken as admissible below −10⁻⁹, so that rounding decides nowhere.
double farthest_outside(const Scene<double>& s, const SectionPoint<double>& z, double time) {
    const int samples = 400 + static_cast<int>(100 * std::fabs(z.spin) * time);
    double worst = -1;
    for (int i = 1; i < samples; ++i) {
        const double t = time * i / samples;
        const double x = 1 - s.alpha + z.vn * t - s.beta * (std::cos(t) - 1);
        const double y = z.vt * t - s.beta * std::sin(t);
        if (s.is_disk()) {
            worst = std::max(worst, std::hypot(x, y) - (1 - s.alpha));
            continue;
        }
        for (int k = 0; k < s.sides; ++k) {
            const double a = z.spin * t + two_pi * k / s.sides;
            worst = std::max(worst, std::hypot(x + s.alpha * std::cos(a), y + s.alpha * std::sin(a)) - 1);
        }
    }
    return worst;
}

struct Tally {
    long tested = 0;
    double worst = 0;  ///< |F(z) − z|
};

/// `time` is where the contact is expected.
void expect_fixed(const Scene<double>& scene, const SectionPoint<double>& z, double time, Tally& tally) {
    with_collision_map(scene, [&](const auto& map) {
        const auto step = map.advance(post_impact_state(z));
        ASSERT_EQ(step.outcome, FirstContactOutcome::contact);
        const SectionPoint<double> next = section_point(step.after);
        const double error = std::max({std::fabs(next.psi), std::fabs(next.chi), std::fabs(next.vn - z.vn),
                                       std::fabs(next.vt - z.vt), std::fabs(next.spin - z.spin)});
        // A rounding of the state is multiplied by DF; below 10³ this is the 10⁻¹² of a well-conditioned point.
        const double norm = linearise_by_saltation(map, z).derivative.norm();
        EXPECT_LE(error, 1e-15 * std::max(1e3, norm));
        EXPECT_NEAR(step.flight_time, time, 1e-15 * std::max(1e3, norm));
        ++tally.tested;
        tally.worst = std::max(tally.worst, error);
    });
}

void report(const char* what, const Tally& tally, long inadmissible) {
    std::printf("%s: %ld steady modes (%ld not admissible), largest |F(z) - z| %.1e\n", what, tally.tested,
                inadmissible, tally.worst);
}

TEST(SteadyModes, EveryAdmissibleFlightTimeIsOneForTheDisk) {
    Tally tally;
    long inadmissible = 0;
    for (const double alpha : {0.1, 0.3, 0.5, 0.7, 0.9})
        for (const double beta : {0.01, 0.05, 0.1, 0.3, 0.5, 1.0, 2.0, 5.0})
            for (int i = 1; i <= 40; ++i)
                for (const double mu : {0.0, 0.1, 1.5}) {
                    const double time = 0.15 * i;
                    const Scene<double> scene = elastic_scene(disk_sides, alpha, beta, mu);
                    SectionPoint<double> z = steady_point(scene, time, 0.7);
                    if (mu > 0) z.spin = (beta - z.vt) / alpha;
                    if (farthest_outside(scene, z, time) > -1e-9) {
                        ++inadmissible;
                        continue;
                    }
                    expect_fixed(scene, z, time, tally);
                }
    report("disk", tally, inadmissible);
    EXPECT_GE(tally.tested, 1000);
}

/// Roots in τ of α(τ − 2πj/N) − βτ + R sin τ = 0: the spin that friction asks for brings vertex j.
std::vector<double> flight_times(const Scene<double>& s, int j, double longest) {
    const double r = s.beta + 1 - s.alpha;
    const auto f = [&](double t) { return s.alpha * (t - two_pi * j / s.sides) - s.beta * t + r * std::sin(t); };
    std::vector<double> roots;
    constexpr int pieces = 500;
    for (int i = 1; i < pieces; ++i) {
        const double low = longest * i / pieces, high = longest * (i + 1) / pieces;
        if (f(low) * f(high) >= 0) continue;
        std::uintmax_t iterations = 100;
        const auto bracket = boost::math::tools::toms748_solve(
            f, low, high, [](double a, double b) { return std::fabs(b - a) <= 4e-16 * std::fabs(a); }, iterations);
        roots.push_back((bracket.first + bracket.second) / 2);
    }
    return roots;
}

TEST(SteadyModes, PolygonsHaveThemWhereTheNextVertexArrives) {
    Tally tally;
    long inadmissible = 0;
    for (const int sides : {3, 4, 5, 6, 7, 9, 12})
        for (const double alpha : {0.15, 0.3, 0.45, 0.6, 0.75, 0.9})
            for (const double beta : {0.05, 0.1, 0.3, 0.6, 1.2, 3.0})
                for (int j = -2 * sides; j <= 2 * sides; ++j) {
                    const Scene<double> scene = elastic_scene(sides, alpha, beta, 0.4, static_cast<Law>((j & 7) % 3));
                    for (const double time : flight_times(scene, j, 6.2)) {
                        const SectionPoint<double> z = steady_point(scene, time, 1 - two_pi * j / (sides * time));
                        if (farthest_outside(scene, z, time) > -1e-9) {
                            ++inadmissible;
                            continue;
                        }
                        expect_fixed(scene, z, time, tally);
                    }
                }
    report("polygons with friction", tally, inadmissible);
    EXPECT_GE(tally.tested, 500);
}

/// Without friction the spin is free: every τ is a steady mode with S = 1 − 2πj/(Nτ).
TEST(SteadyModes, PolygonsWithoutFrictionHaveOneForEveryFlightTime) {
    Tally tally;
    long inadmissible = 0;
    for (const int sides : {3, 4, 6, 12})
        for (const double alpha : {0.2, 0.5, 0.8})
            for (const double beta : {0.1, 0.5, 2.0})
                for (int j = -3; j <= 3; ++j)
                    for (int i = 1; i <= 20; ++i) {
                        const double time = 0.3 * i;
                        const Scene<double> scene = elastic_scene(sides, alpha, beta, 0);
                        const SectionPoint<double> z = steady_point(scene, time, 1 - two_pi * j / (sides * time));
                        if (farthest_outside(scene, z, time) > -1e-9) {
                            ++inadmissible;
                            continue;
                        }
                        expect_fixed(scene, z, time, tally);
                    }
    report("polygons without friction", tally, inadmissible);
    EXPECT_GE(tally.tested, 200);
}

}  // namespace
}  // namespace swirl
