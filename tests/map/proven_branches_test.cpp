// Branches of cycles proven along a parameter: against the list of all fixed points at single parameters, by other
// equations, at ends that are known; and what is false refused.
#include "map/proof/all_fixed_points.hpp"
#include "map/proof/prove_branch.hpp"
#include "map/proof_check/stated_branch.hpp"
#include "tests/map/proof_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl::tests {
namespace {

using proof::BranchBox;
using proof::BranchClaim;
using proof::BranchEndKind;
using proof::BranchProof;
using proof::prove_branch;
using proof_check::StatedBranch;

const std::function<bool()> go_on = [] { return false; };

StatedBranch stated_branch(const BranchClaim& claim, const BranchProof& p) {
    StatedBranch branch;
    branch.cycle = stated(claim.scene, proof::CycleProof{});
    for (const proof::Branch& letter : p.itinerary) {
        proof_check::StatedStep step;
        step.vertex_step = letter.vertex_step;
        step.contact_mode = name_of(letter.mode);
        step.slip = letter.slip;
        branch.cycle.steps.push_back(step);
    }
    branch.parameter = name_of(claim.parameter);
    branch.from = p.from;
    branch.to = p.to;
    for (const BranchBox& b : p.boxes)
        branch.boxes.push_back({b.running, b.low, b.high, b.middle, b.within, b.decided, b.outside, b.inside});
    for (const proof::SpecialPoint& s : p.special)
        if (s.proven)
            branch.special.push_back({std::string(name_of(s.kind)), s.middle, s.within, s.parameter_low,
                                      s.parameter_high, s.angle_low, s.angle_high, s.first, s.last});
    return branch;
}

std::string what_fails(const StatedBranch& branch) {
    try {
        return proof_check::what_fails(branch, go_on);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

BranchClaim hexagon_claim(std::size_t cycle, Parameter parameter, double low, double high) {
    return {hexagon(), proof_cases("fixed_points.json")[cycle].claim, parameter, low, high};
}

/// The list of all fixed points at a parameter of the box has one in it, with as many multipliers outside.
void expect_listed(const BranchClaim& claim, const BranchBox& box) {
    Scene<double> scene = with_parameter(claim.scene, claim.parameter, box.middle.back());
    const auto all = proof::all_fixed_points(scene, box.middle[5] + 0.1, go_on);
    bool found = false;
    for (const proof::CycleProof& p : all.proven) {
        const auto& z = p.points.front();
        const double away = std::max({std::abs(std::remainder(z.psi - box.middle[0], 2 * pi<double>())),
                                      std::abs(z.chi - box.middle[1]), std::abs(z.vn - box.middle[2]),
                                      std::abs(z.vt - box.middle[3]), std::abs(z.spin - box.middle[4])});
        if (away < 1e-9) found = found || !box.decided || p.stability == box.stability();
    }
    EXPECT_TRUE(found) << name_of(claim.parameter) << " = " << box.middle.back();
}

TEST(ProvenBranch, HoldsFixedPointsOfTheWholeListAtItsParameters) {
    const BranchClaim claim = hexagon_claim(1, Parameter::alpha, 0.38, 0.41);
    const BranchProof p = prove_branch(claim, go_on);
    ASSERT_TRUE(p.proven()) << p.reason;
    EXPECT_EQ(what_fails(stated_branch(claim, p)), "");
    std::mt19937 draw(1);
    for (int i = 0; i < 3; ++i) expect_listed(claim, p.boxes[draw() % p.boxes.size()]);
}

TEST(ProvenBranch, GoesOnThroughAFoldBeyondWhichThereAreTwoFixedPointsLess) {
    const BranchClaim claim = hexagon_claim(1, Parameter::alpha, 0.39, 0.6);
    const BranchProof p = prove_branch(claim, go_on);
    ASSERT_TRUE(p.proven()) << p.reason;
    ASSERT_LT(p.to, 0.6);
    EXPECT_EQ(p.ends[0].kind, BranchEndKind::range);  // both ways back to 0.39
    EXPECT_EQ(p.ends[1].kind, BranchEndKind::range);
    EXPECT_EQ(p.ends[0].parameter_low, 0.39);
    EXPECT_EQ(p.ends[1].parameter_low, 0.39);
    proof::SpecialPoint fold;
    for (const auto& special : p.special)
        if (special.kind == proof::SpecialKind::fold) fold = special;
    ASSERT_TRUE(fold.proven);
    EXPECT_LT(fold.parameter_high - fold.parameter_low, 1e-9);
    const auto count = [&](double alpha) {
        return proof::all_fixed_points(with_parameter(claim.scene, claim.parameter, alpha), 1.5, go_on).proven.size();
    };
    EXPECT_EQ(count(fold.parameter_low - 1e-8), count(fold.parameter_high + 1e-8) + 2);
}

/// Where β = 1 − α sticking fixed points of the − branch touch with u_n = 0.
TEST(ProvenBranch, EndsWhereBetaIsOneMinusAlpha) {
    const auto cases = proof_cases("fixed_points.json");
    int ends = 0;
    for (std::size_t i = 6; i < 9; ++i) {
        const BranchProof p = prove_branch({hexagon(), cases[i].claim, Parameter::alpha, 0.45, 0.6}, go_on);
        ASSERT_TRUE(p.proven()) << p.reason;
        for (const auto& end : p.ends) {
            if (end.kind != BranchEndKind::contact_mode) continue;
            EXPECT_TRUE(end.proven);
            EXPECT_LT(end.parameter_high - end.parameter_low, 1e-5);
            ends += end.parameter_low <= 0.5 && 0.5 <= end.parameter_high ? 1 : 0;
        }
    }
    EXPECT_EQ(ends, 3);
}

/// Of all three laws, from triangle to dodecagon, periods 1 to 8, along each parameter.
void expect_reference_branches(std::size_t step, double part) {
    const auto cases = proof_cases("cycles.json");
    for (std::size_t i = 0; i < cases.size(); i += step) {
        const Parameter parameter = all_parameters[(i / step) % 5];
        Scene<double> scene = cases[i].scene;
        const double value = number_of(scene, parameter), width = part * value;
        const BranchClaim claim{scene, cases[i].claim, parameter, value - width, value + width};
        const BranchProof p = prove_branch(claim, go_on);
        ASSERT_TRUE(p.proven()) << "cycle " << i << ": " << p.reason;
        EXPECT_LE(p.from, value);
        EXPECT_GE(p.to, value);
        for (const auto& end : p.ends)
            EXPECT_TRUE(end.proven || end.kind == BranchEndKind::equations) << "cycle " << i << ": " << end.reason;
        EXPECT_EQ(what_fails(stated_branch(claim, p)), "") << "cycle " << i;
    }
}

TEST(ProvenBranch, OfCyclesOfPeriodsOneToEightIsProvenAgain) {
    expect_reference_branches(3, 1e-4);
}

TEST(ProvenBranchNightly, OfTwentyCyclesOfPeriodsOneToEightIsProvenAgain) {
    expect_reference_branches(1, 1e-3);
}

/// One special point of a branch, proven.
proof::SpecialPoint only_special(const BranchProof& p) {
    EXPECT_EQ(p.special.size(), 1U);
    if (p.special.size() != 1) return {};
    EXPECT_TRUE(p.special.front().proven);
    EXPECT_LT(p.special.front().parameter_high - p.special.front().parameter_low, 1e-9);
    return p.special.front();
}

TEST(ProvenBranch, HasANeimarkSackerPointWithTheAngleOfItsMultipliers) {
    const BranchClaim claim = hexagon_claim(1, Parameter::alpha, 0.4, 0.42);
    const BranchProof p = prove_branch(claim, go_on);
    ASSERT_TRUE(p.proven()) << p.reason;
    const auto special = only_special(p);
    EXPECT_EQ(special.kind, proof::SpecialKind::neimark_sacker);
    EXPECT_EQ(what_fails(stated_branch(claim, p)), "");
    const double angle = 0.5 * (special.angle_low + special.angle_high);
    const auto all = proof::all_fixed_points(with_parameter(claim.scene, claim.parameter, special.parameter_low - 1e-7),
                                             special.middle[5] + 0.1, go_on);
    double nearest = 1;
    for (const proof::CycleProof& cycle : all.proven)
        for (const auto& disc : cycle.multipliers)
            nearest = std::min(nearest, std::hypot(disc.re - std::cos(angle), disc.im - std::sin(angle)));
    EXPECT_LT(nearest, 1e-4);
}

/// A stated special point of which one thing is false.
StatedBranch with_false_special(StatedBranch branch, unsigned what, std::mt19937& draw) {
    auto& special = branch.special[draw() % branch.special.size()];
    std::uniform_real_distribution<double> share(0, 1);
    switch (what % 6) {
        case 0:
            special.kind = special.kind == "fold" ? "flip" : "fold";
            break;
        case 1:
            special.middle[draw() % special.middle.size()] += special.within * (2.1 + 1e3 * share(draw));
            break;
        case 2:
            special.within = 1e-19 * share(draw);
            break;
        case 3:
            special.low = special.high;
            special.high += 1e-9 * (1 + share(draw));
            break;
        case 4:
            if (special.kind == "neimark-sacker")
                special.angle_high = special.angle_low;
            else
                special.kind = "neimark-sacker";
            break;
        default:
            special.last = special.first;
            break;
    }
    return branch;
}

void expect_special_refused(unsigned count) {
    std::mt19937 draw(11);
    for (const auto& [low, high] : {std::pair(0.4, 0.42), std::pair(0.39, 0.6)}) {
        const BranchClaim claim = hexagon_claim(1, Parameter::alpha, low, high);
        const BranchProof p = prove_branch(claim, go_on);
        StatedBranch whole = stated_branch(claim, p);
        ASSERT_FALSE(whole.special.empty());
        // The boxes beside the points, so that each edit costs little.
        std::vector<proof_check::StatedSpecial> one{whole.special.front()};
        const std::size_t first = one[0].first - 1, last = one[0].last + 1;
        whole.boxes = {whole.boxes.begin() + static_cast<std::ptrdiff_t>(first),
                       whole.boxes.begin() + static_cast<std::ptrdiff_t>(last)};
        one[0].last -= first;
        one[0].first = 1;
        whole.special = one;
        whole.from = whole.to = 0.5 * (one[0].low + one[0].high);
        ASSERT_EQ(what_fails(whole), "");
        for (unsigned i = 0; i < count; ++i)
            EXPECT_NE(what_fails(with_false_special(whole, i, draw)), "") << one[0].kind << ", edit " << i;
    }
}

TEST(ProvenBranch, OfWhichASpecialPointIsMadeFalseIsRefused) {
    expect_special_refused(12);
}

TEST(ProvenBranchNightly, OfWhichASpecialPointIsMadeFalseInManyWaysIsRefused) {
    expect_special_refused(500);
}

TEST(ProvenBranch, RefusesAClaimThatIsNoCycle) {
    BranchClaim claim = hexagon_claim(1, Parameter::alpha, 0.39, 0.41);
    claim.cycle.points[0].spin += 1e-2;
    EXPECT_FALSE(prove_branch(claim, go_on).proven());
    claim = hexagon_claim(1, Parameter::alpha, 0.39, 0.41);
    claim.cycle.itinerary[0].mode = ContactMode::sliding;
    EXPECT_FALSE(prove_branch(claim, go_on).proven());
    claim = hexagon_claim(1, Parameter::alpha, 0.39, 0.41);
    claim.cycle.itinerary[0].vertex_step += 1;
    EXPECT_FALSE(prove_branch(claim, go_on).proven());
}

TEST(ProvenBranch, RefusesFamilies) {
    EXPECT_THROW(proof::require_isolated_branch(hexagon(), Parameter::mu, 0, 0.5), std::invalid_argument);
    Scene<double> disk = hexagon();
    disk.sides = disk_sides;
    EXPECT_THROW(proof::require_isolated_branch(disk, Parameter::restitution, 0.9, 1), std::invalid_argument);
    EXPECT_NO_THROW(proof::require_isolated_branch(hexagon(), Parameter::alpha, 0.1, 0.9));
}

/// Beyond e = 1 the equations have solutions, too, but there is no scene.
TEST(ProvenBranch, ThatLeavesTheParametersRangeIsRefused) {
    const auto cases = proof_cases("cycles.json");
    const BranchClaim claim{cases[6].scene, cases[6].claim, Parameter::restitution, 0.9929, 1};
    const BranchProof p = prove_branch(claim, go_on);
    ASSERT_TRUE(p.proven()) << p.reason;
    ASSERT_EQ(p.to, 1);
    StatedBranch branch = stated_branch(claim, p);
    ASSERT_EQ(what_fails(branch), "");
    for (auto& box : branch.boxes)
        if (box.running + 1 == box.middle.size() && box.high > 1) box.high += 1e-3 * (box.high - box.low);
    const std::string failed = what_fails(branch);
    EXPECT_NE(failed.find("leaves the range"), std::string::npos) << failed;
}

/// One thing is made false: every edit is beyond the 1 % by which a stated box is wider than the proof's.
StatedBranch made_false(StatedBranch branch, unsigned what, std::mt19937& draw) {
    auto& box = branch.boxes[draw() % branch.boxes.size()];
    const std::size_t parameter = box.middle.size() - 1;
    std::size_t other = draw() % parameter;
    if (other == box.running) other = (other + 1) % parameter;
    std::uniform_real_distribution<double> share(0, 1);
    switch (what % 8) {
        case 0:
            box.middle[other] += (draw() % 2 == 0 ? 1 : -1) * box.within * (2.1 + 5 * share(draw));
            break;
        case 1:
            box.within *= 0.95 * share(draw);
            break;
        case 2:
            ++box.outside;
            --box.inside;
            break;
        case 3:
            box.high += (box.high - box.low) * (0.5 + share(draw));
            break;
        case 4:
            branch.to += 1e-3 + share(draw) * 0.05;
            break;
        case 5:
            branch.boxes.erase(branch.boxes.begin() + 1 +
                               static_cast<std::ptrdiff_t>(draw() % (branch.boxes.size() - 2)));
            break;
        case 6:
            branch.cycle.beta += 0.05 + 0.2 * share(draw);
            break;
        default:
            branch.cycle.steps[draw() % branch.cycle.steps.size()].contact_mode =
                draw() % 2 == 0 ? "r-sticking" : "sliding";
            break;
    }
    return branch;
}

void expect_refused(unsigned count) {
    const BranchClaim claim = hexagon_claim(1, Parameter::alpha, 0.38, 0.41);
    const BranchProof p = prove_branch(claim, go_on);
    ASSERT_TRUE(p.proven()) << p.reason;
    ASSERT_GT(p.boxes.size(), 3U);
    for (const BranchBox& box : p.boxes) ASSERT_TRUE(box.decided);
    const StatedBranch whole = stated_branch(claim, p);
    ASSERT_EQ(what_fails(whole), "");
    std::mt19937 draw(7);
    for (unsigned i = 0; i < count; ++i) EXPECT_NE(what_fails(made_false(whole, i, draw)), "") << "edit " << i;
}

TEST(ProvenBranch, ThatIsMadeFalseIsRefused) {
    expect_refused(40);
}

TEST(ProvenBranchNightly, ThatIsMadeFalseInAThousandWaysIsRefused) {
    expect_refused(1000);
}

}  // namespace
}  // namespace swirl::tests
