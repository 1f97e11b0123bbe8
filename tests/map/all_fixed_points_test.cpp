// All fixed points, proven, against those that the equations of steady modes lead to.
#include "map/proof/all_fixed_points.hpp"
#include "map/steady/steady_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace swirl::tests {
namespace {

using proof::CycleProof;

TEST(AllFixedPoints, AreFoundWhateverTheFriction) {
    // With little friction most solutions of the equations for slip would slip along their friction: they are none.
    struct Case {
        int sides;
        double alpha, beta, mu, restitution;
        Law law;
    };
    for (const Case& c : {Case{6, 0.4, 0.5, 0.1, 0.9, Law::poisson}, Case{3, 0.4, 0.7, 0.1, 0.95, Law::newton},
                          Case{5, 0.5, 0.3, 0.05, 0.8, Law::stronge}, Case{8, 0.3, 0.9, 0.1, 1.0, Law::poisson},
                          Case{4, 0.464, 0.085, 2.5, 1.0, Law::newton}}) {
        const Scene<double> scene{
            c.sides, c.alpha, c.beta, c.mu, c.restitution, c.law, uniform_inertia_factor<double>(c.sides)};
        const auto all = proof::all_fixed_points(scene, 5, [] { return false; });
        std::printf("N = %d, mu = %g, e = %g, %s: %zu fixed points, %zu refuted, %zu open\n", c.sides, c.mu,
                    c.restitution, std::string(name_of(c.law)).c_str(), all.proven.size(), all.refuted.size(),
                    all.open.size());
        EXPECT_TRUE(all.complete());
        EXPECT_GT(all.proven.size(), 0U);
        // Those that Newton's method finds from the steady modes' own equations are all there.
        for (const SteadyMode& mode : steady_modes(scene, {5}).modes) {
            const auto is_here = [&](const CycleProof& proof) {
                return std::abs(proof.times.front() - mode.tau) < 1e-8 &&
                       std::abs(proof.points.front().spin - mode.point.spin) < 1e-8;
            };
            EXPECT_TRUE(std::any_of(all.proven.begin(), all.proven.end(), is_here)) << mode.tau;
        }
    }
}

}  // namespace
}  // namespace swirl::tests
