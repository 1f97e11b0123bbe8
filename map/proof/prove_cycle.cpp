#include "map/proof/prove_cycle.hpp"

#include "map/intervals/eigenvalue_discs.hpp"
#include "map/proof/clear_flight.hpp"
#include "map/proof/prepared_system.hpp"
#include "map/proof/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace swirl::proof {

namespace {

using intervals::Disc;

/// The first of the inequalities that is not certain; proven if none.
struct Finding {
    Verdict verdict = Verdict::proven;
    std::string reason;
};

Finding check_modes(const CycleSystem& system, const BallVector& box) {
    for (std::size_t i = 0; i < system.period(); ++i) {
        Margins margins;
        system.step(box, i, &margins);
        for (const Margin& margin : margins) {
            if (intervals::is_positive(margin.value)) continue;
            const bool wrong = intervals::is_negative(margin.value);
            return {wrong ? Verdict::refuted : Verdict::undecided,
                    words("impact %zu, %s: %s fails, it lies in %.3g ... %.3g", i + 1,
                          std::string(name_of(system.itinerary[i].mode)).c_str(), margin.name.c_str(),
                          intervals::lower(margin.value), intervals::upper(margin.value))};
        }
    }
    return {};
}

Finding check_flights(const CycleSystem& system, const BallVector& box) {
    for (std::size_t i = 0; i < system.period(); ++i) {
        const int sides = std::max(1, system.scene.sides);
        const int arriving = ((system.itinerary[i].vertex_step % sides) + sides) % sides;
        const Clearance clearance = clear_flight(system.scene, system.point(box, i), system.time(box, i), arriving);
        if (clearance.verdict != Verdict::proven)
            return {clearance.verdict, words("flight %zu: %s", i + 1, clearance.reason.c_str())};
    }
    return {};
}

/// The points of a cycle are different ones, angles modulo 2π.
Finding check_period(const CycleSystem& system, const BallVector& box) {
    const Ball turn = Ball(2) * intervals::pi_ball();
    for (std::size_t i = 1; i < system.period(); ++i) {
        const BallPoint<Ball> a = system.point(box, 0), b = system.point(box, i);
        const auto same_angle = [&](const Ball& x, const Ball& y) {
            return intervals::contains_zero(sine_cosine(Ball(0.5) * (x - y)).sine);
        };
        const auto same = [](const Ball& x, const Ball& y) { return intervals::overlap(x, y); };
        if (same_angle(a.psi, b.psi) && same_angle(a.chi, b.chi) && same(a.vn, b.vn) && same(a.vt, b.vt) &&
            same(a.spin, b.spin))
            return {Verdict::undecided, words("the period is not proven to be %zu: the boxes of points 1 and %zu meet",
                                              system.period(), i + 1)};
    }
    return {};
}

/// What the equations' form takes for granted.
Finding check_family(const CycleSystem& system, const BallVector& box) {
    if (system.form == FamilyForm::symmetric) {
        if (intervals::contains_zero(sine_cosine(Ball(0.5) * system.time(box, 0)).sine))
            return {Verdict::undecided, "the flight's time is not proven to differ from whole turns of the swirl"};
    }
    if (system.form != FamilyForm::conserved) return {};
    // Fᵏ(z_1) and z_1 = Fᵏ(z_1) + λ a lie within λ a of each other; J is the same at both.
    BallPoint<Ball> z = system.point(box, 0);
    const Ball lambda = hull(Ball(0), -box.back());
    Ball* const places[]{&z.psi, &z.chi, &z.vn, &z.vt, &z.spin};
    for (const std::size_t index : system.active) *places[index] += lambda * Ball(system.conserved_gradient[index]);
    const auto gradient = conserved_gradient(system.scene, z);
    Ball rise;
    for (const std::size_t index : system.active)
        rise.add_product(gradient[index], Ball(system.conserved_gradient[index]));
    if (intervals::is_positive(rise)) return {};
    return {Verdict::undecided,
            words("J is not proven to rise along its gradient: by %.3g or more", intervals::lower(rise))};
}

std::vector<BallVector> product(const std::vector<BallVector>& a, const std::vector<BallVector>& b) {
    std::vector<BallVector> result(a.size(), BallVector(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a.size(); ++j)
            for (std::size_t l = 0; l < a.size(); ++l) result[i][j].add_product(a[i][l], b[l][j]);
    return result;
}

/// Replaces the disc that holds a known number by that number, if it holds one eigenvalue alone.
void set_exact(std::vector<Disc>& discs, double known) {
    std::size_t index = discs.size(), meeting = 0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        if (!(std::hypot(discs[i].re - known, discs[i].im) <= discs[i].radius)) continue;
        index = i;
        ++meeting;
    }
    if (meeting == 1) discs[index] = {known, 0, 0};
}

std::vector<Disc> multipliers_of(const CycleSystem& system, const BallVector& cycle) {
    std::vector<BallVector> derivative = step_derivative(system, cycle, 0);
    for (std::size_t i = 1; i < system.period(); ++i)
        derivative = product(step_derivative(system, cycle, i), derivative);
    std::vector<Disc> discs = intervals::eigenvalue_discs(derivative);
    const bool sticks = std::any_of(system.itinerary.begin(), system.itinerary.end(),
                                    [](const Branch& branch) { return ends_in_stick(branch.mode); });
    if (sticks) set_exact(discs, 0);  // u_t = 0 after the impact: DF has lost a rank
    if (system.form != FamilyForm::isolated) set_exact(discs, 1);
    // A frictionless disk's S never changes.
    if (system.active.size() == 3) discs.push_back({1, 0, 0});
    // Room for another program's enclosure: other equations widen a box otherwise (of a multiplier −1.4·10⁵ six times
    // as much), those of a family by more.
    const double room = system.form == FamilyForm::isolated ? 32 : 1024;
    constexpr double slack = 1e-14;  // of the modulus
    for (Disc& disc : discs)
        if (disc.radius > 0) disc.radius = room * disc.radius + slack * std::hypot(disc.re, disc.im) + 1e-24;
    return discs;
}

ProvenStability stability_of(const std::vector<Disc>& discs) {
    std::size_t inside = 0, outside = 0, one = 0;
    for (const Disc& disc : discs) {
        const bool exactly_one = disc.re == 1 && disc.im == 0 && disc.radius == 0;
        if (exactly_one) ++one;
        if (!exactly_one && disc.largest_modulus() < 1) ++inside;
        if (!exactly_one && disc.least_modulus() > 1) ++outside;
    }
    if (outside > 0 && inside > 0) return ProvenStability::saddle;
    if (outside == discs.size()) return ProvenStability::repelling;
    if (inside == discs.size()) return ProvenStability::attracting;
    return one > 0 && one + inside == discs.size() ? ProvenStability::neutral : ProvenStability::undecided;
}

void take_box(const CycleSystem& system, const BallVector& centre, const BallVector& box, CycleProof& proof) {
    for (std::size_t i = 0; i < system.period(); ++i) {
        const BallPoint<Ball> at = system.point(centre, i), all = system.point(box, i);
        using intervals::middle;
        using intervals::radius;
        proof.points.push_back({middle(at.psi), middle(at.chi), middle(at.vn), middle(at.vt), middle(at.spin)});
        proof.radii.push_back({radius(all.psi), radius(all.chi), radius(all.vn), radius(all.vt), radius(all.spin)});
        proof.times.push_back(middle(system.time(centre, i)));
        proof.time_radii.push_back(radius(system.time(box, i)));
    }
}

}  // namespace

void require_interval_arithmetic() {}

CycleProof prove_cycle(const Scene<double>& scene, const CycleClaim& claim) {
    CycleProof proof;
    proof.points = claim.points;
    proof.times = claim.times;
    proof.itinerary = claim.itinerary;
    const PreparedSystem prepared = prepared_system(validated(scene), claim);
    proof.itinerary = prepared.system.itinerary;
    proof.reason = prepared.reason;
    if (!proof.reason.empty()) return proof;
    const KrawczykBox found = krawczyk_box(prepared);
    proof.reason = found.reason;
    if (!proof.reason.empty()) return proof;
    const CycleSystem& system = prepared.system;
    proof.points.clear();
    proof.times.clear();
    take_box(system, prepared.middle, found.box, proof);
    proof.phase = system.phase;
    for (const auto check : {check_modes, check_flights, check_period, check_family}) {
        const Finding finding = check(system, found.box);
        if (finding.verdict == Verdict::proven) continue;
        proof.verdict = finding.verdict;
        proof.reason = finding.reason;
        return proof;
    }
    const auto equations = [&](const BallVector& box) { return evaluate(system, box); };
    const BallVector cycle = intervals::narrowed(equations, found.box);
    if (system.form == FamilyForm::conserved) {
        proof.reason = "a family of a frictionless scene: its two multipliers 1 are not told apart";
        return proof;
    }
    const std::vector<Disc> discs = multipliers_of(system, cycle);
    for (const Disc& disc : discs) proof.multipliers.push_back({disc.re, disc.im, disc.radius});
    proof.stability = stability_of(discs);
    proof.verdict = Verdict::proven;
    return proof;
}

}  // namespace swirl::proof
