// From an unevenly sampled series to an equally spaced one, with its gaps left open.
#pragma once

#include "analysis/spectrum/bin_average.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::analysis {

enum class Interpolation {
    linear,  ///< straight lines between samples
    hold,    ///< each sample stays until the next: exact for a signal that changes only at the samples
};
std::string_view name_of(Interpolation interpolation);
/// "linear" or "hold"; throws std::invalid_argument otherwise.
Interpolation interpolation_from_name(std::string_view word);

struct TimedSamples {
    std::vector<double> times;
    std::vector<double> values;
};

/// Those that are not NaN. Throws std::invalid_argument for sizes that differ, times that do not rise (with their
/// index), or fewer than 2 samples. O(n).
TimedSamples samples_there(std::span<const double> times, std::span<const double> values);

/// Of neighbouring times, of which there are 2 or more. O(n log n).
double median_distance(std::span<const double> times);

struct ResampleOptions {
    Interpolation interpolation = Interpolation::linear;
    double spacing = 0;     ///< of the result, time unit of the input; 0: the median distance of the samples
    double gap_factor = 4;  ///< a distance above this many median distances is a gap, > 1
    bool low_pass = false;  ///< take out what the new samples would show at a frequency that it does not have
};

struct Resampled {
    EvenSeries series;            ///< NaN inside gaps
    std::size_t gaps = 0;         ///< distances that count as gaps
    double missing_fraction = 0;  ///< of the time span that lies in gaps
    double own_nyquist = 0;       ///< 1/(2Δ), Δ the mean of the distances that are no gaps
    double low_pass = 0;          ///< nothing is left from this frequency on; 0: no low-pass was needed or asked for
};

/// Point values at times.front() + i · spacing. A gap is not bridged: what falls strictly inside it is NaN, and
/// power_spectrum() leaves out the segments that touch it. Samples that are NaN count as not there.
///   times   strictly rising;   values   the same number, ≥ 2 of them not NaN
/// Linear interpolation attenuates what is fast: by sinc⁴(f × distance of the samples) in power. On a grid coarser than
/// Δ what is above the new Nyquist frequency would fold back; on a finer one straight lines repeat what is below the
/// samples' own Nyquist frequency above it. With low_pass both are taken out: straight lines on a grid at least twice
/// as fine as Δ are averaged with weights sin(2πf_c t)/(πt), f_c 43/47 of the Nyquist frequency that is lower, under a
/// Blackman window of 32 of its half periods to either side: what is up to 0.83 of that frequency stays, of what is
/// above it less than 10⁻⁷ in power does. Beside gaps and ends the weights that are left add up to 1.
/// Throws std::invalid_argument for sizes, times that do not rise (with their index), or options out of range. O(n +
/// m).
Resampled resample(std::span<const double> times, std::span<const double> values, const ResampleOptions& options = {});

}  // namespace swirl::analysis
