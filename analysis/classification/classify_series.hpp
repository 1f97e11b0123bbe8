// Names the mode of a measured series: no map, no derivative, noise of unknown size.
//
// Evidence, in this order; what is disagreeing or not enough gives `undecided`:
//   1. Does it last? The means of the halves differ by less than half a standard deviation, and the variances by
//      less than 3 : 1. If not: transient.
//   2. Does it repeat? The smallest k, 16 times in the series, for which the k phase means leave a residual within the
//      noise (given, or at most `largest_noise` of the standard deviation) that is white, over all and phase by phase;
//      after a first k whose residual is small but structured a multiple of it whose residual is white and half as
//      large (returns.hpp). Or the smallest k, 8 times in the series, that leaves nothing but rounding (10⁻¹² of the
//      largest value). A structured residual is otherwise a torus, a band or a drift, and no noise.
//   3. Is the spectrum all lines, and do neighbours stay neighbours (their distance less than doubles, on the
//      mean, over a quarter of the series)? Then the series is quasi-periodic; of a flow, periodic or quasi-periodic.
//      Lines with neighbours that part are chaos on narrow bands, or noise: undecided.
//   4. Is it deterministic and does it diverge? It is predicted better than all of its surrogates (surrogates.hpp): 39
//      with its linear correlations and its distribution, and, where its values come again and again, as many with its
//      transitions and its times of stay. And nearest neighbours part at one rate in two of three embedding dimensions
//      (series_exponent.hpp), above two of its errors, and typical ones do, not a few that jump. Both: chaotic, unless
//      the mean frequency of a smooth series changes slowly all along (a tone that is swept): undecided.
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

/// Fewer do not show eight repetitions of anything.
inline constexpr std::size_t fewest_samples = 64;

/// Samples of S, equally far apart in time (sampled_flow) or one after each impact; all finite.
/// Throws std::invalid_argument for a value that isn't finite or fewer than 64 samples.
Classification classify_series(std::span<const double> series, const ClassifySeriesOptions& options = {});

}  // namespace swirl::analysis
