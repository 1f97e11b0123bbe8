// How the motion of a body divides whose angle a camera measured: lines, a continuum, noise.
//
// Differences of the angle, which S would be, hold twice the noise's variance over Δt², all at high frequencies: at 30
// frames a second a degree of noise hides any S. So the angle itself is looked at. Its line is taken away, the rest
// tapered (four-term Blackman-Harris: side lobes at 10⁻⁹, main lobe four bins either way) and transformed. Between the
// impacts θ is straight, so that its power falls at least as ω⁻², and what the highest third of the frequencies holds
// is nearly white: its level is the median there over ln 2. It is noise or, where impacts are as frequent as rows, the
// motion itself.
//
//   lines      bins of 25 times the noise or more, and of 30 times the median of the bins about them (7 … 40 away): of
//              a continuum, whose bins are distributed exponentially, one in e²¹ is
//   continuum  blocks of 64 of the other bins whose median is 3 times that of the noise, or more (of noise one block
//              in 10⁸); without any, what all of the others in the lower two thirds hold above the noise together, if
//              it is more than 5 standard deviations
//   slow       the lowest bins, which the taper mixes with the line that was taken away
//
// Each has the variance of S that its power, less the noise's, stands for, with |1 − e^(iω)|²/Δt².
//
// Rounding. Angles that were rounded to multiples of q err by q/2 at most. Without noise the errors repeat, and make
// lines; a line of them has an amplitude of 2q/π at most (a square wave's), all of them a variance of q²/4. Noise of
// standard deviation σ before the rounding takes lines away by exp(−2π²σ²/q²) (B. Widrow, I. Kollár, Quantization
// Noise, 2008). What is between the two sizes may be either.
// F. J. Harris, Proc. IEEE 66 (1978) 51: the window.
#pragma once

#include <cstddef>
#include <span>

namespace swirl::analysis {

/// Fewer leave no three blocks of continuum with the noise beside them.
inline constexpr std::size_t fewest_angles = 512;

/// How the variance of S divides.
struct AngleSpectrum {
    double level = 0;       ///< standard deviation that the white level stands for, radians
    double noise = 0;       ///< what counts as noise: the level, or what was given or rounding leaves if more
    double resolution = 0;  ///< q: of the angles, at least 2·10⁻¹² of the largest (what arithmetic leaves)
    double range = 0;       ///< of the distances from the straight line, radians
    int lines = 0;          ///< how many that are more than rounding's
    int uncertain = 0;      ///< lines, and a continuum, that rounding may have made, though the noise speaks against it
    int blocks = 0;         ///< of the continuum
    double in_lines = 0, in_continuum = 0, slow = 0;  ///< variances of S
    double in_rounding = 0;                           ///< the same of a continuum that rounding may have made
    double rate = 0;                                  ///< mean S: slope of the line through the angle

    double continuum_share() const { return in_continuum > 0 ? in_continuum / (in_continuum + in_lines) : 0; }
    /// With what rounding may have made.
    double largest_continuum_share() const {
        const double all = in_continuum + in_rounding;
        return all > 0 ? all / (all + in_lines) : 0;
    }
    /// Nothing but the rounding of a straight line; a tenth for the line, which is fitted.
    bool is_straight() const { return range <= 1.1 * resolution; }
};

///   angle       unwrapped, radians, at equal times
///   spacing     between them, in 1/ω_s
///   noise       standard deviation of the angle's noise, if known; else 0
///   resolution  q: the angles are rounded to multiples of it; 0: not rounded
/// O(n log n). @throws std::invalid_argument for fewer than 512 angles or one that is not finite, a noise or a
/// resolution that is negative or not finite
AngleSpectrum spectrum_of_angle(std::span<const double> angle, double spacing, double noise = 0, double resolution = 0);

}  // namespace swirl::analysis
