// Cycles proven by interval arithmetic: the references are, what is false is not, and certificates hold by other
// equations.
#include "map/proof/all_fixed_points.hpp"
#include "tests/map/proof_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::tests {
namespace {

using proof::CycleClaim;
using proof::CycleProof;
using proof::prove_cycle;
using proof::Verdict;

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The reference's digits lie in the box, and its multipliers in the discs.
void expect_holds(const CycleProof& proof, const nlohmann::json& reference) {
    const auto z = point_from<long double>(reference["point"]);
    const auto& at = proof.points.front();
    const auto& r = proof.radii.front();
    const long double away[]{z.psi - at.psi, z.chi - at.chi, z.vn - at.vn, z.vt - at.vt, z.spin - at.spin};
    for (int i = 0; i < 5; ++i) EXPECT_LE(std::abs(away[i]), r[i]) << i;
    for (const auto& m : reference["multipliers"]) {
        bool inside = false;
        for (const auto& disc : proof.multipliers) {
            // The references' multipliers are exact to their last double digit; exact zeros are some 10⁻²⁰ there.
            const double away_from = std::hypot(m[0].get<double>() - disc.re, m[1].get<double>() - disc.im);
            inside = inside || away_from <= disc.radius + 1e-15 * std::hypot(disc.re, disc.im) + 1e-18;
        }
        EXPECT_TRUE(inside) << m << reference["point"];
    }
}

TEST(Proof, EveryCycleOfTheReferencesIsProvenAndItsCertificateHolds) {
    for (const char* file : {"cycles.json", "steady_e1.json", "fixed_points.json"}) {
        std::size_t proven = 0, cases = 0;
        double longest = 0, checking = 0;
        for (const ProofCase& c : proof_cases(file)) {
            ++cases;
            auto begin = std::chrono::steady_clock::now();
            const CycleProof proof = prove_cycle(c.scene, c.claim);
            longest = std::max(longest, seconds_since(begin));
            EXPECT_TRUE(proof.proven()) << file << ' ' << cases << ": " << proof.reason;
            if (!proof.proven()) continue;
            ++proven;
            expect_holds(proof, c.reference);
            begin = std::chrono::steady_clock::now();
            EXPECT_EQ(proof_check::what_fails(stated(c.scene, proof)), "") << file << ' ' << cases;
            checking = std::max(checking, seconds_since(begin));
        }
        std::printf("%s: %zu of %zu proven, %.1f ms at most, checked in %.1f ms at most\n", file, proven, cases,
                    1e3 * longest, 1e3 * checking);
        EXPECT_GE(cases, 10U);
    }
}

TEST(Proof, StabilityIsThatOfTheMultipliers) {
    EXPECT_EQ(prove_cycle(hexagon(), proof_cases("fixed_points.json")[1].claim).stability,
              proof::ProvenStability::attracting);
    EXPECT_EQ(prove_cycle(hexagon(), proof_cases("fixed_points.json")[0].claim).stability,
              proof::ProvenStability::saddle);
}

/// Claims that are false, made of a true one.
std::vector<CycleClaim> false_claims(const Scene<double>& scene, const CycleClaim& claim) {
    std::vector<CycleClaim> claims;
    CycleClaim twice = claim;
    twice.points.insert(twice.points.end(), claim.points.begin(), claim.points.end());
    twice.times.insert(twice.times.end(), claim.times.begin(), claim.times.end());
    twice.itinerary.insert(twice.itinerary.end(), claim.itinerary.begin(), claim.itinerary.end());
    claims.push_back(twice);
    for (const double by : {1e-6, -1e-6}) {
        CycleClaim moved = claim;
        moved.points.back().psi += by;
        claims.push_back(moved);
        moved = claim;
        moved.points.front().spin += by;
        claims.push_back(moved);
        moved = claim;
        moved.times.front() += by;
        claims.push_back(moved);
    }
    for (const ContactMode mode : {ContactMode::sliding, ContactMode::c_sticking, ContactMode::r_sticking,
                                   ContactMode::c_reversed, ContactMode::r_reversed}) {
        CycleClaim other = claim;
        if (other.itinerary.front().mode == mode) continue;
        other.itinerary.front().mode = mode;
        claims.push_back(other);
    }
    for (int step = 1; step < 3 && !scene.is_disk(); ++step) {
        CycleClaim other = claim;
        other.itinerary.front().vertex_step = (other.itinerary.front().vertex_step + step) % scene.sides;
        claims.push_back(other);
    }
    return claims;
}

TEST(Proof, FalseClaimsAreRefused) {
    int refused = 0;
    for (const char* file : {"cycles.json", "fixed_points.json"}) {
        const auto cases = proof_cases(file);
        for (std::size_t i = 0; i < cases.size(); i += 4)
            for (const CycleClaim& claim : false_claims(cases[i].scene, cases[i].claim)) {
                const CycleProof proof = prove_cycle(cases[i].scene, claim);
                EXPECT_FALSE(proof.proven()) << file << ' ' << i;
                EXPECT_FALSE(proof.reason.empty());
                ++refused;
            }
    }
    std::printf("%d false claims refused\n", refused);
}

TEST(Proof, AVertexOutsideInBetweenIsSeen) {
    const auto all = proof::all_fixed_points(hexagon(), 12, [] { return false; });
    ASSERT_GE(all.refuted.size(), 10U);
    for (const CycleProof& ghost : all.refuted) {
        const CycleProof again = prove_cycle(hexagon(), {ghost.points, ghost.times, ghost.itinerary});
        EXPECT_EQ(again.verdict, Verdict::refuted);
        EXPECT_NE(again.reason.find("is outside at t ="), std::string::npos) << again.reason;
    }
    // Where the map itself finds the next contact, another vertex strikes first.
    for (const CycleProof& ghost : all.refuted) {
        const CycleClaim real = claim_at(hexagon(), ghost.points.front(), 1);
        EXPECT_LT(real.times.front(), ghost.times.front() - 1e-6);
    }
}

TEST(Proof, AllFixedPointsOfTheHexagonAreThirtyOne) {
    const auto begin = std::chrono::steady_clock::now();
    const auto all = proof::all_fixed_points(hexagon(), 12, [] { return false; });
    std::printf("%zu fixed points, %zu refuted, %zu cells, %.2f s\n", all.proven.size(), all.refuted.size(), all.cells,
                seconds_since(begin));
    EXPECT_TRUE(all.complete());
    ASSERT_EQ(all.proven.size(), 31U);
    const double outer[]{0.43506898, 1.05816754, 1.80819457, 2.41102760, 2.80934543, 3.16879717};
    const int steps[]{1, 2, 2, 1, 0, 5};  // j = 1, 2, 2, 1, 0, −1
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(all.proven[i].times.front(), outer[i], 5e-9);  // as many digits as are given
        EXPECT_EQ(all.proven[i].itinerary.front().vertex_step, steps[i]);
    }
    for (std::size_t i = 6; i < 31; ++i)
        EXPECT_EQ(all.proven[i].itinerary.front().vertex_step, static_cast<int>(i - 5) % 6);  // j = 1 … 25
    for (const CycleProof& proof : all.proven) EXPECT_EQ(proof_check::what_fails(stated(hexagon(), proof)), "");
}

TEST(Proof, MembersOfFamiliesAreProvenWithTheirPhase) {
    // The fixed points in closed form: ψ = χ = 0, R = β + 1 − α.
    const auto member = [](int sides, double alpha, double beta, double mu, double tau, double spin) {
        const Scene<double> scene{sides, alpha, beta, mu, 1.0, Law::poisson, uniform_inertia_factor<double>(sides)};
        const double r = beta + 1 - alpha, half = std::sin(tau / 2);
        const double vt = r * std::sin(tau) / tau;
        const SectionPoint<double> z{0, 0, -2 * r / tau * half * half, vt, mu > 0 ? (beta - vt) / alpha : spin};
        CycleProof proof = prove_cycle(scene, claim_at(scene, z, 1));
        EXPECT_TRUE(proof.phase.has_value());
        if (proof.proven()) {
            EXPECT_EQ(proof_check::what_fails(stated(scene, proof)), "") << sides << ' ' << mu;
        }
        return proof;
    };
    const CycleProof rolls = member(disk_sides, 0.3, 0.1, 0.5, 2.5, 0);
    EXPECT_TRUE(rolls.proven()) << rolls.reason;
    int ones = 0;
    for (const auto& disc : rolls.multipliers) ones += std::hypot(disc.re - 1, disc.im) <= disc.radius ? 1 : 0;
    EXPECT_GE(ones, 1);
    // Without friction the multiplier 1 is double, and the check tells the two no better than the proof does.
    for (const CycleProof& proof :
         {member(disk_sides, 0.3, 0.1, 0.0, 2.5, 0.7), member(6, 0.4, 0.5, 0.0, 1.2, 1 - 2 * pi<double>() / (6 * 1.2)),
          member(6, 0.4, 0.5, 0.0, 1.2, 1.0)}) {
        EXPECT_FALSE(proof.proven());
        EXPECT_NE(proof.reason.find("frictionless"), std::string::npos) << proof.reason;
    }
}

TEST(Proof, EveryEditOfACertificateThatMakesItFalseIsRefused) {
    const auto cases = proof_cases("cycles.json");
    int refused = 0;
    for (const std::size_t i : {0U, 5U, 8U}) {
        const CycleProof proof = prove_cycle(cases[i].scene, cases[i].claim);
        ASSERT_TRUE(proof.proven());
        const auto refuse = [&](const char* what, auto edit) {
            auto cycle = stated(cases[i].scene, proof);
            edit(cycle);
            std::string why;
            try {
                why = proof_check::what_fails(cycle);
            } catch (const std::invalid_argument& error) {
                why = error.what();
            }
            EXPECT_NE(why, "") << what << " of cycle " << i;
            ++refused;
        };
        refuse("alpha", [](auto& c) { c.alpha += 1e-5; });
        refuse("beta", [](auto& c) { c.beta -= 1e-5; });
        refuse("restitution", [](auto& c) { c.restitution += 1e-4; });
        refuse("inertia", [](auto& c) { c.inertia_factor *= 1.0001; });
        refuse("sides", [](auto& c) { c.sides += 1; });
        refuse("law", [](auto& c) { c.law = "hertz"; });
        refuse("vertex", [](auto& c) { c.steps[0].vertex_step = (c.steps[0].vertex_step + 1) % c.sides; });
        refuse("mode", [](auto& c) { c.steps[0].contact_mode = "sliding"; });
        refuse("mode's name", [](auto& c) { c.steps[0].contact_mode = "c-stocking"; });
        refuse("slip", [](auto& c) { c.steps[0].slip = -c.steps[0].slip; });
        refuse("no slip", [](auto& c) { c.steps[0].slip = 2; });
        refuse("psi", [](auto& c) { c.steps[0].point[0] += 1e-6; });
        refuse("S", [](auto& c) { c.steps.back().point[4] -= 1e-6; });
        refuse("flight time", [](auto& c) { c.steps[0].time += 1e-6; });
        refuse("half-width", [](auto& c) { c.steps[0].radius[0] = 1e-30; });
        refuse("half-width 0", [](auto& c) { c.steps[0].radius[2] = 0; });
        refuse("half-width beyond", [](auto& c) { c.steps[0].radius[1] = 0.5; });
        refuse("multiplier", [](auto& c) { c.multipliers[0].re += 1e-9; });
        refuse("disc", [](auto& c) { c.multipliers[0].radius = 0; });
        refuse("fewer multipliers", [](auto& c) { c.multipliers.pop_back(); });
        refuse("stability", [](auto& c) { c.stability = "saddle"; });
        refuse("period", [](auto& c) { c.steps.insert(c.steps.end(), c.steps.begin(), c.steps.end()); });
        refuse("phase", [](auto& c) { c.phase = {false, c.steps[0].point[4]}; });
        refuse("no points", [](auto& c) { c.steps.clear(); });
    }
    std::printf("%d edits refused\n", refused);
}

TEST(Proof, WhatCannotBeProvenSaysWhy) {
    auto scene = hexagon();
    const auto cases = proof_cases("fixed_points.json");
    // Another scene than the cycle's: Newton's method goes elsewhere, or nowhere.
    scene.alpha = 0.41;
    const CycleProof proof = prove_cycle(scene, cases[1].claim);
    EXPECT_FALSE(proof.proven());
    EXPECT_NE(proof.reason.find("no cycle with this word there"), std::string::npos) << proof.reason;
    EXPECT_THROW(
        (void)proof::all_fixed_points({disk_sides, 0.3, 0.1, 0.5, 1, Law::poisson, 0.5}, 12, [] { return false; }),
        std::invalid_argument);
    EXPECT_EQ(proof::all_fixed_points({disk_sides, 0.3, 0.1, 0.5, 0.9, Law::poisson, 0.5}, 12, [] { return false; })
                  .proven.size(),
              0U);
}

/// N = 3 … 12, all laws, e from 0.8 to 1.
std::vector<Scene<double>> scenes_with_fixed_points() {
    std::vector<Scene<double>> scenes;
    const double restitutions[]{0.8, 0.85, 0.9, 0.95, 1.0};
    for (int sides = 3; sides <= 12; ++sides) {
        const double u = 0.1 * sides;
        const Law law = std::array{Law::poisson, Law::newton, Law::stronge}[sides % 3];
        scenes.push_back({sides, 0.25 + 0.3 * std::fmod(7.31 * u, 1), 0.2 + 0.8 * std::fmod(3.17 * u, 1),
                          0.2 + 0.6 * std::fmod(5.77 * u, 1), restitutions[sides % 5], law,
                          uniform_inertia_factor<double>(sides)});
    }
    return scenes;
}

TEST(Proof, AThousandFalseClaimsAreRefusedOverTenScenes) {
    int refused = 0;
    for (const Scene<double>& scene : scenes_with_fixed_points()) {
        const auto begin = std::chrono::steady_clock::now();
        const auto all = proof::all_fixed_points(scene, 12, [] { return false; });
        std::printf("N = %d, e = %g, %s: %zu fixed points, %zu refuted, %zu open, %zu cells, %.2f s\n", scene.sides,
                    scene.restitution, std::string(name_of(scene.law)).c_str(), all.proven.size(), all.refuted.size(),
                    all.open.size(), all.cells, seconds_since(begin));
        EXPECT_TRUE(all.complete());
        for (const CycleProof& proof : all.proven) {
            EXPECT_EQ(proof_check::what_fails(stated(scene, proof)), "");
            for (const CycleClaim& claim : false_claims(scene, {proof.points, proof.times, proof.itinerary})) {
                EXPECT_FALSE(prove_cycle(scene, claim).proven());
                ++refused;
            }
        }
        for (const CycleProof& ghost : all.refuted) {
            EXPECT_FALSE(prove_cycle(scene, {ghost.points, ghost.times, ghost.itinerary}).proven());
            ++refused;
        }
    }
    std::printf("%d false claims refused\n", refused);
    EXPECT_GE(refused, 1000);
}

}  // namespace
}  // namespace swirl::tests
