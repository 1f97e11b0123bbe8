// The largest Lyapunov exponent of a tail.
#pragma once

#include "analysis/classification/tail.hpp"
#include "analysis/lyapunov/exponent_sign.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"
#include "analysis/section_map.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace swirl::analysis::classification_detail {

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
