#include "map/orbit/return_derivative.hpp"

#include <Eigen/SVD>

namespace swirl::detail {

Eigen::MatrixXd without_rounding(const Eigen::MatrixXd& derivative, double speed) {
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    if (!derivative.allFinite() || !(speed > 0)) return derivative;
    Eigen::VectorXd units = Eigen::VectorXd::Ones(derivative.rows());
    units.tail(3).setConstant(speed);
    const Eigen::MatrixXd balanced = units.cwiseInverse().asDiagonal() * derivative * units.asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(balanced, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::VectorXd sizes = svd.singularValues();  // the largest first
    for (auto& size : sizes)
        if (size <= rounding * svd.singularValues()[0]) size = 0;
    const Eigen::MatrixXd kept = svd.matrixU() * sizes.asDiagonal() * svd.matrixV().transpose();
    return units.asDiagonal() * kept * units.cwiseInverse().asDiagonal();
}

}  // namespace swirl::detail
