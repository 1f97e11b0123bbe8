// From a table of measured impacts to e, μ, the law and how well all of it is known.
#pragma once

#include "analysis/fits/alike_impacts.hpp"
#include "analysis/fits/constancy.hpp"
#include "analysis/fits/law_fit.hpp"
#include "analysis/fits/momentum_balance.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace swirl::analysis {

struct ImpactFitSettings {
    std::optional<double> inertia;    ///< k = I/m, else fitted
    bool stated_errors = false;       ///< the impacts' errors are known; else they are fitted, see velocity_share
    bool fixed_weights = false;       ///< only the middle of alike impacts counts, see with_fixed_weights()
    double rivals_within = no_rival;  ///< deviance up to which another minimum starts fits of the resamples
    bool signs_known = false;         ///< spin and v_x are in the right sense: momentum turns none
    std::size_t resamples = 200;      ///< of the bootstrap over impacts; 0: e, μ and the law alone, without intervals
    std::size_t parts = 10;           ///< of the cross-validation
    std::uint64_t seed = 1;
    int threads = 0;  ///< 0: all
    /// Resample number `index`, where impacts rest on what is fitted to them all or are means of several; none: the
    /// impacts as they are, drawn with replacement.
    std::function<WeighedImpacts(std::uint64_t index)> resampled;
};

enum class ImpactFitOutcome {
    fitted,
    no_offsets,      ///< r = 0 at most of the impacts: an impulse turns nothing, and friction shows nowhere
    no_inertia,      ///< the spin does not change, so that momentum does not tell k
    receding,        ///< at most of the impacts the contact moves away from the wall before, or into it after
    gains_energy,    ///< energy surely rises at more than half of the impacts (energy_change): no wall adds any
    inertia_absurd,  ///< the given k, or that of momentum, is not within 10^±6 of the offsets' median r²
    not_fitted       ///< noise, scale or loss is no number
};

/// A value with its interval at 95 %.
struct FittedNumber {
    double value = nan, low = nan, high = nan;
};

/// One of the laws, fitted.
struct FittedLaw {
    std::string name;
    LawParameters parameters;
    double loss = nan;
    /// How much worse it is than the best one, in standard errors of the sum of differences impact by impact (Vuong,
    /// Econometrica 57 (1989) 307); 0 of the best one, and of one that predicts the same.
    double worse_by = 0;
};

/// The loss over one parameter, the other one fitted: deviance 2 (loss − least loss), χ² with 1 degree of freedom.
struct LossProfile {
    std::vector<double> values, deviances;
};

struct ImpactFit {
    ImpactFitOutcome outcome =
        ImpactFitOutcome::fitted;  ///< any other: nothing but `length`, `inertia` and `energy` below
    std::size_t left_out = 0;      ///< impacts with a number a million times the others' (natural_units.hpp)
    double length = nan;           ///< a length of the offsets: the power of two next to their median
    MomentumSigns signs;
    FittedNumber restitution, friction;
    FittedNumber inertia;  ///< k that was used; of a given one all three are that
    FittedNumber balance;  ///< k by momentum alone; high NaN: no upper end, as of inertia
    EnergyChange energy;
    bool friction_open = false;  ///< any μ above friction.low does: nothing slides to the end, value and high are NaN
    std::size_t best = 0;        ///< of `laws`
    std::vector<FittedLaw> laws;
    LawParameters weighed_at;                       ///< where fixed weights are those of the errors
    std::vector<Rival> rivals;                      ///< that explain the impacts nearly as well
    bool law_decided = false;                       ///< every other law is worse by `sure_law`
    double velocity_noise = nan, spin_noise = nan;  ///< standard errors that momentum shows, or that were stated
    double scatter = nan;                           ///< of the misfits to the law, in units of that noise
    double predicted = nan;                         ///< share of held-out impacts within the noise
    LossProfile restitution_profile, friction_profile;
    std::vector<ConstancyTest> constancy;
    std::vector<MeasuredImpact> impacts;    ///< with the signs that momentum asks for, and with their errors
    std::vector<ImpactResidual> residuals;  ///< of each
    std::vector<double> held_out;  ///< of each: squared distance of the prediction by a fit without it, χ²(3)
};

/// Two comparisons at 5 % together.
inline constexpr double sure_law = 2.241;
/// 95 % of χ² with 1 and 3 degrees of freedom.
inline constexpr double sure_square_of_one = 3.841459;
inline constexpr double sure_square_of_three = 7.814728;
/// Fewer impacts are not fitted.
inline constexpr std::size_t fewest_impacts = 8;

/// Momentum first: signs, k and noise, in natural units, so that all that follows is the same in any; then each law by
/// total least squares; then what the data can tell. Intervals are quantiles of a bootstrap over impacts, k and law
/// (among those that are not clearly worse) chosen anew in each resample; that of a μ without an upper end, and of one
/// given k, see analysis/fits/README.md. Parallel over resamples, equal bits whatever the number of threads. Cost: some
/// 15 fits an impact and resample.
/// @throws std::invalid_argument for fewer than `fewest_impacts` impacts without a gross error, or no law
ImpactFit fit_impacts(std::span<const MeasuredImpact> impacts, std::span<const NamedImpactLaw> laws,
                      const ImpactFitSettings& settings);

}  // namespace swirl::analysis
