// Delay vectors of a series, their neighbours, and how far neighbours part.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace swirl::analysis {

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

}  // namespace swirl::analysis
