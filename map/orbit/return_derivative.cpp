#include "map/orbit/return_derivative.hpp"

#include <Eigen/SVD>

namespace swirl::detail {

Eigen::MatrixXd without_rounding(const Eigen::MatrixXd& b) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(b, Eigen::ComputeThinU | Eigen::ComputeThinV);
    Eigen::VectorXd sizes = svd.singularValues();
    for (auto& size : sizes)
        if (size <= difference_rounding) size = 0;
    return svd.matrixU() * sizes.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace swirl::detail
