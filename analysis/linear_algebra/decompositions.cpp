#include "analysis/linear_algebra/decompositions.hpp"

template class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
template class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
template class Eigen::EigenSolver<Eigen::MatrixXd>;
template class Eigen::HouseholderQR<Eigen::MatrixXd>;
template class Eigen::JacobiSVD<Eigen::MatrixXcd>;
template class Eigen::JacobiSVD<Eigen::MatrixXd>;
template class Eigen::PartialPivLU<Eigen::MatrixXd>;
