// Second and third derivatives of Fᵏ, as changes of its exact first derivative, by differences in extended precision.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace swirl::analysis {

/// Directional derivatives of A(z; p) = D(Fᵏ)(z; p) at one point. Empty where the map ends nearby.
struct HigherForms {
    /// d/dh A(z + h u; p + h q): B(u, v) = first(u, 0) v.
    std::function<std::optional<Eigen::MatrixXd>(const Eigen::VectorXd& u, double q)> first;
    /// ∂²/∂h∂l A(z + h u + l v; p): C(u, v, w) = second(u, v) w.
    std::function<std::optional<Eigen::MatrixXd>(const Eigen::VectorXd& u, const Eigen::VectorXd& v)> second;
};

/// Central differences in the number type T, with errors O(h²) and O(l²) relative to the next derivatives, plus T's
/// rounding over h and l²: with 113 bits and h = 10⁻¹⁰, l = 10⁻⁸ both are below 10⁻¹⁵.
///   derivative  A(z; p) in T; false where the map ends
template <class T>
HigherForms difference_forms(std::function<bool(const Eigen::Matrix<T, Eigen::Dynamic, 1>&, const T&,
                                                Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>&)>
                                 derivative,
                             const Eigen::VectorXd& z, double p, double h = 1e-10, double l = 1e-8) {
    using State = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Square = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
    const State centre = z.template cast<T>();
    HigherForms forms;
    forms.first = [=](const Eigen::VectorXd& u, double q) -> std::optional<Eigen::MatrixXd> {
        const State step = u.template cast<T>() * T(h);
        Square above, below;
        if (!derivative(State(centre + step), T(p) + T(q) * T(h), above) ||
            !derivative(State(centre - step), T(p) - T(q) * T(h), below))
            return std::nullopt;
        return Square((above - below) / T(2 * T(h))).template cast<double>();
    };
    forms.second = [=](const Eigen::VectorXd& u, const Eigen::VectorXd& v) -> std::optional<Eigen::MatrixXd> {
        const State a = u.template cast<T>() * T(l), b = v.template cast<T>() * T(l);
        Square both, first, second, none;
        if (!derivative(State(centre + a + b), T(p), both) || !derivative(State(centre + a - b), T(p), first) ||
            !derivative(State(centre - a + b), T(p), second) || !derivative(State(centre - a - b), T(p), none))
            return std::nullopt;
        return Square((both - first - second + none) / T(4 * T(l) * T(l))).template cast<double>();
    };
    return forms;
}

}  // namespace swirl::analysis
