// The rotation number of an angle, and the fundamental frequency of any observable: whether an orbit lies on a torus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::analysis {

enum class RotationOutcome {
    quasi_periodic,  ///< converged, and no fraction with a small denominator lies within the error
    periodic,        ///< converged to fractions only: locked, `denominator` is the period in samples
    not_converged,   ///< the halves disagree: chaotic, noisy, transient, or too few samples
    not_a_rotation,  ///< the advances fill the whole circle, or the curve does not wind round its centre
    constant,        ///< no variation beyond rounding
    too_short,       ///< fewer than `RotationOptions::min_samples`
};
std::string_view name_of(RotationOutcome outcome);

struct RotationOptions {
    std::size_t min_samples = 256;
    double min_digits = 6;               ///< agreement of the two halves that counts as converged (chaos shows 1 to 3)
    std::int64_t max_denominator = 256;  ///< longest period that counts as locked
    double rational_tolerance = 1e-9;    ///< turns; a fraction within max(this, 10 half differences) is locking
    int max_lines = 6;                   ///< lines examined in `rotation_of_observable`
    double min_line_share = 1e-6;        ///< lines with a smaller share of the variance are ignored
    double max_line_error = 1e-3;        ///< of a line, half_difference · n: chaos shows 0.1 to 1
    double max_residual = 0.5;           ///< share of the variance that the lines of a torus may leave unexplained
    double min_angular_gap = 0.05;       ///< turns; part of the circle that the advances must leave free
    double min_radius = 0.02;            ///< smallest over mean radius of a delay curve that winds round its centre
};

/// p/q in lowest terms.
struct Fraction {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
};

/// The fraction of smallest denominator ≤ max_denominator within `tolerance` of x (continued fraction, with the
/// intermediate fractions); denominator 0 if there is none.
Fraction simplest_fraction(double x, double tolerance, std::int64_t max_denominator);

struct RotationNumber {
    RotationOutcome outcome = RotationOutcome::too_short;
    double rotation = 0;         ///< turns per sample, in [0, 1); of an observable in [0, ½] (its sign is not defined)
    double half_difference = 0;  ///< |first half − second half|, turns per sample
    double digits = 0;           ///< −log₁₀ half_difference, at most 16
    double order = 0;  ///< p of half_difference ∝ n^(−p), from n/4 to n: ≈ ½ chaotic; > 2 quasi-periodic
                       ///< until rounding is reached; NaN by "frequency"
    std::int64_t denominator = 0;  ///< period in samples if `periodic`, else 0
    double residual = 0;           ///< share of the variance outside the lines examined (`rotation_of_observable`): the
                                   ///< strongest alone where that is not converged
    std::string_view method = {};  ///< "angle", "delay angle" or "frequency"
};

/// Mean advance of an angle-like series per sample, by the weighted Birkhoff average.
///   angles   n samples on one orbit, in the unit of `period`, not unwrapped
///   period   2π for radians, 1 for turns, > 0
/// Each advance is only known modulo `period`: the branch is cut in the middle of the widest arc that no advance
/// visits. If no arc wider than `min_angular_gap` is free, the branch is not defined and the outcome is
/// `not_a_rotation`. Throws std::invalid_argument for a period that is not positive and finite, or samples that are not
/// finite. Cost O(n log n). Source: Das et al., Nonlinearity 30 (2017) 4111; Sander & Meiss, Physica D 411 (2020)
/// 132569.
RotationNumber rotation_number_of_angle(std::span<const double> angles, double period,
                                        const RotationOptions& options = {});

/// The rotation number from a scalar observable: the angle of (x_j − c, x_{j+1} − c) about the orbit's centre c.
/// Right when the torus' section projects to a curve that winds once round c; if it winds m times the result is m ρ.
/// Outcome `not_a_rotation` when the curve passes too near c. Both directions of turning are folded into [0, ½].
RotationNumber rotation_number_by_delay(std::span<const double> samples, const RotationOptions& options = {});

/// One line of a quasi-periodic series.
struct FrequencyLine {
    double frequency = 0;        ///< cycles per sample, in (0, ½]
    double amplitude = 0;        ///< of the real oscillation, unit of the samples
    double phase = 0;            ///< radians at sample 0: amplitude · cos(2π f j + phase)
    double half_difference = 0;  ///< |frequency of the first half − of the second half|, cycles per sample
    double share = 0;            ///< of the series' variance, amplitude²/2 over the variance
};

/// Lines by numerical analysis of the fundamental frequency: the strongest line of the bump-windowed series is found
/// by FFT, refined by maximising |Σ w_j x_j e^{−2πi f j}|, subtracted, and so on, at most `options.max_lines` times or
/// until a line carries less than `options.min_line_share`. Frequencies of a quasi-periodic series are found to near
/// rounding if its lines are more than about 20/n apart. Empty for a constant series. Throws std::invalid_argument for
/// samples that are not finite. Cost O(lines (n log n + 100 n)).
///   goes_on  false for a line: the last that is wanted
/// Source: Laskar, Icarus 88 (1990) 266; with the bump of Das et al. for Laskar's Hann window.
std::vector<FrequencyLine> fundamental_frequencies(std::span<const double> samples, const RotationOptions& options = {},
                                                   const std::function<bool(const FrequencyLine&)>& goes_on = {});

/// Rotation number of a torus from any observable: the strongest converged line that is not locked. When every line
/// that was examined is a fraction: `periodic`. When the strongest has not converged, the delay angle is tried.
/// The result is ρ up to m ρ + k with integers m, k: which line is strongest depends on the observable.
RotationNumber rotation_of_observable(std::span<const double> samples, const RotationOptions& options = {});

}  // namespace swirl::analysis
