#include "analysis/curves/curve.hpp"

#include "analysis/linear_algebra/dense.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

namespace swirl::analysis {

namespace {

/// Distances on a curve below which points are not told apart: a base may itself be off by the root of rounding (at a
/// fold).
constexpr double indistinct = 1e-7;

Correction correct_by(const Equations& equations, const CurveProblem& problem, const CurvePoint& base, double h,
                      double farthest, CurvePoint& point) {
    const Eigen::VectorXd predicted = base.y + h * base.tangent;
    const auto step = [&](const Eigen::VectorXd& y, const ShootingResidual& at) -> Eigen::VectorXd {
        Eigen::VectorXd right(at.gap.size() + 1);
        right.head(at.gap.size()) = -at.gap;
        right[at.gap.size()] = h - problem.product(base.tangent, y - base.y);
        return solve_by_qr(bordered(problem, at, base.tangent), right);
    };
    point.y = predicted;
    const Correction outcome = newton(equations, step, problem.newton, point.y, point.shooting).outcome;
    if (outcome != Correction::converged) return outcome;
    if (problem.keeps_itinerary && point.shooting.itinerary != base.shooting.itinerary)
        return Correction::itinerary_changed;
    if (problem.length(point.y - predicted) > farthest * std::abs(h) + indistinct) return Correction::failed;
    return find_tangent(problem, base.tangent, point) ? Correction::converged : Correction::failed;
}

/// By guesses on the map's surfaces; what is found must solve the equations themselves, with the same itinerary.
bool correct_on_surface(const CurveProblem& problem, const CurvePoint& base, double h, double farthest,
                        CurvePoint& point) {
    if (correct_by(problem.equations_from_surface, problem, base, h, farthest, point) != Correction::converged)
        return false;
    point.shooting = problem.equations(point.y);
    return closes_to(point.shooting, problem.newton.accept) &&
           (!problem.keeps_itinerary || point.shooting.itinerary == base.shooting.itinerary);
}

}  // namespace

double CurveProblem::length(const Eigen::VectorXd& y) const {
    return std::sqrt(product(y, y));
}

CurveProblem augmented_problem(Eigen::VectorXd weights, Equations equations) {
    CurveProblem problem{std::move(weights), std::move(equations)};
    problem.newton.weights = problem.weights;
    problem.newton.goal = 1e-14;
    problem.newton.accept = 1e-9;
    problem.newton.most_iterations = 14;
    problem.locate.has_poles = true;
    return problem;
}

CyclePoints CurvePoint::points() const {
    return unstacked(y.head(shooting.coordinates()), shooting.dimension);
}

Eigen::MatrixXd bordered(const CurveProblem& problem, const ShootingResidual& at, const Eigen::VectorXd& tangent) {
    Eigen::MatrixXd full(at.jacobian.rows() + 1, at.jacobian.cols());
    full.topRows(at.jacobian.rows()) = at.jacobian;
    full.bottomRows(1) = tangent.cwiseProduct(problem.weights).transpose();
    return full;
}

bool find_tangent(const CurveProblem& problem, const Eigen::VectorXd& along, CurvePoint& point) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(point.shooting.gap.size() + 1);
    right[point.shooting.gap.size()] = 1;
    point.tangent = solve_by_qr(bordered(problem, point.shooting, along), right);
    const double length = problem.length(point.tangent);
    if (!std::isfinite(length) || length == 0) return false;
    point.tangent /= length;
    return true;
}

bool find_point(const CurveProblem& problem, const Eigen::VectorXd& guess, const Eigen::VectorXd& along,
                double farthest, CurvePoint& point) {
    constexpr double small = 1e-10;
    const Eigen::VectorXd scale = problem.weights.cwiseSqrt().cwiseInverse();
    const auto scaled = [&](const ShootingResidual& at) -> Eigen::MatrixXd { return at.jacobian * scale.asDiagonal(); };
    const auto step = [&](const Eigen::VectorXd&, const ShootingResidual& at) -> Eigen::VectorXd {
        return scale.cwiseProduct(minimum_norm_solution(scaled(at), -at.gap, small));
    };
    point.y = guess;
    if (newton(problem.equations, step, problem.newton, point.y, point.shooting).outcome != Correction::converged)
        return false;
    if (!(problem.length(point.y - guess) <= farthest)) return false;
    Eigen::VectorXd direction = scale.cwiseProduct(right_singular_vectors(scaled(point.shooting)).right.rightCols(1));
    if (problem.product(direction, along) < 0) direction *= -1;
    return find_tangent(problem, direction, point);
}

Correction correct(const CurveProblem& problem, const CurvePoint& base, double h, CurvePoint& point, double farthest) {
    const Correction outcome = correct_by(problem.equations, problem, base, h, farthest, point);
    if (outcome == Correction::converged || !problem.equations_from_surface) return outcome;
    CurvePoint other;
    if (!correct_on_surface(problem, base, h, farthest, other)) return outcome;
    point = std::move(other);
    return Correction::converged;
}

bool passes(const CurveProblem& problem, const CurvePoint& base, double h, const CurvePoint& target) {
    constexpr double same = 1e-7;  // both are known to 10⁻⁹ or better
    const double along = problem.product(base.tangent, target.y - base.y);
    if (!(along > 0) || !(along <= h)) return false;
    CurvePoint at;
    if (correct(problem, base, along, at) != Correction::converged) return false;
    return problem.length(at.y - target.y) <= same && problem.product(at.tangent, target.tangent) > 0;
}

bool locate(const CurveProblem& problem, const CurvePoint& base, double h, double f0, double f1,
            const std::function<double(const CurvePoint&)>& value, CurvePoint& found) {
    if (!(f0 * f1 < 0)) return false;
    bool failed = false;
    const auto at = [&](double s) {
        if (!failed && correct(problem, base, s, found) == Correction::converged)
            if (const double f = value(found); std::isfinite(f)) return f;
        failed = true;
        return 0.0;  // ends the search
    };
    const LocateRule& rule = problem.locate;
    std::uintmax_t most = rule.most_trials;
    const auto [low, high] = boost::math::tools::toms748_solve(
        at, 0.0, h, f0, f1, boost::math::tools::eps_tolerance<double>(static_cast<unsigned>(rule.bits)), most);
    const double f = at(rule.takes_middle ? 0.5 * (low + high) : low);
    return !failed && (!rule.has_poles || std::abs(f) <= 1e-3 * std::max(std::abs(f0), std::abs(f1)));
}

}  // namespace swirl::analysis
