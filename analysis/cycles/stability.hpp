// What the multipliers of a cycle say: which are neutral, which attract, which repel.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::analysis {

/// A modulus, or a multiplier, this near to 1 can't be told from it: a double multiplier 1 (e = 1 without friction)
/// splits by the root of the residual's rounding. And what attracts by less takes a million impacts to come e times
/// nearer: no orbit that is followed shows it.
inline constexpr double neutral_margin = 1e-6;

enum class Stability {
    stable,    ///< all multipliers inside the unit circle
    unstable,  ///< one outside
    neutral,   ///< none outside, some on it (to `neutral_margin`)
};
std::string_view name_of(Stability stability);

using Multipliers = std::span<const std::complex<double>>;

/// True if the multiplier is 1: that of a direction in which the cycle continues as a family.
bool is_one(std::complex<double> multiplier);

/// How many lie outside the unit circle.
int index_of(Multipliers multipliers);
Stability stability_of(Multipliers multipliers);

/// The largest modulus of those that are not 1, 0 if there is none: the rate at which a family, or a cycle, attracts.
double slowest_of(Multipliers multipliers);

/// True if all but those that are 1 lie inside the unit circle.
bool attracts(Multipliers multipliers);

/// The eigenvalues of DFᵏ in the order of `sort_multipliers`; none of a matrix that is not finite. Cost: some 10 D³.
std::vector<std::complex<double>> sorted_multipliers(const Eigen::MatrixXd& derivative);

/// By falling modulus; of a conjugate pair that with Im > 0 first.
void sort_multipliers(std::vector<std::complex<double>>& multipliers);

}  // namespace swirl::analysis
