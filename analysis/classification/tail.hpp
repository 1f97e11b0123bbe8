// The part of an orbit that is looked at: its states and durations after the transient.
#pragma once

#include "analysis/section_map.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace swirl::analysis {

template <int D>
struct Tail {
    std::vector<Vector<D>> states;      ///< n states
    std::vector<double> durations;      ///< durations[i]: from states[i] to the next
    std::vector<double> integrals;      ///< Advance::integral on that way
    std::int64_t steps = 0;             ///< steps taken in all, the transient included
    bool ended = false;                 ///< the map ended before all steps were taken
    Vector<D> end = Vector<D>::Zero();  ///< if so: the state that has no next one
};

/// Follows `transient` steps, then keeps `count` states. Cost: one step of the map each.
template <SectionMap M>
Tail<M::dimension> follow_tail(const M& map, Vector<M::dimension> z, std::int64_t transient, std::int64_t count) {
    Tail<M::dimension> tail;
    const auto step_from = [&](const Vector<M::dimension>& state) {
        const auto step = map.advance(state);
        if (step.alive && step.state.allFinite()) {
            ++tail.steps;
        } else {
            tail.ended = true;
            tail.end = state;
        }
        return step;
    };
    for (std::int64_t i = 0; i < transient; ++i) {
        const auto step = step_from(z);
        if (tail.ended) return tail;
        z = step.state;
    }
    tail.states.reserve(static_cast<std::size_t>(count));
    tail.durations.reserve(static_cast<std::size_t>(count));
    tail.integrals.reserve(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
        const auto step = step_from(z);
        if (tail.ended) return tail;
        tail.states.push_back(z);
        tail.durations.push_back(step.duration);
        tail.integrals.push_back(step.integral);
        z = step.state;
    }
    return tail;
}

/// a − b, angles as angles, in (−P/2, P/2].
template <SectionMap M>
Vector<M::dimension> difference(const M& map, const Vector<M::dimension>& a, const Vector<M::dimension>& b) {
    Vector<M::dimension> d = a - b;
    for (int i = 0; i < M::dimension; ++i) {
        const double period = map.angle_period(i);
        if (period > 0) d[i] = std::remainder(d[i], period);
    }
    return d;
}

/// The largest coordinate of the difference; or, beyond `give_up`, any that is. Angles, which cost most, come last.
template <SectionMap M>
double distance(const M& map, const Vector<M::dimension>& a, const Vector<M::dimension>& b,
                double give_up = std::numeric_limits<double>::infinity()) {
    double largest = 0;
    for (const bool angles : {false, true})
        for (int i = 0; i < M::dimension && largest <= give_up; ++i) {
            const double period = map.angle_period(i);
            if ((period > 0) != angles) continue;
            const double d = std::abs(angles ? std::remainder(a[i] - b[i], period) : a[i] - b[i]);
            if (!(d <= largest)) largest = d;
        }
    return largest;
}

}  // namespace swirl::analysis
