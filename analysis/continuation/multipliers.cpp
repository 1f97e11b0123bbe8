#include "analysis/continuation/multipliers.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/linear_algebra/dense.hpp"

namespace swirl::analysis {

std::vector<std::complex<double>> multipliers_at(const CurvePoint& point) {
    return sorted_multipliers(monodromy(point.shooting));
}

double flip_function(const std::vector<std::complex<double>>& multipliers) {
    std::complex<double> product = 1;
    for (const auto& m : multipliers) product *= 1.0 + m;
    return product.real();
}

double neimark_sacker_function(const std::vector<std::complex<double>>& multipliers) {
    std::complex<double> product = 1;
    for (std::size_t i = 0; i < multipliers.size(); ++i)
        for (std::size_t j = i + 1; j < multipliers.size(); ++j) product *= multipliers[i] * multipliers[j] - 1.0;
    return product.real();
}

double crossing_function(const CurveProblem& problem, const CurvePoint& point) {
    return determinant_of(bordered(problem, point.shooting, point.tangent));
}

}  // namespace swirl::analysis
