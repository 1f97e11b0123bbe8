#include "analysis/curves/newton.hpp"

#include "analysis/linear_algebra/dense.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace swirl::analysis {

NewtonRule until_rounding(double goal) {
    NewtonRule rule;
    rule.goal = goal;
    rule.may_rise_until = 2;
    rule.keeps_best = true;
    return rule;
}

NewtonResult newton(const Equations& equations,
                    const std::function<Eigen::VectorXd(const Eigen::VectorXd& y, const ShootingResidual& at)>& step_at,
                    const NewtonRule& rule, Eigen::VectorXd& y, ShootingResidual& at) {
    NewtonResult result;
    const bool by_step = rule.weights.size() > 0;
    const auto is_accepted = [&](double size) {
        return at.rounding.size() > 0 && !by_step ? closes_to(at, rule.accept) : size <= rule.accept;
    };
    Eigen::VectorXd best = y, step;
    double last = infinity;
    for (int i = 0; i < rule.most_iterations; ++i) {
        at = equations(y);
        if (!at.alive) {
            result.outcome = Correction::map_ended;
            break;
        }
        if (by_step) step = step_at(y, at);
        const double size = by_step ? std::sqrt(step.cwiseProduct(rule.weights).dot(step)) : at.residual();
        if (!std::isfinite(size)) break;
        const bool falls = size < (rule.keeps_best ? result.least : last);
        if (size < result.least) {
            result.least = size;
            best = y;
        }
        if (size <= rule.goal || (!rule.keeps_best && size >= 0.5 * last && is_accepted(size))) {
            result.outcome = Correction::converged;
            break;
        }
        if (!falls && i > rule.may_rise_until) break;
        // Below 100 times the goal what rises is rounding.
        if (rule.most_rise > 0 && size > rule.most_rise * std::max(result.least, 100 * rule.goal)) break;
        last = size;
        if (!by_step) step = step_at(y, at);
        if (!step.allFinite()) break;
        y += step;
    }
    if (rule.keeps_best) y = best;
    return result;
}

double newton_of_least_norm(const Equations& equations, Eigen::VectorXd& y, const NewtonRule& rule) {
    constexpr double small = 1e-9;  // singular values below that of the largest are a family's
    ShootingResidual at;
    const auto step = [](const Eigen::VectorXd&, const ShootingResidual& here) {
        return minimum_norm_solution(here.jacobian, -here.gap, small);
    };
    return newton(equations, step, rule, y, at).least;
}

std::optional<Eigen::VectorXd> solve_square_system(const Equations& equations, const Eigen::VectorXd& start) {
    constexpr double farthest = 0.1;
    NewtonRule rule;
    rule.weights = Eigen::VectorXd::Ones(start.size());
    rule.goal = 1e-12;
    rule.accept = 1e-9;
    rule.most_iterations = rule.may_rise_until = 20;
    const auto nearby = [&](const Eigen::VectorXd& y) {
        return (y - start).norm() < farthest ? equations(y) : ShootingResidual{};
    };
    const auto step = [](const Eigen::VectorXd&, const ShootingResidual& at) {
        return solve_by_qr(at.jacobian, -at.gap);
    };
    Eigen::VectorXd y = start;
    ShootingResidual at;
    if (newton(nearby, step, rule, y, at).outcome != Correction::converged) return std::nullopt;
    return y;
}

}  // namespace swirl::analysis
