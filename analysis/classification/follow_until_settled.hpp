// Follows an orbit for as long as its verdict can change.
#pragma once

#include "analysis/classification/settled.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace swirl::analysis {

/// An orbit as far as it was followed.
template <SectionMap M>
struct FollowedOrbit {
    Tail<M> tail;         ///< of a settled orbit the last states that were looked at; `states`, not `points`
    FoundCycle<M> cycle;  ///< on which it has settled; period 0: it has not
};

namespace classification_detail {

/// When an orbit is looked at: after 128 steps, and then whenever it is half as long again, so that it is followed at
/// most half longer than it takes. (From look to look there are as many steps as the next one sees.)
inline constexpr std::int64_t first_look = 128;
inline std::int64_t next_look(std::int64_t look) {
    return look + look / 2;
}

/// What so many steps may cost, in ordinary ones, before fewer are followed: ten thousand are followed in full where
/// they cost 200 each on average.
inline double most_effort(std::int64_t steps) {
    return std::max(2e6, 8 * static_cast<double>(steps));
}

/// What all looks for a cycle along so many steps may cost: beyond four times what the steps may, an orbit is followed
/// to its end without them. Ordinary ones stay far below (4 candidates of a 24th of the steps, 20 derivatives each, add
/// up to 20 steps for each step that is followed).
inline double most_effort_of_looks(std::int64_t steps) {
    return most_effort(4 * steps);
}

/// A tail whose kept steps belonged to the transient begins anew.
template <SectionMap M>
void forget_kept(Tail<M>& tail) {
    tail.effort = 0;
    tail.states.clear();
    tail.durations.clear();
    tail.integrals.clear();
}

/// How many of its last states are looked at: an eighth of them. Longer periods are seen later.
inline std::int64_t window_of(std::int64_t look) {
    return std::max<std::int64_t>(64, look / 8);
}

/// Do any of the coordinates that are no angles tell that the last two states do not return to `vicinity` after k ≤
/// `longest` steps? Where they tell so of each k, no period is near, and nobody needs to know the angles. `find_period`
/// looks at as many returns as the period has states: one for k = 1.
template <SectionMap M>
bool may_return(const M& map, const std::vector<State<M>>& states, std::int64_t longest, double vicinity) {
    const auto n = static_cast<std::int64_t>(states.size());
    const auto near = [&](std::int64_t a, std::int64_t b) {
        for (int i = M::dimension - 1; i >= 0; --i) {
            if (map.angle_period(i) > 0) continue;
            const double d = coordinate(map, states[static_cast<std::size_t>(a)], i) -
                             coordinate(map, states[static_cast<std::size_t>(b)], i);
            if (!(std::abs(d) <= vicinity)) return false;
        }
        return true;
    };
    for (std::int64_t k = 1; k <= std::min(longest, n - 1); ++k)
        if (near(n - 1, n - 1 - k) && (k == 1 || n < k + 2 || near(n - 2, n - 2 - k))) return true;
    return false;
}

/// Where derivatives are dear: one candidate, and no longer a period than `longest`. Newton's method takes some 20
/// derivatives a step of the period.
inline PeriodOptions affordable_periods(PeriodOptions options, std::int64_t longest) {
    options.candidates = 1;
    options.max_period = std::max<std::int64_t>(1, std::min(options.max_period, longest));
    return options;
}

/// Looks at the last states of a tail.
template <SectionMap M>
FoundCycle<M> look_back(const M& map, const Tail<M>& tail, std::int64_t window, const PeriodOptions& wanted,
                        Effort& effort) {
    constexpr double dear = 32, spent_on_one = 5000;  // of Newton's method at one look, in steps of the period
    const double one = tail.effort / static_cast<double>(tail.durations.size());
    const PeriodOptions options =
        one > dear ? affordable_periods(wanted, static_cast<std::int64_t>(spent_on_one / one)) : wanted;
    Tail<M> seen;
    const auto count = static_cast<std::ptrdiff_t>(window);
    if (!tail.points.empty()) {
        seen.points.assign(tail.points.end() - count, tail.points.end());
    } else {
        seen.states.assign(tail.states.end() - count, tail.states.end());
        if (!may_return(map, seen.states, window / 3, options.vicinity)) return {};
        add_points(map, seen);
    }
    seen.last = tail.last;
    return settled_cycle(map, seen, options, effort);
}

}  // namespace classification_detail

/// Follows an orbit from z through `transient` steps and `count` more that are kept, and ends as soon as it has settled
/// on an attracting cycle (`settled_cycle`): looked for after 128, 192, 288, … steps.
///   settles  false where nothing can (a map that preserves volume): not looked for
/// Where steps cost so much more than ordinary ones that either part exceeds `most_effort`, that part is cut short
/// there (Tail::cut), by the counts of Advance::effort, so that the same orbit is cut at the same step everywhere. The
/// looks have a limit of their own, beyond which nothing is looked for until the end.
/// Cost: the steps; `settled_cycle` at each look.
template <SectionMap M>
FollowedOrbit<M> follow_until_settled(const M& map, State<M> z, std::int64_t transient, std::int64_t count,
                                      const PeriodOptions& options, bool settles, const Stop& stop = {}) {
    namespace detail = classification_detail;
    constexpr std::int64_t longest_as_states = 1 << 20;  // a longer tail has no room for both states and points
    FollowedOrbit<M> orbit;
    Tail<M>& tail = orbit.tail;
    Effort effort{0, detail::most_effort(transient)}, looks{0, detail::most_effort_of_looks(transient + count)};
    std::int64_t look = detail::first_look;
    for (; settles && look <= transient && !tail.cut; look = detail::next_look(look)) {
        const std::int64_t window = detail::window_of(look);
        tail.cut = !skip_steps(map, z, look - window - tail.steps, tail, stop, effort);
        if (tail.ended || tail.stopped) return orbit;
        if (tail.cut) break;
        tail.cut = !record_steps(map, z, window, Keep::states, tail, stop, effort.most - effort.spent);
        if (tail.ended || tail.stopped) return orbit;
        if (!tail.cut) orbit.cycle = detail::look_back(map, tail, window, options, looks);
        if (orbit.cycle.period > 0) return orbit;
        effort.spent += tail.effort;
        detail::forget_kept(tail);
    }
    if (!tail.cut) tail.cut = !skip_steps(map, z, transient - tail.steps, tail, stop, effort);
    if (tail.ended || tail.stopped) return orbit;
    const double most = detail::most_effort(count);
    const std::int64_t before = tail.steps;  // `transient`, or where it was cut
    const Keep keep = count > longest_as_states ? Keep::points : Keep::states;
    reserve(tail, count, keep);
    tail.first = z;
    for (std::int64_t kept = 0; kept < count; look = detail::next_look(look)) {
        while (look <= before) look = detail::next_look(look);
        const std::int64_t until = settles ? std::min(look - before, count) : count;
        const bool whole = record_steps(map, z, until - kept, keep, tail, stop, most);
        if (tail.ended || tail.stopped) return orbit;
        kept = static_cast<std::int64_t>(tail.durations.size());
        if (!whole) {
            tail.cut = true;
            return orbit;
        }
        const std::int64_t window = detail::window_of(look);
        if (kept == count || window > kept) continue;
        orbit.cycle = detail::look_back(map, tail, window, options, looks);
        if (orbit.cycle.period > 0) return orbit;
    }
    return orbit;
}

}  // namespace swirl::analysis
