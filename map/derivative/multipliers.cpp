#include "map/derivative/multipliers.hpp"

#include <Eigen/Eigenvalues>

namespace swirl {

Eigen::VectorXcd multipliers_of(const Eigen::MatrixXd& derivative) {
    return Eigen::EigenSolver<Eigen::MatrixXd>(derivative, false).eigenvalues();
}

}  // namespace swirl
