// The motions of an elastic polygon with friction that lose nothing where there is no swirl: chords of the circle on
// which its centre can touch, run through without slip. Derivation: map/chords/README.md.
#pragma once

#include "map/model/scene.hpp"

#include <complex>
#include <cstddef>
#include <vector>

namespace swirl {

/// A chord: with β = 0 and e = 1 every impact has χ = 0 and u_t = 0 before and after. At speed v, for any v > 0,
///
///     v_n = −v cos a   v_t = v sin a   S = −v sin a/α   τ = 2ρ cos a/v   after an impact, ρ = 1 − α
///
/// and the contact goes on by π − 2a. A vertex is there each time: π − 2a + (ρ/α) sin 2a = 2πj/N, modulo 2π.
struct Chord {
    double angle = 0;  ///< a, between the chord and the normal, in radians, |a| < π/2; the mirror image of a is −a
    int vertex_step = 0;  ///< j, from impact to impact, 0 … N − 1
    double turn = 0;      ///< Sτ = −(ρ/α) sin 2a: by what the body turns in a flight, in radians
    double length = 0;    ///< 2ρ cos a, in R_c
    /// Two multipliers of the transverse motion, for every v; the others are 1 (v), 1 (the chord's direction) and 0
    /// (sticking).
    std::complex<double> multipliers[2];

    bool is_diameter() const { return angle == 0; }
    /// Do small transverse deviations decay?
    bool attracts() const { return std::abs(multipliers[0]) < 1 && std::abs(multipliers[1]) < 1; }
};

struct Chords {
    std::vector<Chord> chords;  ///< by rising a
    bool complete = true;       ///< false: there are more, nearer to the wall
};

/// All chords of a polygon with friction along which no other vertex strikes earlier; none of a disk (its chords are a
/// family over a) and without friction (S is free). β, μ > 0, e and the law of the scene are not read.
///   most  of them, those with the smallest |a|
/// Cost: about N(1 + 2ρ/α) roots, a microsecond each.
/// @throws std::invalid_argument if a parameter is out of range
Chords chords_of(const Scene<double>& scene, std::size_t most = 1000);

}  // namespace swirl
