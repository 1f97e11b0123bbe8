#include "map/proof/steady_cells.hpp"

#include "map/cells/plane_search.hpp"
#include "map/proof/branch_standing.hpp"
#include "map/proof/cell_flight.hpp"
#include "map/proof/cell_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace swirl::proof {

namespace {

using cells::ParameterCell;
using cells::Ranged;
using intervals::is_negative;
using intervals::is_positive;
using intervals::lower;
using intervals::square;
using intervals::upper;
using Differentiated = intervals::Dual<2, Ranged>;

double largest(const Ranged& x) {
    return std::max(std::abs(lower(x)), std::abs(upper(x)));
}

/// sin χ_m: beyond it a neighbour is outside.
Ranged largest_sine(const SceneIn<Ranged>& scene) {
    const Ranged half = Ranged(0.5) * scene.spacing;
    return sine_cosine(half - asin(scene.alpha * sine_cosine(half).sine)).sine;
}

/// A flight that begins at 0: no solution where 1 − S has a sign and |j| < 1.
bool is_before_first(const SceneIn<Ranged>& scene, const Ranged& tau, const Ranged& one_less_spin) {
    if (lower(tau) > 0 || (!is_positive(one_less_spin) && !is_negative(one_less_spin))) return false;
    return largest(tau * one_less_spin / scene.spacing) < 1;
}

bool excluded_sticking(const SceneIn<Ranged>& scene, const Ranged& tau, const Ranged& phi) {
    const Ranged sine = scene.beta * sine_cosine(phi).sine, offset2 = square(sine), mu2 = square(scene.mu);
    if (is_positive(offset2 * (Ranged(1) + mu2) - mu2)) return true;  // |tan χ| > μ
    if (is_positive(offset2 - square(largest_sine(scene)))) return true;
    const auto at = steady_in_balls<Ranged>(scene, tau, phi);
    if (is_negative(at.radius)) return true;
    if (lower(tau) > 0) return false;
    const Ranged push = at.radius * versine_rate(tau);
    const Ranged spin = at.w - at.radius * sinc(tau) - at.s / at.c * (at.s - push);
    return is_before_first(scene, tau, Ranged(1) - spin / scene.alpha);
}

bool excluded_sliding(const SceneIn<Ranged>& scene, ContactSet set, const Ranged& tau, const Ranged& phi) {
    const KnownOffset<Ranged> offset = known_offset(scene, set);
    const Ranged sine = scene.beta * sine_cosine(phi).sine;
    if (is_positive(sine + offset.sine) || is_negative(sine + offset.sine)) return true;
    const Ranged width = scene.beta * sine_cosine(phi).cosine, radius = offset.cosine - scene.alpha + width;
    if (is_negative(radius) || is_positive(square(offset.sine) - square(largest_sine(scene)))) return true;
    if (lower(tau) > 0) return false;
    // (1 − S)/τ = (R/(αs)) (½ c sinc²(τ/2) (1 − e)/(1 + e) − s (1 − sinc τ)/τ), 0 < (1 − sinc τ)/τ² ≤ 1/6
    const Ranged lost = (Ranged(1) - scene.restitution) / (Ranged(1) + scene.restitution);
    const Ranged first = Ranged(0.5) * offset.cosine * square(sinc(Ranged(0.5) * tau)) * lost;
    const Ranged second = offset.sine * tau * Ranged(intervals::between(0, 1.0 / 6 * (1 + 1e-15)));
    const Ranged rate = radius / (scene.alpha * offset.sine) * (first - second);
    return (is_positive(rate) || is_negative(rate)) && largest(rate * square(tau) / scene.spacing) < 1;
}

class SteadyCell : public cells::CellEquations {
public:
    SteadyCell(const PlaneScene& plane, const ParameterCell& cell)
        : CellEquations(cell),
          plane_(plane),
          over_(scene_over<Ranged>(plane, cell, 2)),
          at_middle_(scene_over<Ranged>(plane, cell, 2, true)),
          curving_(scene_over<cells::Curving>(plane, cell, 0)) {}

    cells::Equations values(int set, const Ranged& tau, const Ranged& x) const override {
        const auto at = solution_equations<Ranged>(over_, ContactSet(set), tau, x);
        return {at.f, at.j};
    }
    cells::CurvedEquations curved(int set, const cells::Curving& tau, const cells::Curving& x) const override {
        const auto at = solution_equations<cells::Curving>(curving_, ContactSet(set), tau, x);
        return {at.f, at.j};
    }
    cells::LinearEquations linear(int set, const Ranged& tau, const Ranged& x, bool at_middle) const override {
        const auto at =
            solution_equations<Differentiated>(at_middle ? at_middle_ : over_, ContactSet(set),
                                               Differentiated::variable(tau, 0), Differentiated::variable(x, 1));
        return {at.f.value, at.j.value, {at.f.by, at.j.by}};
    }
    bool is_excluded(int set, const Ranged& tau, const Ranged& x) const override {
        return ContactSet(set) == ContactSet::sticking ? excluded_sticking(over_, tau, x)
                                                       : excluded_sliding(over_, ContactSet(set), tau, x);
    }
    bool is_met_earlier(int set, long j, const Ranged& tau, const Ranged& x) const override {
        return is_met_at_a_moment(over_, section_point_of<Ranged>(over_, ContactSet(set), j, tau, x), tau, j);
    }
    cells::BranchStanding standing_of(const cells::SolutionBranch& branch) const override {
        return proof::standing_of(plane_, cell(), branch);
    }

private:
    PlaneScene plane_;
    SceneIn<Ranged> over_, at_middle_;
    SceneIn<cells::Curving> curving_;
};

/// Sets are those of ContactSet; the second unknown is φ = ψ + χ.
cells::PlaneProblem plane_problem(const PlaneScene& scene) {
    cells::PlaneProblem problem;
    problem.over = [scene](const ParameterCell& cell) { return std::make_unique<SteadyCell>(scene, cell); };
    const double pi_up = upper(intervals::pi_ball());
    for (const ContactSet set : {ContactSet::sticking, ContactSet::sliding_ahead, ContactSet::sliding_back})
        for (const double from : {-0.5, 0.5})  // around φ = 0, and around π
            problem.unknowns.push_back(
                {static_cast<int>(set), {0, from * pi_up}, {scene.max_time, (from + 1) * pi_up}});
    return problem;
}

}  // namespace

cells::PlanePiece proven_piece(const PlaneScene& scene, const ParameterCell& piece, const cells::PlaneLimits& limits,
                               const std::function<bool()>& stop) {
    return cells::prove_piece(plane_problem(scene), piece, limits, stop);
}

}  // namespace swirl::proof
