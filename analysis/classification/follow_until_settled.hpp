// Follows an orbit for as long as its verdict can change.
#pragma once

#include "analysis/classification/settled.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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
inline double most_cost(std::int64_t steps) {
    return std::max(2e6, 8 * static_cast<double>(steps));
}

/// What all looks for a cycle along so many steps may cost: beyond four times what the steps may, an orbit is followed
/// to its end without them. Ordinary ones stay far below (4 candidates of a 24th of the steps, 20 derivatives each, add
/// up to 20 steps for each step that is followed).
inline double most_cost_of_looks(std::int64_t steps) {
    return most_cost(4 * steps);
}

/// A tail whose kept steps belonged to the transient begins anew.
template <SectionMap M>
void forget_kept(Tail<M>& tail) {
    tail.cost = 0;
    tail.derivative_is_zero = false;
    tail.states.clear();
    tail.durations.clear();
    tail.integrals.clear();
    tail.letters.clear();
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
                        StepBudget& budget) {
    constexpr double dear = 32, spent_on_one = 5000;  // of Newton's method at one look, in steps of the period
    const double one = tail.cost / static_cast<double>(tail.durations.size());
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
    seen.durations.assign(tail.durations.end() - count, tail.durations.end());
    return settled_cycle(map, seen, options, budget);
}

}  // namespace classification_detail

/// Steps that an orbit is to take before it is looked at again; none: it is over.
struct WantedSteps {
    std::int64_t count = 0;
    bool kept = false;       ///< their states are kept in the tail
    double most = infinity;  ///< what they may cost, in ordinary ones, before the orbit is cut
};

/// An orbit that is followed for as long as its verdict can change, in pieces that others may take for it
/// (`follow_until_settled` takes them all): while `wanted()` has steps, take them from `state()` on and `look`.
template <SectionMap M>
class SettlingOrbit {
public:
    /// As `follow_until_settled`.
    SettlingOrbit(const State<M>& start, std::int64_t transient, std::int64_t count, const PeriodOptions& options,
                  bool settles)
        : z_(start),
          transient_(transient),
          count_(count),
          options_(options),
          settles_(settles),
          budget_{0, classification_detail::most_cost(transient)},
          looks_{0, classification_detail::most_cost_of_looks(transient + count)} {
        search_on();
    }

    WantedSteps wanted() const { return {wanted_.count, wanted_.kept, most_wanted()}; }
    /// Where they begin.
    const State<M>& state() const { return z_; }
    FollowedOrbit<M>& orbit() { return orbit_; }

    /// Takes them.
    void take(const M& map, const Stop& stop) {
        if (!wanted_.kept) {
            whole_ = skip_steps(map, z_, wanted_.count, orbit_.tail, stop, budget_);
        } else {
            const double most = orbit_.tail.cost + most_wanted();
            whole_ = record_steps(map, z_, wanted_.count, keep(), orbit_.tail, stop, most);
        }
    }

    /// Others have taken them, for no more than they may cost: those that are kept are in the tail.
    ///   excess  what they cost beyond as many ordinary steps
    ///   derivative_is_zero  DF = 0 in one of them (Advance::derivative_is_zero)
    void taken(const State<M>& end, double excess, bool derivative_is_zero) {
        z_ = end;
        whole_ = true;
        orbit_.tail.steps += wanted_.count;
        (wanted_.kept ? orbit_.tail.cost : budget_.spent) += static_cast<double>(wanted_.count) + excess;
        if (!wanted_.kept) return;
        orbit_.tail.derivative_is_zero |= derivative_is_zero;
        orbit_.tail.last = orbit_.tail.states.back();
    }

    /// May others keep its states? (A tail that is very long has room for points only.)
    bool keeps_states() const {
        constexpr std::int64_t longest_as_states = 1 << 20;  // a longer tail has no room for both states and points
        return count_ <= longest_as_states;
    }

    /// What the steps that were taken show, and which are wanted next.
    void look(const M& map) {
        Tail<M>& tail = orbit_.tail;
        if (tail.ended || tail.stopped) return end();
        switch (stage_) {
            case Stage::searching:
                return look_in_search(map);
            case Stage::transient:
                tail.cut = !whole_;
                return begin_to_keep();
            case Stage::keeping:
                return look_at_kept(map);
        }
    }

private:
    enum class Stage { searching, transient, keeping };

    Keep keep() const { return stage_ == Stage::keeping && !keeps_states() ? Keep::points : Keep::states; }
    double most_kept() const { return classification_detail::most_cost(count_); }
    double most_wanted() const {
        return stage_ == Stage::keeping ? most_kept() - orbit_.tail.cost : budget_.most - budget_.spent;
    }
    void end() { wanted_ = {}; }

    /// The next look within the transient, and the steps before its window; or what is left of the transient.
    void search_on() {
        Tail<M>& tail = orbit_.tail;
        if (!settles_ || look_ > transient_ || tail.cut) {
            stage_ = Stage::transient;
            wanted_ = {tail.cut ? 0 : transient_ - tail.steps, false};
            if (wanted_.count == 0) begin_to_keep();
            return;
        }
        window_ = classification_detail::window_of(look_);
        wanted_ = {look_ - window_ - tail.steps, false};
        if (wanted_.count == 0) wanted_ = {window_, true};
    }

    void look_in_search(const M& map) {
        namespace detail = classification_detail;
        Tail<M>& tail = orbit_.tail;
        tail.cut = !whole_;
        if (tail.cut && !wanted_.kept) return search_on();
        if (!wanted_.kept) {
            wanted_ = {window_, true};
            return;
        }
        if (!tail.cut) orbit_.cycle = detail::look_back(map, tail, window_, options_, looks_);
        if (orbit_.cycle.period > 0) return end();
        budget_.spent += tail.cost;
        detail::forget_kept(tail);
        look_ = detail::next_look(look_);
        search_on();
    }

    void begin_to_keep() {
        Tail<M>& tail = orbit_.tail;
        stage_ = Stage::keeping;
        reserve(tail, count_, keep());
        tail.first = z_;
        before_ = tail.steps;
        keep_on();
    }

    void keep_on() {
        const auto kept = static_cast<std::int64_t>(orbit_.tail.durations.size());
        while (look_ <= before_) look_ = classification_detail::next_look(look_);
        wanted_ = {(settles_ ? std::min(look_ - before_, count_) : count_) - kept, true};
    }

    void look_at_kept(const M& map) {
        namespace detail = classification_detail;
        Tail<M>& tail = orbit_.tail;
        const auto kept = static_cast<std::int64_t>(tail.durations.size());
        tail.cut |= !whole_;
        if (!whole_) return end();
        const std::int64_t window = detail::window_of(look_);
        if (kept < count_ && window <= kept) orbit_.cycle = detail::look_back(map, tail, window, options_, looks_);
        if (kept == count_ || orbit_.cycle.period > 0) return end();
        look_ = detail::next_look(look_);
        keep_on();
    }

    FollowedOrbit<M> orbit_;
    State<M> z_;
    std::int64_t transient_, count_;
    PeriodOptions options_;
    bool settles_;
    StepBudget budget_, looks_;
    WantedSteps wanted_;
    Stage stage_ = Stage::searching;
    std::int64_t look_ = classification_detail::first_look, window_ = 0, before_ = 0;
    bool whole_ = true;  ///< of the last steps none was left out for what they cost
};

/// Takes all steps of an orbit that it wants.
template <SectionMap M>
FollowedOrbit<M> follow_to_end(SettlingOrbit<M> orbit, const M& map, const Stop& stop = {}) {
    while (orbit.wanted().count > 0) {
        orbit.take(map, stop);
        orbit.look(map);
    }
    return std::move(orbit.orbit());
}

/// Follows an orbit from z through `transient` steps and `count` more that are kept, and ends as soon as it has settled
/// on an attracting cycle (`settled_cycle`): looked for after 128, 192, 288, … steps.
///   settles  false where nothing can (a map that preserves volume): not looked for
/// Where steps cost so much more than ordinary ones that either part exceeds `most_cost`, that part is cut short
/// there (Tail::cut), by the counts of Advance::cost, so that the same orbit is cut at the same step everywhere. The
/// looks have a limit of their own, beyond which nothing is looked for until the end.
/// Cost: the steps; `settled_cycle` at each look.
template <SectionMap M>
FollowedOrbit<M> follow_until_settled(const M& map, const State<M>& z, std::int64_t transient, std::int64_t count,
                                      const PeriodOptions& options, bool settles, const Stop& stop = {}) {
    return follow_to_end(SettlingOrbit<M>(z, transient, count, options, settles), map, stop);
}

}  // namespace swirl::analysis
