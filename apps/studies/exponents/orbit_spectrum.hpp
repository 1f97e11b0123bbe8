// The whole Lyapunov spectrum of a scene's orbit, with its errors and signs.
//
// λ_i = lim (1/n) ln |R_ii(n) … R_ii(1)| with Q(n) R(n) = DF(z_n) Q(n − 1): DF carries an orthonormal frame from impact
// to impact, QR makes it one again, and the diagonal of R says by how much each direction grew. Source: G. Benettin et
// al., Meccanica 15 (1980) 9 and 21 (analysis/lyapunov/README.md).
#pragma once

#include "analysis/lyapunov/exponent_sign.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/orbit/outcome.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace swirl::studies {

/// A spectrum, the sign of each exponent, and why some are zero.
struct OrbitSpectrum {
    analysis::LyapunovSpectrum spectrum;
    std::vector<analysis::SignEvidence> signs;  ///< one per exponent; empty without exponents
    /// Per step: the weighted mean where both halves of the orbit agree on it to `regular_agreement` (fixed, periodic
    /// and quasi-periodic orbits, on which it converges faster than any power), the plain mean elsewhere.
    std::vector<double> exponents;
    std::vector<double> per_time;          ///< the same per unit of time
    double sum = std::nan("");             ///< −∞ where a rank is lost; NaN without exponents
    double jacobi_residual = 0;            ///< ‖∇J(F(z)) DF − ∇J(z)‖ relative, NaN where J is not conserved
    Outcome outcome = Outcome::completed;  ///< how following the orbit ended
    long long impacts = 0;
    long long before = 0;  ///< impacts before the first counted one
};

/// If the halves of an orbit agree on a weighted mean to this, the orbit counts as regular (periodic or
/// quasi-periodic).
inline constexpr double regular_agreement = 1e-8;

/// The spectrum of one orbit. A pure function of its arguments.
///   transient   impacts before the first that counts
///   collisions  impacts that count
/// Cost: some five steps of the map an impact.
/// @throws std::invalid_argument for a scene or start out of range
OrbitSpectrum spectrum_of(const Scene<double>& scene, const Start<double>& start, std::int64_t transient,
                          std::int64_t collisions, Accuracy accuracy = Accuracy::double_precision);

}  // namespace swirl::studies
