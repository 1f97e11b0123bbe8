// Power spectral density by Welch's method, of real series (one-sided) and complex ones (two-sided).
#pragma once

#include "analysis/spectrum/segments.hpp"

#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::analysis {

enum class Detrend {
    none,    ///< the integral is then the mean square
    mean,    ///< the mean of the whole series is subtracted
    linear,  ///< its least-squares line is subtracted
};
std::string_view name_of(Detrend detrend);
Detrend detrend_from_name(std::string_view word);  ///< throws std::invalid_argument for another word

struct SpectrumOptions {
    Window window = Window::hann;
    std::size_t segment_length = 0;  ///< samples; 0: automatic_segment_length; n: one segment, finest resolution
    std::size_t segments = 0;        ///< used at most, spread evenly over those that fit; 0: all
    double overlap = 0.5;            ///< of neighbouring segments, in [0, 1)
    Detrend detrend = Detrend::mean;
    bool compensate_bin_average = false;  ///< divide power by sinc²(f · spacing): undoes the averaging over bins
    /// Time that makes frequency 1. 2π (the swirl's period at ω_s = 1): frequency is ω/ω_s; 1: cycles per time unit.
    double cycle_time = 2 * std::numbers::pi;
};

enum class SpectrumOutcome {
    completed,
    constant,             ///< no variation beyond rounding: power is zero throughout
    too_short,            ///< fewer than 8 samples, or than one segment
    no_complete_segment,  ///< no stretch between gaps is as long as a segment
};
std::string_view name_of(SpectrumOutcome outcome);

struct PowerSpectrum {
    SpectrumOutcome outcome = SpectrumOutcome::too_short;
    bool two_sided = false;
    std::vector<double> frequency;  ///< rising, equally spaced; from 0, two-sided from about minus the largest
    std::vector<double> power;      ///< per unit of frequency; Σ power · frequency_step = variance
    std::vector<double> spread;     ///< standard deviation between segments over their mean, per frequency; empty below
                                    ///< 4 segments. About 1 for a continuum, near 0 for a steady line
    double frequency_step = 0;
    double variance = 0;         ///< mean |x|² of the detrended series, gaps left out
    double variance_scale = 1;   ///< what power was multiplied by to make its integral the variance; 1 ± a few percent
    double nonstationarity = 0;  ///< |v₁ − v₂|/(v₁ + v₂), v the variances of the halves: 0 steady, 1 decayed
    std::size_t samples = 0;
    std::size_t segment_length = 0;
    std::size_t segments = 0;          ///< used
    std::size_t segments_skipped = 0;  ///< fewer than without gaps
    double effective_segments = 0;     ///< independent ones, the overlap taken into account
    double spacing = 1;                ///< of the series, time units
    SpectrumOptions settings;          ///< with segment_length filled in
};

/// sinc²(f) = (sin πf / πf)²: what averaging over bins leaves of the power at f cycles per bin.
double bin_average_gain(double frequency);

/// Welch's estimate P_k = c · ⟨|Σ_j w_j x_j e^{−2πi jk/L}|²⟩ Δ / (Σ w_j² · cycle_time), c = 2 except at 0 and Nyquist,
/// scaled so that its integral is exactly the variance of the series (a window weighs the samples unequally; the factor
/// is reported). Segments lie within the stretches between gaps (segments.hpp); the last samples of each that do not
/// fill a segment enter only the variance.
///   series    n equally spaced samples, NaN where missing
///   spacing   their distance in time, > 0
/// Throws std::invalid_argument for spacing or options out of range or an infinite sample. Cost O(n log L).
/// Source: Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70; Harris, Proc. IEEE 66 (1978) 51.
PowerSpectrum power_spectrum(std::span<const double> series, double spacing, const SpectrumOptions& options = {});

/// The spectrum of x + iy: two-sided, negative frequencies turn clockwise, the integral is ⟨|z − z̄|²⟩.
PowerSpectrum power_spectrum(std::span<const std::complex<double>> series, double spacing,
                             const SpectrumOptions& options = {});

}  // namespace swirl::analysis
