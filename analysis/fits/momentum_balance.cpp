#include "analysis/fits/momentum_balance.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/fits/robust.hpp"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace swirl::analysis {

namespace {

constexpr std::size_t fewest_for_signs = 3;  // two coefficients and a residual

Eigen::Vector3d change_of(const MeasuredImpact& impact) {
    return impact.after - impact.before;
}

/// r_x Δv_y and −r_y Δv_x.
Eigen::Vector2d products_of(const MeasuredImpact& impact) {
    const Eigen::Vector3d change = change_of(impact);
    return {impact.offset[0] * change[1], -impact.offset[1] * change[0]};
}

/// r_x Δv_y − r_y Δv_x, and its variance.
double torque_of(const MeasuredImpact& impact) {
    return products_of(impact).sum();
}

/// The variance of the balance's residual, torque + cross k + spin k².
struct BalanceVariance {
    double torque = 0, cross = 0, spin = 0;

    explicit BalanceVariance(const MeasuredImpact& impact) {
        const Eigen::Vector2d& r = impact.offset;
        if (!impact.covariance) {
            const Eigen::Vector3d change = impact.error_before.cwiseAbs2() + impact.error_after.cwiseAbs2();
            torque = r[0] * r[0] * change[1] + r[1] * r[1] * change[0], spin = change[2];
            return;
        }
        const Eigen::Vector3d change = change_of(impact);
        Eigen::Matrix<double, 8, 1> by_torque, by_spin;
        by_torque << r[1], -r[0], 0, -r[1], r[0], 0, change[1], -change[0];
        by_spin << 0, 0, 1, 0, 0, -1, 0, 0;
        torque = by_torque.dot(*impact.covariance * by_torque);
        cross = 2 * by_torque.dot(*impact.covariance * by_spin);
        spin = by_spin.dot(*impact.covariance * by_spin);
    }
    double at(double inertia) const { return torque + inertia * cross + inertia * inertia * spin; }
};

/// The residual of the balance in its standard deviations.
double balance_residual(const MeasuredImpact& impact, double inertia) {
    return (torque_of(impact) - inertia * change_of(impact)[2]) / std::sqrt(BalanceVariance(impact).at(inertia));
}

/// The same as a function of ln k. (Ceres asks for a class.)
class BalanceResidual final : public ceres::CostFunction {
public:
    explicit BalanceResidual(const MeasuredImpact& impact)
        : torque_(torque_of(impact)), spin_(change_of(impact)[2]), variance_(impact) {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(1);
    }
    bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
        constexpr double largest = 150;  // beyond any k; impacts of which none changes the spin ask for more and more
        const double k = std::exp(std::clamp(blocks[0][0], -largest, largest));
        const double variance = variance_.at(k), error = std::sqrt(variance);
        const double left = torque_ - k * spin_;
        residuals[0] = left / error;
        if (jacobians != nullptr && jacobians[0] != nullptr)
            jacobians[0][0] = -k * spin_ / error -
                              (left * k * variance_.cross / 2 + left * k * k * variance_.spin) / (variance * error);
        return std::isfinite(residuals[0]);
    }

private:
    double torque_, spin_;
    BalanceVariance variance_;
};

double balance_scale(std::span<const MeasuredImpact> impacts, std::span<const double> weights, double inertia) {
    std::vector<double> squares;
    for (const MeasuredImpact& impact : impacts) {
        const double residual = balance_residual(impact, inertia);
        squares.push_back(residual * residual);
    }
    return std::sqrt(weighted_median(squares, {weights.begin(), weights.end()}) / median_square_of_one);
}

/// No scale is below it: tables have some nine digits, and solvers end there.
double least_scale(std::span<const MeasuredImpact> impacts, double inertia) {
    std::vector<double> sizes;
    for (const MeasuredImpact& impact : impacts) {
        sizes.push_back(std::abs(torque_of(impact)) / std::sqrt(BalanceVariance(impact).at(inertia)));
    }
    return 1e-7 * quantile(std::move(sizes), 0.5) + 1e-100;
}

/// Weighted sums over impacts: x², xy, y², xs, ys, s², r_x², r_y² and 1 (x = r_x Δv_y, y = −r_y Δv_x, s = ΔS).
struct BalanceMoments {
    Eigen::Matrix<double, 9, 1> sums = Eigen::Matrix<double, 9, 1>::Zero();

    void add(const MeasuredImpact& impact, double weight) {
        const Eigen::Vector2d p = products_of(impact), squares = impact.offset.cwiseAbs2();
        const double s = change_of(impact)[2];
        Eigen::Matrix<double, 9, 1> terms;
        terms << p[0] * p[0], p[0] * p[1], p[1] * p[1], p[0] * s, p[1] * s, s * s, squares[0], squares[1], 1;
        sums += weight * terms;
    }
    /// ⟨r²⟩
    double arm() const { return (sums[6] + sums[7]) / sums[8]; }
    /// Of the variance of x + y − k s, that of the velocities; not finite where x or y tells nothing.
    double share() const {
        Eigen::Matrix2d equations;
        equations << sums[3], 2 * sums[6], sums[4], 2 * sums[7];
        const Eigen::Vector2d found = equations.inverse() * Eigen::Vector2d(sums[0] + sums[1], sums[1] + sums[2]);
        const double k = found[0];
        const double all = sums[0] + 2 * sums[1] + sums[2] - 2 * k * (sums[3] + sums[4]) + k * k * sums[5];
        return 2 * found[1] * (sums[6] + sums[7]) / all;
    }
};

struct Regression {
    Eigen::Vector2d coefficients, errors;
};

/// One step of weighted least squares, with errors that hold for any scatter (White's).
Regression weighted_regression(const Eigen::MatrixX2d& products, const Eigen::VectorXd& spin,
                               const Eigen::VectorXd& weights) {
    Eigen::Matrix2d normal = products.transpose() * weights.asDiagonal() * products;
    // A column of zeros has no coefficient; a ridge of rounding keeps the other's.
    normal.diagonal().array() += 1e-12 * normal.trace();
    const Eigen::Matrix2d inverse = normal.inverse();
    const Eigen::Vector2d coefficients = inverse * (products.transpose() * weights.cwiseProduct(spin));
    const Eigen::VectorXd pulls = weights.cwiseProduct(spin - products * coefficients);
    const Eigen::Matrix2d meat = products.transpose() * pulls.cwiseAbs2().asDiagonal() * products;
    return {coefficients, (inverse * meat * inverse).diagonal().cwiseSqrt()};
}

/// Mallows' weights, 1 for most: a row of which a product is larger than the others' has less of a say, or one gross
/// product alone would draw the regression to itself (Maronna, Martin & Yohai 2006, section 5.11).
Eigen::VectorXd leverage_weights(const Eigen::MatrixX2d& products) {
    constexpr double usual = 3;  // quartiles: one product of two hundred that are normal is larger
    Eigen::VectorXd size = Eigen::VectorXd::Zero(products.rows());
    for (Eigen::Index j = 0; j < 2; ++j) {
        const Eigen::VectorXd sizes = products.col(j).cwiseAbs();
        const double quartile = quantile({sizes.begin(), sizes.end()}, 0.75);
        if (quartile > 0) size = size.cwiseMax(sizes / quartile);
    }
    return size.unaryExpr([](double of_row) { return of_row > usual ? std::pow(usual / of_row, 2) : 1; });
}

Regression robust_regression(const Eigen::MatrixX2d& products, const Eigen::VectorXd& spin) {
    constexpr int rounds = 30;  // both iterations settle within ten on data with one in three gross errors
    const Eigen::VectorXd sizes = spin.cwiseAbs();
    const double least = 1e-9 * quantile({sizes.begin(), sizes.end()}, 0.75) + 1e-300;
    const Eigen::VectorXd leverage = leverage_weights(products);
    Regression fit = weighted_regression(products, spin, leverage);
    for (int round = 0; round < rounds; ++round) {
        const Eigen::VectorXd left = (spin - products * fit.coefficients).cwiseAbs();
        fit = weighted_regression(products, spin, leverage.cwiseQuotient(left.cwiseMax(least)));
    }
    for (int round = 0; round < rounds; ++round) {
        const Eigen::VectorXd squares = (spin - products * fit.coefficients).cwiseAbs2();
        std::vector<double> sorted(squares.begin(), squares.end());
        const double scale = std::max(std::sqrt(quantile(sorted, 0.5) / median_square_of_one), least);
        const Eigen::VectorXd weights =
            squares.unaryExpr([&](double square) { return biweight(square / (scale * scale), biweight_of_one); });
        fit = weighted_regression(products, spin, weights.cwiseProduct(leverage));
    }
    return fit;
}

}  // namespace

MomentumSigns momentum_signs(std::span<const MeasuredImpact> impacts) {
    if (impacts.size() < fewest_for_signs) refuse("impacts", static_cast<double>(impacts.size()), "3 or more");
    const auto count = static_cast<Eigen::Index>(impacts.size());
    Eigen::MatrixX2d products(count, 2);
    Eigen::VectorXd spin(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const MeasuredImpact& impact = impacts[static_cast<std::size_t>(i)];
        products.row(i) = products_of(impact).transpose();
        spin[i] = change_of(impact)[2];
    }
    const Eigen::RowVector2d sizes = products.colwise().norm().cwiseMax(1e-300);
    products.array().rowwise() /= sizes.array();
    const Regression fit = robust_regression(products, spin);
    MomentumSigns signs;
    std::array<int, 2> sense{0, 0};
    for (Eigen::Index j = 0; j < 2; ++j) {
        const auto at = static_cast<std::size_t>(j);
        if (sizes[j] < 1e-12 * sizes.maxCoeff()) continue;
        signs.coefficients[at] = fit.coefficients[j] / sizes[j];
        signs.errors[at] = fit.errors[j] / sizes[j];
        if (std::abs(fit.coefficients[j]) > sure_sign * fit.errors[j]) sense[at] = fit.coefficients[j] > 0 ? 1 : -1;
    }
    // A mirrored spin turns both signs; a mirrored v_x the second alone.
    if (sense[0] < 0) signs.spin = -1;
    if (sense[1] * signs.spin < 0) signs.tangent = -1;
    return signs;
}

MeasuredImpact with_signs(const MeasuredImpact& impact, const MomentumSigns& signs) {
    MeasuredImpact cured = impact;
    for (Eigen::Vector3d* velocity : {&cured.before, &cured.after}) {
        (*velocity)[0] *= signs.tangent;
        (*velocity)[2] *= signs.spin;
    }
    if (impact.covariance) {
        Eigen::Matrix<double, 8, 1> senses;
        senses << signs.tangent, 1, signs.spin, signs.tangent, 1, signs.spin, 1, 1;
        cured.covariance = senses.asDiagonal() * *impact.covariance * senses.asDiagonal();
    }
    return cured;
}

InertiaFit known_inertia(std::span<const MeasuredImpact> impacts, std::span<const double> weights, double inertia) {
    return {inertia, std::max(balance_scale(impacts, weights, inertia), least_scale(impacts, inertia))};
}

InertiaFit fit_inertia(std::span<const MeasuredImpact> impacts, std::span<const double> weights, double start) {
    double logarithm = std::log(start);
    const double least = least_scale(impacts, start);
    for (int round = 0; round < 3; ++round) {  // the scale moves with k, by less each time
        const double scale = std::max(balance_scale(impacts, weights, std::exp(logarithm)), least);
        if (!std::isfinite(scale)) break;  // where friction turns no body, k is told by nothing, and may run off
        ceres::Problem problem;
        for (std::size_t i = 0; i < impacts.size(); ++i) {
            if (!(weights[i] > 0)) continue;
            auto* loss =
                new ceres::ScaledLoss(new ceres::TukeyLoss(biweight_of_one * scale), weights[i], ceres::TAKE_OWNERSHIP);
            problem.AddResidualBlock(new BalanceResidual(impacts[i]), loss, &logarithm);
        }
        ceres::Solver::Options solver;
        solver.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
        solver.function_tolerance = 1e-10;
        solver.gradient_tolerance = 0;  // it has a unit
        solver.logging_type = ceres::SILENT;
        ceres::Solver::Summary summary;
        ceres::Solve(solver, &problem, &summary);
    }
    return known_inertia(impacts, weights, std::exp(logarithm));
}

double first_inertia(std::span<const MeasuredImpact> impacts) {
    std::vector<double> torques, spins;
    for (const MeasuredImpact& impact : impacts) {
        torques.push_back(std::abs(torque_of(impact)));
        spins.push_back(std::abs(change_of(impact)[2]));
    }
    return quantile(torques, 0.5) / quantile(spins, 0.5);
}

EnergyChange energy_change(std::span<const MeasuredImpact> impacts, double inertia) {
    EnergyChange change;
    std::vector<double> ratios;
    for (const MeasuredImpact& impact : impacts) {
        const Eigen::Vector3d weights(1, 1, inertia);
        const Eigen::Vector3d before = weights.cwiseProduct(impact.before), after = weights.cwiseProduct(impact.after);
        const double energy_before = before.dot(impact.before) / 2, energy_after = after.dot(impact.after) / 2;
        if (energy_before > 0) ratios.push_back(energy_after / energy_before);
        double variance = before.cwiseProduct(impact.error_before).squaredNorm() +
                          after.cwiseProduct(impact.error_after).squaredNorm();
        if (impact.covariance) {
            Eigen::Matrix<double, 8, 1> slopes;
            slopes << -before, after, 0, 0;
            variance = slopes.dot(*impact.covariance * slopes);
        }
        if (energy_after - energy_before > sure_rise * std::sqrt(variance)) ++change.rises;
    }
    if (!ratios.empty()) change.ratio = quantile(std::move(ratios), 0.5);
    return change;
}

double velocity_share(std::span<const MeasuredImpact> impacts, std::span<const double> weights, double inertia) {
    constexpr std::size_t parts = 20;
    constexpr double trust = 0.3, least = 0.02;
    const double scale = std::max(balance_scale(impacts, weights, inertia), least_scale(impacts, inertia));
    std::vector<BalanceMoments> part(parts);
    BalanceMoments all;
    for (std::size_t i = 0; i < impacts.size(); ++i) {
        const double residual = balance_residual(impacts[i], inertia) / scale;
        const double weight = weights[i] * biweight(residual * residual, biweight_of_one);
        part[i % parts].add(impacts[i], weight);
        all.add(impacts[i], weight);
    }
    const double guess = all.arm() / (all.arm() + inertia);
    const double own = all.share();
    double variance = 0;
    for (BalanceMoments& without : part) {
        without.sums = all.sums - without.sums;
        variance += std::pow(without.share() - own, 2) * (parts - 1) / parts;
    }
    if (!std::isfinite(variance) || !std::isfinite(own)) return guess;
    const double weight = trust * trust / (trust * trust + variance);
    return std::clamp(weight * own + (1 - weight) * guess, least, 1 - least);
}

std::vector<MeasuredImpact> with_shared_errors(std::span<const MeasuredImpact> impacts, double inertia, double share) {
    constexpr double longest = 16;  // medians of r²: beyond lies no body's contact
    std::vector<double> squares;
    for (const MeasuredImpact& impact : impacts) squares.push_back(impact.offset.squaredNorm());
    const double most = longest * quantile(squares, 0.5);
    double arm = 0;
    for (const double square : squares) arm += std::min(square, most);
    arm /= static_cast<double>(impacts.size());
    const Eigen::Vector3d error(1, 1, std::sqrt((1 - share) / share * arm) / inertia);
    std::vector<MeasuredImpact> same(impacts.begin(), impacts.end());
    for (MeasuredImpact& impact : same) impact.error_before = impact.error_after = error;
    return same;
}

}  // namespace swirl::analysis
