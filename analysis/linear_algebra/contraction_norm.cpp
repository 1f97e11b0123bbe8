#include "analysis/linear_algebra/contraction_norm.hpp"

#include "analysis/linear_algebra/dense.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace swirl::analysis {

Eigen::VectorXd ContractionNorm::axis(Eigen::Index i, double size) const {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(root.rows(), i) * size;
    return root.triangularView<Eigen::Upper>().solve(unit);
}

std::optional<ContractionNorm> contraction_norm(const Eigen::MatrixXd& a) {
    constexpr double most = 1e12;     // of P: beyond, 1 − q is within rounding
    constexpr int doublings = 64;     // of 2ʲ powers; 45 are enough for that P
    constexpr double nothing = 1e-9;  // of a power of A: what follows adds its square
    Eigen::MatrixXd sum = Eigen::MatrixXd::Identity(a.rows(), a.cols()), power = a;
    for (int i = 0; i < doublings && power.norm() > nothing; ++i) {
        sum += (power.transpose() * sum * power).eval();
        if (!(sum.norm() < most)) return {};
        power = (power * power).eval();
    }
    if (!(power.norm() <= nothing)) return {};
    ContractionNorm norm;
    norm.root = sum.llt().matrixU();
    norm.largest = std::max(1.0, eigenvalues_of(sum).real().maxCoeff());
    norm.rate = std::sqrt(1 - 1 / norm.largest);
    return norm;
}

}  // namespace swirl::analysis
