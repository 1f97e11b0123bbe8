// Where the swirl leads a body on a chord: without end along a diameter, to a limit on a winding chord, with e < 1 to
// a balance. Derivation: map/chords/README.md.
#pragma once

#include "map/chords/chords.hpp"
#include "map/model/scene.hpp"

#include <optional>
#include <string_view>

namespace swirl {

/// K of the diameter: ΔE = K β²/v⁴ an impact to leading order in 1/v, mean over the swirl's phase, so that with e = 1
/// J → (¾ K β² n)^⅓ after n impacts. In closed form, for Poisson's and Stronge's laws
///
///     K = (1 − α)³ (3 + 2κ + 2ακ(2 + κ)) (1 − 2α + ακ + 2α²(2 + κ)) / (9 (1 + κ) (1 − (1 − κ)α)²)
///
/// and for Newton's 2 (1 − α)³ (1 − 2α + ακ + 2α²(2 + κ)) (1 + α(2 + κ)) / (9 (1 − (1 − κ)α)²). Positive for every α.
double diameter_growth(const Scene<double>& scene);

/// Which way a chord's speed goes.
enum class ChordFate {
    leaves,      ///< the pair of multipliers repels: no body stays on it
    starves,     ///< the swirl feeds it at no speed (or at none above the resonance)
    limit,       ///< to a speed v*
    accelerates  ///< at every speed that was looked at, up to `fastest_chord`
};
std::string_view name_of(ChordFate fate);

struct ChordSpeeds {
    ChordFate fate = ChordFate::leaves;
    double fed_from = 0;    ///< v above which the swirl feeds it, up to v*; 0: from the resonance on
    double limit = 0;       ///< v*, G(v*) = 0, G falling
    double limit_spin = 0;  ///< S* = −v* sin a/α; 0 for one that accelerates (S → 0 on a diameter)
};

inline constexpr double fastest_chord = 1000;  ///< R_c ω_s; beyond, rounding is a thousandth of G

/// With e = 1, from the signs of G(v), which depend neither on β nor on μ. A diameter accelerates (K > 0). v* is the
/// highest speed at which G turns from gain to loss, to 10⁻¹² of itself. Cost: a tenth of a millisecond.
ChordSpeeds chord_speeds(const Scene<double>& scene, const Chord& chord);

/// Impacts from one speed to another by dE = G(v) β² dn, E = ½v²(1 + κ sin² a); infinite where G has the wrong sign on
/// the way. Relative error some 10⁻⁴. Cost: 0.1 ms.
double impacts_between(const Scene<double>& scene, const Chord& chord, double from, double to);

/// The speed at which the gain of an attracting chord makes up for (1 − e²)(v cos a)²/2 an impact, above which loss
/// prevails: an attractor with J* = v²/2 on a diameter, v⁶ → 2Kβ²/(1 − e²) as e → 1. None if loss always prevails, or
/// e = 1. To leading order in 1 − e.
std::optional<double> balanced_speed(const Scene<double>& scene, const Chord& chord);

}  // namespace swirl
