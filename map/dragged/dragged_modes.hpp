// The steady modes of a scene over a floor that drags: fixed points of F with impacts. map/dragged/README.md, "Steady
// modes".
//
// Three equations for (τ, ψ, χ) and each j: the law of impact is two, and that the spin is kept gives χ for (τ, ψ):
//
//     Im(k(1 + hβ cis(−ψ)) cis(−χ)) = α Im k + (I/α) γ_r(τ − 2πj/N)      k = E(1 − e^{−γτ}cis(−τ))/D
//
// at most two χ (of a disk χ = 0, and S follows). What is left is looked for on a grid over (τ, ψ): where both parts of
// the law change their signs about a cell, Newton's method solves the three.
#pragma once

#include "map/model/scene.hpp"
#include "map/steady/verified_mode.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace swirl {

struct DraggedModesOptions {
    double longest_flight = 12;       ///< τ, in 1/ω_s; (0, 10⁴]
    double fastest_spin = 10;         ///< |S| ≤ this
    std::function<bool()> stop = {};  ///< true: the search ends with what it has
};

struct DraggedModes {
    std::vector<SteadyMode> modes;  ///< by rising τ; their branch is that of cos ψ; each confirmed by the map
    std::size_t candidates = 0;     ///< solutions, before the map was asked
    double searched_to = 0;  ///< looked for up to this τ: the longest flight, or less where a body has many vertices
};

/// Modes that lie closer together than the grid (0.04 in τ, 1/160 of a turn in ψ) may be missed. Of a disk whose spin
/// is not dragged none are looked for: S is free. Cost: of a hexagon with τ ≤ 12 a second, and as N and τ² where more
/// is asked; up to 6·10⁷ points of grids.
/// @throws std::invalid_argument if a parameter or an option is out of range, or the scene has no drag
DraggedModes dragged_modes(const Scene<double>& scene, const DraggedModesOptions& options = {});

}  // namespace swirl
