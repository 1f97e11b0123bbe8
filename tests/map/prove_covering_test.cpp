// What is not carried over a set, though it lies beyond both of its ends.
#include "map/proof/covering_claim.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace swirl::tests {
namespace {

/// A disk without friction that goes slowly round the wall: flights of 14 to 10, so that a change of v_t by 0.006 turns
/// ψ by 3.97 after the next impact, from 1.155 through π to −1.153.
proof::CoveringProof carried_over_set_at(double psi) {
    const Scene<double> scene{.sides = 0, .alpha = 0.3, .beta = 0.01, .mu = 0, .restitution = 1, .inertia_factor = 0.5};
    proof::ChaosClaim claim;
    claim.jacobi = -0.018725619445404632;
    claim.sets = {{{0.5, 0.036}, {0, 1e-5, 0.003, 0}}, {{psi, 0.036}, {0.5, 0, 0, 0.02}}};
    return proof::prove_covering(scene, claim, {0, 1, {0, ContactMode::frictionless, 0}, 11.84, {}}, 3000);
}

TEST(ProveCovering, HoldsWhereTheImageCrosses) {
    const proof::CoveringProof proof = carried_over_set_at(std::acos(-1.0));
    EXPECT_TRUE(proof.proven) << proof.reason;
}

TEST(ProveCovering, FailsWhereTheImageGoesRoundTheOtherWay) {
    const proof::CoveringProof proof = carried_over_set_at(0);
    EXPECT_FALSE(proof.proven);
    EXPECT_NE(proof.reason.find("half a turn"), std::string::npos) << proof.reason;
}

}  // namespace
}  // namespace swirl::tests
