#include "analysis/boundaries/critical_value.hpp"

#include <Eigen/LU>

#include <cmath>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;

Eigen::MatrixXcd cyclic_matrix(const PlaneShooting& shooting, Complex multiplier) {
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

/// D²F(z; p)(u, ·) and ∂/∂p DF(z; p) u, as one D × (D + 2) matrix, for a real direction u.
std::optional<Eigen::MatrixXd> change_along(const PlaneMap& map, const Eigen::VectorXd& z, const Eigen::Vector2d& p,
                                            std::int64_t letter, const Eigen::VectorXd& u) {
    const Eigen::Index d = z.size();
    const double size = u.norm();
    if (size == 0) return Eigen::MatrixXd::Zero(d, d + 2);
    constexpr double step = 1e-5;  // rounding/step and step² are both 10⁻¹⁰ or so
    const auto both = [d](const PlaneStep& at) {
        Eigen::MatrixXd m(d, d + 2);
        m << at.by_state, at.by_parameters;
        return m;
    };
    const auto usable = [letter](const PlaneStep& at) { return at.alive && at.letter == letter; };
    const PlaneStep above = map.step(z + (step / size) * u, p), below = map.step(z - (step / size) * u, p);
    if (usable(above) && usable(below)) return Eigen::MatrixXd((both(above) - both(below)) * (size / (2 * step)));
    const PlaneStep here = map.step(z, p);  // beside a border: on one side only
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

CriticalValue critical_value(const PlaneShooting& shooting, Complex multiplier, const CriticalBorders& borders) {
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
                                            const Eigen::Vector2d& p, const PlaneShooting& shooting,
                                            const CriticalValue& value) {
    const Eigen::Index d = map.dimension, size = points.size();
    Eigen::VectorXcd gradient = Eigen::VectorXcd::Zero(size + 2);
    for (Eigen::Index i = 0; i * d < size; ++i) {
        const Eigen::VectorXd z = points.segment(i * d, d);
        const Eigen::VectorXcd q = value.right.segment(i * d, d);
        const std::int64_t letter = shooting.word[static_cast<std::size_t>(i)];
        const auto real = change_along(map, z, p, letter, q.real());
        const auto imaginary = change_along(map, z, p, letter, q.imag());
        if (!real || !imaginary) return std::nullopt;
        const Eigen::RowVectorXcd row = value.left.segment(i * d, d).adjoint() *
                                        (real->cast<Complex>() + Complex(0, 1) * imaginary->cast<Complex>());
        gradient.segment(i * d, d) = -row.head(d).transpose();
        gradient.tail(2) -= row.tail(2).transpose();
    }
    return gradient;
}

CriticalBorders borders_at(const PlaneShooting& shooting, Complex multiplier,
                           const std::optional<CriticalBorders>& before) {
    const auto n = static_cast<Eigen::Index>(shooting.gap.size());
    CriticalBorders borders = before.value_or(CriticalBorders{some_vector(n, 1.3), some_vector(n, 0.7)});
    const int rounds = before ? 1 : 4;
    for (int i = 0; i < rounds; ++i) {
        const CriticalValue value = critical_value(shooting, multiplier, borders);
        borders.column = real_part(value.left, before ? &before->column : nullptr);
        borders.row = real_part(value.right, before ? &before->row : nullptr);
    }
    return borders;
}

}  // namespace swirl::analysis
