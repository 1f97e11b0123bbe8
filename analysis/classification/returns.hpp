// The returns of an orbit to itself after k steps: how near, and whether they shrink.
#pragma once

#include "analysis/classification/tail.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace swirl::analysis::classification_detail {

/// The orbit's largest return after k steps, over its last `count` states.
template <SectionMap M>
double return_distance(const M& map, const Tail<M>& tail, std::int64_t k, std::int64_t count, double give_up) {
    const std::int64_t n = static_cast<std::int64_t>(tail.points.size());
    double largest = 0;
    for (std::int64_t j = n - 1; j >= std::max(n - count, k) && largest <= give_up; --j)
        largest = std::max(largest, distance(map, tail.points[static_cast<std::size_t>(j)],
                                             tail.points[static_cast<std::size_t>(j - k)], give_up));
    return largest;
}

/// The nearest of an orbit's returns, so many and no farther than `vicinity`, the nearest first.
class NearestReturns {
public:
    NearestReturns(int most, double vicinity) : most_(static_cast<std::size_t>(most)), farthest_(vicinity) {}

    /// Beyond this none is taken any more.
    double farthest() const { return farthest_; }
    void add(double returned, std::int64_t k) {
        const std::pair<double, std::int64_t> here(returned, k);
        if (!(returned <= farthest_)) return;
        nearest_.insert(std::upper_bound(nearest_.begin(), nearest_.end(), here), here);
        if (nearest_.size() > most_) nearest_.pop_back();
        if (nearest_.size() == most_) farthest_ = nearest_.empty() ? -1 : nearest_.back().first;
    }
    const std::vector<std::pair<double, std::int64_t>>& all() const { return nearest_; }

private:
    std::size_t most_;
    double farthest_;
    std::vector<std::pair<double, std::int64_t>> nearest_;
};

/// Do the orbit's returns after k steps shrink along the tail, to `part` of what they were or less?
template <SectionMap M>
bool returns_shrink(const M& map, const Tail<M>& tail, std::int64_t k, double part) {
    const auto n = static_cast<std::int64_t>(tail.points.size());
    const std::int64_t count = std::max(k, n / 16);  // states, so that the phase of a complex multiplier plays no part
    const auto largest = [&](std::int64_t first) {   // from `first` on, to those k steps before
        double farthest = 0;
        for (std::int64_t j = first; j < first + count; ++j)
            farthest = std::max(farthest, distance(map, tail.points[static_cast<std::size_t>(j)],
                                                   tail.points[static_cast<std::size_t>(j - k)]));
        return farthest;
    };
    return largest(n - count) <= part * largest(k);
}

/// To which part an approach makes them shrink at least: to half, or by half of what the slowest multiplier m of the
/// cycle (of period `period`) predicts, in the logarithm. On a torus near a rational one they stay as they are, and
/// Newton's method finds a cycle there all the same.
template <SectionMap M>
double part_of_approach(const Tail<M>& tail, std::int64_t k, double slowest, std::int64_t period) {
    const auto n = static_cast<std::int64_t>(tail.points.size());
    const auto apart = static_cast<double>(n - std::max(k, n / 16) - k) / static_cast<double>(period);
    return std::max(0.5, std::pow(slowest, 0.5 * apart));
}

/// Newton's method is asked where returns shrink to this part or less: those of a torus stay as they are to some 10⁻³
/// (in a map of a hexagon, μ = 0.5, e = 0.95, nine tenths of all derivatives were spent on them, in vain; of the cycles
/// found there all had shrunk to 2/3; 2026-11-26). What shrinks less comes nearer by 2 % along the whole tail.
constexpr double seen_to_shrink = 0.99;

}  // namespace swirl::analysis::classification_detail
