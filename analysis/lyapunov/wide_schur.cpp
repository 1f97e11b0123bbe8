#include "analysis/lyapunov/wide_schur.hpp"

#include <boost/multiprecision/eigen.hpp>

#include <Eigen/Eigenvalues>

namespace swirl::analysis {

std::optional<WideMatrix> real_schur_form(const WideMatrix& a) {
    const Eigen::HessenbergDecomposition<WideMatrix> hessenberg(a);
    Eigen::RealSchur<WideMatrix> schur(a.rows());
    schur.computeFromHessenberg(hessenberg.matrixH(), a, false);  // the second is of Schur vectors, not asked for
    if (schur.info() != Eigen::Success) return std::nullopt;
    return schur.matrixT();
}

}  // namespace swirl::analysis
