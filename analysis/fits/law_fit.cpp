#include "analysis/fits/law_fit.hpp"

#include "analysis/fits/robust.hpp"

#include <ceres/cost_function.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl::analysis {

namespace {

using Matrix32 = Eigen::Matrix<double, 3, 2>;

struct LawStep {
    Eigen::Vector3d after;
    Eigen::Matrix3d by_before;
    Matrix32 by_parameters;
};

LawStep step_from(const MeasuredImpact& impact, const Eigen::Vector3d& before, double inertia, const ImpactLaw& law,
                  const LawParameters& parameters) {
    const Eigen::Vector2d& r = impact.offset;
    const PredictedImpulse predicted = law(r, inertia, contact_velocity(r, before), parameters);
    const Matrix32 effect = effect_of_impulse(r, inertia);
    Eigen::Matrix<double, 2, 3> contact;
    contact << 1, 0, -r[1], 0, 1, r[0];
    LawStep step;
    step.after = before + effect * predicted.impulse;
    step.by_before = Eigen::Matrix3d::Identity() + effect * (predicted.slopes.leftCols<2>() * contact);
    step.by_parameters = effect * predicted.slopes.rightCols<2>();
    return step;
}

/// The derivative of the law's v⁺ by r, by differences.
Matrix32 slopes_by_offset(const MeasuredImpact& impact, double inertia, const ImpactLaw& law,
                          const LawParameters& parameters) {
    constexpr double share = 1e-5;  // of |r|: the rest is of the order of its square
    const double step = share * impact.offset.norm();
    Matrix32 slopes = Matrix32::Zero();
    if (!(step > 0)) return slopes;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        MeasuredImpact to = impact, from = impact;
        to.offset[axis] += step, from.offset[axis] -= step;
        slopes.col(axis) = (step_from(to, impact.before, inertia, law, parameters).after -
                            step_from(from, impact.before, inertia, law, parameters).after) /
                           (2 * step);
    }
    return slopes;
}

/// Of v⁺ − law(v⁻, r).
Eigen::Matrix3d full_covariance(const ImpactCovariance& errors, const Eigen::Matrix3d& by_before,
                                const Matrix32& by_offset) {
    Eigen::Matrix<double, 3, 8> slopes;
    slopes << -by_before, Eigen::Matrix3d::Identity(), -by_offset;
    return slopes * errors * slopes.transpose();
}

Eigen::Matrix3d covariance_of(const MeasuredImpact& impact, const Eigen::Matrix3d& by_before) {
    Eigen::Matrix3d covariance = by_before * impact.error_before.cwiseAbs2().asDiagonal() * by_before.transpose();
    covariance.diagonal() += impact.error_after.cwiseAbs2();
    return covariance;
}

double squared_distance(const MeasuredImpact& impact, const Eigen::Vector3d& before, const LawStep& step) {
    return (before - impact.before).cwiseQuotient(impact.error_before).squaredNorm() +
           (impact.after - step.after).cwiseQuotient(impact.error_after).squaredNorm();
}

}  // namespace

LawMisfit misfit_of(const MeasuredImpact& impact, double inertia, const ImpactLaw& law,
                    const LawParameters& parameters) {
    if (impact.whitening) {
        const LawStep step = step_from(impact, impact.before, inertia, law, parameters);
        return {*impact.whitening * (impact.after - step.after), -*impact.whitening * step.by_parameters,
                impact.before};
    }
    constexpr double settled = 3e-3;  // in standard errors: the distance is off by its square
    Eigen::Vector3d before = impact.before;
    LawStep step = step_from(impact, before, inertia, law, parameters);
    double least = squared_distance(impact, before, step);
    for (int i = 0; i < misfit_steps; ++i) {
        const Eigen::Vector3d left = impact.after - step.after - step.by_before * (impact.before - before);
        const Eigen::Vector3d weighed = covariance_of(impact, step.by_before).llt().solve(left);
        const Eigen::Vector3d nearest = impact.before + impact.error_before.cwiseAbs2().cwiseProduct(
                                                            Eigen::Vector3d(step.by_before.transpose() * weighed));
        Eigen::Vector3d move = nearest - before;
        if (move.cwiseQuotient(impact.error_before).squaredNorm() < settled * settled) break;
        bool shorter = false;
        for (int halving = 0; halving < 3 && !shorter; ++halving, move *= 0.5) {
            const LawStep tried = step_from(impact, before + move, inertia, law, parameters);
            const double squared = squared_distance(impact, before + move, tried);
            if (!(squared < least)) continue;
            before += move;
            step = tried;
            least = squared;
            shorter = true;
        }
        if (!shorter) break;
    }
    const Eigen::LLT<Eigen::Matrix3d> root(covariance_of(impact, step.by_before));
    const Eigen::Vector3d left = impact.after - step.after - step.by_before * (impact.before - before);
    return {root.matrixL().solve(left), -root.matrixL().solve(step.by_parameters), before};
}

MeasuredImpact with_fixed_weights(const MeasuredImpact& impact, double inertia, const ImpactLaw& law,
                                  const std::optional<LawParameters>& parameters) {
    Eigen::Matrix3d by_before = Eigen::Matrix3d::Identity();
    if (parameters) by_before = step_from(impact, impact.before, inertia, law, *parameters).by_before;
    Eigen::Matrix3d covariance = covariance_of(impact, by_before);
    if (impact.covariance && parameters)
        covariance =
            full_covariance(*impact.covariance, by_before, slopes_by_offset(impact, inertia, law, *parameters));
    const Eigen::LLT<Eigen::Matrix3d> root(covariance);
    MeasuredImpact weighed = impact;
    weighed.whitening = root.matrixL().solve(Eigen::Matrix3d::Identity());
    return weighed;
}

Prediction predict(const MeasuredImpact& impact, double inertia, const ImpactLaw& law,
                   const LawParameters& parameters) {
    const LawStep step = step_from(impact, impact.before, inertia, law, parameters);
    const Eigen::Vector3d left = impact.after - step.after;
    const Eigen::Matrix3d covariance =
        impact.covariance
            ? full_covariance(*impact.covariance, step.by_before, slopes_by_offset(impact, inertia, law, parameters))
            : covariance_of(impact, step.by_before);
    return {step.after, left.dot(covariance.llt().solve(left))};
}

namespace {

/// The misfit of an impact whose distance from the law is beyond the numbers: an outlier for every loss.
constexpr double outlier_misfit = 1e20;

/// (Ceres asks for a class.)
class MisfitResidual final : public ceres::CostFunction {
public:
    MisfitResidual(const MeasuredImpact& impact, const LawProblem& problem) : impact_(impact), problem_(problem) {
        set_num_residuals(3);
        mutable_parameter_block_sizes()->assign(2, 1);
    }
    bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
        LawMisfit misfit = misfit_at({blocks[0][0], blocks[1][0]});
        if (!misfit.residual.allFinite() || !misfit.slopes.allFinite()) {
            misfit.residual.setConstant(outlier_misfit);
            misfit.slopes.setZero();
        }
        Eigen::Map<Eigen::Vector3d>{residuals} = misfit.residual;
        for (int j = 0; jacobians != nullptr && j < 2; ++j)
            if (jacobians[j] != nullptr) Eigen::Map<Eigen::Vector3d>(jacobians[j], 3) = misfit.slopes.col(j);
        return true;
    }

private:
    /// Ceres asks for the residual alone where it may go, and for the Jacobian beside it where it went: the same
    /// misfit.
    const LawMisfit& misfit_at(const LawParameters& at) const {
        if (at.restitution == at_.restitution && at.friction == at_.friction) return misfit_;
        misfit_ = misfit_of(impact_, problem_.inertia, *problem_.law, at);
        at_ = at;
        return misfit_;
    }

    const MeasuredImpact& impact_;
    const LawProblem& problem_;
    mutable LawParameters at_{nan, nan};  // a problem is solved by one thread
    mutable LawMisfit misfit_;
};

ceres::Solver::Options fit_solver_options() {
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    solver.max_num_iterations = 30;
    solver.gradient_tolerance = 0;
    solver.function_tolerance = 1e-6;    // of the loss: hundredths of a standard error
    solver.parameter_tolerance = 1e-11;  // exact impacts end here
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    return solver;
}

std::vector<double> squares_of(const LawProblem& problem, const LawParameters& parameters) {
    std::vector<double> squares;
    squares.reserve(problem.impacts.size());
    for (const MeasuredImpact& impact : problem.impacts) {
        const double square = misfit_of(impact, problem.inertia, *problem.law, parameters).squared();
        squares.push_back(std::isfinite(square) ? square : outlier_misfit * outlier_misfit);
    }
    return squares;
}

/// Half Tukey's loss of a squared misfit in units of the scale.
double half_loss(double square) {
    constexpr double cut = biweight_of_three * biweight_of_three;
    const double left = std::max(0.0, 1 - square / cut);
    return cut / 6 * (1 - left * left * left);
}

/// Four in five misfits: gross errors are fewer than the others; the median alone does not see the few that slide among
/// impacts that stick. χ² with 3 degrees of freedom is below this so often.
constexpr double four_fifths = 0.8, four_fifths_of_three = 4.641628;

/// 10⁻⁹ of the speeds (their median) in units of their errors: no scale is below it.
double least_misfit_scale(const LawProblem& problem) {
    std::vector<double> sizes;
    for (const MeasuredImpact& impact : problem.impacts)
        sizes.push_back(impact.before.cwiseQuotient(impact.error_before).cwiseAbs().maxCoeff());
    return 1e-9 * quantile(std::move(sizes), 0.5);
}

}  // namespace

LawFit fit_law(const LawProblem& problem, const LawParameters& start, const std::optional<double>& fixed_restitution,
               const std::optional<double>& fixed_friction) {
    double e = std::clamp(fixed_restitution.value_or(start.restitution), 0.0, 1.0);
    double mu = std::clamp(fixed_friction.value_or(start.friction), 0.0, largest_friction);
    ceres::Problem ceres_problem;
    for (std::size_t i = 0; i < problem.impacts.size(); ++i) {
        if (!(problem.weights[i] > 0)) continue;
        auto* biweight_loss = new ceres::TukeyLoss(biweight_of_three * problem.scale);
        ceres_problem.AddResidualBlock(new MisfitResidual(problem.impacts[i], problem),
                                       new ceres::ScaledLoss(biweight_loss, problem.weights[i], ceres::TAKE_OWNERSHIP),
                                       &e, &mu);
    }
    if (ceres_problem.NumResidualBlocks() == 0) return {{e, mu}, nan};
    ceres_problem.SetParameterLowerBound(&e, 0, 0);
    ceres_problem.SetParameterUpperBound(&e, 0, 1);
    ceres_problem.SetParameterLowerBound(&mu, 0, 0);
    ceres_problem.SetParameterUpperBound(&mu, 0, largest_friction);
    if (fixed_restitution) ceres_problem.SetParameterBlockConstant(&e);
    if (fixed_friction) ceres_problem.SetParameterBlockConstant(&mu);
    ceres::Solver::Summary summary;
    ceres::Solve(fit_solver_options(), &ceres_problem, &summary);
    return {{e, mu}, summary.final_cost / (problem.scale * problem.scale)};
}

RobustStart first_parameters(const LawProblem& problem) {
    constexpr int steps = 20;
    struct Tried {
        LawParameters parameters;
        std::vector<double> squares;
    };
    std::vector<Tried> grid;
    double least = infinity;
    LawParameters nearest;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            // μ = 0, 0.01 … 3, evenly in its logarithm
            const double friction = j == 0 ? 0 : 0.01 * std::pow(300.0, (j - 1.0) / (steps - 1));
            const LawParameters parameters{static_cast<double>(i) / steps, friction};
            grid.push_back({parameters, squares_of(problem, parameters)});
            const double square = quantile(grid.back().squares, four_fifths);
            if (square < least) least = square, nearest = parameters;
        }
    // No finer than half a step of e: where the true e is on the grid, impacts that stick fit at any larger μ, and
    // would leave those that slide beyond the loss's reach.
    double beside = infinity;
    for (const double e : {nearest.restitution - 0.5 / steps, nearest.restitution + 0.5 / steps})
        if (e >= 0 && e <= 1)
            beside = std::min(beside, quantile(squares_of(problem, {e, nearest.friction}), four_fifths));
    RobustStart start;
    start.scale = std::max(std::sqrt(std::max(least, beside) / four_fifths_of_three), least_misfit_scale(problem));
    least = infinity;
    for (const Tried& tried : grid) {
        double sum = 0;
        for (const double square : tried.squares) sum += half_loss(square / (start.scale * start.scale));
        if (sum < least) least = sum, start.parameters = tried.parameters;
    }
    return start;
}

double misfit_scale(const LawProblem& problem, const LawParameters& parameters) {
    const double median =
        weighted_median(squares_of(problem, parameters), {problem.weights.begin(), problem.weights.end()});
    return std::max(std::sqrt(median / median_square_of_three), least_misfit_scale(problem));
}

std::vector<double> losses_of(const LawProblem& problem, const LawParameters& parameters) {
    std::vector<double> losses = squares_of(problem, parameters);
    for (double& loss : losses) loss = half_loss(loss / (problem.scale * problem.scale));
    return losses;
}

LawFit fit_from(const LawProblem& problem, const std::vector<LawParameters>& starts,
                const std::optional<double>& fixed_restitution, const std::optional<double>& fixed_friction) {
    LawFit best;
    for (const LawParameters& start : starts) {
        const LawFit found = fit_law(problem, start, fixed_restitution, fixed_friction);
        if (!(found.loss >= best.loss)) best = found;
    }
    return best;
}

std::vector<LawFit> minima_of(const LawProblem& problem, const LawParameters& near, double most) {
    // Kinks of the law where contact modes change make small dents in the loss: also from beside it.
    std::vector<LawFit> found = {fit_law(problem, near)};
    for (const double factor : {0.96, 0.98, 1.02, 1.04})
        found.push_back(fit_law(problem, {near.restitution, factor * near.friction}));
    for (const double friction : {0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6, largest_friction}) {
        LawParameters parameters{0.5, friction};
        LawProblem coarse = problem;
        for (const double factor : {16.0, 4.0}) {
            coarse.scale = factor * problem.scale;
            parameters = fit_law(coarse, parameters).parameters;
        }
        found.push_back(fit_law(problem, parameters));
    }
    std::stable_sort(found.begin(), found.end(), [](const LawFit& a, const LawFit& b) { return a.loss < b.loss; });
    std::vector<LawFit> minima;
    for (const LawFit& one : found) {
        if (2 * (one.loss - found.front().loss) > most) break;
        constexpr double same = 0.01, level = 0.05;
        const bool is_new = std::none_of(minima.begin(), minima.end(), [&](const LawFit& other) {
            const LawParameters &a = one.parameters, &b = other.parameters;
            const bool flat = std::abs(one.loss - other.loss) < level;  // where any large μ predicts the same
            return std::abs(a.restitution - b.restitution) < same &&
                   (flat || std::abs(a.friction - b.friction) < same * (0.1 + b.friction));
        });
        if (is_new) minima.push_back(one);
    }
    return minima;
}

double worse_by(const std::vector<double>& losses, const std::vector<double>& best) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < losses.size(); ++i) sum += losses[i] - best[i];
    const double mean = sum / static_cast<double>(losses.size());
    for (std::size_t i = 0; i < losses.size(); ++i) squares += std::pow(losses[i] - best[i] - mean, 2);
    constexpr double rounding = 1e-6;  // of a loss, where fits end
    return sum > rounding * static_cast<double>(losses.size()) ? sum / std::sqrt(squares) : 0;
}

}  // namespace swirl::analysis
