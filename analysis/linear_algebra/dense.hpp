// Decompositions of small dense matrices whose size is known at run time, by Eigen. They stand in files of their own,
// because a file that instantiates one of them takes some ten seconds longer to compile.
#pragma once

#include <Eigen/Core>

namespace swirl::analysis {

/// The eigenvalues of a square matrix, in Eigen's order. Cost: a Hessenberg reduction and the QR algorithm, some 10 n³.
Eigen::VectorXcd eigenvalues_of(const Eigen::MatrixXd& matrix);

struct SingularVectors {
    Eigen::VectorXd values;  ///< falling, as many as the smaller of rows and columns
    Eigen::MatrixXd right;   ///< columns: the right singular vectors, all of them, in the order of the values
};

/// Singular values and right singular vectors by one-sided Jacobi rotations, which find small values to high relative
/// accuracy. Null vectors are the last columns.
SingularVectors right_singular_vectors(const Eigen::MatrixXd& matrix);

/// x with matrix · x = right, by QR with column pivoting; the least-squares solution where there is none.
Eigen::VectorXd solve_by_qr(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// The shortest x that minimises |matrix · x − right|, by the complete orthogonal decomposition.
///   threshold  pivots below that share of the largest count as zero
Eigen::VectorXd minimum_norm_solution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, double threshold);

/// The rank by QR with column pivoting; `threshold` as above.
Eigen::Index rank_of(const Eigen::MatrixXd& matrix, double threshold);

/// The determinant of a square matrix, by LU with partial pivoting.
double determinant_of(const Eigen::MatrixXd& matrix);

}  // namespace swirl::analysis
