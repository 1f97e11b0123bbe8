// Arithmetics of a map's own type, for the files that compile them.
#pragma once

#include "apps/studies/scene_map/in_digits.hpp"
#include "apps/studies/tradeoff/arithmetic.hpp"
#include "map/baselines/baseline_map.hpp"
#include "map/model/parameter.hpp"
#include "map/numbers/quad.hpp"
#include "map/orbit/speed_limits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace swirl::studies::tradeoff {

// An arithmetic of a map's own type, for the files that compile them.

/// A number type T: the return map, contact too.
template <class T>
struct InNumbers {
    using Number = T;

    template <class Use>
    static auto with_map(const Scene<double>& scene, Use&& use) {
        return with_collision_map(scene_in<T>(scene), std::forward<Use>(use));
    }

    /// What follows orbits on a map; refers to it.
    template <class Map>
    struct Follower {
        explicit Follower(const Map& map) : return_map(map) {}
        Outcome advance(ReturnStep<T>& step) const { return return_map.advance(step); }
        ReturnMap<Map> return_map;
    };
};

namespace arithmetic_detail {

/// A map with what follows it, and the starts in its type.
template <class Family, class Map>
struct Followed {
    using T = typename Family::Number;

    Followed(const Map& m, std::span<const PostImpactState<double>> states) : map(m), follower(map) {
        for (const auto& state : states) starts.push_back(begin_in<T>(map.body(), state));
    }
    Followed(const Followed&) = delete;
    Followed& operator=(const Followed&) = delete;

    ArithmeticStep advance(const PostImpactState<Quad>& from) const {
        ReturnStep<T> step;
        step.collision.after = state_in<T>(from);
        const T before = jacobi_of(map.body(), step.collision.after);
        ArithmeticStep result;
        result.outcome = follower.advance(step);
        const Collision<T>& c = step.collision;
        result.rounded = rounded_from(step);
        result.rounded.outcome = result.outcome;
        result.after = state_in<Quad>(c.after);
        if (result.outcome != Outcome::completed) return result;
        if (has_diverged(map.body(), c.after)) result.outcome = Outcome::diverged;
        if (has_come_to_rest(map.body(), c.after)) result.outcome = Outcome::resting;
        const T accounted = c.jacobi_restitution + c.jacobi_friction + step.contact_work;
        result.jacobi_drift = static_cast<double>(jacobi_of(map.body(), c.after) - before - accounted);
        return result;
    }

    std::int64_t run(std::size_t first, std::size_t chains, int steps) const {
        std::int64_t impacts = 0;
        ReturnStep<T> step;
        for (std::size_t i = 0; i < chains; ++i) {
            step.collision.after = starts[(first + i) % starts.size()];
            for (int k = 0; k < steps && follower.advance(step) == Outcome::completed; ++k) ++impacts;
            kept = static_cast<double>(step.collision.after.spin);
        }
        return impacts;
    }

    Map map;
    typename Family::template Follower<Map> follower;
    std::vector<PostImpactState<T>> starts;
    mutable volatile double kept = 0;  ///< so that no compiler leaves out what nobody reads
};

template <class Family>
ArithmeticMap make(const Scene<double>& scene, std::span<const PostImpactState<double>> starts) {
    return Family::with_map(scene, [&](const auto& map) {
        using Its = Followed<Family, std::decay_t<decltype(map)>>;
        const auto its = std::make_shared<const Its>(map, starts);
        return ArithmeticMap{
            [its](const PostImpactState<Quad>& z) { return its->advance(z); },
            [its](std::size_t first, std::size_t chains, int steps) { return its->run(first, chains, steps); }};
    });
}

template <class Family>
PostImpactState<Quad> begin(const Scene<double>& scene, const PostImpactState<double>& state) {
    using T = typename Family::Number;
    return state_in<Quad>(begin_in<T>(make_body(scene_in<T>(scene)), state));
}

}  // namespace arithmetic_detail

/// A line of the table of arithmetics.
template <class Family>
Arithmetic arithmetic(std::string_view name, std::string_view what, bool is_exact) {
    return {name,
            what,
            is_exact,
            static_cast<double>(epsilon<typename Family::Number>()),
            &arithmetic_detail::make<Family>,
            &arithmetic_detail::begin<Family>};
}

// Arithmetics that differ in the search for the contact alone (map/baselines): there to be compared with.

/// Double with another search.
template <BaselineSearch search>
struct WithSearch {
    using Number = double;

    template <class Use>
    static auto with_map(const Scene<double>& scene, Use&& use) {
        return with_collision_map(scene, [&](const auto& exact) {
            using Exact = std::decay_t<decltype(exact)>;
            return use(BaselineMap<Exact::shape, Exact::rule>(exact, search));
        });
    }

    template <class Map>
    using Follower = InNumbers<double>::Follower<Map>;
};

}  // namespace swirl::studies::tradeoff
