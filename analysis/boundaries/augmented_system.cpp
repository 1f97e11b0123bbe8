#include "analysis/boundaries/augmented_system.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;

Eigen::MatrixXcd cyclic_matrix(const ShootingResidual& shooting, Complex multiplier) {
    const auto k = static_cast<Eigen::Index>(shooting.steps.size());
    const Eigen::Index d = shooting.steps.front().by_state.rows();
    Eigen::MatrixXcd m = Eigen::MatrixXcd::Zero(k * d, k * d);
    for (Eigen::Index i = 0; i < k; ++i) {
        const Eigen::Index next = (i + 1) % k;
        m.block(i * d, i * d, d, d) += shooting.steps[static_cast<std::size_t>(i)].by_state.cast<Complex>();
        const Complex closing = i + 1 == k ? multiplier : Complex(1);
        m.block(i * d, next * d, d, d) -= closing * Eigen::MatrixXcd::Identity(d, d);
    }
    return m;
}

constexpr double usual_step = 1e-5;  // rounding/step and step² are both 10⁻¹⁰ or so

/// Over which differences are taken at a step of the map with this margin.
double difference_step(double margin, double steep_below) {
    if (!(margin < steep_below)) return usual_step;
    constexpr double least = 1e-9;  // rounding of DF, 10⁻¹⁶ of it, is 10⁻⁷ of its change
    const double share = margin / steep_below;
    return std::max(least, share * share * usual_step);
}

/// D²F(z; p)(u, ·) and ∂/∂p DF(z; p) u, as one D × (D + 2) matrix, for a real direction u.
std::optional<Eigen::MatrixXd> change_along(const PlaneMap& map, const Eigen::VectorXd& z, const Eigen::Vector2d& p,
                                            std::int64_t letter, const Eigen::VectorXd& u, double step) {
    const Eigen::Index d = z.size();
    const double size = u.norm();
    if (size == 0) return Eigen::MatrixXd::Zero(d, d + 2);
    const auto both = [d](const ShootingStep& at) {
        Eigen::MatrixXd m(d, d + 2);
        m << at.by_state, at.by_parameter;
        return m;
    };
    const auto usable = [letter](const ShootingStep& at) { return at.alive && at.letter == letter; };
    const ShootingStep above = map.step(z + (step / size) * u, p), below = map.step(z - (step / size) * u, p);
    if (usable(above) && usable(below)) return Eigen::MatrixXd((both(above) - both(below)) * (size / (2 * step)));
    const ShootingStep here = map.step(z, p);  // beside a border: on one side only
    if (usable(above) && usable(here)) return Eigen::MatrixXd((both(above) - both(here)) * (size / step));
    if (usable(below) && usable(here)) return Eigen::MatrixXd((both(here) - both(below)) * (size / step));
    return std::nullopt;
}

/// The real part of v e^{iφ}, φ such that it is largest, of unit length, and not turned round against `before`.
Eigen::VectorXd real_part(const Eigen::VectorXcd& v, const Eigen::VectorXd* before) {
    const Complex square = (v.array() * v.array()).sum();  // |Re(v e^{iφ})|² is largest for 2φ = −arg Σ v²
    Eigen::VectorXd part = (v * std::polar(1.0, -0.5 * std::arg(square))).real();
    if (before != nullptr && part.dot(*before) < 0) part *= -1;
    return part.normalized();
}

/// A fixed vector without zeros or symmetries.
Eigen::VectorXd some_vector(Eigen::Index size, double rate) {
    Eigen::VectorXd v(size);
    for (Eigen::Index i = 0; i < size; ++i) v[i] = std::cos(rate * static_cast<double>(i + 1));
    return v.normalized();
}

}  // namespace

CriticalValue critical_value(const ShootingResidual& shooting, Complex multiplier, const CriticalBorders& borders) {
    const Eigen::Index n = borders.column.size();
    const Eigen::Index d = shooting.steps.front().by_state.rows();
    Eigen::MatrixXcd full = Eigen::MatrixXcd::Zero(n + 1, n + 1);
    full.topLeftCorner(n, n) = cyclic_matrix(shooting, multiplier);
    full.topRightCorner(n, 1) = borders.column.cast<Complex>();
    full.bottomLeftCorner(1, n) = borders.row.transpose().cast<Complex>();
    Eigen::VectorXcd one = Eigen::VectorXcd::Zero(n + 1);
    one[n] = 1;
    const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(full);
    const Eigen::VectorXcd right = lu.solve(one), left = lu.adjoint().solve(one);
    CriticalValue value;
    value.g = right[n];
    value.right = right.head(n);
    value.left = left.head(n);
    value.by_multiplier = value.left.tail(d).dot(value.right.head(d));  // dot conjugates its first argument
    return value;
}

std::optional<Eigen::VectorXcd> gradient_of(const PlaneMap& map, const Eigen::VectorXd& points,
                                            const Eigen::Vector2d& p, const ShootingResidual& shooting,
                                            const CriticalValue& value, double steep_below) {
    const Eigen::Index d = map.dimension, size = points.size();
    Eigen::VectorXcd gradient = Eigen::VectorXcd::Zero(size + 2);
    for (Eigen::Index i = 0; i * d < size; ++i) {
        const Eigen::VectorXd z = points.segment(i * d, d);
        const Eigen::VectorXcd q = value.right.segment(i * d, d);
        const std::int64_t letter = shooting.itinerary[static_cast<std::size_t>(i)];
        const double over = difference_step(shooting.steps[static_cast<std::size_t>(i)].margin, steep_below);
        const auto real = change_along(map, z, p, letter, q.real(), over);
        const auto imaginary = change_along(map, z, p, letter, q.imag(), over);
        if (!real || !imaginary) return std::nullopt;
        const Eigen::RowVectorXcd row = value.left.segment(i * d, d).adjoint() *
                                        (real->cast<Complex>() + Complex(0, 1) * imaginary->cast<Complex>());
        gradient.segment(i * d, d) = -row.head(d).transpose();
        gradient.tail(2) -= row.tail(2).transpose();
    }
    return gradient;
}

CriticalBorders borders_at(const ShootingResidual& shooting, Complex multiplier,
                           const std::optional<CriticalBorders>& before) {
    const auto n = shooting.coordinates();
    CriticalBorders borders = before.value_or(CriticalBorders{some_vector(n, 1.3), some_vector(n, 0.7)});
    const int rounds = before ? 1 : 4;
    for (int i = 0; i < rounds; ++i) {
        const CriticalValue value = critical_value(shooting, multiplier, borders);
        borders.column = real_part(value.left, before ? &before->column : nullptr);
        borders.row = real_part(value.right, before ? &before->row : nullptr);
    }
    return borders;
}

namespace {

/// E and O of one c, and their gradients by (Z, p) if asked for.
struct EvenOdd {
    double even = 0, odd = 0;
    Eigen::VectorXd even_gradient, odd_gradient;
};

Complex multiplier_of_cosine(double c) {
    if (std::abs(c) <= 1) return {c, std::sqrt(1 - c * c)};
    return c + std::copysign(std::sqrt(c * c - 1), c);
}

EvenOdd even_odd(const ShootingResidual& shooting, double c, const CriticalBorders& borders) {
    constexpr double coincident = 1e-12;  // where λ and 1/λ can't be told apart: their difference quotient's limit
    if (std::abs(std::abs(c) - 1) < coincident) {
        const CriticalValue value = critical_value(shooting, std::copysign(1.0, c), borders);
        return {value.g.real(), value.by_multiplier.real(), {}, {}};
    }
    const Complex multiplier = multiplier_of_cosine(c);
    const CriticalValue first = critical_value(shooting, multiplier, borders);
    if (std::abs(c) < 1) return {first.g.real(), first.g.imag() / multiplier.imag(), {}, {}};
    const CriticalValue second = critical_value(shooting, 1.0 / multiplier, borders);
    const double apart = multiplier.real() - 1 / multiplier.real();
    return {0.5 * (first.g + second.g).real(), (first.g - second.g).real() / apart, {}, {}};
}

/// Gradients, at a c that is kept apart from ±1: they steer only.
bool even_odd_gradients(const AugmentedSystem& system, const Eigen::VectorXd& y, const ShootingResidual& shooting,
                        double c, EvenOdd& result) {
    const Eigen::Index n = system.coordinates();
    const auto gradient_at = [&](Complex multiplier) {
        return gradient_of(system.map, y.head(n), y.segment<2>(n), shooting,
                           critical_value(shooting, multiplier, system.borders), system.steep_below);
    };
    constexpr double apart_at_least = 1e-6;
    if (std::abs(std::abs(c) - 1) < apart_at_least) c = std::copysign(1 - apart_at_least, c);
    const Complex multiplier = multiplier_of_cosine(c);
    const auto first = gradient_at(multiplier);
    if (!first) return false;
    if (std::abs(c) < 1) {
        result.even_gradient = first->real();
        result.odd_gradient = first->imag() / multiplier.imag();
        return true;
    }
    const auto second = gradient_at(1.0 / multiplier);
    if (!second) return false;
    result.even_gradient = 0.5 * (*first + *second).real();
    result.odd_gradient = (*first - *second).real() / (multiplier.real() - 1 / multiplier.real());
    return true;
}

/// The last two rows of a Neimark–Sacker curve's equations.
bool add_pair(const AugmentedSystem& system, const Eigen::VectorXd& y, ShootingResidual& shooting) {
    const Eigen::Index n = system.coordinates();
    const double c = y[n + 2];
    EvenOdd here = even_odd(shooting, c, system.borders);
    if (!even_odd_gradients(system, y, shooting, c, here)) return false;
    constexpr double h = 1e-5;
    const EvenOdd above = even_odd(shooting, c + h, system.borders), below = even_odd(shooting, c - h, system.borders);
    shooting.gap[n] = here.even;
    shooting.gap[n + 1] = here.odd;
    shooting.jacobian.row(n).head(n + 2) = here.even_gradient.transpose();
    shooting.jacobian.row(n + 1).head(n + 2) = here.odd_gradient.transpose();
    shooting.jacobian(n, n + 2) = (above.even - below.even) / (2 * h);
    shooting.jacobian(n + 1, n + 2) = (above.odd - below.odd) / (2 * h);
    return true;
}

bool add_real(const AugmentedSystem& system, const Eigen::VectorXd& y, ShootingResidual& shooting) {
    const Eigen::Index n = system.coordinates();
    const CriticalValue value = critical_value(shooting, system.multiplier(y), system.borders);
    const auto gradient = gradient_of(system.map, y.head(n), y.segment<2>(n), shooting, value, system.steep_below);
    if (!gradient) return false;
    shooting.gap[n] = value.g.real();
    shooting.jacobian.row(n) = gradient->real().transpose();
    return true;
}

}  // namespace

Complex AugmentedSystem::multiplier(const Eigen::VectorXd& y) const {
    switch (kind) {
        case BoundaryKind::fold:
            return 1;
        case BoundaryKind::flip:
            return -1;
        case BoundaryKind::neimark_sacker:
            break;
    }
    return multiplier_of_cosine(y[coordinates() + 2]);
}

ShootingResidual AugmentedSystem::shooting(const Eigen::VectorXd& y) const {
    return shooting_residual(map, y.head(coordinates()), y.segment<2>(coordinates()));
}

Eigen::VectorXd AugmentedSystem::unknowns(const CyclePoints& points, const Eigen::Vector2d& p,
                                          Complex multiplier) const {
    Eigen::VectorXd y(weights().size());
    y.head(coordinates()) = stacked(points);
    y.segment<2>(coordinates()) = p;
    if (kind == BoundaryKind::neimark_sacker) y[coordinates() + 2] = multiplier.real() / std::abs(multiplier);
    return y;
}

Eigen::VectorXd AugmentedSystem::weights() const {
    const bool pair = kind == BoundaryKind::neimark_sacker;
    Eigen::VectorXd w = Eigen::VectorXd::Constant(coordinates() + (pair ? 3 : 2), 1.0 / static_cast<double>(period));
    w.segment<2>(coordinates()) = unit.cwiseAbs2().cwiseInverse();
    if (pair) w[coordinates() + 2] = 1;
    return w;
}

CurveProblem problem_of(const AugmentedSystem& system) {
    return augmented_problem(system.weights(), [system](const Eigen::VectorXd& y) {
        ShootingResidual shooting = system.shooting(y);
        if (!shooting.alive) return shooting;
        shooting.rounding.resize(0);  // that of g is not known
        shooting.gap.conservativeResize(y.size() - 1);
        shooting.jacobian.conservativeResizeLike(Eigen::MatrixXd::Zero(y.size() - 1, y.size()));
        const bool pair = system.kind == BoundaryKind::neimark_sacker;
        shooting.alive = pair ? add_pair(system, y, shooting) : add_real(system, y, shooting);
        return shooting;
    });
}

}  // namespace swirl::analysis
