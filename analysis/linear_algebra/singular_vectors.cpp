#include "analysis/linear_algebra/dense.hpp"

#include <Eigen/SVD>

namespace swirl::analysis {

SingularVectors right_singular_vectors(const Eigen::MatrixXd& matrix) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
    return {svd.singularValues(), svd.matrixV()};
}

}  // namespace swirl::analysis
