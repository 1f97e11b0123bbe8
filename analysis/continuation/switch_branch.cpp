#include "analysis/continuation/switch_branch.hpp"

#include "analysis/cycles/family.hpp"
#include "analysis/linear_algebra/dense.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace swirl::analysis {

namespace {

/// At a flip: the cycle run through twice, and the direction in which the two rounds part.
bool doubled(const ShootingMap& map, const SpecialPoint& flip, CurvePoint& base) {
    const CurvePoint& at = flip.cycle.at;
    const Eigen::Index n = at.shooting.coordinates(), d = map.dimension;
    base.y.resize(2 * n + 1);
    base.y << at.y.head(n), at.y.head(n), at.p();
    base.shooting = cycle_problem(map, 2 * at.shooting.period, at.p()).equations(base.y);
    if (!base.shooting.alive) return false;
    Eigen::VectorXd q = eigen_pair(monodromy(at.shooting), -1).right.real();
    base.tangent = Eigen::VectorXd::Zero(2 * n + 1);
    for (Eigen::Index i = 0; i < 2 * n; i += d) {
        base.tangent.segment(i, d) = q;
        q = at.shooting.steps[static_cast<std::size_t>(i % n / d)].by_state * q;
    }
    return true;
}

/// At a branch point ∂G/∂(Z, p) has two null vectors: the direction in their plane across the known branch.
bool crossing(const SpecialPoint& special, CurvePoint& base) {
    base = special.cycle.at;
    const Eigen::MatrixXd plane = right_singular_vectors(base.shooting.jacobian).right.rightCols(2);
    const Eigen::Vector2d known = plane.transpose() * base.tangent;
    base.tangent = plane * Eigen::Vector2d(-known[1], known[0]);
    return base.tangent.norm() > 0;
}

}  // namespace

bool switch_branch(const ShootingMap& map, const SpecialPoint& special, const ContinuationOptions& options,
                   Branch& branch, const std::function<bool(const CurvePoint&)>& is_known) {
    CurvePoint base;
    const bool flip = special.kind == SpecialKind::flip;
    if (flip ? !doubled(map, special, base) : !crossing(special, base)) return false;
    CurveProblem problem = cycle_problem(map, base.shooting.period, base.p());
    problem.newton.most_iterations = 20;
    base.tangent /= problem.length(base.tangent);
    constexpr double farthest = 10;  // the direction lies across the known branch, not along the one sought
    bool any = false;
    for (const double sign : {1.0, -1.0}) {
        // Far enough to leave the neighbourhood where both branches solve the equations to rounding.
        for (double h = options.first_step; h > 1e-6; h *= 0.25) {
            CurvePoint start;
            if (correct(problem, base, sign * h, start, farthest) != Correction::converged) continue;
            if (!flip && std::abs(problem.product(start.tangent, special.cycle.at.tangent)) > least_cosine)
                continue;  // the known branch again
            if (flip && minimal_cycle(map, start.points(), 0.1 * h).size() < start.shooting.period) continue;
            if (problem.product(start.tangent, base.tangent) * sign < 0) turn(start);
            if (is_known && is_known(start)) break;
            Branch half = follow_one_way(map, start, options);
            half.begin = CurveEnd::switched;
            if (!any)
                branch = std::move(half);
            else
                put_before(std::move(half), branch);
            any = true;
            break;
        }
        if (flip && any) return true;  // the other way is the same cycle begun half a period later
    }
    return any;
}

}  // namespace swirl::analysis
