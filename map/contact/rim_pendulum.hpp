// A disk on the wall is a pendulum while it rolls, and while it slides without friction.
//
//     ψ″ = −k sin ψ,  k = β/(ρ(1 + κ)) rolling, β/ρ without friction;  ρ = 1 − α
//
// ψ′²/2 + k(1 − cos ψ) = h is conserved: it rests (h = 0), librates about ψ = 0 (h < 2k) or circulates. With m = h/2k,
// ω = √k and Jacobi's functions of modulus √m (librating) or 1/√m (circulating)
//
//     librating    sin ψ/2 = √m sn(ωt)    ψ′ = 2ω√m cn(ωt)     period 4K(√m)/ω
//     circulating  sin ψ/2 = sn(ω√m t)    ψ′ = 2ω√m dn(ω√m t)  period 2K(1/√m)/(ω√m)
//
// In double: it tells what becomes of a contact that lasts, and no impact follows from it.
// Source: Landau, Lifshitz, Mechanics, § 11; derived in map/contact/README.md.
#pragma once

#include "map/contact/contact_state.hpp"

#include <optional>

namespace swirl {

struct RimPendulum {
    bool rolls = true;     ///< false: slides without friction, S is any constant
    double strength = 0;   ///< k, in ω_s²
    double height = 0;     ///< h, in ω_s²: the energy above rest
    double direction = 1;  ///< the sign of ψ′ at the state that it was made from

    bool turns() const { return height > 2 * strength; }
};

/// The pendulum of a disk's state in contact. Rolling (u_t = 0) where there is friction.
RimPendulum rim_pendulum(const ContactScene<double>& scene, const ContactState<double>& state);

/// Time from ψ and ψ′ back to both, in 1/ω_s (ψ modulo 2π): of small swings 2π/√k, infinite on the separatrix.
double period_of(const RimPendulum& pendulum);

/// The time mean of S over a period, rolling: −(ρ/α)(1 + mean ψ′), where ψ′ has the mean 0 (librating) or ±2π/period.
double mean_rolling_spin(const ContactScene<double>& scene, const RimPendulum& pendulum);

/// The margin of the contact, its minimum over a whole period: μλ − |f| rolling, λ without friction, with λ = β cos ψ +
/// ρ(1 + ψ′)² and |f| = κβ|sin ψ|/(1 + κ). If it is positive the contact never ends. Cost: some microseconds.
double least_hold(const ContactScene<double>& scene, const RimPendulum& pendulum);

/// The limit of a disk that slips a little in each period. With x the share of friction that is missing, the slips on
/// either side of ψ = 0 change ψ′ by O(x^{3/2}) each and cancel to that order; a period changes x by O(−x²). So the
/// distance to the pendulum on which friction just holds, `least_hold` = 0, falls like 1/n in n periods.
/// @return the pendulum of the same kind, of the energy nearest below on which friction just holds; the pendulum itself
///         if friction holds; none if there is none
std::optional<RimPendulum> settled_pendulum(const ContactScene<double>& scene, const RimPendulum& pendulum);

/// The state of a rolling or frictionless disk a time later, if nothing ends the contact before; ψ is unwound. Error:
/// some ε times the turns of ψ.
ContactState<double> advance_rim(const ContactScene<double>& scene, const ContactState<double>& state, double time);

}  // namespace swirl
