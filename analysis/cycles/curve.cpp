#include "analysis/cycles/curve.hpp"

#include "analysis/cycles/null_space.hpp"
#include "analysis/linear_algebra/dense.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl::analysis {

namespace {

/// Distances on a curve below which cycles are not told apart: a base may itself be off by the root of rounding (at a
/// fold).
constexpr double indistinct = 1e-7;

Eigen::Index unknowns_of(const ShootingMap& map, const ShootingResidual& shooting) {
    return shooting.gap.size() + (map.has_parameter ? 1 : 0);
}

/// The weights of the curve's product: 1/k for coordinates, 1 for the parameter.
Eigen::VectorXd weights(Eigen::Index size, bool has_parameter, std::size_t k) {
    Eigen::VectorXd w = Eigen::VectorXd::Constant(size, 1.0 / static_cast<double>(k));
    if (has_parameter) w[size - 1] = 1;
    return w;
}

Eigen::MatrixXd jacobian(const ShootingMap& map, const ShootingResidual& shooting) {
    Eigen::MatrixXd j(shooting.gap.size(), unknowns_of(map, shooting));
    j.leftCols(shooting.gap.size()) = shooting.by_points;
    if (map.has_parameter) j.rightCols(1) = shooting.by_parameter;
    return j;
}

/// The null vector of the Jacobian that has a positive product with `along`; false unless it is well defined.
bool find_tangent(const ShootingMap& map, const ShootingResidual& shooting, const Eigen::VectorXd& along,
                  Eigen::VectorXd& tangent) {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(shooting.gap.size() + 1);
    right[shooting.gap.size()] = 1;
    tangent = solve_by_qr(bordered(map, shooting, along), right);
    const double length = std::sqrt(curve_product(tangent, tangent, map.has_parameter, shooting.steps.size()));
    if (!std::isfinite(length) || length == 0) return false;
    tangent /= length;
    return true;
}

/// A direction that the curve has a part of: the null vector of the Jacobian's smallest singular value.
Eigen::VectorXd null_direction(const ShootingMap& map, const ShootingResidual& shooting) {
    const SingularVectors svd = right_singular_vectors(jacobian(map, shooting));
    Eigen::VectorXd direction = svd.right.rightCols(1);
    Eigen::Index lead = direction.size() - 1;
    if (!map.has_parameter || std::abs(direction[lead]) < 1e-6) direction.cwiseAbs().maxCoeff(&lead);
    if (direction[lead] < 0) direction *= -1;
    return direction;
}

}  // namespace

double curve_product(const Eigen::VectorXd& a, const Eigen::VectorXd& b, bool has_parameter, std::size_t k) {
    return a.cwiseProduct(weights(a.size(), has_parameter, k)).dot(b);
}

Eigen::MatrixXd bordered(const ShootingMap& map, const ShootingResidual& shooting, const Eigen::VectorXd& tangent) {
    const Eigen::MatrixXd j = jacobian(map, shooting);
    Eigen::MatrixXd full(j.rows() + 1, j.cols());
    full.topRows(j.rows()) = j;
    full.bottomRows(1) =
        tangent.cwiseProduct(weights(tangent.size(), map.has_parameter, shooting.steps.size())).transpose();
    return full;
}

bool is_on_curve(const ShootingMap& map, const ShootingResidual& shooting) {
    Eigen::MatrixXd scaled = jacobian(map, shooting);
    equilibrate(scaled);
    return rank_of(scaled, null_margin) == scaled.cols() - 1;
}

bool begin_curve(const ShootingMap& map, const CyclePoints& points, double p, const Eigen::VectorXd& previous,
                 CurvePoint& point) {
    point.points = points;
    point.p = p;
    point.shooting = shooting_residual(map, points, p);
    if (!point.shooting.alive) return false;
    const Eigen::VectorXd along = previous.size() > 0 ? previous : null_direction(map, point.shooting);
    return find_tangent(map, point.shooting, along, point.tangent);
}

namespace {

Correction correct_by(const ShootingMap& map, const CurvePoint& base, double h, CurvePoint& point,
                      const CorrectorOptions& options) {
    const Eigen::Index size = base.shooting.gap.size();
    Eigen::VectorXd origin(base.tangent.size());
    origin.head(size) = stacked(base.points);
    if (map.has_parameter) origin[size] = base.p;
    Eigen::VectorXd y = origin + h * base.tangent;
    double last = infinity;
    for (int i = 0; i < options.most_iterations; ++i) {
        point.points = unstacked(y.head(size), map.dimension);
        point.p = map.has_parameter ? y[size] : base.p;
        point.shooting = shooting_residual(map, point.points, point.p);
        if (!point.shooting.alive) return Correction::map_ended;
        const double residual = point.shooting.residual();
        if (residual <= options.goal || (residual >= 0.5 * last && closes_to(point.shooting, options.accept))) {
            if (options.keep_word && word_of(point.shooting) != word_of(base.shooting)) return Correction::word_changed;
            const Eigen::VectorXd aside = y - origin - h * base.tangent;
            const double away = std::sqrt(curve_product(aside, aside, map.has_parameter, base.points.size()));
            if (away > options.farthest * std::abs(h) + indistinct) return Correction::failed;
            return find_tangent(map, point.shooting, base.tangent, point.tangent) ? Correction::converged
                                                                                  : Correction::failed;
        }
        if (i > 4 && residual >= last) return Correction::failed;
        last = residual;
        Eigen::VectorXd right(size + 1);
        right.head(size) = -point.shooting.gap;
        right[size] = h - curve_product(base.tangent, y - origin, map.has_parameter, base.points.size());
        const Eigen::VectorXd change = solve_by_qr(bordered(map, point.shooting, base.tangent), right);
        if (!change.allFinite()) return Correction::failed;
        y += change;
    }
    return Correction::failed;
}

/// By guesses on the map's surfaces; what is found must be a cycle of the map itself, with the same word.
Correction correct_on_surface(const ShootingMap& map, const CurvePoint& base, double h, CurvePoint& point,
                              const CorrectorOptions& options) {
    ShootingMap on_surface = map;
    on_surface.step = map.step_from_surface;
    const Correction result = correct_by(on_surface, base, h, point, options);
    if (result != Correction::converged) return result;
    point.shooting = shooting_residual(map, point.points, point.p);
    if (!closes_to(point.shooting, options.accept)) return Correction::failed;
    const bool same_word = word_of(point.shooting) == word_of(base.shooting);
    return options.keep_word && !same_word ? Correction::word_changed : Correction::converged;
}

}  // namespace

Correction correct(const ShootingMap& map, const CurvePoint& base, double h, CurvePoint& point,
                   const CorrectorOptions& options) {
    const Correction result = correct_by(map, base, h, point, options);
    if (result == Correction::converged || !map.step_from_surface) return result;
    CurvePoint other;
    if (correct_on_surface(map, base, h, other, options) != Correction::converged) return result;
    point = std::move(other);
    return Correction::converged;
}

}  // namespace swirl::analysis
