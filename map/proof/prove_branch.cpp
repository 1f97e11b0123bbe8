#include "map/proof/prove_branch.hpp"

#include "map/proof/branch_walk.hpp"
#include "map/proof/prepared_system.hpp"
#include "map/proof/special_points.hpp"
#include "map/proof/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace swirl::proof {

namespace {

using intervals::curve_piece;

std::vector<double> claimed_point(const CycleSystem& system, const CycleClaim& claim) {
    std::vector<double> point;
    for (std::size_t i = 0; i < claim.points.size(); ++i) {
        const auto& z = claim.points[i];
        const std::array<double, 5> all{z.psi, z.chi, z.vn, z.vt, z.spin};
        for (const std::size_t index : system.active) point.push_back(all[index]);
        point.push_back(claim.times[i]);
    }
    return point;
}

/// The start, or why there is none.
std::variant<BranchStart, std::string> start_of(const BranchClaim& claim) {
    // Its word and turns alone: at a fold the derivative by the state has no inverse.
    const PreparedSystem prepared = prepared_system(claim.scene, claim.cycle);
    if (prepared.system.turns.empty()) return prepared.reason;
    std::vector<double> point = claimed_point(prepared.system, claim.cycle);
    Scene<double> scene = claim.scene;
    point.push_back(number_of(scene, claim.parameter));
    BranchStart start{branch_system(prepared.system, claim.parameter), claim.low, claim.high, {}, {}, {}};
    for (const double x : point) start.scales.push_back(std::max(1.0, std::abs(x)));
    start.scales.back() = claim.high - claim.low;
    const auto equations = [&](const std::vector<Running>& unknowns) { return evaluate(start.system, unknowns); };
    for (std::size_t i = point.size(); i-- > 0;) {  // the parameter first
        start.direction = unit_direction(start.system, point, i, start.scales);
        if (start.direction.empty()) continue;
        const std::size_t best = running_unknown(start.direction);
        const auto found = curve_piece(equations, point, best, point[best], point[best]);
        if (!found) break;
        for (std::size_t k = 0; k < point.size(); ++k)
            if (std::abs(found->middle[k] - point[k]) > 1e-6 * start.scales[k])
                return words("no cycle with this word there: Newton's method moves the point by %.3g",
                             std::abs(found->middle[k] - point[k]));
        start.point = *found;
        start.direction = unit_direction(start.system, found->middle, best, start.scales);
        if (start.direction.empty()) break;
        if (start.direction.back() < 0)
            for (double& d : start.direction) d = -d;
        return start;
    }
    return prepared.reason.empty() ? "no box about the cycle is mapped into itself by Krawczyk's operator"
                                   : prepared.reason;
}

/// The parameters that the points between boxes reach, less what the check's enclosures of such a point, of some 10⁻¹¹,
/// may be wider: a range of 10⁻⁴ leaves them that.
void set_range(const BranchClaim& claim, BranchProof& proof) {
    const double room = 1e-7 * (claim.high - claim.low);
    proof.from = claim.high;
    proof.to = claim.low;
    for (const BranchBox& box : proof.boxes)
        for (const double p : {box.parameter_begin, box.parameter_end}) {
            proof.from = std::min(proof.from, p <= claim.low ? claim.low : p + room);
            proof.to = std::max(proof.to, p >= claim.high ? claim.high : p - room);
        }
}

}  // namespace

void require_isolated_branch(const Scene<double>& scene, Parameter parameter, double low, double high) {
    const double e = parameter == Parameter::restitution ? high : scene.restitution;
    const double mu = parameter == Parameter::mu ? low : scene.mu;
    if (e == 1 && (scene.is_disk() || !(mu > 0)))
        throw std::invalid_argument(
            "restitution = 1: cycles of a disk, and those without friction, come in families there; restitution < 1 is "
            "wanted");
    if (scene.is_disk() && !(mu > 0))
        throw std::invalid_argument("mu = 0: a disk's cycles come in families there; mu > 0 is wanted");
    if (parameter == Parameter::mu && !(mu > 0))
        throw std::invalid_argument("mu = 0: the contact modes are others there; a range of mu > 0 is wanted");
}

BranchProof prove_branch(const BranchClaim& claim, const std::function<bool()>& stop) {
    BranchProof proof;
    proof.itinerary = claim.cycle.itinerary;
    require_isolated_branch(validated(claim.scene), claim.parameter, claim.low, claim.high);
    const auto found = start_of(claim);
    if (const auto* reason = std::get_if<std::string>(&found)) {
        proof.reason = *reason;
        return proof;
    }
    const auto& start = std::get<BranchStart>(found);
    proof.itinerary = start.system.cycle.itinerary;
    const BoxStanding standing = standing_of(start.system, start.point);
    if (standing.verdict != Verdict::proven) {
        proof.reason = standing.reason;
        return proof;
    }
    Walked ahead = walk(start, true, stop);
    Walked back;
    back.end = ahead.end;
    if (ahead.end.kind != BranchEndKind::closed) back = walk(start, false, stop);
    std::reverse(back.boxes.begin(), back.boxes.end());
    for (BranchBox& box : back.boxes) {
        std::swap(box.parameter_begin, box.parameter_end);
        proof.boxes.push_back(std::move(box));
    }
    for (BranchBox& box : ahead.boxes) proof.boxes.push_back(std::move(box));
    proof.ends = {back.end, ahead.end};
    set_range(claim, proof);
    proof.special = special_points(start.system, proof.boxes);
    if (proof.boxes.empty()) proof.reason = ahead.end.reason;
    return proof;
}

}  // namespace swirl::proof
