#include "analysis/linear_algebra/dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>

namespace swirl::analysis {

Eigen::VectorXd solve_by_qr(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
    return matrix.colPivHouseholderQr().solve(right);
}

Eigen::VectorXd minimum_norm_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, double threshold) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(threshold);
    solver.compute(matrix);
    return solver.solve(right);
}

Eigen::Index rank_of(const Eigen::MatrixXd& matrix, double threshold) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver;
    solver.setThreshold(threshold);
    return solver.compute(matrix).rank();
}

double determinant_of(const Eigen::MatrixXd& matrix) {
    return matrix.partialPivLu().determinant();
}

}  // namespace swirl::analysis
