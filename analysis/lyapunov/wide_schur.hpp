// The real Schur form in a hundred digits: multipliers of a cycle whose moduli lie eighty decades apart.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <Eigen/Core>

#include <optional>

namespace swirl::analysis {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                           boost::multiprecision::et_off>;
using WideMatrix = Eigen::Matrix<Wide, Eigen::Dynamic, Eigen::Dynamic>;

/// T of A = Q T Qᵀ, Q orthogonal, T block upper triangular with blocks of 1 × 1 (a real eigenvalue) and 2 × 2 (a
/// complex pair) on its diagonal, by Householder's reduction to Hessenberg form and Francis's double-shift QR steps
/// (Golub & Van Loan, Matrix Computations, 4th ed., section 7.5). The error is 10⁻¹⁰⁰‖A‖ times a small number. Nothing
/// where the steps do not converge. O(n³) operations of about a microsecond.
std::optional<WideMatrix> real_schur_form(const WideMatrix& a);

}  // namespace swirl::analysis
