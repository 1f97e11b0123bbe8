// Eigen's decompositions of matrices whose size is known at run time, compiled once in decompositions.cpp: a file that
// instantiates one of them for itself takes up to ten seconds longer.
#pragma once

#include <Eigen/Dense>

extern template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
extern template class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
extern template class Eigen::EigenSolver<Eigen::MatrixXd>;
extern template class Eigen::HouseholderQR<Eigen::MatrixXd>;
extern template class Eigen::JacobiSVD<Eigen::MatrixXcd>;
extern template class Eigen::JacobiSVD<Eigen::MatrixXd>;
extern template class Eigen::PartialPivLU<Eigen::MatrixXd>;
