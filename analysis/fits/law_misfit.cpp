#include "analysis/fits/law_misfit.hpp"

#include <Eigen/Cholesky>

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
    const Eigen::LLT<Eigen::Matrix3d> root(covariance_of(impact, by_before));
    MeasuredImpact weighed = impact;
    weighed.whitening = root.matrixL().solve(Eigen::Matrix3d::Identity());
    return weighed;
}

Prediction predict(const MeasuredImpact& impact, double inertia, const ImpactLaw& law,
                   const LawParameters& parameters) {
    const LawStep step = step_from(impact, impact.before, inertia, law, parameters);
    const Eigen::Vector3d left = impact.after - step.after;
    return {step.after, left.dot(covariance_of(impact, step.by_before).llt().solve(left))};
}

}  // namespace swirl::analysis
