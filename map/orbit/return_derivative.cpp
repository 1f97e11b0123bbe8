#include "map/orbit/return_derivative.hpp"

#include <Eigen/SVD>

namespace swirl::detail {

Eigen::MatrixXd without_rounding(const Eigen::MatrixXd& derivative) {
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    if (!derivative.allFinite()) return derivative;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(derivative, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::VectorXd sizes = svd.singularValues();  // the largest first
    for (auto& size : sizes)
        if (size <= rounding * svd.singularValues()[0]) size = 0;
    return svd.matrixU() * sizes.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace swirl::detail
