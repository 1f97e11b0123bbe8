// Every steady mode of a scene: the fixed points of F with impacts, with a flight time up to a limit.
//
// A fixed point follows from two equations in (τ, χ) (steady_equations.hpp): the law of impact leaves plane curves, on
// which the number of vertices on, Nτ(1 − S)/2π, has to be whole. The curves are followed, the whole numbers found, and
// each point put to the map itself. Source: map/steady/README.md.
#pragma once

#include "map/steady/steady_families.hpp"
#include "map/steady/verified_mode.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace swirl {

/// What kind of set the steady modes of a scene are.
enum class SteadySet {
    points,             ///< a polygon with friction: isolated
    families,           ///< e = 1, a disk or no friction: over τ
    none_lossy_disk,    ///< e < 1: χ = 0 gives q = 0 and the same |u_n| before and after
    none_frictionless,  ///< μ = 0, e < 1: the same
};
std::string_view name_of(SteadySet set);
/// Why there are none, in words; empty where there may be some.
std::string_view why_none(SteadySet set);

struct SteadyOptions {
    double longest_flight = 12;  ///< τ, in 1/ω_s; (0, 10⁴]
    std::size_t most = 100'000;  ///< solutions put to the map, the earliest in τ
    double fastest_spin = 5;     ///< of a polygon without friction, where S is free: |S| ≤ this, [1, 10⁶] …
    long long most_steps = 100;  ///< … and |j| ≤ this
    /// Only where modes that attract were found, on a coarser grid: flights of at most `longest_attracting_flight`.
    /// Families are left out.
    bool attracting = false;
};

/// No mode that attracts was found with a longer flight: of 23,000 modes of 820 random scenes (three laws, e = 0 … 1,
/// α = 0.1 … 0.9, β = 0.02 … 1.22, μ up to 1.5, τ up to 20) 256 attract, with τ ≤ 4.3; of 5,000 scenes 1,396, with
/// τ ≤ 4.9, two of them sliding. On the − branch few do, at small e: 4 of 165 in 1,500 scenes of which half had e <
/// 0.3, with e from 0.09 to 0.15.
inline constexpr double longest_attracting_flight = 6.283185307179586;

struct SteadyModes {
    SteadySet set = SteadySet::points;
    std::vector<SteadyMode> modes;       ///< by branch (+ first) and rising τ
    std::vector<SteadyFamily> families;  ///< by branch, j and τ
    std::size_t candidates = 0;          ///< solutions of both equations, before the map was asked
    double complete_to = 0;      ///< all with τ ≤ this are listed: the longest flight, or less if there are too many
    bool phase_is_free = false;  ///< β = 0: ψ is any constant; listed is ψ = 0
};

/// All steady modes with τ ≤ longest_flight whose impacts are faster than 10⁻⁶; where j and so S is free, a polygon's
/// without friction, those with |S| ≤ fastest_spin: a family may end there.
///
/// With `attracting` half a millisecond at few sides, up to 1.1 s with thousands and little friction (N = 20,000,
/// μ = 10⁻⁵, e = 0.1); of those that slide the 10,000 of shortest flight.
/// Some of the modes that it lists do not attract.
///
/// Missed are two modes about a turn of a curve that is narrower than the grid (0.005 in τ; a hundredth of the range of
/// χ), and modes within rounding of a border of the map (grazing, |tan χ| = μ).
/// Cost: some ten milliseconds; some ten microseconds for each candidate, of which there are about Nτ(1 + |S|)/2π for
/// each curve; of families a collision, a microsecond, for each 0.01 of τ and each j with |S| ≤ fastest_spin, so
/// that it grows with N τ².
/// @throws std::invalid_argument if a parameter or an option is out of range
SteadyModes steady_modes(const Scene<double>& scene, const SteadyOptions& options = {});

}  // namespace swirl
