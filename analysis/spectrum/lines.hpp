// Lines of a spectrum: sub-bin frequency and amplitude, the floor they stand on, and lines against continuum.
#pragma once

#include "analysis/spectrum/power_spectrum.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace swirl::analysis {

struct LineOptions {
    double false_alarm = 1e-3;         ///< chance that a white spectrum shows one line or more
    std::size_t floor_half_width = 0;  ///< bins to either side in the floor's median; 0: m/16, within 16 lobes and 512
    double largest_spread = 0.4;       ///< a line is steady from segment to segment; a continuum has about 1
    double smallest_power = 1e-10;     ///< of the strongest bin: below are rounding and side lobes, not lines
    double all_lines = 0.98;      ///< verdict `lines` from this share of the variance on (narrow-banded chaos: 0.9)
    double all_continuum = 0.05;  ///< verdict `continuum` up to this share
    double nonstationary = 0.5;   ///< verdict `nonstationary` above this value of PowerSpectrum::nonstationarity
};

struct SpectralPeak {
    double frequency = 0;   ///< as PowerSpectrum::frequency, between bins
    double amplitude = 0;   ///< A of A cos(2πft + φ); two-sided: of A e^{2πift + iφ}
    double power = 0;       ///< variance of the line: A²/2; two-sided: A²
    double prominence = 0;  ///< power at the peak's bin over the noise floor there (∞ over a floor of zero)
    double spread = 0;      ///< PowerSpectrum::spread at the bin; NaN below 4 segments
    std::size_t bin = 0;    ///< index of the local maximum in PowerSpectrum::power
};

/// Expected power per bin of the continuum: running median over 2 h + 1 bins divided by the median of χ² of
/// 2 K degrees of freedom over its mean, K = effective_segments. O(m log h + h² log h): GSL sorts the shortened windows
/// at both ends.
std::vector<double> noise_floor(const PowerSpectrum& spectrum, std::size_t half_width);

/// Local maxima that stand above the floor with `false_alarm` over all bins (Γ distribution of K averaged
/// periodograms) and are steady (`spread`), strongest first. Frequency 0 is no candidate. A line at half the sampling
/// frequency (a series of period 2) is its own mirror image: it stays at its bin, A (−1)^j of power A². The sub-bin
/// place x solves |W(x − 1)|/|W(x + 1)| = √(P₊/P₋) of the bins beside the maximum (rectangular window: the maximum and
/// its larger neighbour), W the window's own transform, and A = |X|/|W(x)|: exact for one line, limited by what leaks
/// from others: side lobes of the window and, below about 2 lobes, the mirror image at −f. Averaging over bins
/// (PowerSpectrum::settings) is put back at the refined frequency. Cost as noise_floor.
std::vector<SpectralPeak> find_peaks(const PowerSpectrum& spectrum, const LineOptions& options = {});

enum class SpectrumVerdict {
    constant,       ///< no variation
    lines,          ///< periodic or quasi-periodic
    continuum,      ///< noise or chaos
    mixed,          ///< both: noisy chaos with a rhythm, or lines closer than the resolution
    nonstationary,  ///< the halves of the series differ too much in variance: a transient
    undecided,      ///< no spectrum
};
std::string_view name_of(SpectrumVerdict verdict);

/// Lines against continuum, with what decided it.
struct LineShare {
    SpectrumVerdict verdict = SpectrumVerdict::undecided;
    double line_fraction = 0;    ///< share of the variance within one main lobe of a line and above the floor
    double nonstationarity = 0;  ///< from the spectrum
    std::size_t lines = 0;
    bool steadiness_tested = false;  ///< ≥ 4 segments; without it a continuum's own peaks can pass for lines
};
LineShare line_share(const PowerSpectrum& spectrum, const LineOptions& options = {});

/// find_peaks() and line_share() over one noise_floor(), which is most of their cost.
struct Lines {
    std::vector<SpectralPeak> peaks;
    LineShare share;
};
Lines find_lines(const PowerSpectrum& spectrum, const LineOptions& options = {});

}  // namespace swirl::analysis
