#include "analysis/continuation/switch_branch.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/linear_algebra/dense.hpp"

#include <cmath>

namespace swirl::analysis {

namespace {

/// At a flip: the cycle run through twice, and the direction in which the two rounds part.
bool doubled(const ShootingMap& map, const SpecialPoint& flip, CurvePoint& base) {
    const CurvePoint& at = flip.cycle.at;
    Eigen::VectorXd q = eigen_pair(monodromy(at.shooting), -1).right.real();
    std::vector<Eigen::VectorXd> directions;
    for (int round = 0; round < 2; ++round)
        for (const auto& step : at.shooting.steps) {
            directions.push_back(q);
            q = step.by_state * q;
        }
    base.p = at.p;
    base.points = at.points;
    base.points.insert(base.points.end(), at.points.begin(), at.points.end());
    base.shooting = shooting_residual(map, base.points, base.p);
    if (!base.shooting.alive) return false;
    base.tangent = Eigen::VectorXd::Zero(base.shooting.gap.size() + 1);
    base.tangent.head(base.shooting.gap.size()) = stacked(directions);
    return true;
}

/// At a branch point ∂G/∂(Z, p) has two null vectors: the direction in their plane across the known branch.
bool crossing(const ShootingMap& map, const SpecialPoint& special, CurvePoint& base) {
    base = special.cycle.at;
    const Eigen::MatrixXd full = bordered(map, base.shooting, base.tangent);
    const SingularVectors svd = right_singular_vectors(full.topRows(full.rows() - 1));
    const Eigen::MatrixXd plane = svd.right.rightCols(2);
    const Eigen::Vector2d known = plane.transpose() * base.tangent;
    base.tangent = plane * Eigen::Vector2d(-known[1], known[0]);
    return base.tangent.norm() > 0;
}

}  // namespace

bool switch_branch(const ShootingMap& map, const SpecialPoint& special, const ContinuationOptions& options,
                   Branch& branch, const std::function<bool(const CurvePoint&)>& is_known) {
    CurvePoint base;
    const bool flip = special.kind == SpecialKind::flip;
    if (flip ? !doubled(map, special, base) : !crossing(map, special, base)) return false;
    base.tangent /= std::sqrt(curve_product(base.tangent, base.tangent, true, base.points.size()));
    bool any = false;
    for (const double sign : {1.0, -1.0}) {
        // Far enough to leave the neighbourhood where both branches solve the equations to rounding.
        for (double h = options.first_step; h > 1e-6; h *= 0.25) {
            CurvePoint start;
            CorrectorOptions corrector;
            corrector.most_iterations = 20;
            corrector.farthest = 10;  // the direction lies across the known branch, not along the one sought
            if (correct(map, base, sign * h, start, corrector) != Correction::converged) continue;
            if (!flip && std::abs(curve_product(start.tangent, special.cycle.at.tangent, true, base.points.size())) >
                             least_cosine)
                continue;  // the known branch again
            if (flip && minimal_cycle(map, start.points, 0.1 * h).size() < start.points.size()) continue;
            if (curve_product(start.tangent, base.tangent, true, base.points.size()) * sign < 0) start.tangent *= -1;
            if (is_known && is_known(start)) break;
            Branch half;
            follow_one_way(map, start, options, half);
            half.begin = BranchEnd::switched;
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
