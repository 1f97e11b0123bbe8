// Names the mode of a body whose angle a camera measured: S is its rate, and the noise is the angle's.
//
// Differences of the angle, which S would be, hold twice the noise's variance over Δt², all at high frequencies: at 30
// frames a second a degree of noise hides any S. So the angle itself is looked at. Its line is taken away, the rest
// tapered (four-term Blackman-Harris: side lobes at 10⁻⁹, main lobe four bins either way) and transformed. Between the
// impacts θ is straight, so that its power falls at least as ω⁻², and what the highest third of the frequencies holds
// is white noise: its level is the median there over ln 2, unless the noise is given.
//
//   lines      bins of 25 times the noise or more, and of 30 times the median of the bins about them (7 … 40 away): of
//   a
//              continuum, whose bins are distributed exponentially, one in e²¹ is
//   continuum  blocks of 64 of the other bins whose median is 3 times that of the noise, or more (of noise one block
//              in 10⁸)
//   slow       the lowest bins, which the taper mixes with the line that was taken away
//
// Each has the variance of S that its power, less the noise's, stands for, with |1 − e^(iω)|²/Δt². Then
//   slow more than half of all                       undecided, transient
//   neither lines nor continuum                      steady, S constant within the noise
//   continuum at most 2 % of both                    quasi-steady (a cycle or a torus: periodic or not in time)
//   continuum at least 30 %, three blocks or more    chaotic
//   else                                             undecided
// A continuum is chaos because nothing else than the camera is random in a body that slides and strikes; a shaken
// container would look the same, and the evidence says so. F. J. Harris, Proc. IEEE 66 (1978) 51: the window.
#pragma once

#include "analysis/classification/classify_series.hpp"

#include <span>

namespace swirl::analysis {

/// Fewer leave no three blocks of continuum with the noise beside them.
inline constexpr std::size_t fewest_angles = 512;

/// How the variance of S divides.
struct AngleSpectrum {
    double noise = 0;                                 ///< standard deviation of the angle's noise, radians
    int lines = 0;                                    ///< how many
    int blocks = 0;                                   ///< of the continuum
    double in_lines = 0, in_continuum = 0, slow = 0;  ///< variances of S
    double rate = 0;                                  ///< mean S: slope of the line through the angle

    double continuum_share() const { return in_continuum > 0 ? in_continuum / (in_continuum + in_lines) : 0; }
};

///   angle    unwrapped, radians, at equal times
///   spacing  between them, in 1/ω_s
///   noise    standard deviation of the angle's noise, if known; else 0
/// O(n log n). @throws std::invalid_argument for fewer than 512 angles or one that is not finite
AngleSpectrum spectrum_of_angle(std::span<const double> angle, double spacing, double noise = 0);

/// The verdict; its mean is the slope. `options.noise` is the angle's. @throws as spectrum_of_angle
Classification classify_angle(std::span<const double> angle, double spacing, const ClassifySeriesOptions& options = {});

}  // namespace swirl::analysis
