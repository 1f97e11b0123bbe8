// The largest exponent of a measured series, from its vectors of delayed values.
#pragma once

#include "analysis/special_values.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace swirl::analysis {

// Delay vectors of a series, their neighbours, and how far neighbours part.

/// y_i = (x_i, x_{i + delay}, …, x_{i + (dimension − 1) delay}), with the Euclidean distance.
struct DelayVectors {
    std::span<const double> x;
    std::size_t dimension = 1;
    std::size_t delay = 1;

    std::size_t count() const { return x.size() - (dimension - 1) * delay; }
    double distance_squared(std::size_t i, std::size_t j) const;
    /// Of y_i from the straight line between y_j and y_{j + 1}.
    double distance_squared_to_segment(std::size_t i, std::size_t j) const;
};

/// The first lag at which the autocorrelation falls below 1/e, at most n/20.
std::size_t decorrelation(std::span<const double> x);

/// Nearest neighbours of the first `count` delay vectors among themselves: sorted by the first coordinate, from which
/// the search goes outwards until that coordinate alone is further away than what was found.
class NeighbourSearch {
public:
    using Neighbour = std::pair<double, std::size_t>;  ///< squared distance, and the vector's number
    enum class Equal { left_out, counts };             ///< vectors that are equal

    NeighbourSearch(const DelayVectors& vectors, std::size_t count, Equal equal = Equal::left_out);
    /// The k nearest, nearest first, of those more than `window` steps away in time; fewer if there are fewer. Valid
    /// until the next call.
    std::span<const Neighbour> nearest(std::size_t i, std::size_t k, std::size_t window);

private:
    DelayVectors vectors_;
    Equal equal_;
    std::vector<std::size_t> order_, place_;
    std::vector<Neighbour> found_;
};

struct DivergenceOptions {
    std::size_t horizon = 1;             ///< steps for which neighbours are followed
    std::size_t window = 1;              ///< neighbours are more steps apart in time than this
    bool across_flow = false;            ///< distances from the neighbour's path, not from the point on it
    std::size_t most_references = 4000;  ///< of longer series every second, third, … vector has its neighbour sought
};

/// ln d_r(t), t = 0 … horizon, of reference r and its nearest neighbour t steps later; NaN where that is not known.
struct Divergence {
    std::size_t references = 0;
    std::size_t horizon = 0;
    std::vector<double> logarithms;  ///< references × (horizon + 1)

    std::span<const double> of(std::size_t reference) const {
        return std::span(logarithms).subspan(reference * (horizon + 1), horizon + 1);
    }
};

/// Two points of one path of a flow never part along it; with `across_flow` that distance, which hides how they part
/// across it, is left out: the point of the neighbour's path that is nearest is followed. Without any references if
/// the series is too short. O(n^(2 − 1/dimension)) for neighbours, O(references × horizon) after that.
Divergence divergence_of(const DelayVectors& vectors, const DivergenceOptions& options);

// The largest Lyapunov exponent of a measured series, with an error that covers the truth, or none.

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
