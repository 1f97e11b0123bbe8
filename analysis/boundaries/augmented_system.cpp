#include "analysis/boundaries/augmented_system.hpp"

#include <cmath>

namespace swirl::analysis {

namespace {

using Complex = std::complex<double>;

/// E and O of one c, and their gradients by (Z, p) if asked for.
struct EvenOdd {
    double even = 0, odd = 0;
    Eigen::VectorXd even_gradient, odd_gradient;
};

Complex multiplier_of_cosine(double c) {
    if (std::abs(c) <= 1) return {c, std::sqrt(1 - c * c)};
    return c + std::copysign(std::sqrt(c * c - 1), c);
}

EvenOdd even_odd(const PlaneShooting& shooting, double c, const CriticalBorders& borders) {
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
bool even_odd_gradients(const PlaneMap& map, const Eigen::VectorXd& points, const Eigen::Vector2d& p,
                        const PlaneShooting& shooting, double c, const CriticalBorders& borders, EvenOdd& result) {
    constexpr double apart_at_least = 1e-6;
    if (std::abs(std::abs(c) - 1) < apart_at_least) c = std::copysign(1 - apart_at_least, c);
    const Complex multiplier = multiplier_of_cosine(c);
    const auto first = gradient_of(map, points, p, shooting, critical_value(shooting, multiplier, borders));
    if (!first) return false;
    if (std::abs(c) < 1) {
        result.even_gradient = first->real();
        result.odd_gradient = first->imag() / multiplier.imag();
        return true;
    }
    const auto second = gradient_of(map, points, p, shooting, critical_value(shooting, 1.0 / multiplier, borders));
    if (!second) return false;
    result.even_gradient = 0.5 * (*first + *second).real();
    result.odd_gradient = (*first - *second).real() / (multiplier.real() - 1 / multiplier.real());
    return true;
}

/// The last two rows of a Neimark–Sacker curve's equations.
bool add_pair(const AugmentedSystem& system, const Eigen::VectorXd& y, const PlaneShooting& shooting,
              ArcEquations& at) {
    const Eigen::Index n = system.coordinates();
    const double c = y[n + 2];
    EvenOdd here = even_odd(shooting, c, system.borders);
    if (!even_odd_gradients(system.map, y.head(n), y.segment<2>(n), shooting, c, system.borders, here)) return false;
    constexpr double h = 1e-5;
    const EvenOdd above = even_odd(shooting, c + h, system.borders), below = even_odd(shooting, c - h, system.borders);
    at.residual[n] = here.even;
    at.residual[n + 1] = here.odd;
    at.jacobian.row(n).head(n + 2) = here.even_gradient.transpose();
    at.jacobian.row(n + 1).head(n + 2) = here.odd_gradient.transpose();
    at.jacobian(n, n + 2) = (above.even - below.even) / (2 * h);
    at.jacobian(n + 1, n + 2) = (above.odd - below.odd) / (2 * h);
    return true;
}

bool add_real(const AugmentedSystem& system, const Eigen::VectorXd& y, const PlaneShooting& shooting,
              ArcEquations& at) {
    const Eigen::Index n = system.coordinates();
    const CriticalValue value = critical_value(shooting, system.multiplier(y), system.borders);
    const auto gradient = gradient_of(system.map, y.head(n), y.segment<2>(n), shooting, value);
    if (!gradient) return false;
    at.residual[n] = value.g.real();
    at.jacobian.row(n) = gradient->real().transpose();
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

PlaneShooting AugmentedSystem::shooting(const Eigen::VectorXd& y) const {
    return plane_shooting(map, y.head(coordinates()), y.segment<2>(coordinates()));
}

ArcSystem equations_of(const AugmentedSystem& system) {
    const bool pair = system.kind == BoundaryKind::neimark_sacker;
    const Eigen::Index n = system.coordinates();
    ArcSystem arc;
    arc.weights = Eigen::VectorXd::Constant(n + (pair ? 3 : 2), 1.0 / static_cast<double>(system.period));
    arc.weights.segment<2>(n) = system.unit.cwiseAbs2().cwiseInverse();
    if (pair) arc.weights[n + 2] = 1;
    arc.equations = [system, pair, n](const Eigen::VectorXd& y, ArcEquations& at) {
        const PlaneShooting shooting = system.shooting(y);
        if (!shooting.alive) return false;
        at.word = shooting.word;
        at.residual.resize(y.size() - 1);
        at.jacobian = Eigen::MatrixXd::Zero(y.size() - 1, y.size());
        at.residual.head(n) = shooting.gap;
        at.jacobian.topLeftCorner(n, n + 2) = shooting.by_unknowns;
        return pair ? add_pair(system, y, shooting, at) : add_real(system, y, shooting, at);
    };
    return arc;
}

void renew_borders(AugmentedSystem& system, const Eigen::VectorXd& y) {
    const PlaneShooting shooting = system.shooting(y);
    if (shooting.alive) system.borders = borders_at(shooting, system.multiplier(y), system.borders);
}

bool augmented_system_at(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                         Complex multiplier, const Eigen::Vector2d& unit, AugmentedSystem& system, Eigen::VectorXd& y) {
    const bool pair = kind == BoundaryKind::neimark_sacker;
    system = AugmentedSystem{kind, map, points.size(), unit, {}};
    const Eigen::Index n = system.coordinates();
    y.resize(n + (pair ? 3 : 2));
    y.head(n) = stacked(points);
    y.segment<2>(n) = p;
    if (pair) y[n + 2] = multiplier.real() / std::abs(multiplier);
    const PlaneShooting shooting = system.shooting(y);
    if (!shooting.alive) return false;
    system.borders = borders_at(shooting, system.multiplier(y));
    return true;
}

}  // namespace swirl::analysis
