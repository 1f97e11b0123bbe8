// What is known in closed form of a body over a floor that drags. map/dragged/README.md, "Riding" and "Rolling".
#pragma once

#include "map/model/scene.hpp"

#include <optional>

namespace swirl {

/// A disk on the wall that rolls locked to the swirl, ψ′ = 0: S = −ρ/α with ρ = 1 − α and
///
///     β(sin ψ + γ[table] cos ψ) = −(γ + κγ_r)ρ      so that it exists iff (γ + κγ_r)ρ ≤ β √(1 + γ²[table]).
///
/// The wall's friction is −κγ_rρ, and the normal force λ = β(cos ψ − γ[table] sin ψ) + ρ.
struct LockedRolling {
    double psi = 0;       ///< of the one that is restored: cos ψ > γ[table] sin ψ
    double spin = 0;      ///< S
    double force = 0;     ///< λ, in m R_c ω_s²
    double friction = 0;  ///< μ from which on friction holds it
    bool holds = false;   ///< λ > 0 and μ is that large
    /// Γ = γ − 2κργ_r/λ: about this motion an elastic disk bounces with v³/λ ∝ e^{−Γt}, v the small speed at which it
    /// leaves the wall. Γ < 0: its bounces grow.
    double bounce_decay = 0;
};

struct FloorFacts {
    /// A dish: the radius |h|β = β/√(1 + γ²) of the circle on which a body that rides along goes about its place Q in
    /// the container, S = 0. A table: β, of the circle on which the container goes about a body at rest on it.
    double riding_radius = 0;
    /// 1 − α − `riding_radius`: |Q| up to which a body does so without contact, whatever its orientation; < 0: none
    /// does (a polygon may have somewhat more room).
    double riding_room = 0;
    bool rides = false;  ///< some body does: γ > 0 and room for it, of a polygon as of a disk (README.md, "Flight")
    /// Of a disk with friction: (γ + κγ_r)ρ/(β√(1 + γ²[table])), which must be ≤ 1; infinite without swirl.
    std::optional<double> locking_ratio;
    std::optional<LockedRolling> locked;  ///< if it is
};

/// A disk without friction that slides with ψ′ = 0: as `FloorFacts::locked` with κ = 0, so that Γ = γ, and with the S =
/// 0 that the floor brings it to. Nothing where the drag takes it along, γρ > β √(1 + γ²[table]), where γ_r = 0 leaves
/// S as it is, and of a polygon.
/// @throws std::invalid_argument if a parameter is out of range
std::optional<LockedRolling> locked_sliding(const Scene<double>& scene);

/// @throws std::invalid_argument if a parameter is out of range
FloorFacts floor_facts(const Scene<double>& scene);

}  // namespace swirl
