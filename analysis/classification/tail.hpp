// The part of an orbit that is looked at: its states' coordinates and durations after the transient.
#pragma once

#include "analysis/section_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace swirl::analysis {

template <SectionMap M>
struct Tail {
    std::vector<Vector<M::dimension>> points;  ///< coordinates of n states
    std::vector<double> durations;             ///< durations[i]: from points[i] to the next
    std::vector<double> integrals;             ///< Advance::integral on that way
    State<M> first{};                          ///< the state at points.front(): where others follow the same orbit from
    State<M> last{};                           ///< the state at points.back()
    std::int64_t steps = 0;                    ///< steps taken in all, the transient included
    bool ended = false;                        ///< the map ended before all steps were taken
    bool stopped = false;                      ///< it was stopped before: what is there is no tail
    State<M> end{};                            ///< if it ended: the state that has no next one
};

/// Follows `transient` steps, then keeps `count` states. Cost: one step of the map each.
template <SectionMap M>
Tail<M> follow_tail(const M& map, State<M> z, std::int64_t transient, std::int64_t count, const Stop& stop = {}) {
    constexpr std::int64_t between = 1024;      // steps from one look at `stop` to the next
    constexpr std::int64_t reserved = 1 << 20;  // a tail that is longer grows as it is followed
    Tail<M> tail;
    tail.steps = follow(map, z, transient, stop);
    if (tail.steps < transient) {
        tail.stopped = stop && stop();
        tail.ended = !tail.stopped;
        tail.end = z;
        return tail;
    }
    const auto room = static_cast<std::size_t>(std::min(count, reserved));
    tail.points.reserve(room);
    tail.durations.reserve(room);
    tail.integrals.reserve(room);
    tail.first = z;
    for (std::int64_t i = 0; i < count; ++i) {
        if (stop && i % between == 0 && (tail.stopped = stop())) return tail;
        const auto step = map.advance(z);
        if (!goes_on(map, step)) {
            tail.ended = true;
            tail.end = z;
            return tail;
        }
        ++tail.steps;
        tail.points.push_back(coordinates(map, z));
        tail.durations.push_back(step.duration);
        tail.integrals.push_back(step.integral);
        tail.last = z;
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
