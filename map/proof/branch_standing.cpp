#include "map/proof/branch_standing.hpp"

#include "map/intervals/unit_circle.hpp"
#include "map/proof/cell_flight.hpp"
#include "map/proof/cell_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace swirl::proof {

namespace {

using cells::Doubt;
using cells::SolutionBranch;
using intervals::contains_zero;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using Ranging = cells::Curving;  // both parameters
using intervals::square;
using intervals::upper;
using StepSlopes = intervals::Dual<6, Ranging>;
constexpr std::size_t coordinates = 5;

/// The impact of a solution: its mode, if its inequalities are certain; `refuted` if one is violated for all
/// parameters.
struct ImpactSight {
    std::optional<Branch> itinerary;
    bool refuted = false;

    /// Something has to be positive. @return whether it is
    bool needs(const Ranging& x) {
        refuted = refuted || is_negative(x);
        return is_positive(x);
    }
};

/// A contact that sticks: all velocities are in proportion to the impulse p = 2Qc, so that the inequalities are asked
/// of what is left without it (map/steady/README.md, "One equation"): u_t = 2Qs before, p_k = kp, u_n = (1 − ε)p
/// before.
ImpactSight sticking_impact(const SceneIn<Ranging>& scene, const SteadyInBalls<Ranging>& at, int step) {
    ImpactSight sight;
    const Ranging one(1), size = abs(at.s), grip = scene.mu * at.c - size;
    const Ranging slowing = scene.mu * (scene.kappa + square(at.c)) - size * at.c;  // κ(μB₁ − |B₃|): it holds, too
    const Ranging slipping = scene.kappa + size * (size - scene.mu * at.c);         // κ(B₂ − μ|B₃|)
    const bool holds = sight.needs(grip) && sight.needs(slowing);
    if (!holds || contains_zero(at.s)) return sight;
    const Ranging share = stop_share(scene, at), epsilon = Ranging(0.5) * (one - deficit(scene, at, false));
    const Ranging d = square(at.s) / (scene.kappa + square(at.c));
    const Ranging order = epsilon - (one + d) * (one - share);  // C where slip stops, over p
    if (!sight.needs(one - share) || !sight.needs(one - epsilon) || contains_zero(order)) return sight;
    const bool early = is_negative(order);
    if (!early && !sight.needs(slipping)) return sight;
    sight.itinerary =
        Branch{step, early ? ContactMode::c_sticking : ContactMode::r_sticking, is_positive(at.s) ? 1 : -1};
    return sight;
}

/// u_n = p/(1 + e) before, for B₂ − sμB₃ = 1; u_t falls by 2Q|s| and must not come to 0.
ImpactSight sliding_impact(const SceneIn<Ranging>& scene, ContactSet set, const BallPoint<Ranging>& z, int step) {
    ImpactSight sight;
    if (sight.needs(Ranging(slip_of(set)) * kinematics(scene, z).ut))
        sight.itinerary = Branch{step, ContactMode::sliding, slip_of(set)};
    return sight;
}

ImpactSight impact_of(const SceneIn<Ranging>& scene, const SolutionBranch& branch, const BallPoint<Ranging>& z,
                      const Ranging& tau, const Ranging& phi) {
    const int step = static_cast<int>(((branch.j % scene.sides) + scene.sides) % scene.sides);
    const auto set = ContactSet(branch.set);
    const auto at = steady_on<Ranging>(scene, set, tau, phi);
    ImpactSight pushed;  // R > 0 and no whole turns of the swirl: p > 0
    if (!pushed.needs(at.radius) ||
        !pushed.needs(sine_cosine(Ranging(0.5) * tau).sine * sine_cosine(Ranging(0.5) * tau).sine))
        return pushed;
    return is_sliding(set) ? sliding_impact(scene, set, z, step) : sticking_impact(scene, at, step);
}

/// F(z) = z holds by the two equations; an enclosure that excludes it would be wrong.
bool closes(const SceneIn<Ranging>& scene, const Branch& itinerary, const BallPoint<Ranging>& z, const Ranging& tau) {
    const BallStep<Ranging> step = step_in_balls<Ranging>(scene, itinerary, tau.mid, z, tau);
    return contains_zero(step.gap) && contains_zero(step.after.vn - z.vn) && contains_zero(step.after.vt - z.vt) &&
           contains_zero(step.after.spin - z.spin);
}

/// How many multipliers lie inside the unit circle. With F(z, τ) and the gap g(z, τ), DF − λ is what elimination leaves
/// of (F_z − λ, F_τ; g_z, g_τ), whose determinant is g_τ det(DF − λ).
std::optional<int> multipliers_inside(const SceneIn<Ranging>& scene, const Branch& itinerary,
                                      const BallPoint<Ranging>& z, const Ranging& tau) {
    const BallPoint<StepSlopes> at{StepSlopes::variable(z.psi, 0), StepSlopes::variable(z.chi, 1),
                                   StepSlopes::variable(z.vn, 2), StepSlopes::variable(z.vt, 3),
                                   StepSlopes::variable(z.spin, 4)};
    const BallStep<StepSlopes> step =
        step_in_balls<StepSlopes>(scene, itinerary, tau.mid, at, StepSlopes::variable(tau, 5));
    intervals::CurvedMatrix a, b;
    for (const StepSlopes* row :
         {&step.after.psi, &step.after.chi, &step.after.vn, &step.after.vt, &step.after.spin, &step.gap}) {
        a.emplace_back(row->by.begin(), row->by.end());
        const std::size_t i = b.size();
        b.emplace_back(coordinates + 1);
        if (i < coordinates) b.back()[i] = Ranging(-1);
    }
    return intervals::zeros_inside(a, b);
}

}  // namespace

cells::BranchStanding standing_of(const PlaneScene& plane, const cells::ParameterCell& cell,
                                  const cells::SolutionBranch& branch) {
    using cells::BranchStanding;
    const Ranging tau = cells::on_curved_branch(cell, branch, 0, branch.close[0]);
    const Ranging phi = cells::on_curved_branch(cell, branch, 1, branch.close[1]);
    if (lower(tau) > plane.max_time) return BranchStanding::no_fixed_point();
    const auto scene = scene_over<Ranging>(plane, cell, 0);
    const auto set = ContactSet(branch.set);
    const BallPoint<Ranging> z = section_point_of<Ranging>(scene, set, branch.j, tau, phi);
    const ImpactSight impact = impact_of(scene, branch, z, tau, phi);
    if (impact.refuted) return BranchStanding::no_fixed_point();
    const auto timed = scene_over<Timed>(plane, cell, 0);
    const auto timed_tau = cells::on_branch<Timed>(cell, branch, 0, 0, branch.near[0]);
    const auto timed_phi = cells::on_branch<Timed>(cell, branch, 1, 0, branch.near[1]);
    const BallPoint<Timed> start = section_point_of<Timed>(timed, set, branch.j, timed_tau, timed_phi);
    const Verdict flight = clear_over_cell(timed, start, timed_tau, branch.j);
    if (flight == Verdict::refuted) return BranchStanding::no_fixed_point();
    if (!(upper(tau) <= plane.max_time)) return BranchStanding::doubtful(Doubt::longest_flight);
    if (!impact.itinerary || !closes(scene, *impact.itinerary, z, tau))
        return BranchStanding::doubtful(Doubt::contact_mode);
    if (flight != Verdict::proven) return BranchStanding::doubtful(Doubt::clearance);
    const auto inside = multipliers_inside(scene, *impact.itinerary, z, tau);
    if (!inside) return BranchStanding::doubtful(Doubt::stability);
    return BranchStanding::fixed_point(static_cast<int>(coordinates) - *inside, *inside);
}

}  // namespace swirl::proof
