#include "apps/bifurcate/attractor.hpp"

#include "analysis/classification/tail.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/modes/name_mode.hpp"
#include "apps/system/scene_map.hpp"

#include <algorithm>
#include <limits>

namespace swirl::apps::bifurcate {

namespace {

constexpr std::int64_t longest_death = 100'000;  // impacts for which an orbit's end is waited for
constexpr std::int64_t most_settling = 20'000;   // impacts
constexpr double settled = 1e-13;                // some 10² ε: an orbit dithers by its rounding over 1 − |m|

/// Follows the orbit on until it is on the cycle but for rounding. Returns the distance that is left.
template <int D>
double settle_on(const SceneMap<D>& map, const std::vector<analysis::Vector<D>>& cycle, PostImpactState<double>& z) {
    const auto away = [&] {
        const analysis::Vector<D> here = map.coordinates(z);
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& point : cycle) nearest = std::min(nearest, analysis::distance(map, point, here));
        return nearest;
    };
    const auto period = static_cast<std::int64_t>(cycle.size());
    double left = away();
    for (std::int64_t n = 0; left > settled && n < most_settling; n += period) {
        if (analysis::follow(map, z, period) < period) break;
        left = away();
    }
    return left;
}

/// The orbit's own samples once it is on the cycle that the verdict names.
template <int D>
void take_cycle(const SceneMap<D>& map, const analysis::Classification& verdict, PostImpactState<double> z,
                Attractor& attractor) {
    const auto point = map.state_at(analysis::Vector<D>(verdict.point.data()));
    const auto cycle = analysis::follow_tail(map, point, 0, verdict.period).points;
    attractor.distance = settle_on(map, cycle, z);
    for (const auto& sample : analysis::follow_tail(map, z, 0, verdict.period).points)
        attractor.states.emplace_back(sample);
}

/// What `classify` says of the start: from fewer impacts where they decide, from as many as it takes where they do not.
NamedMode verdict_of(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings,
                     OrbitSamples& samples) {
    const bool dissipative = is_dissipative_without_drive(scene);
    analysis::ClassifyOptions few, many;
    few.transient = settings.transient + (dissipative ? longest_death : 0);
    few.collisions = settings.collisions;
    few.period.exact_multipliers = false;  // the same verdict, and nobody reads them
    const NamedMode named = name_mode(scene, start, few, is_interrupted, &samples);
    const bool decided = named.verdict.mode != analysis::Mode::undecided;
    if (!named.finished || decided || dissipative || named.outcome != Outcome::completed) return named;
    many.transient = std::max(many.transient, few.transient);
    many.collisions = std::max(many.collisions, few.collisions);
    many.period.exact_multipliers = false;
    OrbitSamples longer;
    const NamedMode again = name_mode(scene, start, many, is_interrupted, &longer);
    samples.last = longer.last;
    return again;
}

}  // namespace

Attractor settle(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings) {
    Attractor attractor;
    OrbitSamples samples;
    const NamedMode named = verdict_of(scene, start, settings, samples);
    attractor.finished = named.finished;
    if (!named.finished) return attractor;
    attractor.outcome = named.outcome;
    attractor.mode = named.verdict.mode;
    attractor.kind = named.verdict.kind;
    attractor.period = named.verdict.period;
    attractor.mean_spin = named.verdict.mean;
    attractor.last = samples.last;
    if (named.outcome != Outcome::completed || is_dissipative_without_drive(scene)) return attractor;
    const bool decided = named.verdict.mode != analysis::Mode::undecided;
    if (decided && named.verdict.period > 0)
        with_scene_map(scene, [&](const auto& map) {
            take_cycle(map, named.verdict, post_impact_state(*samples.last), attractor);
        });
    else
        attractor.states = std::move(samples.points);
    return attractor;
}

}  // namespace swirl::apps::bifurcate
