#include "analysis/cycles/multi_shooting.hpp"

#include "analysis/linear_algebra/dense.hpp"
#include "analysis/special_values.hpp"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace swirl::analysis {

namespace {

/// 1/√ of the largest of each row (column); 1 where all are zero.
double factor_of(double largest) {
    return largest > 0 ? 1 / std::sqrt(largest) : 1.0;
}

}  // namespace

Eigen::VectorXd equilibrate(Eigen::MatrixXd& matrix) {
    constexpr int rounds = 12;  // the logarithms of all maxima halve in each
    Eigen::VectorXd columns = Eigen::VectorXd::Ones(matrix.cols());
    for (int round = 0; round < rounds; ++round) {
        const Eigen::VectorXd by_row = matrix.cwiseAbs().rowwise().maxCoeff().unaryExpr(&factor_of);
        const Eigen::VectorXd by_column = matrix.cwiseAbs().colwise().maxCoeff().transpose().unaryExpr(&factor_of);
        matrix = by_row.asDiagonal() * matrix * by_column.asDiagonal();
        columns = columns.cwiseProduct(by_column);
    }
    return columns;
}

Eigen::MatrixXd null_vectors(const Eigen::MatrixXd& matrix) {
    Eigen::MatrixXd scaled = matrix;
    const Eigen::VectorXd columns = equilibrate(scaled);
    const SingularVectors svd = right_singular_vectors(scaled);
    const Eigen::VectorXd& values = svd.values;
    Eigen::Index rank = values.size();
    while (rank > 0 && values[rank - 1] <= null_margin * values[0]) --rank;
    return columns.asDiagonal() * svd.right.rightCols(matrix.cols() - rank);
}

namespace {

/// F(z_i; p) − z_{i+1}; for k = 1 both are the same block. (Ceres asks for a class.)
class StepResidual final : public ceres::CostFunction {
public:
    StepResidual(const ShootingMap& map, double p, bool closed) : map_(map), p_(p) {
        set_num_residuals(map.dimension);
        mutable_parameter_block_sizes()->push_back(map.dimension);
        if (!closed) mutable_parameter_block_sizes()->push_back(map.dimension);
    }

    bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
        const int d = map_.dimension;
        const bool closed = parameter_block_sizes().size() == 1;
        const Eigen::VectorXd z = Eigen::Map<const Eigen::VectorXd>(blocks[0], d);
        const Eigen::VectorXd next = Eigen::Map<const Eigen::VectorXd>(blocks[closed ? 0 : 1], d);
        const ShootingStep& step = step_from(z);
        if (!step.alive) return false;
        Eigen::Map<Eigen::VectorXd>(residuals, d) = map_.gap(step.state, next);
        using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(d, d);
        identity.diagonal().tail(map_.constraints).setZero();
        if (jacobians != nullptr && jacobians[0] != nullptr) {
            Eigen::Map<RowMajor> by_state(jacobians[0], d, d);
            by_state = step.by_state;
            if (closed) by_state -= identity;
        }
        if (!closed && jacobians != nullptr && jacobians[1] != nullptr)
            Eigen::Map<RowMajor>(jacobians[1], d, d) = -identity;
        return true;
    }

private:
    /// Ceres asks for the residual alone where it may go, and for the Jacobian beside it where it went: the same step.
    const ShootingStep& step_from(const Eigen::VectorXd& z) const {
        if (from_.size() == z.size() && from_ == z) return step_;
        step_ = map_.step(z, p_);
        from_ = z;
        return step_;
    }

    const ShootingMap& map_;
    double p_;
    mutable Eigen::VectorXd from_;  // a problem is solved by one thread
    mutable ShootingStep step_;
};

constexpr double same_time = 1e-6;  // another contact lies farther away, or the two can't be told apart

constexpr std::size_t stall_window = 8;  // iterations, of ShootingOptions::one_of_many

/// Ends the solver where the polishing can take over, and one of many where it gets nowhere.
class StopWhenNear final : public ceres::IterationCallback {
public:
    explicit StopWhenNear(const ShootingOptions& options)
        : near_(0.5 * options.residual * options.residual), gives_up_(options.one_of_many) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
        least_.push_back(least_.empty() ? summary.cost : std::min(least_.back(), summary.cost));
        const bool stalls =
            gives_up_ && least_.size() > stall_window && least_.back() > 0.8 * least_[least_.size() - 1 - stall_window];
        return stalls || least_.back() <= near_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
    }

private:
    double near_;
    bool gives_up_;
    std::vector<double> least_;  ///< cost up to each iteration
};

ceres::Solver::Options solver_options(const ShootingOptions& options, std::size_t unknowns) {
    ceres::Solver::Options solver;
    const auto dense = options.one_of_many && unknowns > 10 ? ceres::DENSE_NORMAL_CHOLESKY : ceres::DENSE_QR;
    solver.linear_solver_type = unknowns <= 60 ? dense : ceres::SPARSE_NORMAL_CHOLESKY;
    solver.max_num_iterations = options.most_iterations;
    solver.initial_trust_region_radius = options.radius;
    solver.function_tolerance = 1e-12;  // relative fall of the cost: a local minimum that is no cycle
    solver.gradient_tolerance = 0;
    solver.parameter_tolerance = 1e-14;
    solver.max_num_consecutive_invalid_steps = 10;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    return solver;
}

}  // namespace

ShootingResult solve_shooting(const ShootingMap& map, const CyclePoints& guess, double p, double accept,
                              const ShootingOptions& options) {
    ShootingResult result;
    result.points = guess;
    result.residual = infinity;
    if (!shooting_residual(map, guess, p).alive) return result;
    const auto k = guess.size();
    ceres::Problem problem;
    for (std::size_t i = 0; i < k; ++i) {
        double* here = result.points[i].data();
        if (k == 1)
            problem.AddResidualBlock(new StepResidual(map, p, true), nullptr, here);
        else
            problem.AddResidualBlock(new StepResidual(map, p, false), nullptr, here, result.points[(i + 1) % k].data());
    }
    auto solver = solver_options(options, k * static_cast<std::size_t>(map.dimension));
    StopWhenNear stop(options);
    solver.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    result.iterations = static_cast<int>(summary.iterations.size());
    if (!summary.IsSolutionUsable() || !(summary.final_cost < 1e-6)) return result;  // |G| ≈ 10⁻³: too far for Newton
    result.residual = polish_cycle(map, result.points, p);
    result.converged = result.residual <= accept || closes_to(shooting_residual(map, result.points, p), accept);
    return result;
}

ShootingResult solve_near_grazing(const ShootingMap& map, const TimedMap& timed, const CyclePoints& guess, double p,
                                  double accept, const ShootingOptions& options) {
    ShootingResult result;
    result.points = guess;
    result.residual = infinity;
    CyclePoints with_times;
    for (std::size_t i = 0; i < guess.size(); ++i) {
        Eigen::VectorXd extended(timed.map.dimension);
        extended << guess[i], timed.time_between(guess[i], guess[(i + 1) % guess.size()]);
        with_times.push_back(extended);
    }
    const ShootingResult shot = solve_shooting(timed.map, with_times, p, accept, options);
    result.iterations = shot.iterations;
    if (!shot.converged) return result;
    for (std::size_t i = 0; i < guess.size(); ++i) result.points[i] = shot.points[i].head(map.dimension);
    const ShootingResidual shooting = shooting_residual(map, result.points, p);
    if (!shooting.alive) return result;
    for (std::size_t i = 0; i < guess.size(); ++i)  // the map's first contact, and no other
        if (std::abs(shooting.steps[i].duration - shot.points[i].tail(1)[0]) > same_time) return result;
    result.residual = shooting.residual();
    result.converged = closes_to(shooting, accept);
    return result;
}

}  // namespace swirl::analysis
