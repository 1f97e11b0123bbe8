// `swirl lyapunov`: the whole Lyapunov spectrum of an orbit, with its errors and how it converged.
#pragma once

#include "analysis/lyapunov/exponent_sign.hpp"
#include "apps/command_line/output_options.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "map/orbit/outcome.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace swirl::apps::lyapunov {

struct LyapunovCommandOptions {
    SceneOptions scene;
    StartOptions start;
    OutputOptions output;
    std::int64_t transient = 10'000;
    std::int64_t collisions = 100'000;

    void add_to(Flags& command);
};

extern const char* const lyapunov_details;

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
/// @throws std::invalid_argument for a scene or start out of range
OrbitSpectrum spectrum_of(const Scene<double>& scene, const Start<double>& start, std::int64_t transient,
                          std::int64_t collisions, Accuracy accuracy = Accuracy::double_precision);

int lyapunov(LyapunovCommandOptions& options);

}  // namespace swirl::apps::lyapunov
