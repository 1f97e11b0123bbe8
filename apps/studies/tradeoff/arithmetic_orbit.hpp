// What an arithmetic makes of the scene's orbit: its verdict, mean S, largest exponent, and what it loses of J.
#pragma once

#include "analysis/classification/mode.hpp"
#include "apps/studies/tradeoff/arithmetic.hpp"
#include "apps/studies/tradeoff/timing.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

namespace swirl::studies::tradeoff {

/// NaN where not measured: the orbit ended before.
struct ArithmeticOrbit {
    analysis::Mode mode = analysis::Mode::undecided;
    analysis::Kind kind = analysis::Kind::none;
    std::int64_t period = 0;  ///< 0: none
    Outcome outcome = Outcome::completed;
    std::int64_t impacts = 0;
    double duration = 0;                                                            ///< of all of them, in 1/ω_s
    double mean_spin = std::nan("");                                                ///< ∫S dt / T over all impacts
    double mean_spin_error = std::nan("");                                          ///< its standard error, by blocks
    double largest_exponent = std::nan(""), largest_exponent_error = std::nan("");  ///< per impact
    /// |J after − J before − what impacts and contact say they added|, of the sum over all impacts, per impact.
    double jacobi_drift = std::nan("");
};

/// Follows `count` impacts of an arithmetic's own from a state, and judges them by the arithmetic's own map;
/// derivatives are double's, at the arithmetic's states. Periods are looked for up to 256. Where impacts only lose
/// (is_dissipative_without_ drive) the verdict is known beforehand. Nothing if the budget is spent before.
std::optional<ArithmeticOrbit> orbit_by(const Arithmetic& arithmetic, const Scene<double>& scene,
                                        const PostImpactState<double>& begin, std::int64_t count, const Budget& budget);

}  // namespace swirl::studies::tradeoff
