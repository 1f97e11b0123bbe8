#include "analysis/lyapunov/cycle_exponents.hpp"

#include "analysis/enum_name.hpp"
#include "analysis/lyapunov/exponent_record.hpp"
#include "analysis/lyapunov/wide_schur.hpp"
#include "analysis/special_values.hpp"

#include <boost/multiprecision/eigen.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace swirl::analysis {

namespace {

/// 100 digits less what the eigenvalue solver's normwise error and double's own 16 digits need.
constexpr double widest_ratio = 1e-80;

void require_square(std::span<const Eigen::MatrixXd> derivatives) {
    if (derivatives.empty()) throw std::invalid_argument("cycle length = 0: must be at least 1");
    for (const Eigen::MatrixXd& d : derivatives) {
        if (d.rows() > 0 && d.rows() == derivatives[0].rows() && d.cols() == d.rows()) continue;
        throw std::invalid_argument("derivative of size " + std::to_string(d.rows()) + " × " +
                                    std::to_string(d.cols()) + ": all must be square and alike");
    }
}

struct WideMultiplier {
    Wide real;
    Wide imaginary;
    Wide modulus;
};

/// ln x, as exact as a double can be: a logarithm in 100 digits takes as long as a tenth of the eigenvalues.
double log_of(const Wide& x) {
    if (x > 0.5 && x < 2) return std::log1p(static_cast<double>(Wide(x - 1)));
    int exponent = 0;
    const auto mantissa = static_cast<double>(Wide(frexp(x, &exponent)));
    return std::log(mantissa) + exponent * std::log(2.0);
}

/// The complex pair of a 2 × 2 block [[a, b], [c, d]] on the diagonal: (a + d)/2 ± i √−(p² + b c), p = (a − d)/2.
void add_pair(const Eigen::Matrix<Wide, 2, 2>& block, std::vector<WideMultiplier>& multipliers) {
    const Wide p = Wide(block(0, 0) - block(1, 1)) / 2;
    const Wide real = block(1, 1) + p;
    const Wide imaginary = sqrt(abs(Wide(p * p + block(1, 0) * block(0, 1))));
    const Wide modulus = sqrt(Wide(real * real + imaginary * imaginary));
    multipliers.push_back({real, imaginary, modulus});
    multipliers.push_back({real, -imaginary, modulus});
}

/// By the real Schur form. (Eigen's EigenSolver gives the same; what it compiles beside takes as long again.)
std::vector<WideMultiplier> wide_multipliers(std::span<const Eigen::MatrixXd> derivatives) {
    WideMatrix product = derivatives[0].cast<Wide>();
    for (std::size_t i = 1; i < derivatives.size(); ++i)
        product = derivatives[i].cast<Wide>().lazyProduct(product).eval();
    const std::optional<WideMatrix> schur = real_schur_form(product);
    std::vector<WideMultiplier> result;
    if (!schur) {  // zeros where no rank is lost are unresolved
        result.resize(static_cast<std::size_t>(product.rows()));
        return result;
    }
    const WideMatrix& t = *schur;
    for (Eigen::Index i = 0; i < t.rows(); ++i) {
        if (i + 1 == t.rows() || t(i + 1, i) == 0) {
            result.push_back({t(i, i), 0, abs(t(i, i))});
        } else {
            add_pair(t.block<2, 2>(i, i), result);
            ++i;
        }
    }
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.modulus > b.modulus; });
    return result;
}

}  // namespace

std::string_view name_of(CycleOutcome outcome) {
    using enum CycleOutcome;
    return name_in<CycleOutcome>({{completed, "completed"},
                                  {ended_early, "ended-early"},
                                  {not_finite, "not-finite"},
                                  {unresolved, "unresolved"}},
                                 outcome);
}

CycleExponents cycle_exponents(std::span<const Eigen::MatrixXd> derivatives, double rank_tolerance) {
    require_square(derivatives);
    CycleExponents result;
    for (const Eigen::MatrixXd& derivative : derivatives) {
        if (derivative.allFinite()) continue;
        result.outcome = CycleOutcome::not_finite;
        return result;
    }
    const std::vector<WideMultiplier> wide = wide_multipliers(derivatives);
    const std::size_t kept = wide.size() - static_cast<std::size_t>(lost_ranks(derivatives, rank_tolerance));
    const double length = static_cast<double>(derivatives.size());
    for (std::size_t i = 0; i < wide.size(); ++i) {
        if (i >= kept) {
            result.multipliers.emplace_back(0, 0);
            result.exponents.push_back(-infinity);
        } else if (wide[i].modulus <= widest_ratio * wide[0].modulus) {
            result.outcome = CycleOutcome::unresolved;
            result.multipliers.emplace_back(nan, nan);
            result.exponents.push_back(nan);
        } else {
            result.multipliers.emplace_back(static_cast<double>(wide[i].real), static_cast<double>(wide[i].imaginary));
            result.exponents.push_back(log_of(wide[i].modulus) / length);
        }
    }
    return result;
}

}  // namespace swirl::analysis
