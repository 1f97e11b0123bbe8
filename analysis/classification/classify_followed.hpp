// The verdict on an orbit that was followed no longer than its verdict could change.
// analysis/classification/README.md, "When a verdict is settled".
#pragma once

#include "analysis/classification/classify.hpp"
#include "analysis/classification/follow_until_settled.hpp"
#include "analysis/classification/tail.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace swirl::analysis {

namespace classification_detail {

/// The cycle's own numbers: means over one period, RC of k values that are visited equally often, the exponents of its
/// multipliers.
template <SectionMap M>
Classification verdict_on_cycle(const M& map, const FollowedOrbit<M>& orbit, int observable,
                                const ClassifyOptions& options) {
    Classification result;
    result.steps = orbit.tail.steps;
    Findings findings;
    take_cycle(map, orbit.cycle, options, observable, findings, result);
    std::vector<double> values;
    for (const auto& point : points_from(map, orbit.cycle.state, orbit.cycle.period))
        values.push_back(point[observable]);
    const auto rate = recurrence::recurrence_rate(recurrence::embed_series(values), options.recurrence_threshold);
    const auto n = static_cast<double>(options.collisions);  // of a series of as many steps as would be kept
    result.recurrence_rate = rate.with_diagonal();
    result.recurrence_rate_without_diagonal = (result.recurrence_rate * n - 1) / (n - 1);
    result.largest_exponent = std::log(std::abs(result.multipliers.front())) / static_cast<double>(orbit.cycle.period);
    result.largest_exponent_error = 0;
    decide_settled(findings, options, result);
    return result;
}

/// Has the observable grown out of proportion along a tail, as on an orbit that gains energy without end? Then no part
/// of the tail stands for the whole.
inline bool runs_away(const std::vector<double>& series) {
    constexpr double out_of_proportion = 10;
    const auto largest = [](auto begin, auto end) {
        double size = 0;
        for (auto x = begin; x != end; ++x) size = std::max(size, std::abs(*x));
        return size;
    };
    const auto quarter = static_cast<std::ptrdiff_t>(series.size() / 4);
    return largest(series.end() - quarter, series.end()) >
           out_of_proportion * largest(series.begin(), series.begin() + quarter);
}

/// What the derivatives of n steps may cost.
inline double most_cost_of_derivatives(std::int64_t n) {
    return 3 * most_cost(n);
}

/// Of how many of a tail's steps the derivative is taken: of all of them, unless what the first ones cost says that
/// this exceeds `most_cost_of_derivatives` (differences through contact follow two neighbours a coordinate, for which
/// contact may be much longer). Ordinary steps are not asked.
template <SectionMap M>
std::int64_t steps_with_derivative(const M& map, const Tail<M>& tail) {
    constexpr std::int64_t asked = 32;
    const auto n = static_cast<std::int64_t>(tail.durations.size());
    if (tail.cost < 1.5 * static_cast<double>(n)) return n;
    const double most = most_cost_of_derivatives(n);
    State<M> z = tail.first;
    double cost = 0;
    std::int64_t steps = 0;
    while (steps < std::min(n, asked) && cost < most) {
        const auto step = map.linearise(z);
        cost += step.cost;
        ++steps;
        if (!goes_on(map, step)) break;
        z = step.state;
    }
    return std::max(steps, std::min(n, static_cast<std::int64_t>(most / cost * static_cast<double>(steps))));
}

/// Too few steps for any verdict.
inline constexpr std::int64_t fewest_judged = 64;

/// An orbit whose steps cost so much that fewer were followed than asked for.
template <SectionMap M>
Evidence evidence_of_cut(const Tail<M>& tail, const ClassifyOptions& options) {
    const auto kept = static_cast<double>(tail.durations.size());
    return {"impacts judged", kept, static_cast<double>(options.collisions),
            "each costs " + in_words(tail.cost / kept) +
                " ordinary ones, as in long contact: fewer were followed than the limits allow",
            "all of them are followed (--exhaustive): the verdict is then on these"};
}

/// A search for a cycle, by Newton's method through steps that cost much, which ended before it had tried everything.
inline Evidence evidence_of_search_cut(const StepBudget& search) {
    return {"search for a cycle", search.spent, search.most,
            "its derivatives cost more ordinary steps than the limits allow, as through long contact: it was given up, "
            "so that a cycle may be there",
            "a cycle is found in a search to the end (--exhaustive): steady or quasi-steady"};
}

/// The verdict on a tail whose orbit has not settled: that of `classify_tail`, without what can't change it. Where it
/// can't return to itself nothing looks for a period, and where that leaves chaos nothing else is asked. What searches
/// for a cycle may cost is limited in the same way.
template <SectionMap M>
Classification verdict_on_tail(const M& map, Tail<M>& tail, int observable, ClassifyOptions options) {
    Classification result = measure_tail(map, tail, observable, options.recurrence_threshold);
    if (result.ended) return result;
    Findings findings;
    const auto n = static_cast<std::int64_t>(tail.durations.size());
    if (tail.cut && n < fewest_judged) {
        result.evidence.push_back(evidence_of_cut(tail, options));
        return result;
    }
    const std::int64_t affordable = steps_with_derivative(map, tail);
    if (affordable < n) options.period = affordable_periods(options.period, affordable / 100);
    options.period.poor_starts = false;
    const std::int64_t longest = std::min(options.period.max_period, n / 2);
    FoundCycle<M> cycle;
    StepBudget search{0, most_cost_of_derivatives(n)};
    if (tail.states.empty() || may_return(map, tail.states, longest, options.period.vicinity)) {
        if (options.chaos_alone) return result;
        if (tail.points.empty()) add_points(map, tail);
        cycle = find_period(map, tail, options.period, search);
        take_cycle(map, cycle, options, observable, findings, result);
    }
    if (tail.derivative_is_zero) {
        take_forgotten(findings, result);
    } else {
        const bool stands_for_all = cycle.period == 0 && !runs_away(series_of(map, tail, observable));
        take_exponent(stands_for_all ? exponent_of_few(map, tail, affordable, sign_options(options))
                                     : exponent_of_steps(map, tail, 0, affordable),
                      options, findings, result);
    }
    if (cycle.period == 0 && findings.exponent.sign == ExponentSign::positive) {
        decide(findings, options, result);
    } else if (options.chaos_alone) {
        return result;
    } else {
        if (tail.points.empty()) add_points(map, tail);
        look_further(map, tail, observable, options, findings, result, search);
    }
    if (search.is_spent() && !findings.has_cycle) result.evidence.push_back(evidence_of_search_cut(search));
    if (tail.cut) result.evidence.push_back(evidence_of_cut(tail, options));
    return result;
}

}  // namespace classification_detail

/// Names the mode of an orbit that `follow_until_settled` has followed. Settled on a cycle: the cycle's own numbers.
/// Else what `classify_tail` says of its tail, with the exponent of chaos from as many steps only as tell its sign;
/// where `chaos_alone` is asked it is undecided if it is no chaos, or may be about to repeat itself. The states of the
/// tail may be turned into points. Cost: of chaos some hundred derivatives, else as `classify_tail`.
template <SectionMap M>
Classification classify_followed(const M& map, FollowedOrbit<M>& orbit, int observable,
                                 const ClassifyOptions& options = {}) {
    namespace detail = classification_detail;
    return orbit.cycle.period > 0 ? detail::verdict_on_cycle(map, orbit, observable, options)
                                  : detail::verdict_on_tail(map, orbit.tail, observable, options);
}

/// Follows an orbit from `start` for as long as its verdict can change, and names its mode.
template <SectionMap M>
Classification classify_sequentially(const M& map, const State<M>& start, int observable,
                                     const ClassifyOptions& options = {}) {
    auto orbit =
        follow_until_settled(map, start, options.transient, options.collisions, options.period, !options.conserves);
    return classify_followed(map, orbit, observable, options);
}

}  // namespace swirl::analysis
