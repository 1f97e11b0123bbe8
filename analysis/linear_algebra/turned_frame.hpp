// A frame turned by a derivative and made orthonormal again.
#pragma once

#include <Eigen/Core>
#include <Eigen/Householder>

namespace swirl::analysis {

/// The Householder decomposition A = Q R of a D × D matrix (D may be Eigen::Dynamic), by reflections one after the
/// other: Q takes A's place, the diagonal of R, with its signs, is returned. The same numbers as of Eigen's
/// HouseholderQR, whose blocks, which so small a matrix does not use, take some five seconds to compile for each size.
/// Cost: some 8 D³/3.
template <int D>
Eigen::Matrix<double, D, 1> turn_frame(Eigen::Matrix<double, D, D>& a) {
    const Eigen::Index n = a.rows();
    Eigen::Matrix<double, D, 1> scale(n), diagonal(n);
    Eigen::Matrix<double, 1, D> work(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        a.col(k).tail(n - k).makeHouseholderInPlace(scale[k], diagonal[k]);
        a.bottomRightCorner(n - k, n - k - 1)
            .applyHouseholderOnTheLeft(a.col(k).tail(n - k - 1), scale[k], work.data());
    }
    Eigen::Matrix<double, D, D> q = Eigen::Matrix<double, D, D>::Identity(n, n);
    for (Eigen::Index k = n - 1; k >= 0; --k)
        q.bottomRightCorner(n - k, n - k).applyHouseholderOnTheLeft(a.col(k).tail(n - k - 1), scale[k], work.data());
    a = q;
    return diagonal;
}

}  // namespace swirl::analysis
