// Chords and diameters of elastic polygons, against the map itself driven along them, and against values that were
// found by long orbits and by another computation of the response.
#include "map/chords/chords.hpp"
#include "map/chords/chord_fate.hpp"
#include "map/chords/chord_response.hpp"
#include "map/collision_map.hpp"
#include "map/derivative/multipliers.hpp"
#include "map/derivative/saltation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace swirl {
namespace {

Scene<double> elastic(int sides, double alpha, double beta = 0.1, Law law = Law::poisson) {
    return {sides, alpha, beta, 0.5, 1, law, uniform_inertia_factor<double>(sides)};
}

/// The chord of that angle's sign, of j = N/2.
Chord opposite(const Scene<double>& scene, int sign) {
    for (const Chord& c : chords_of(scene).chords)
        if (2 * c.vertex_step == scene.sides && sign * c.angle >= 0 && (c.angle == 0) == (sign == 0)) return c;
    ADD_FAILURE() << "no such chord";
    return {};
}

SectionPoint<double> on_chord(const Scene<double>& scene, const Chord& c, double v, const ChordDeviation& amplitude,
                              double theta) {
    const std::complex<double> turn = std::polar(scene.beta, theta);
    const auto moved = [&](int k) { return std::real(amplitude[k] * turn); };
    SectionPoint<double> z;
    z.psi = -theta + moved(0);
    z.chi = moved(1);
    z.vn = -v * std::cos(c.angle) + moved(2) + scene.beta * std::sin(z.psi);
    z.vt = v * std::sin(c.angle) + moved(3) + scene.beta * std::cos(z.psi);
    z.spin = -v * std::sin(c.angle) / scene.alpha + moved(4);
    return z;
}

/// In the container's frame.
double energy_of(const Scene<double>& scene, const PostImpactState<double>& z) {
    const double wn = z.vn - scene.beta * z.psi.y, wt = z.vt - scene.beta * z.psi.x;
    return 0.5 * (wn * wn + wt * wt + scene.inertia_factor * scene.alpha * scene.alpha * z.spin * z.spin);
}

/// ΔE an impact over β², from orbits of the map that start at all phases of the swirl.
double measured_gain(const Scene<double>& scene, const Chord& chord, double v, int impacts) {
    constexpr int phases = 32;
    const ChordDeviation amplitude = chord_response(scene, chord, v).amplitude;
    double sum = 0;
    for (int i = 0; i < phases; ++i) {
        const double theta = 2 * pi<double>() * i / phases;
        const auto start = post_impact_state(on_chord(scene, chord, v, amplitude, theta));
        auto z = start;
        with_collision_map(scene, [&](const auto& map) {
            for (int n = 0; n < impacts; ++n) z = map.advance(z).after;
        });
        sum += energy_of(scene, z) - energy_of(scene, start);
    }
    return sum / (phases * impacts * scene.beta * scene.beta);
}

TEST(Chords, AreRootsThatTheMapRunsThrough) {
    for (const int sides : {3, 4, 5, 6, 8, 12})
        for (const double alpha : {0.2, 0.35, 0.44, 0.5, 0.56, 0.7, 0.9}) {
            const Scene<double> scene = elastic(sides, alpha);
            const Chords all = chords_of(scene);
            EXPECT_TRUE(all.complete);
            Scene<double> still = scene;
            still.beta = 0;
            const CollisionMap<double, Shape::polygon, ImpactRule::poisson> map(still);
            for (const Chord& c : all.chords) {
                const double excess = pi<double>() - 2 * c.angle + (1 - alpha) / alpha * std::sin(2 * c.angle) -
                                      2 * pi<double>() * c.vertex_step / sides;
                EXPECT_NEAR(std::remainder(excess, 2 * pi<double>()), 0, 1e-13);
                const double v = 3;
                const auto z = post_impact_state(SectionPoint<double>{
                    0, 0, -v * std::cos(c.angle), v * std::sin(c.angle), -v * std::sin(c.angle) / alpha});
                const auto next = map.advance(z);
                EXPECT_EQ(next.vertex_step, c.vertex_step);
                EXPECT_NEAR(next.flight_time, c.length / v, 1e-13);
                EXPECT_NEAR(next.after.vn, z.vn, 1e-12);
                EXPECT_NEAR(next.after.vt, z.vt, 1e-12);
                EXPECT_NEAR(next.after.spin * next.flight_time, c.turn, 1e-12);
            }
            const auto mirrored = std::count_if(all.chords.begin(), all.chords.end(), [&](const Chord& c) {
                return std::any_of(all.chords.begin(), all.chords.end(), [&](const Chord& d) {
                    return std::abs(c.angle + d.angle) < 1e-12 && (c.vertex_step + d.vertex_step) % sides == 0;
                });
            });
            EXPECT_EQ(static_cast<std::size_t>(mirrored), all.chords.size());
            const bool diameter =
                std::any_of(all.chords.begin(), all.chords.end(), [](const Chord& c) { return c.is_diameter(); });
            EXPECT_EQ(diameter, sides % 2 == 0);
        }
}

TEST(Chords, DiskAndFrictionlessPolygonHaveNone) {
    EXPECT_TRUE(chords_of(elastic(disk_sides, 0.3)).chords.empty());
    Scene<double> smooth = elastic(6, 0.3);
    smooth.mu = 0;
    EXPECT_TRUE(chords_of(smooth).chords.empty());
}

/// The 4 × 4 part of (χ, w_n, w_t, S) is DF of the map at β = 0, where V = w.
TEST(Chords, DerivativeIsThatOfTheMap) {
    for (const int sides : {3, 5, 6, 8})
        for (const double alpha : {0.3, 0.44, 0.6})
            for (const Chord& c : chords_of(elastic(sides, alpha)).chords) {
                const double v = 2;
                const CollisionMap<double, Shape::polygon, ImpactRule::poisson> map(elastic(sides, alpha, 0));
                const auto z = SectionPoint<double>{0, 0, -v * std::cos(c.angle), v * std::sin(c.angle),
                                                    -v * std::sin(c.angle) / alpha};
                const auto known = linearise_by_saltation(map, z);
                // On the chord u_t = 0 to rounding: sticking is the mode on either side of it.
                ASSERT_TRUE(ends_in_stick(known.collision.impulse.mode));
                const auto by_hand = chord_derivative(elastic(sides, alpha), c, v);
                EXPECT_LT((by_hand - known.derivative).cwiseAbs().maxCoeff(),
                          1e-11 * (1 + by_hand.cwiseAbs().maxCoeff()));
                auto expected = multipliers_of(by_hand);
                for (const auto& m : c.multipliers) {
                    const double off = (expected.array() - m).abs().minCoeff();
                    EXPECT_LT(off, 1e-6);  // a double eigenvalue 1 is known to √ε
                }
            }
}

TEST(Chords, DiameterAttractsAboveHalf) {
    for (const int sides : {4, 6, 8, 12}) {
        const Chord c = opposite(elastic(sides, 0.5), 0);
        EXPECT_NEAR(std::max(std::abs(c.multipliers[0]), std::abs(c.multipliers[1])), 1, 1e-7);
        EXPECT_TRUE(opposite(elastic(sides, 0.501), 0).attracts());
        EXPECT_FALSE(opposite(elastic(sides, 0.499), 0).attracts());
    }
}

TEST(Chords, MultipliersOfTheHexagonAndThePentagon) {
    EXPECT_NEAR(std::abs(opposite(elastic(6, 0.44), 1).multipliers[0]), 0.364, 5e-4);
    double largest = 0;
    for (const Chord& c : chords_of(elastic(5, 0.45)).chords)
        if (c.vertex_step == 2) largest = std::max(largest, std::abs(c.multipliers[0]));
    EXPECT_NEAR(largest, 3.02, 5e-3);
}

/// K is the limit of v⁴ G(v) as v → ∞; its correction is of order v⁻².
TEST(Chords, DiametersGainIsTheClosedForm) {
    for (const Law law : {Law::poisson, Law::newton, Law::stronge})
        for (const int sides : {4, 6, 8, 30})
            for (const double alpha : {0.52, 0.56, 0.7, 0.9}) {
                const Scene<double> scene = elastic(sides, alpha, 0.1, law);
                const Chord c = opposite(scene, 0);
                const auto scaled = [&](double v) { return std::pow(v, 4) * chord_response(scene, c, v).gain(); };
                const double limit = (4 * scaled(80) - scaled(40)) / 3;  // Richardson's, of an even series
                EXPECT_NEAR(limit / diameter_growth(scene), 1, 3e-6) << sides << ' ' << alpha << ' ' << name_of(law);
            }
}

TEST(Chords, DiametersRateOfTheHexagon) {
    EXPECT_NEAR(std::cbrt(0.75 * diameter_growth(elastic(6, 0.56))), 0.44702, 5e-6);
}

TEST(Chords, LimitsOfTheHexagon) {
    const struct {
        double alpha, a, v, spin;
    } expected[] = {{0.42, 0.6731, 18.73, -27.81},
                    {0.44, 0.5868, 8.304, -10.451},
                    {0.46, 0.4825, 5.905, -5.956},
                    {0.48, 0.3437, 5.551, -3.897}};
    for (const auto& row : expected) {
        const Scene<double> scene = elastic(6, row.alpha);
        const Chord against = opposite(scene, 1), with = opposite(scene, -1);
        EXPECT_NEAR(against.angle, row.a, 5e-5);
        const ChordSpeeds speeds = chord_speeds(scene, against);
        EXPECT_EQ(speeds.fate, ChordFate::limit);
        EXPECT_NEAR(speeds.limit, row.v, 5e-3);
        EXPECT_NEAR(speeds.limit_spin, row.spin, 5e-3);
        EXPECT_LT(chord_speeds(scene, with).limit, 1.1);  // a slow one
    }
    EXPECT_EQ(chord_speeds(elastic(6, 0.56), opposite(elastic(6, 0.56), 0)).fate, ChordFate::accelerates);
}

/// Fast ones are fed against the swirl alone; with it only such as are slow (v* < 1.5).
TEST(Chords, OnlyThoseAgainstTheSwirlAreFedWhenFast) {
    int against = 0, with = 0, fast = 0;
    for (int sides = 3; sides <= 12; ++sides)
        for (double alpha = 0.205; alpha < 0.9; alpha += 0.03) {
            const Scene<double> scene = elastic(sides, alpha);
            for (const Chord& c : chords_of(scene).chords) {
                if (!c.attracts() || c.is_diameter()) continue;
                const ChordSpeeds speeds = chord_speeds(scene, c);
                (c.angle > 0 ? against : with) += 1;
                EXPECT_EQ(speeds.fate, ChordFate::limit);
                if (speeds.limit < 1.5) continue;
                ++fast;
                EXPECT_GT(c.angle, 0) << sides << ' ' << alpha << ' ' << speeds.limit;
            }
        }
    EXPECT_GT(fast, 10);
    EXPECT_EQ(against, with);
}

/// The map itself, with a swirl, at every phase: corrections are of relative order β².
TEST(Chords, GainIsThatOfTheDrivenMap) {
    const double beta = 0.004;
    for (const Law law : {Law::poisson, Law::newton, Law::stronge}) {
        const Scene<double> diameter = elastic(6, 0.56, beta, law);
        const Scene<double> winding = elastic(6, 0.44, beta, law), square = elastic(4, 0.46, beta, law);
        const Scene<double> slow = elastic(6, 0.44, beta / 8, law);  // near the resonance deviations are large
        const struct {
            Scene<double> scene;
            Chord chord;
            double v;
        } cases[] = {{diameter, opposite(diameter, 0), 3}, {winding, opposite(winding, 1), 4},
                     {winding, opposite(winding, -1), 4},  {winding, opposite(winding, 1), 12},
                     {slow, opposite(slow, -1), 0.5},      {square, opposite(square, 1), 3},
                     {square, opposite(square, -1), 3}};
        for (const auto& c : cases) {
            const double expected = chord_response(c.scene, c.chord, c.v).gain();
            EXPECT_NEAR(measured_gain(c.scene, c.chord, c.v, 100) / expected, 1, 2e-2)
                << name_of(law) << ' ' << c.chord.angle << ' ' << c.v;
        }
    }
}

TEST(Chords, BalanceWithALittleLoss) {
    const double expected[] = {1.1419, 2.4600, 5.3000};
    for (int k = 0; k < 3; ++k) {
        Scene<double> scene = elastic(6, 0.56);
        scene.restitution = 1 - std::pow(10, -4 - k);
        const double closed = 0.5 * std::cbrt(2 * diameter_growth(scene) * 0.01 / (1 - std::pow(scene.restitution, 2)));
        EXPECT_NEAR(closed, expected[k], 6e-5);
        const double v = *balanced_speed(scene, opposite(scene, 0));
        EXPECT_NEAR(0.5 * v * v / closed, 1, 0.03 / (v * v));  // G v⁴/K − 1 = 0.06/v²
    }
    EXPECT_FALSE(balanced_speed(elastic(6, 0.56), opposite(elastic(6, 0.56), 0)));
}

}  // namespace
}  // namespace swirl
