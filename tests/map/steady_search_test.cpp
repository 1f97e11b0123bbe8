// steady_modes: the references found, all of them and no other; the theorems on where there is none; the options.
#include "map/steady/steady_modes.hpp"
#include "tests/references/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace swirl {
namespace {

using nlohmann::json;
using Complex = std::complex<double>;

Scene<double> lamina(int sides, double alpha, double beta, double mu, double e, Law law = Law::poisson) {
    return {sides, alpha, beta, mu, e, law, uniform_inertia_factor<double>(sides)};
}

double distance(const SectionPoint<double>& a, const SectionPoint<double>& b) {
    return std::max({std::fabs(wrapped_angle(a.psi - b.psi)), std::fabs(a.chi - b.chi), std::fabs(a.vn - b.vn),
                     std::fabs(a.vt - b.vt), std::fabs(a.spin - b.spin)});
}

/// Each listed multiplier, by falling modulus, against the nearest one left; relative above 1.
double multiplier_error(std::vector<Complex> left, const json& listed) {
    double worst = left.size() == listed.size() ? 0 : HUGE_VAL;
    for (const json& m : listed) {
        if (left.empty()) return HUGE_VAL;
        const Complex wanted(m[0].get<double>(), m[1].get<double>());
        const auto nearest = std::min_element(left.begin(), left.end(), [&](const Complex& a, const Complex& b) {
            return std::abs(a - wanted) < std::abs(b - wanted);
        });
        worst = std::max(worst, std::abs(*nearest - wanted) / std::max(1.0, std::abs(wanted)));
        left.erase(nearest);
    }
    return worst;
}

/// The mode with this branch, j and τ.
bool is_stable(const SteadyMode& mode) {
    return std::abs(mode.multipliers.front()) < 1;
}

const SteadyMode* find(const SteadyModes& modes, int branch, long long j, double tau) {
    for (const SteadyMode& mode : modes.modes)
        if (static_cast<int>(mode.branch) == branch && mode.j == j && std::fabs(mode.tau - tau) < 1e-9) return &mode;
    return nullptr;
}

/// A mode against an entry of a reference file. (τ, χ) solve two equations of condition 10 at most in both files, so
/// the point is known to some ten ε; multipliers amplify the rounding of the point by ‖DF‖ where the impact is soft.
void expect_same(const SteadyMode& mode, const json& entry) {
    const double error = distance(mode.point, tests::point_from<double>(entry["point"]));
    const double multipliers = multiplier_error(mode.multipliers, entry["multipliers"]);
    EXPECT_LE(error, 1e-14);  // measured: 1.3e-15
    EXPECT_NEAR(mode.tau, tests::number<double>(entry["return_time"]), 1e-14 * std::max(1.0, mode.tau));
    EXPECT_LE(multipliers, 1e-13 * std::max(1e3, mode.amplification));
    EXPECT_EQ(is_stable(mode), entry["stable"].get<bool>());
    std::printf("%+d j %3lld tau %11.8f  point %.1e  multipliers %.1e\n", static_cast<int>(mode.branch), mode.j,
                mode.tau, error, multipliers);
}

TEST(SteadySearch, FindsAll31FixedPointsOfTheHexagonAndNoOther) {
    const json reference = tests::read_reference("fixed_points.json");
    const json& entries = reference["cycles"];
    const SteadyModes result = steady_modes(tests::scene_from<double>(entries[0]), {});
    EXPECT_EQ(result.complete_to, 12);
    EXPECT_EQ(result.modes.size(), 31u);
    ASSERT_EQ(entries.size(), 31u);
    for (const json& entry : entries) {
        const double tau = tests::number<double>(entry["return_time"]);
        const SteadyMode* mode = find(result, entry["branch"], entry["j"], tau);
        ASSERT_NE(mode, nullptr) << "tau = " << tau;
        expect_same(*mode, entry);
    }
}

TEST(SteadySearch, FindsTheElasticPolygonsWithTheirMultipliers) {
    const json reference = tests::read_reference("steady_e1.json");
    int count = 0;
    for (const json& entry : reference["cycles"]) {
        const SteadyModes result = steady_modes(tests::scene_from<double>(entry));
        const SteadyMode* mode = find(result, 1, entry["j"], tests::number<double>(entry["return_time"]));
        ASSERT_NE(mode, nullptr) << count;
        EXPECT_EQ(mode->chi, 0);
        expect_same(*mode, entry);
        ++count;
    }
    EXPECT_EQ(count, 10);
}

TEST(SteadySearch, TheHexagonWithoutLossHasOnePublishedStableMode) {
    const SteadyModes result = steady_modes(lamina(6, 0.4, 0.5, 0.5, 1));
    const auto stable = std::find_if(result.modes.begin(), result.modes.end(), is_stable);
    ASSERT_NE(stable, result.modes.end());
    EXPECT_EQ(stable->j, 2);
    EXPECT_NEAR(stable->tau, 1.02515, 5e-6);
    EXPECT_NEAR(stable->point.spin, -1.04301, 5e-6);
    const double moduli[] = {0.9585, 0.9585, 0.6633, 0.6633, 0};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(std::abs(stable->multipliers[i]), moduli[i], 5e-5);
}

TEST(SteadySearch, ThereIsNoneOnALossyDiskNorWithoutFriction) {
    for (const double e : {0.0, 0.5, 0.999}) {
        for (const double mu : {0.0, 0.3}) {
            const SteadyModes disk = steady_modes(lamina(disk_sides, 0.3, 0.1, mu, e));
            EXPECT_EQ(disk.set, mu > 0 ? SteadySet::none_lossy_disk : SteadySet::none_frictionless);
            EXPECT_TRUE(disk.modes.empty() && disk.families.empty());
        }
        const SteadyModes polygon = steady_modes(lamina(5, 0.3, 0.4, 0, e));
        EXPECT_EQ(polygon.set, SteadySet::none_frictionless);
        EXPECT_TRUE(polygon.modes.empty() && polygon.families.empty());
        // A container at rest takes energy with every impact: the curves are empty, not left out.
        EXPECT_TRUE(steady_modes(lamina(5, 0.3, 0, 0.4, e)).modes.empty());
    }
}

/// As e → 1 the modes tend to those with χ = 0, as 1 − e: χ ≈ Q(1 − e)/(1 + e).
TEST(SteadySearch, TheElasticLimitIsContinuous) {
    for (const Law law : {Law::poisson, Law::newton, Law::stronge}) {
        const SteadyModes limit = steady_modes(lamina(6, 0.4, 0.5, 0.5, 1, law), {.longest_flight = 6});
        for (const double loss : {1e-4, 1e-8, 1e-12}) {
            const SteadyModes near = steady_modes(lamina(6, 0.4, 0.5, 0.5, 1 - loss, law), {.longest_flight = 6});
            ASSERT_EQ(near.modes.size(), limit.modes.size());
            for (std::size_t i = 0; i < near.modes.size(); ++i) {
                const SteadyMode &a = near.modes[i], &b = limit.modes[i];
                EXPECT_EQ(a.j, b.j);
                EXPECT_NEAR(a.tau, b.tau, 10 * loss + 1e-14);
                EXPECT_NEAR(a.chi, 0.5 * loss * b.speed, loss * loss + 1e-3 * loss);
            }
        }
    }
}

/// In contacts that slip throughout all laws agree, to the last bit; where slip stops they do not.
TEST(SteadySearch, EachLawHasItsOwnModes) {
    const auto with = [](Law law, double mu) { return steady_modes(lamina(4, 0.4, 0.5, mu, 0.3, law)); };
    const auto first_of = [&](Law law) { return with(law, 0.6).modes.front(); };
    const SteadyMode poisson = first_of(Law::poisson), newton = first_of(Law::newton), stronge = first_of(Law::stronge);
    EXPECT_GT(distance(poisson.point, newton.point), 1e-4);
    EXPECT_GT(distance(poisson.point, stronge.point), 1e-4);
    EXPECT_GT(distance(newton.point, stronge.point), 1e-4);

    const auto sliding_of = [&](Law law) {
        std::vector<SteadyMode> sliding = with(law, 0.05).modes;
        sliding.erase(std::remove_if(sliding.begin(), sliding.end(),
                                     [](const SteadyMode& m) { return m.contact != ContactMode::sliding; }),
                      sliding.end());
        return sliding;
    };
    const auto a = sliding_of(Law::poisson), b = sliding_of(Law::newton), c = sliding_of(Law::stronge);
    ASSERT_FALSE(a.empty());
    ASSERT_TRUE(a.size() == b.size() && b.size() == c.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(distance(a[i].point, b[i].point), 0);
        EXPECT_EQ(distance(a[i].point, c[i].point), 0);
        EXPECT_DOUBLE_EQ(std::fabs(std::tan(a[i].chi)), 0.05);
    }
}

/// Without loss there are more than those with χ = 0: Newton's law asks Q sin χ = 1, for which the swirl must be wide.
TEST(SteadySearch, AWideSwirlHasElasticModesWithAnAngle) {
    const SteadyModes result = steady_modes(lamina(4, 0.4, 4.7, 1, 1, Law::newton));
    const auto oblique = std::count_if(result.modes.begin(), result.modes.end(), [](const SteadyMode& m) {
        if (m.chi == 0 || m.contact == ContactMode::sliding) return false;
        const double half_impulse =
            (std::cos(m.chi) - 0.4 +
             static_cast<int>(m.branch) * std::sqrt(4.7 * 4.7 - std::sin(m.chi) * std::sin(m.chi))) *
            (1 - std::cos(m.tau)) / m.tau;
        EXPECT_NEAR(half_impulse * std::sin(m.chi), 1, 1e-12);
        return true;
    });
    EXPECT_GE(oblique, 1);
}

TEST(SteadySearch, SaysWhenItWasCutShort) {
    EXPECT_LT(steady_modes(lamina(6, 0.4, 0.5, 0, 1), {.longest_flight = 3, .most_steps = 2}).complete_to, 3);
    EXPECT_EQ(steady_modes(lamina(6, 0.4, 0.5, 0.5, 1)).complete_to, 12);
}

TEST(SteadySearch, WhatIsCutShortIsCompleteUpToATime) {
    const Scene<double> scene = lamina(6, 0.4, 0.5, 0.5, 0.9);
    const SteadyModes all = steady_modes(scene);
    for (const std::size_t most : {10u, 20u, 40u}) {
        const SteadyModes cut = steady_modes(scene, {.most = most});
        ASSERT_LT(cut.complete_to, 12) << most;
        EXPECT_LE(cut.candidates, most);
        const auto within = [&](const SteadyMode& mode) { return mode.tau <= cut.complete_to; };
        const auto listed = std::count_if(all.modes.begin(), all.modes.end(), within);
        EXPECT_EQ(static_cast<long>(cut.modes.size()), listed) << most;
        EXPECT_EQ(std::count_if(cut.modes.begin(), cut.modes.end(), within), listed) << most;
    }
}

TEST(SteadySearch, RefusesWhatIsOutOfRange) {
    const Scene<double> scene = lamina(6, 0.4, 0.5, 0.5, 0.9);
    EXPECT_THROW(steady_modes(scene, {.longest_flight = 0}), std::invalid_argument);
    EXPECT_THROW(steady_modes(scene, {.longest_flight = NAN}), std::invalid_argument);
    EXPECT_THROW(steady_modes(scene, {.fastest_spin = 0.5}), std::invalid_argument);
    EXPECT_THROW(steady_modes(lamina(6, 0.4, 0.5, -1, 0.9)), std::invalid_argument);
}

}  // namespace
}  // namespace swirl
