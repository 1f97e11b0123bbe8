// What is known of a scene in closed form, before anything is computed. Lengths in R_c, frequencies in ω_s, m = 1.
#pragma once

#include "map/model/scene.hpp"

#include <optional>
#include <string_view>

namespace swirl {

/// What becomes of impacts (map/README.md, "Energy in the swirling frame").
enum class ImpactFate {
    fade,       ///< e < 1 and no drive: J (μ = 0; β = 0: the energy) falls with each and is bounded below
    conserved,  ///< e = 1, μ = 0: J is the same for ever
    can_last,   ///< friction and the swirl may replace what impacts take; e = 1 takes nothing without slip
};
std::string_view name_of(ImpactFate fate);

/// A disk on the wall is a pendulum about the swirl's direction (map/contact/README.md): ψ″ = −k sin ψ, with
/// ρ = 1 − α and
///
///     k = β/((1 + κ)ρ) rolling (μ > 0), β/ρ without friction       H = ψ′²/2 − k cos ψ
///     λ = β cos ψ + ρ(1 + ψ′)² > 0       rolling needs κβ|sin ψ|/(1 + κ) ≤ μλ       S = −ρ(1 + ψ′)/α rolling
///
/// H = −k: at rest in the frame that turns with the swirl; H < k: librates; H > k: circulates. Contact comes of e < 1.
struct RimFacts {
    bool rolls = true;
    double strength = 0;               ///< k
    double small_frequency = 0;        ///< √k, of small librations, in the frame that turns with the swirl
    double circulation_energy = 0;     ///< H above which it circulates: k
    double rest_force = 0;             ///< λ at rest, β + ρ; no friction is needed there
    std::optional<double> mean_spin;   ///< of S at rest and librating: −ρ/α; without friction S is any constant
    double widest_libration = 0;       ///< the largest amplitude of ψ, up to π, on which λ > 0 and friction hold
    bool circulates_forward = false;   ///< they hold, too, on the slowest circulation with ψ′ > 0 …
    bool circulates_backward = false;  ///< … and with ψ′ < 0
};

struct SceneFacts {
    /// χ_m = π/N − asin(α sin(π/N)): |χ| at which the neighbouring vertex touches too. A disk has χ = 0. With corners
    /// of radius r that of their centres, (α − r)/(1 − r) in place of α.
    double widest_chi = 0;
    /// μ from which sliding may have B₂ − sμB₃ ≤ 0 for some |χ| ≤ χ_m (Painlevé): κ/T + (1 + κ)T, T = min(√(κ/(1 + κ)),
    /// tan χ_m), the least over tan χ of (κ + (1 + κ)tan²χ)/tan χ. None for the disk, whose B₃ = 0,
    /// and with rounded corners.
    std::optional<double> painleve_friction;
    bool can_jam = false;  ///< μ ≥ that
    /// 1 − α − β: while the body's centre is nearer than this to the swirl's centre nothing touches, wherever the
    /// container is. If > 0 a body at rest there stays untouched for ever, whatever its spin.
    double untouched_radius = 0;
    /// For a body that turns with the swirl, S = 1, at its centre: the room √(1 − α²sin²(π/N)) − α cos(π/N) −
    /// β beyond an edge's middle. Larger than `untouched_radius` for a polygon.
    double untouched_room_turning = 0;
    ImpactFate impacts = ImpactFate::can_last;
    std::optional<RimFacts> rim;  ///< of a disk
};

/// Cost: microseconds; a millisecond for a disk.
/// @throws std::invalid_argument if a parameter is out of range
SceneFacts scene_facts(const Scene<double>& scene);

}  // namespace swirl
