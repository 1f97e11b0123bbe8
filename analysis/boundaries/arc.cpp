#include "analysis/boundaries/arc.hpp"

#include "analysis/linear_algebra/dense.hpp"
#include "analysis/special_values.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace swirl::analysis {

namespace {

/// A step of Newton's method that is no more than the rounding of well-conditioned unknowns …
constexpr double least_rounding = 1e-14;
/// … and one that is accepted where rounding stops the method: what large multipliers leave of it.
constexpr double most_rounding = 1e-9;

double length(const ArcSystem& system, const Eigen::VectorXd& y) {
    return std::sqrt(system.product(y, y));
}

/// The Jacobian with one more row: the tangent's.
Eigen::MatrixXd bordered(const ArcSystem& system, const ArcEquations& at, const Eigen::VectorXd& tangent) {
    Eigen::MatrixXd full(at.jacobian.rows() + 1, at.jacobian.cols());
    full.topRows(at.jacobian.rows()) = at.jacobian;
    full.bottomRows(1) = tangent.cwiseProduct(system.weights).transpose();
    return full;
}

bool find_tangent(const ArcSystem& system, const Eigen::VectorXd& along, ArcPoint& point) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(along.size());
    right[along.size() - 1] = 1;
    point.tangent = solve_by_qr(bordered(system, point.at, along), right);
    const double size = length(system, point.tangent);
    if (!std::isfinite(size) || size == 0) return false;
    point.tangent /= size;
    return true;
}

/// Newton's method with `step_at` for its steps; the point is the last one whose equations were worked out.
Correction solve(const ArcSystem& system, Eigen::VectorXd y, ArcPoint& point,
                 const std::function<Eigen::VectorXd(const ArcPoint&)>& step_at) {
    constexpr int most = 14;
    double last = infinity;
    for (int i = 0; i < most; ++i) {
        point.y = y;
        if (!system.equations(point.y, point.at)) return Correction::map_ended;
        const Eigen::VectorXd step = step_at(point);
        const double size = length(system, step);
        if (!std::isfinite(size)) return Correction::failed;
        if (size <= least_rounding || (size >= 0.5 * last && size <= most_rounding)) return Correction::converged;
        if (i > 4 && size >= last) return Correction::failed;
        last = size;
        y += step;
    }
    return Correction::failed;
}

}  // namespace

double outside_plane(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Eigen::Vector2d& p) {
    if (!p.allFinite()) return infinity;
    const Eigen::Array2d width = (high - low).array();
    return ((low - p).array() / width).max((p - high).array() / width).maxCoeff();
}

bool begin_arc(const ArcSystem& system, const Eigen::VectorXd& guess, const Eigen::VectorXd& along, double farthest,
               ArcPoint& point) {
    constexpr double small = 1e-10;
    const Eigen::VectorXd scale = system.weights.cwiseSqrt().cwiseInverse();  // steps of least arclength
    const auto step = [&](const ArcPoint& at) -> Eigen::VectorXd {
        const Eigen::MatrixXd scaled = at.at.jacobian * scale.asDiagonal();
        return scale.cwiseProduct(minimum_norm_solution(scaled, -at.at.residual, small));
    };
    if (solve(system, guess, point, step) != Correction::converged) return false;
    if (!(length(system, point.y - guess) <= farthest)) return false;
    const Eigen::MatrixXd scaled = point.at.jacobian * scale.asDiagonal();
    Eigen::VectorXd direction = scale.cwiseProduct(right_singular_vectors(scaled).right.rightCols(1));
    if (system.product(direction, along) < 0) direction *= -1;
    return find_tangent(system, direction, point);
}

Correction correct(const ArcSystem& system, const ArcPoint& base, double h, ArcPoint& point, bool keep_word) {
    const Eigen::VectorXd predicted = base.y + h * base.tangent;
    const auto step = [&](const ArcPoint& at) -> Eigen::VectorXd {
        Eigen::VectorXd right(predicted.size());
        right.head(right.size() - 1) = -at.at.residual;
        right[right.size() - 1] = h - system.product(base.tangent, at.y - base.y);
        return solve_by_qr(bordered(system, at.at, base.tangent), right);
    };
    const Correction outcome = solve(system, predicted, point, step);
    if (outcome != Correction::converged) return outcome;
    if (keep_word && point.at.word != base.at.word) return Correction::word_changed;
    constexpr double farthest = 0.5, indistinct = 1e-7;  // as of CorrectorOptions
    if (length(system, point.y - predicted) > farthest * std::abs(h) + indistinct) return Correction::failed;
    return find_tangent(system, base.tangent, point) ? Correction::converged : Correction::failed;
}

bool passes(const ArcSystem& system, const ArcPoint& base, double h, const ArcPoint& target, bool keep_word) {
    constexpr double same = 1e-7;  // both are known to `most_rounding` or better
    const double along = system.product(base.tangent, target.y - base.y);
    if (!(along > 0) || !(along <= h)) return false;
    ArcPoint at;
    if (correct(system, base, along, at, keep_word) != Correction::converged) return false;
    return length(system, at.y - target.y) <= same && system.product(at.tangent, target.tangent) > 0;
}

bool locate(const ArcSystem& system, const ArcPoint& base, double h, double f0, double f1,
            const std::function<double(const ArcPoint&)>& value, ArcPoint& found, bool keep_word) {
    if (!(f0 * f1 < 0)) return false;
    bool failed = false;
    const auto at = [&](double s) {
        if (!failed && correct(system, base, s, found, keep_word) == Correction::converged)
            if (const double f = value(found); std::isfinite(f)) return f;
        failed = true;
        return 0.0;  // ends the search
    };
    std::uintmax_t most = 60;
    const auto [low, high] =
        boost::math::tools::toms748_solve(at, 0.0, h, f0, f1, boost::math::tools::eps_tolerance<double>(50), most);
    const double f = at(0.5 * (low + high));
    return !failed && std::abs(f) <= 1e-3 * std::max(std::abs(f0), std::abs(f1));
}

}  // namespace swirl::analysis
