#include "analysis/cycles/null_space.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

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
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeFullV);
    const auto& values = svd.singularValues();
    Eigen::Index rank = values.size();
    while (rank > 0 && values[rank - 1] <= null_margin * values[0]) --rank;
    return columns.asDiagonal() * svd.matrixV().rightCols(matrix.cols() - rank);
}

}  // namespace swirl::analysis
