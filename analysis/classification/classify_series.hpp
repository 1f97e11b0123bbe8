// Names the mode of a measured series: no map, no derivative, noise of unknown size.
//
// Evidence, in this order; what is disagreeing or not enough gives `undecided`:
//   1. Does it last? The means of the halves differ by less than half a standard deviation, and the variances by
//      less than 3 : 1. If not: transient.
//   2. Does it repeat? The smallest k, 16 times in the series, for which the k phase means leave a residual within the
//      noise (given, or at most `largest_noise` of the standard deviation) that is white, over all and phase by phase;
//      after a first k whose residual is small but structured a multiple of it whose residual is white and half as
//      large (repetition.hpp). Or the smallest k, 8 times in the series, that leaves nothing but rounding (10⁻¹² of the
//      largest value). A structured residual is otherwise a torus, a band or a drift, and no noise.
//   3. Is the spectrum all lines, and do neighbours stay neighbours (their distance less than doubles, on the
//      mean, over a quarter of the series)? Then the series is quasi-periodic; of a flow, periodic or quasi-periodic.
//      Lines with neighbours that part are chaos on narrow bands, or noise: undecided.
//   4. Is it deterministic and does it diverge? Its nonlinear prediction error is smaller than that of all of 39
//      amplitude-adjusted surrogates (Theiler et al., Physica D 58 (1992) 77), which share its linear correlations and
//      its distribution; and the mean logarithmic distance of nearest neighbours grows along a straight line
//      (Rosenstein et al., Physica D 65 (1993) 117), whose slope agrees in embedding dimensions 2, 3 and 4 within 20 %.
//      Both: chaotic.
#pragma once

#include "analysis/classification/classify.hpp"

#include <cstddef>
#include <span>

namespace swirl::analysis {

struct ClassifySeriesOptions {
    double noise = 0;             ///< standard deviation of the measurement's noise; 0: unknown
    double largest_noise = 0.15;  ///< of an unknown noise, over the series' standard deviation
    int max_period = 256;         ///< also at most as in RepetitionLimits
    double recurrence_threshold = 1e-6;
    bool sampled_flow = false;  ///< even samples of a signal in time; else one sample a step of a map
};

/// The embedding dimensions' rates of divergence may differ by so much of their median.
inline constexpr double largest_spread = 0.2;

/// The largest exponent of a series by the divergence of nearest neighbours.
struct SeriesExponent {
    bool trusted = false;  ///< a straight rise of a factor 4.5 or more, the same in dimensions 2, 3 and 4
    double exponent = 0;   ///< per sample: median over the dimensions; NaN if no dimension shows a rise
    double spread = 0;     ///< largest minus smallest of the dimensions, over their median
    int dimensions = 0;    ///< that show a straight rise
};
/// Uses the last 4000 samples at most. O(n²).
SeriesExponent exponent_of_series(std::span<const double> series);

/// ln of the factor by which the distance of nearest neighbours (embedding dimension 3, the last 4000 samples at most)
/// has grown, on the mean, in the last quarter of n/4 samples: 0 on a torus. NaN if no two points differ. O(n²).
double separation_of_neighbours(std::span<const double> series);

/// Nonlinear prediction error of the series (last 1000 samples at most) and the smallest of its surrogates'. The
/// surrogates come from a generator of fixed seed: equal series, equal numbers. O(surrogates n²).
struct SurrogateTest {
    double error = 0;
    double smallest_of_surrogates = 0;
    int surrogates = 39;
};
SurrogateTest test_surrogates(std::span<const double> series);

/// Fewer do not show eight repetitions of anything.
inline constexpr std::size_t fewest_samples = 64;

/// Samples of S, equally far apart in time (sampled_flow) or one after each impact; all finite.
/// Throws std::invalid_argument for a value that isn't finite or fewer than 64 samples.
Classification classify_series(std::span<const double> series, const ClassifySeriesOptions& options = {});

}  // namespace swirl::analysis
