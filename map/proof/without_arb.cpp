// What a build without Arb answers.
#include "map/proof/all_fixed_points.hpp"
#include "map/proof/covering_claim.hpp"
#include "map/proof/prove_branch.hpp"
#include "map/proof/prove_cycle.hpp"
#include "map/proof/steady_cells.hpp"
#include "map/proof_check/stated_branch.hpp"
#include "map/proof_check/stated_chaos.hpp"
#include "map/proof_check/stated_cycle.hpp"
#include "map/proof_check/stated_plane.hpp"

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace swirl {

namespace {

[[noreturn]] void refuse() {
    throw std::invalid_argument(
        "this build of swirl has no interval arithmetic: build it where Arb is (FLINT 3, or libflint-arb-dev) to prove "
        "cycles");
}

}  // namespace

namespace proof {

void require_interval_arithmetic() {
    refuse();
}
CycleProof prove_cycle(const Scene<double>&, const CycleClaim&) {
    refuse();
}
AllFixedPoints all_fixed_points(const Scene<double>&, double, const std::function<bool()>&) {
    refuse();
}

cells::PlanePiece proven_piece(const PlaneScene&, const cells::ParameterCell&, const cells::PlaneLimits&,
                               const std::function<bool()>&) {
    refuse();
}

BranchProof prove_branch(const BranchClaim&, const std::function<bool()>&) {
    refuse();
}
std::vector<std::size_t> section_chart(const Scene<double>&) {
    refuse();
}
void require_chart(const Scene<double>&) {
    refuse();
}
CoveringProof prove_covering(const Scene<double>&, const ChaosClaim&, const CoveringClaim&, int) {
    refuse();
}
std::string common_point(const Scene<double>&, const ChaosClaim&, std::size_t, std::size_t) {
    refuse();
}
GrowthBound growth_bound(std::size_t, const std::vector<std::pair<std::size_t, std::size_t>>&) {
    refuse();
}
void require_isolated_branch(const Scene<double>&, Parameter, double, double) {
    refuse();
}

}  // namespace proof

namespace proof_check {

std::string what_fails(const StatedCycle&) {
    refuse();
}
std::string what_fails(const StatedPlane&, const std::function<bool()>&) {
    refuse();
}
std::string what_fails(const StatedBranch&, const std::function<bool()>&) {
    refuse();
}
std::string what_fails(const StatedChaos&, const std::function<bool()>&) {
    refuse();
}

}  // namespace proof_check

}  // namespace swirl
