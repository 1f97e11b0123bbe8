// Exact exponents of a cycle from the multipliers of DFᵏ, however different their sizes.
#pragma once

#include "analysis/section_map.hpp"
#include "analysis/within_period.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::analysis {

enum class CycleOutcome {
    completed,
    ended_early,  ///< the map ended within the cycle
    not_finite,
    unresolved,  ///< multipliers differ by more than 10⁸⁰: the smaller ones are NaN
};
std::string_view name_of(CycleOutcome outcome);

/// By falling modulus, vectors of length D.
struct CycleExponents {
    CycleOutcome outcome = CycleOutcome::completed;
    std::vector<std::complex<double>> multipliers;  ///< eigenvalues of DF(z_k) … DF(z_1); 0 where a rank is lost
    std::vector<double> exponents;                  ///< ln|multiplier|/k per step; −∞ for 0
    double time = 0;                                ///< duration of the cycle, if it was followed
    double closure = 0;  ///< max-norm of Fᵏ(z) − z, angles modulo their period; if followed
};

/// Eigenvalues of the product D_k … D_1 of square matrices, formed and solved in 100 decimal digits, so that each is as
/// accurate as the D_i make it. As many of the smallest are exactly zero as QR around the cycle finds ranks lost at
/// `rank_tolerance` (see LyapunovOptions). Throws std::invalid_argument if there is no matrix or one does not fit.
/// Cost about k D³ · 0.3 µs + 25 D³ · 10 µs.
CycleExponents cycle_exponents(std::span<const Eigen::MatrixXd> derivatives, double rank_tolerance = 1e-13);

/// The exponents of the cycle of length k through `state`, which must be on it: see `closure`.
template <SectionMap M>
CycleExponents cycle_exponents(const M& map, const State<M>& state, std::int64_t k, double rank_tolerance = 1e-13) {
    constexpr int D = M::dimension;
    std::vector<Eigen::MatrixXd> derivatives;
    State<M> z = state;
    double time = 0;
    for (std::int64_t i = 0; i < k; ++i) {
        const auto step = map.linearise(z);
        if (!goes_on(map, step) || !step.derivative.allFinite()) {
            CycleExponents ended;
            ended.outcome = step.alive ? CycleOutcome::not_finite : CycleOutcome::ended_early;
            return ended;
        }
        derivatives.push_back(step.derivative);
        time += step.duration;
        z = step.state;
    }
    CycleExponents result = cycle_exponents(derivatives, rank_tolerance);
    result.time = time;
    const Vector<D> open = coordinates(map, z) - coordinates(map, state);
    for (int i = 0; i < D; ++i)
        result.closure = std::max(result.closure, std::abs(within_period(open[i], map.angle_period(i))));
    return result;
}

}  // namespace swirl::analysis
