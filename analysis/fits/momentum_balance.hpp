// What momentum alone says of measured impacts, before any law: signs, inertia, noise.
#pragma once

#include "analysis/fits/measured_impact.hpp"
#include "analysis/special_values.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace swirl::analysis {

/// The impulse is what changes the linear momentum, whatever the law, and its torque changes the spin:
///     k ΔS = r_x Δv_y − r_y Δv_x.
/// ΔS is regressed on both products. Each coefficient is 1/k; one that is negative shows which sign was measured in
/// the other sense.
struct MomentumSigns {
    std::array<double, 2> coefficients{nan, nan};  ///< of r_x Δv_y and of −r_y Δv_x
    std::array<double, 2> errors{nan, nan};        ///< their standard errors
    int spin = 1;                                  ///< −1: S is measured in the sense from y to x
    int tangent = 1;  ///< −1: v_x is measured against the x of r and of the spin (or r_y, S and r_x are mirrored)
};

/// A coefficient counts as negative if it is below −`sure_sign` standard errors.
inline constexpr double sure_sign = 4;

/// By iteratively reweighted least squares, Tukey's biweight, from least absolute deviations, with Mallows' weights
/// against gross products. A coefficient that is not known (a disk has r_x = 0) asks for no change. O(impacts).
/// @throws std::invalid_argument for fewer than 3 impacts
MomentumSigns momentum_signs(std::span<const MeasuredImpact> impacts);

/// The impact with its spin and v_x multiplied by the signs.
MeasuredImpact with_signs(const MeasuredImpact& impact, const MomentumSigns& signs);

struct InertiaFit {
    double inertia = nan;  ///< k
    /// The robust standard deviation of the balance's residuals, in units of the standard errors that the impacts
    /// state: 1 if these are right.
    double scale = nan;
};

/// k by total least squares over the impacts, both sides of the balance having errors: Tukey's biweight of
/// (r_x Δv_y − r_y Δv_x − k ΔS)/√(variance of this), Ceres. A weight of an impact counts it so many times; 0 leaves it
/// out. Impacts that do not tell k (without friction nothing turns a disk) may leave it 0 or infinite, without a scale.
/// O(impacts).
InertiaFit fit_inertia(std::span<const MeasuredImpact> impacts, std::span<const double> weights, double start);
/// The same scale for a k that is given.
InertiaFit known_inertia(std::span<const MeasuredImpact> impacts, std::span<const double> weights, double inertia);

/// A k to start from: the ratio of the median absolute values of both sides.
double first_inertia(std::span<const MeasuredImpact> impacts);

/// What impacts do to the kinetic energy per mass, (v_x² + v_y² + k S²)/2.
struct EnergyChange {
    double ratio = nan;     ///< that after over that before, the median
    std::size_t rises = 0;  ///< impacts at which it surely does
};

/// Energy counts as risen by more than so many standard errors.
inline constexpr double sure_rise = 3;

/// At a wall that is at rest no impact with e ≤ 1 adds energy, whatever the friction: where it rises at most of them,
/// `before` is what was after, or the film runs backwards. Errors as the impacts state them. O(impacts).
EnergyChange energy_change(std::span<const MeasuredImpact> impacts, double inertia);

/// Which share of the balance's variance is the velocities' errors, the rest being the spin's. With x = r_x Δv_y,
/// y = −r_y Δv_x, s = ΔS and σ² the variance of a velocity,
///     ⟨x (x + y)⟩ = k ⟨x s⟩ + 2σ² ⟨r_x²⟩,   ⟨y (x + y)⟩ = k ⟨y s⟩ + 2σ² ⟨r_y²⟩
/// are two linear equations for k and σ². Errors equal in all of (v_x, v_y, √k S), as of a tracker whose error of the
/// angle times the radius of gyration is that of the position, have the share ⟨r²⟩/(⟨r²⟩ + k); the data's own is
/// averaged with it, weighted by its variance (jackknife by twentieths) and by 0.3² of this guess. In [0.02, 0.98].
double velocity_share(std::span<const MeasuredImpact> impacts, std::span<const double> weights, double inertia);

/// The impacts with unit errors of the velocities and such an error of the spin, the same for all, that the velocities
/// have this share.
std::vector<MeasuredImpact> with_shared_errors(std::span<const MeasuredImpact> impacts, double inertia, double share);

}  // namespace swirl::analysis
