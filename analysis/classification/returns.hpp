// Does a measured series repeat, within its noise?
#pragma once

#include "analysis/classification/tail.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace swirl::analysis {

struct RepetitionLimits {
    double residual = 0;   ///< noise: standard deviation about the phase means, at most
    double exact = 0;      ///< rounding: what repeats within it repeats, whatever its structure
    int max_period = 256;  ///< also at most an eighth of the samples, and a sixteenth unless exact
};

struct Repetition {
    int period = 0;          ///< 0: none
    double residual = 0;     ///< standard deviation about the phase means; 0 with period 0: above the limit at every k
    double correlation = 0;  ///< largest autocorrelation of the residual; 0 for what is exact
    double chance = 1;       ///< of neighbours as correlated, phase by phase, as the residual's, were it noise
    int structured = 0;      ///< the smallest k whose residual is within the limit, but not white; 0: none
};

/// At most this is the largest autocorrelation of the residual of n samples, if it is white.
double white_autocorrelation(std::size_t n);

/// Noise has a smaller chance than this of being called structured phase by phase.
inline constexpr double smallest_chance = 1e-5;

/// The smallest k for which the k phase means leave a residual within the limit that is white: no autocorrelation up to
/// lag 2k + 8 beyond 4/√n, and no correlation of neighbours phase by phase beyond chance. The second is what tells
/// chaos in k bands: the map segments each band by its own factor, of either sign, so that a residual decides the next
/// at every phase while the mean over the phases sees nothing. A residual that is small but structured is that of a
/// longer period, or no noise at all: a torus, a band, a drift. The longer period is a multiple (the phase means of k
/// know of a period q no more than those of the common divisor of k and q). Its residual is rounding, or white and at
/// most half as large, as where a period has doubled; else more means only hide the structure, which stands.
Repetition repetition_of(std::span<const double> x, const RepetitionLimits& limits);

}  // namespace swirl::analysis

namespace swirl::analysis::classification_detail {

// The returns of an orbit to itself after k steps: how near, and whether they shrink.

/// States in one of the windows that a tail of n states is compared by: a sixteenth of them, and no fewer than k, so
/// that the phase of a complex multiplier plays no part.
inline std::int64_t window_length(std::int64_t n, std::int64_t k) {
    return std::max(k, n / 16);
}

/// The largest return after k steps of the states begin … end − 1 to those k before; it may be any that exceeds
/// `give_up`.
template <SectionMap M>
double largest_return(const M& map, const Tail<M>& tail, std::int64_t k, std::int64_t begin, std::int64_t end,
                      double give_up = infinity) {
    double largest = 0;
    for (std::int64_t j = end - 1; j >= begin && largest <= give_up; --j)
        largest = std::max(largest, distance(map, tail.points[static_cast<std::size_t>(j)],
                                             tail.points[static_cast<std::size_t>(j - k)], give_up));
    return largest;
}

/// The largest distance of a state from the one k steps before, over the orbit's last `count` states.
template <SectionMap M>
double return_distance(const M& map, const Tail<M>& tail, std::int64_t k, std::int64_t count, double give_up) {
    const auto n = static_cast<std::int64_t>(tail.points.size());
    return largest_return(map, tail, k, std::max(n - count, k), n, give_up);
}

/// The nearest of an orbit's returns, so many and no farther than `vicinity`, the nearest first.
class NearestReturns {
public:
    NearestReturns(int most, double vicinity) : most_(static_cast<std::size_t>(most)), farthest_(vicinity) {}

    /// Beyond this none is taken any more.
    double farthest() const { return farthest_; }
    void add(double returned, std::int64_t k) {
        if (most_ == 0 || !(returned <= farthest_)) return;
        const std::pair<double, std::int64_t> here(returned, k);
        nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), here), here);
        if (nearest_.size() > most_) nearest_.pop_back();
        if (nearest_.size() == most_) farthest_ = nearest_.back().first;
    }
    const std::vector<std::pair<double, std::int64_t>>& all() const { return nearest_; }

private:
    std::size_t most_;
    double farthest_;
    std::vector<std::pair<double, std::int64_t>> nearest_;
};

/// Do the orbit's returns after k steps shrink along the tail, from its first window to its last, to `part` of what
/// they were or less?
template <SectionMap M>
bool returns_shrink(const M& map, const Tail<M>& tail, std::int64_t k, double part) {
    const auto n = static_cast<std::int64_t>(tail.points.size());
    const std::int64_t length = window_length(n, k);
    return largest_return(map, tail, k, n - length, n) <= part * largest_return(map, tail, k, k, k + length);
}

/// The ratio of returns at the tail's end to those at its beginning that an orbit settling on a cycle does not exceed:
/// 1/2, or m^(j/2), where m is the slowest multiplier of the cycle (of period `period`) and j counts its periods
/// between the two. On a torus near a rational one returns stay as they are, and Newton's method finds a cycle there
/// all the same.
template <SectionMap M>
double largest_ratio_of_approach(const Tail<M>& tail, std::int64_t k, double slowest, std::int64_t period) {
    const auto n = static_cast<std::int64_t>(tail.points.size());
    const auto apart = static_cast<double>(n - window_length(n, k) - k) / static_cast<double>(period);
    return std::max(0.5, std::pow(slowest, 0.5 * apart));
}

/// Farther than this from a cycle no orbit is taken for approaching it.
constexpr double approach_begins = 0.1;

/// Is a length smaller in each of a tail's last windows than in the one before it?
///   farthest  farthest(w): the largest length in the w-th window, counted from the end (w = 0) back
///   windows   at most so many are compared, none before one in which it exceeds `approach_begins`
///   fewest    so many there must be
///   resolved  a last window below this needs no other: rounding may have stopped the orbit
template <class Farthest>
bool shrinks_by_windows(const Farthest& farthest, std::int64_t windows, std::int64_t fewest, double resolved) {
    double after = 0;
    for (std::int64_t w = 0; w < windows; ++w) {
        const double here = farthest(w);
        if (w == 0 && here <= resolved) return true;
        if (!(here > after)) return false;
        if (here > approach_begins) return w + 1 >= fewest;
        after = here;
    }
    return windows >= fewest;
}

/// May the orbit be approaching a cycle of period k or a divisor of it, so that Newton's method is worth its
/// derivatives? What `cycle_near` asks of the distance to a cycle is asked here of the returns after k steps, which are
/// proportional to it: no larger in the tail's last window than in its first, and smaller from window to window at its
/// end. On a torus they hardly change; those that shrink do so by chance.
template <SectionMap M>
bool may_approach(const M& map, const Tail<M>& tail, std::int64_t k) {
    const auto n = static_cast<std::int64_t>(tail.points.size());
    const std::int64_t length = window_length(n, k);
    const double last = largest_return(map, tail, k, n - length, n);
    if (!(last <= largest_return(map, tail, k, k, k + length))) return false;
    const auto farthest = [&](std::int64_t w) {
        return w == 0 ? last : largest_return(map, tail, k, n - (w + 1) * length, n - w * length);
    };
    return shrinks_by_windows(farthest, std::min<std::int64_t>(4, (n - k) / length), 1, 1e-5);
}

}  // namespace swirl::analysis::classification_detail
