#include "analysis/cycles/stability.hpp"

#include "analysis/enum_name.hpp"
#include "analysis/linear_algebra/dense.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::analysis {

std::string_view name_of(Stability stability) {
    using enum Stability;
    return name_in<Stability>({{stable, "stable"}, {unstable, "unstable"}, {neutral, "neutral"}}, stability);
}

bool is_one(std::complex<double> multiplier) {
    return std::abs(multiplier - 1.0) <= neutral_margin;
}

int index_of(Multipliers multipliers) {
    return static_cast<int>(std::count_if(multipliers.begin(), multipliers.end(),
                                          [](const auto& m) { return std::abs(m) > 1 + neutral_margin; }));
}

Stability stability_of(Multipliers multipliers) {
    if (index_of(multipliers) > 0) return Stability::unstable;
    const bool on = std::any_of(multipliers.begin(), multipliers.end(),
                                [](const auto& m) { return std::abs(m) >= 1 - neutral_margin; });
    return on ? Stability::neutral : Stability::stable;
}

double slowest_of(Multipliers multipliers) {
    double slowest = 0;
    for (const auto& m : multipliers)
        if (!is_one(m)) slowest = std::max(slowest, std::abs(m));
    return slowest;
}

bool attracts(Multipliers multipliers) {
    return std::all_of(multipliers.begin(), multipliers.end(),
                       [](const auto& m) { return is_one(m) || std::abs(m) < 1 - neutral_margin; });
}

std::vector<std::complex<double>> sorted_multipliers(const Eigen::MatrixXd& derivative) {
    if (!derivative.allFinite()) return {};
    const Eigen::VectorXcd values = eigenvalues_of(derivative);
    std::vector<std::complex<double>> multipliers(values.data(), values.data() + values.size());
    sort_multipliers(multipliers);
    return multipliers;
}

void sort_multipliers(std::vector<std::complex<double>>& multipliers) {
    std::stable_sort(multipliers.begin(), multipliers.end(), [](const auto& a, const auto& b) {
        const double first = std::abs(a), second = std::abs(b);
        if (std::abs(first - second) > 1e-12 * (first + second)) return first > second;
        return a.imag() > b.imag();
    });
}

}  // namespace swirl::analysis
