// Spectra of uneven times: the nonuniform transform, and Lomb and Scargle's sums made of it.
#pragma once

#include "analysis/spectrum/lines.hpp"
#include "analysis/spectrum/power_spectrum.hpp"

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace swirl::analysis {

// The Fourier transform of samples at any times, by a fine even grid and FFTW.

/// F_k = Σ_j x_j e^{−2πi k step (t_j − start)}, k = 0 … count.
///   times   finite, any order;   values   as many
///   step    of the frequencies, > 0, in cycles per unit of time
/// Each sample is spread over 16 points of an even grid of twice as many points as the frequencies need, with the
/// kernel exp(β (√(1 − z²) − 1)), whose transform is divided out: right to 10⁻¹² Σ|x_j|, but for what rounding t_j step
/// loses of a phase. O(16 n + count log count). Source: Barnett, Magland, af Klinteberg, SIAM J. Sci. Comput. 41 (2019)
/// C479.
std::vector<std::complex<double>> nonuniform_transform(std::span<const double> times, std::span<const double> values,
                                                       double start, double step, std::size_t count);

// The spectrum of samples at uneven times, and its lines: Lomb and Scargle's periodogram, and least squares.

/// Lomb and Scargle's periodogram at the frequencies k step, k = 1 … count, ω = 2π k step:
///   P = ½ [(Σ x cos ω(t − τ))²/Σ cos² ω(t − τ) + (Σ x sin ω(t − τ))²/Σ sin² ω(t − τ)],
///   tan 2ωτ = Σ sin 2ωt / Σ cos 2ωt.
/// What least squares of a cos ωt + b sin ωt take from Σ x²/2. As scipy.signal.lombscargle of the same values, from
/// which no mean is taken. Sums are those of the nonuniform transform. O(n + count log count).
/// Source: Scargle, Astrophys. J. 263 (1982) 835; Press & Rybicki, Astrophys. J. 338 (1989) 277 (sums by FFT).
std::vector<double> lomb_scargle(std::span<const double> times, std::span<const double> values, double step,
                                 std::size_t count);

/// Of samples at uneven times.
struct UnevenSpectrum {
    PowerSpectrum spectrum;  ///< one segment, of lomb_scargle() of the detrended series, scaled to its variance
    std::vector<SpectralPeak> peaks;  ///< lines that least squares found, strongest first
    LineShare share;
};

/// Spectrum and lines of samples at uneven times; those that are NaN are not there.
///
/// With Δ the mean of the distances that are at most 4 medians, frequencies are k/(t_last − t_first + Δ) up to 1/(2Δ),
/// the samples' own Nyquist frequency: `spacing` is Δ. power_k = variance_scale · 2 P_k / (n frequency_step).
///
/// Uneven samples of one line have power at all frequencies, which no floor tells from a continuum. So lines are found
/// by least squares, one after the other: the strongest maximum of the periodogram, at half the distance of the
/// frequencies, that stands above the floor (lines.hpp, one segment) gives a cos ωt + b sin ωt, whose ω is refined with
/// a and b (Gauss–Newton) and which is subtracted; in the end all are refined in turn, each with the others subtracted.
/// A line must be steady: its power in eighths of the time, where they hold three periods or more, must scatter by at
/// most `largest_spread`. line_fraction is the share of the variance that the lines take.
///   times   strictly rising;   options: segment_length, segments, overlap and window must be as by default
/// Throws std::invalid_argument as resample() for times, fewer than 8 samples give `too_short`.
/// O((n + m log m) (lines + 1)), at most most_uneven_lines of them.
/// Source: Lomb, Astrophys. Space Sci. 39 (1976) 447; of pre-whitening Lenz & Breger, Comm. Asteroseism. 146 (2005) 53.
UnevenSpectrum uneven_spectrum(std::span<const double> times, std::span<const double> values,
                               const SpectrumOptions& options = {}, const LineOptions& lines = {});

inline constexpr std::size_t most_uneven_lines = 64;

}  // namespace swirl::analysis
