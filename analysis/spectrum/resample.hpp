// From an unevenly sampled series to an equally spaced one, with its gaps left open.
#pragma once

#include "analysis/spectrum/bin_average.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace swirl::analysis {

enum class Interpolation {
    linear,  ///< straight lines between samples
    hold,    ///< each sample stays until the next: exact for a signal that changes only at the samples
};
std::string_view name_of(Interpolation interpolation);
/// "linear" or "hold"; throws std::invalid_argument otherwise.
Interpolation interpolation_from_name(std::string_view word);

struct ResampleOptions {
    Interpolation interpolation = Interpolation::linear;
    double spacing = 0;     ///< of the result, time unit of the input; 0: the median distance of the samples
    double gap_factor = 4;  ///< a distance above this many median distances is a gap, > 1
};

struct Resampled {
    EvenSeries series;            ///< NaN inside gaps
    std::size_t gaps = 0;         ///< distances that count as gaps
    double missing_fraction = 0;  ///< of the time span that lies in gaps
};

/// Point values at times.front() + i · spacing. A gap is not bridged: what falls strictly inside it is NaN, and
/// power_spectrum() leaves out the segments that touch it. Samples that are NaN count as not there.
///   times   strictly rising;   values   the same number, ≥ 2 of them not NaN
/// Linear interpolation attenuates what is fast: by sinc⁴(f × distance of the samples) in power.
/// Throws std::invalid_argument for sizes, times that do not rise (with their index), or options out of range. O(n +
/// m).
Resampled resample(std::span<const double> times, std::span<const double> values, const ResampleOptions& options = {});

}  // namespace swirl::analysis
