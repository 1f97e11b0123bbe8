// What a small swirl does to a body on a chord: the linear response to its force, and the energy that this brings.
// Derivation: map/chords/README.md, "The swirl's work".
#pragma once

#include "map/chords/chords.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Core>

#include <complex>

namespace swirl {

/// Deviations from a chord just after an impact, in the container's frame: (ψ, χ, w_n, w_t, S), w = V − O′.
using ChordDeviation = Eigen::Matrix<std::complex<double>, 5, 1>;

struct ChordResponse {
    /// ŝ: the deviation is β Re(ŝ cis θ), θ = −ψ the direction of the swirl's force, seen from the normal.
    ChordDeviation amplitude;
    double work = 0;  ///< W: of the swirl's force in a flight, over β², mean over θ
    double loss = 0;  ///< D: of slip at an impact, over β²; < 0: gained, which Newton's law allows
    double gain() const { return work - loss; }  ///< G(v)
};

/// DF at β = 0 along a chord, of (ψ, χ, w_n, w_t, S), e = 1 and sticking.
///   v  speed > 0; a speed v scales (w, αS) by v and ψ's row by 1/v
Eigen::Matrix<double, 5, 5> chord_derivative(const Scene<double>& scene, const Chord& chord, double v);

/// The response at speed v: λŝ = Mŝ + g with λ = cis(τ − (π − 2a)), exact in v, to leading order in β. Poisson and
/// Stronge agree in it, Newton's loss differs. It diverges at `chord_resonance`, and means nothing below. Relative
/// error of G: some 10⁻¹⁶ v³. Cost: a microsecond.
ChordResponse chord_response(const Scene<double>& scene, const Chord& chord, double v);

/// The speed below which the swirl turns by more than the contact goes on in a flight, 2ρ cos a/(π − 2a), in R_c ω_s.
double chord_resonance(const Chord& chord);

}  // namespace swirl
