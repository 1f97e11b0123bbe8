#include "analysis/linear_algebra/dense.hpp"

#include <Eigen/Eigenvalues>

namespace swirl::analysis {

Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues();
}

}  // namespace swirl::analysis
