// The part of an orbit that is looked at: its states' coordinates and durations after the transient.
#pragma once

#include "analysis/lyapunov/exponent_sign.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "analysis/section_map.hpp"
#include "analysis/special_values.hpp"
#include "analysis/within_period.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace swirl::analysis {

template <SectionMap M>
struct Tail {
    std::vector<Vector<M::dimension>> points;  ///< coordinates of n states
    std::vector<State<M>> states;              ///< the states themselves, of a tail that keeps them
    std::vector<double> durations;             ///< durations[i]: from points[i] to the next
    std::vector<double> integrals;             ///< Advance::integral on that way
    std::vector<std::int64_t> letters;         ///< Advance::letter of that step, of a tail that keeps its states
    State<M> first{};                          ///< the state at points.front(): where others follow the same orbit from
    State<M> last{};                           ///< the state at points.back()
    std::int64_t steps = 0;                    ///< steps taken in all, the transient included
    double cost = 0;                           ///< what those that are kept cost (Advance::cost)
    bool derivative_is_zero = false;  ///< DF = 0 in one of the steps that are kept (Advance::derivative_is_zero)
    bool cut = false;                 ///< fewer steps than were asked for: they cost too much
    bool ended = false;               ///< the map ended before all steps were taken
    bool stopped = false;             ///< it was stopped before: what is there is no tail
    State<M> end{};                   ///< if it ended: the state that has no next one
};

/// What a tail keeps of each state: angles cost two arc tangents, which chaos need not know.
enum class Keep { points, states };

template <SectionMap M>
void keep_state(const State<M>& z, std::int64_t letter, Tail<M>& tail) {
    tail.states.push_back(z);
    tail.letters.push_back(letter);
}

/// Takes `count` steps from z on and keeps each one's state, to the end of the tail; z is the next one then.
/// @return false where the map ended, or it was stopped: as the tail says; or where they have cost `most_cost`
template <SectionMap M>
bool record_steps(const M& map, State<M>& z, std::int64_t count, Keep keep, Tail<M>& tail, const Stop& stop = {},
                  double most_cost = infinity) {
    constexpr std::int64_t between = 1024;  // steps from one look at `stop` to the next
    for (std::int64_t i = 0; i < count; ++i) {
        if (tail.cost >= most_cost) return false;
        if (stop && i % between == 0 && (tail.stopped = stop())) return false;
        const auto step = map.advance(z);
        if (!goes_on(map, step)) {
            tail.ended = true;
            tail.end = z;
            return false;
        }
        ++tail.steps;
        tail.cost += step.cost;
        tail.derivative_is_zero |= step.derivative_is_zero;
        if (keep == Keep::points)
            tail.points.push_back(coordinates(map, z));
        else
            keep_state(z, step.letter, tail);
        tail.durations.push_back(step.duration);
        tail.integrals.push_back(step.integral);
        tail.last = z;
        z = step.state;
    }
    return true;
}

/// Moves z on by `count` steps, with a tail that has none yet.
/// @return as `record_steps`, false also where `budget` is spent
template <SectionMap M>
bool skip_steps(const M& map, State<M>& z, std::int64_t count, Tail<M>& tail, const Stop& stop, StepBudget& budget) {
    const std::int64_t done = follow(map, z, count, stop, budget);
    tail.steps += done;
    if (done == count) return true;
    tail.stopped = stop && stop();
    if (!tail.stopped && budget.is_spent()) return false;
    tail.ended = !tail.stopped;
    tail.end = z;
    return false;
}

/// Skips steps as above, whatever they cost.
template <SectionMap M>
bool skip_steps(const M& map, State<M>& z, std::int64_t count, Tail<M>& tail, const Stop& stop = {}) {
    StepBudget budget;
    return skip_steps(map, z, count, tail, stop, budget);
}

/// Room for that many steps; a tail that is longer than a million grows as it is followed.
template <SectionMap M>
void reserve(Tail<M>& tail, std::int64_t count, Keep keep) {
    constexpr std::int64_t reserved = 1 << 20;
    const auto room = static_cast<std::size_t>(std::min(count, reserved));
    if (keep == Keep::points) {
        tail.points.reserve(room);
    } else {
        tail.states.reserve(room);
        tail.letters.reserve(room);
    }
    tail.durations.reserve(room);
    tail.integrals.reserve(room);
}

/// The points of a tail that has states.
template <SectionMap M>
void add_points(const M& map, Tail<M>& tail) {
    tail.points.reserve(tail.states.size());
    for (const State<M>& z : tail.states) tail.points.push_back(coordinates(map, z));
}

/// Follows `transient` steps, then keeps the points of `count` states. Cost: one step of the map each.
template <SectionMap M>
Tail<M> follow_tail(const M& map, State<M> z, std::int64_t transient, std::int64_t count, const Stop& stop = {}) {
    Tail<M> tail;
    if (!skip_steps(map, z, transient, tail, stop)) return tail;
    reserve(tail, count, Keep::points);
    tail.first = z;
    record_steps(map, z, count, Keep::points, tail, stop);
    return tail;
}

/// a − b, angles as angles, in [−P/2, P/2].
template <SectionMap M>
Vector<M::dimension> difference(const M& map, const Vector<M::dimension>& a, const Vector<M::dimension>& b) {
    Vector<M::dimension> d = a - b;
    for (int i = 0; i < M::dimension; ++i) d[i] = within_period(d[i], map.angle_period(i));
    return d;
}

/// The largest coordinate of the difference; or, beyond `give_up`, any that is. Angles, which cost most, come last.
template <SectionMap M>
double distance(const M& map, const Vector<M::dimension>& a, const Vector<M::dimension>& b, double give_up = infinity) {
    double largest = 0;
    for (const bool angles : {false, true})
        for (int i = 0; i < M::dimension && largest <= give_up; ++i) {
            const double period = map.angle_period(i);
            if ((period > 0) != angles) continue;
            const double d = std::abs(within_period(a[i] - b[i], period));
            if (!(d <= largest)) largest = d;
        }
    return largest;
}

/// Do the orbit's returns after k steps take less time as they grow smaller? Where steps accumulate both fall by the
/// same factor q: the states converge within a finite time, after which the orbit goes on elsewhere. On a cycle returns
/// fall, and the time stays. Asked of the last return and the first since when all were within `vicinity`: yes if the
/// time has fallen by half as much as the return, (1 − q)/2; where returns do not fall, by a tenth; where they are
/// rounding, by a thousandth. Yes also where the last return is within 10⁻⁹ only because it took so little time: it
/// moves at a rate of 10⁻³ or more. The times themselves may be rounding there.
template <SectionMap M>
bool accumulates(const M& map, const Tail<M>& tail, std::int64_t k, double vicinity) {
    constexpr double rounding = 1e-13, still = 1e-9, moves = 1e-3;
    const auto return_to = [&](std::int64_t j) {
        return distance(map, tail.points[static_cast<std::size_t>(j)], tail.points[static_cast<std::size_t>(j - k)]);
    };
    const auto time_to = [&](std::int64_t j) {
        return std::accumulate(tail.durations.begin() + (j - k), tail.durations.begin() + j, 0.0);
    };
    const std::int64_t last = static_cast<std::int64_t>(tail.points.size()) - 1;
    if (last < k) return false;
    const double at_last = return_to(last);
    if (at_last <= still && at_last >= moves * time_to(last)) return true;
    std::int64_t first = last;
    double before = 0;
    while (first - k >= k) {
        const double earlier = return_to(first - k);
        if (earlier > vicinity) break;
        before = earlier;
        first -= k;
    }
    if (first == last) return false;
    const double now = std::max(at_last, rounding);
    const double fall = before <= 10 * rounding ? 2e-3 : now < before ? 1 - now / before : 0.2;
    return time_to(last) <= (1 - fall / 2) * time_to(first);
}

}  // namespace swirl::analysis

namespace swirl::analysis::classification_detail {

// The largest Lyapunov exponent of a tail.

/// All of so many steps count.
inline LyapunovOptions every_step(std::int64_t steps) {
    LyapunovOptions options;
    options.transient = 0;
    options.steps = steps;
    return options;
}

/// The largest exponent of `steps` steps from a state on.
template <SectionMap M>
LyapunovSpectrum exponent_from(const M& map, const State<M>& first, std::int64_t steps) {
    return largest_exponent(map, first, every_step(steps));
}

/// The `i`th step of a tail that keeps its states, with its derivative: of the last it does not keep where it led to.
template <SectionMap M>
Linearised<M::dimension, State<M>> kept_step(const M& map, const Tail<M>& tail, std::size_t i) {
    const State<M>& z = tail.states[i];
    if (i + 1 == tail.states.size()) return map.linearise(z);
    return linearise_known(map, z, KnownStep<State<M>>{tail.states[i + 1], tail.durations[i], tail.letters[i]});
}

/// The largest exponent of `steps` steps of a tail that keeps its states, from its `first` on: without taking them
/// again, where the map need not.
template <SectionMap M>
LyapunovSpectrum exponent_of_steps(const M& map, const Tail<M>& tail, std::int64_t first, std::int64_t steps) {
    if (tail.states.empty()) return exponent_from(map, tail.first, steps);
    const LyapunovOptions options = every_step(steps);
    auto i = static_cast<std::size_t>(first);
    return lyapunov_detail::largest_exponent_of(map, ExponentAccumulator(1, options), 0, options,
                                                [&] { return kept_step(map, tail, i++); });
}

/// The exponent of a tail: of as many of its n steps as tell that it is positive, 256 or more, else of all. It has to
/// be positive on the tail's last steps, too: chaos that ends on the way, or comes late, is known from all. The errors
/// of a sum that scatters fall like the root of its steps, so that what is missing tells how many are asked next.
///   n  at most so many of them
template <SectionMap M>
LyapunovSpectrum exponent_of_few(const M& map, const Tail<M>& tail, std::int64_t n, const SignOptions& sign) {
    constexpr std::int64_t fewest = 256;
    const auto clearly = [&](const LyapunovSpectrum& spectrum) {
        return spectrum.outcome == LyapunovOutcome::completed && is_clearly_positive(judge_sign(spectrum, 0, sign));
    };
    for (std::int64_t steps = fewest; 4 * steps <= n && !tail.states.empty();) {
        auto spectrum = exponent_of_steps(map, tail, 0, steps);
        if (spectrum.outcome != LyapunovOutcome::completed) break;
        if (clearly(spectrum) && clearly(exponent_of_steps(map, tail, n - steps, steps))) return spectrum;
        const std::int64_t needed = steps_until_positive(judge_sign(spectrum, 0, sign), steps, sign);
        if (needed <= 0) break;
        steps = std::max(2 * steps, needed);
    }
    return exponent_of_steps(map, tail, 0, n);
}

}  // namespace swirl::analysis::classification_detail
