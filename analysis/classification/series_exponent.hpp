// The largest Lyapunov exponent of a measured series, with an error that covers the truth, or none.
#pragma once

#include "analysis/special_values.hpp"

#include <cstddef>
#include <span>

namespace swirl::analysis {

/// λ is the slope of S(t) = ⟨ln d(t)⟩, d the distance of nearest neighbours in delay coordinates, all of them, t steps
/// later (Rosenstein et al., Physica D 65 (1993) 117). What biases that slope is left out:
///   - t before the distance has turned into the direction that grows (dimension − 1 steps; half a period of a flow),
///   - what is near the size of the attractor: the fit ends where S has risen by 0.7, and S stays 2.3 below the mean ln
///     of all distances,
///   - of a flow, the distance along it, which does not grow; S is averaged over the mean time between maxima.
/// Of a map the dimensions are 2, 3 and 4, of a flow 3, 4 and 5; two at least must have such a stretch. λ is their
/// median. Its error is √(2 s² + b² + v² + j²): s from a bootstrap of 20 segments (Philox, fixed seed), twice s² since
/// neighbours are each other's; b half the difference of the slope's halves; v half the range of the dimensions; j, of
/// a flow, 2λ times the jump of S in the first step, where neighbours' noise ceases to agree. Where neighbours are too
/// far apart for that (short series, noise with a jump above 0.15, many dimensions), stretches that stay 1.2 below are
/// taken: they show whether neighbours part, but too slowly.
struct SeriesExponent {
    bool resolved = false;   ///< the stretches stay 2.3 below, without a jump: exponent and error are λ's
    double exponent = nan;   ///< per sample; NaN with fewer than two dimensions
    double error = nan;      ///< its standard error, with what bias there may be
    double curvature = nan;  ///< half the difference of the slopes of the stretch's halves
    double spread = nan;     ///< half the range of the dimensions' slopes
    double noise = nan;      ///< of a flow, twice the exponent times the jump of the first step
    double typical = nan;    ///< the median of the references' own slopes over their mean: 0 if a few pairs only part
    int dimensions = 0;      ///< that have a stretch to fit

    /// Neighbours part: above two errors, and the typical pair does, not a few that jump as a random telegraph's do.
    bool is_positive() const;
};
/// The typical pair's share of the mean rate, at least.
inline constexpr double smallest_typical = 0.5;

/// Uses the last 10,000 samples at most.
///   sampled_flow  even samples of a signal in time; else one sample a step of a map
SeriesExponent exponent_of_series(std::span<const double> series, bool sampled_flow);

/// ln of the factor by which the distance of nearest neighbours (embedding dimension 3, the last 4000 samples at most)
/// has grown, on the mean, in the last quarter of n/4 samples: 0 on a torus. NaN if no two points differ.
double separation_of_neighbours(std::span<const double> series);

}  // namespace swirl::analysis
