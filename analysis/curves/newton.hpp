// Newton's method, whatever the unknowns are: one point of a cycle, all k at once, and what else a curve asks for.
#pragma once

#include "analysis/curves/shooting_residual.hpp"

#include <functional>
#include <optional>

namespace swirl::analysis {

/// How a search for a solution, or for the next point of a curve, ends.
enum class Correction {
    converged,
    itinerary_changed,  ///< converged on another smooth branch of the map
    map_ended,          ///< the map ends on the way
    failed,             ///< no solution found, or one so far from where the tangent led that it lies on another curve
};

/// When the method ends. What it is judged by, its size, is max |H|, or the length √(Σ w_i δy_i²) of its step.
struct NewtonRule {
    Eigen::VectorXd weights;  ///< w, of steps; empty: |H| is the size
    double goal = 0;          ///< it has converged as soon as the size is that small …
    double accept = 0;  ///< … and where the size no longer halves and is that small (|H|: or as rounding leaves it)
    int most_iterations = 12;  ///< quadratic: 3 or 4 are usual
    int may_rise_until = 4;    ///< after this iteration it fails where the size does not fall
    /// Until rounding stops it: what is kept is the best y, what does not fall is one no better than that, and
    /// `accept` is not asked.
    bool keeps_best = false;
    double most_rise = 0;  ///< it fails where the size is so many times the best before (0: it may rise)
};

/// |H| as small as rounding lets it be, or `goal`.
NewtonRule until_rounding(double goal);

struct NewtonResult {
    Correction outcome = Correction::failed;
    double least = infinity;  ///< the smallest size; +∞ if the map ends at the start
};

/// Solves H(y) = 0 from y, which becomes the last y whose equations `at` are, or the best.
///   step_at  the step from y, of what the equations say there
/// Cost: the equations and a step an iteration.
NewtonResult newton(const Equations& equations,
                    const std::function<Eigen::VectorXd(const Eigen::VectorXd& y, const ShootingResidual& at)>& step_at,
                    const NewtonRule& rule, Eigen::VectorXd& y, ShootingResidual& at);

/// By steps of minimum norm: where solutions are no points but families (singular values below 10⁻⁹ of the largest) the
/// member near the start is found. Returns the smallest size.
double newton_of_least_norm(const Equations& equations, Eigen::VectorXd& y, const NewtonRule& rule);

/// As many equations as unknowns. Empty if the method leaves the ball of radius 0.1 around the start or has not
/// converged after 20 steps.
std::optional<Eigen::VectorXd> solve_square_system(const Equations& equations, const Eigen::VectorXd& start);

}  // namespace swirl::analysis
