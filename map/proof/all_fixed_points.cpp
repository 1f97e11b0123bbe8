#include "map/proof/all_fixed_points.hpp"

#include "map/proof/fixed_point_lines.hpp"
#include "map/proof/prove_cycle.hpp"
#include "map/proof/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

namespace swirl::proof {

namespace {

using intervals::middle;

SectionPoint<double> middle_of(const BallPoint<Ball>& z) {
    return {wrapped_angle(middle(z.psi)), middle(z.chi), middle(z.vn), middle(z.vt), middle(z.spin)};
}

/// True if the solution of the two equations lies in the box of the proof, so that it is the one that is there.
bool is_the_one(const BallPoint<Ball>& z, const Ball& tau, const CycleProof& proof) {
    if (proof.radii.empty()) return false;
    const SectionPoint<double>& at = proof.points.front();
    const PointRadii& r = proof.radii.front();
    const auto near = [](const Ball& x, double centre, double radius) {
        return intervals::upper(abs(x - Ball(centre))) < radius;
    };
    const double turns = std::round((middle(z.psi) - at.psi) / (2 * pi<double>()));
    const Ball psi = z.psi - Ball(2 * turns) * intervals::pi_ball();
    return near(psi, at.psi, r[0]) && near(z.chi, at.chi, r[1]) && near(z.vn, at.vn, r[2]) && near(z.vt, at.vt, r[3]) &&
           near(z.spin, at.spin, r[4]) && near(tau, proof.times.front(), proof.time_radii.front());
}

/// Proven or refuted, or undecided with a reason. Refuted is what no mode that is possible there makes an orbit, or
/// whose flight meets another vertex.
CycleProof judge(const Scene<double>& scene, const BallPoint<Ball>& z, const Ball& tau, int step,
                 const std::vector<ContactMode>& modes) {
    CycleProof last;
    std::size_t refuted = 0;
    for (const ContactMode mode : modes) {
        CycleProof proof = prove_cycle(scene, {{middle_of(z)}, {middle(tau)}, {{step, mode, 0}}});
        if (proof.verdict != Verdict::undecided && !is_the_one(z, tau, proof)) {
            proof.verdict = Verdict::undecided;
            proof.reason = "the solution of the two equations is not proven to be the one of the box";
        }
        const bool by_vertex = proof.verdict == Verdict::refuted && proof.reason.rfind("flight", 0) == 0;
        if (proof.proven() || by_vertex) return proof;
        if (proof.verdict == Verdict::refuted) ++refuted;
        last = std::move(proof);
    }
    if (refuted < modes.size()) last.verdict = Verdict::undecided;
    return last;
}

OpenCell open_cell(const FixedPointSet& set, const Cell& cell, std::string reason) {
    if (set.problem.unknowns == 2) return {cell.low[0], cell.high[0], cell.low[1], cell.high[1], std::move(reason)};
    const Ball phi = phi_on_line(set);
    return {cell.low[0], cell.high[0], intervals::lower(phi), intervals::upper(phi), std::move(reason)};
}

/// Refuted where friction would act along the slip, and not against it: the equations of a line don't know.
std::optional<CycleProof> refuted_by_slip(const BallScene& balls, const FixedPointSet& set, const BallPoint<Ball>& z,
                                          const Ball& tau, int step) {
    if (set.kind != FixedPointSet::Kind::sliding) return {};
    const Ball slip = slip_along(balls, set, z);
    if (!intervals::is_negative(slip)) return {};
    CycleProof proof;
    proof.verdict = Verdict::refuted;
    proof.points = {middle_of(z)};
    proof.times = {middle(tau)};
    proof.itinerary = {{step, ContactMode::sliding, intervals::is_positive(set.sine) ? 1 : -1}};
    proof.reason = words("impact 1, sliding: s u_t after > 0 fails, it lies in %.3g ... %.3g", intervals::lower(slip),
                         intervals::upper(slip));
    return proof;
}

/// The solutions of one set of equations, each judged.
struct JudgedSet {
    std::vector<CycleProof> proven, refuted;

    /// A solution that was found twice, at φ and φ + 2π, lies in the box of another, which holds one alone.
    bool holds(const BallPoint<Ball>& z, const Ball& tau) const {
        const auto here = [&](const CycleProof& other) { return is_the_one(z, tau, other); };
        return std::any_of(proven.begin(), proven.end(), here) || std::any_of(refuted.begin(), refuted.end(), here);
    }
};

void look_at(const Scene<double>& scene, const BallScene& balls, const FixedPointSet& set,
             const std::function<bool()>& stop, AllFixedPoints& all) {
    PlaneResult result;
    for (const Cell& start : set.start) {
        const std::string& why = stop() ? "not looked at" : set.open;
        if (why.empty())
            solve(set.problem, start, stop, result);
        else
            all.open.push_back(open_cell(set, start, why));
    }
    all.cells += result.cells;
    for (const Cell& cell : result.open) all.open.push_back(open_cell(set, cell, "neither excluded nor closed"));
    JudgedSet judged_here;
    for (const PlaneSolution& solution : result.solutions) {
        if (intervals::lower(solution.tau) > all.max_time) continue;
        if (!(intervals::upper(solution.tau) <= all.max_time)) {
            all.open.push_back(open_cell(set, solution.cell, "its flight's time is within rounding of the longest"));
            continue;
        }
        if (stop()) {
            all.open.push_back(open_cell(set, solution.cell, "one solution, not looked at"));
            continue;
        }
        const BallPoint<Ball> z = fixed_point_of(balls, set, solution);
        if (judged_here.holds(z, solution.tau)) continue;
        const int step = static_cast<int>(((solution.j % scene.sides) + scene.sides) % scene.sides);
        if (auto refuted = refuted_by_slip(balls, set, z, solution.tau, step)) {
            judged_here.refuted.push_back(std::move(*refuted));
            continue;
        }
        CycleProof proof = judge(scene, z, solution.tau, step, modes_of(balls, set, solution));
        if (proof.verdict == Verdict::undecided)
            all.open.push_back(open_cell(set, solution.cell, "one solution, undecided: " + proof.reason));
        else
            (proof.proven() ? judged_here.proven : judged_here.refuted).push_back(std::move(proof));
    }
    all.proven.insert(all.proven.end(), judged_here.proven.begin(), judged_here.proven.end());
    all.refuted.insert(all.refuted.end(), judged_here.refuted.begin(), judged_here.refuted.end());
}

void sort_by_branch(std::vector<CycleProof>& proofs) {
    std::sort(proofs.begin(), proofs.end(), [](const CycleProof& a, const CycleProof& b) {
        const auto outer = [](const CycleProof& p) { return std::cos(p.points[0].psi + p.points[0].chi) > 0; };
        if (outer(a) != outer(b)) return outer(a);
        return a.times[0] < b.times[0];
    });
}

}  // namespace

AllFixedPoints all_fixed_points(const Scene<double>& scene, double max_time, const std::function<bool()>& stop) {
    validated(scene);
    if (!(max_time > 0 && max_time <= 1000))
        throw std::invalid_argument(words("max-time = %g is outside its range: 0 < max-time <= 1000", max_time));
    AllFixedPoints all;
    all.max_time = max_time;
    if (scene.restitution < 1 && (scene.is_disk() || scene.mu == 0)) {
        all.none = scene.is_disk() ? "a disk with e < 1 has no fixed point with impacts"
                                   : "without friction and with e < 1 every impact lowers J";
        return all;
    }
    if (scene.is_disk() || scene.mu == 0 || scene.beta == 0)
        throw std::invalid_argument(
            "fixed points come in families here (a disk or no friction at e = 1, or beta = 0); "
            "all of them are isolated for a polygon with friction and swirl");
    const BallScene balls = ball_scene(scene);
    for (const FixedPointSet& set : fixed_point_sets(balls, max_time)) look_at(scene, balls, set, stop, all);
    sort_by_branch(all.proven);
    sort_by_branch(all.refuted);
    return all;
}

}  // namespace swirl::proof
