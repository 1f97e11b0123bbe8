#include "apps/bifurcate/attractor.hpp"

#include "analysis/classification/tail.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/modes/name_mode.hpp"
#include "apps/system/chatter_once.hpp"

#include <algorithm>
#include <limits>

namespace swirl::apps::bifurcate {

namespace {

constexpr std::int64_t longest_death = 100'000;  // impacts for which an orbit's end is waited for
constexpr std::int64_t most_settling = 20'000;   // impacts
constexpr double settled = 1e-13;                // some 10² ε: an orbit dithers by its rounding over 1 − |m|

/// `period` impacts from z on, chatter that lands counted once (chatter_once.hpp); z moves on by them. Fewer where the
/// map ends.
template <int D>
std::vector<analysis::Vector<D>> one_period(const SceneMap<D>& map, std::int64_t period, PostImpactState<double>& z) {
    std::vector<analysis::Vector<D>> points;
    for (std::int64_t i = 0; i < period; ++i) {
        const auto step = advance_as_one(map, z);
        if (!step.alive) break;
        points.push_back(map.coordinates(z));
        z = step.state;
    }
    return points;
}

/// Follows the orbit on until it is on the cycle but for rounding. Returns the distance that is left.
template <int D>
double settle_on(const SceneMap<D>& map, const std::vector<analysis::Vector<D>>& cycle, PostImpactState<double>& z) {
    const auto away = [&] {
        const analysis::Vector<D> here = map.coordinates(z);
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& point : cycle) nearest = std::min(nearest, analysis::distance(map, point, here));
        return nearest;
    };
    double left = away();
    for (std::int64_t n = 0; left > settled && n < most_settling;) {
        const auto period = static_cast<std::int64_t>(cycle.size());
        if (static_cast<std::int64_t>(one_period(map, period, z).size()) < period) break;
        n += period;
        left = away();
    }
    return left;
}

/// z, or where it is a rebound the first impact after the landing.
template <int D>
PostImpactState<double> past_rebounds(const SceneMap<D>& map, PostImpactState<double> z) {
    for (std::int64_t n = 0; n < most_settling; ++n) {
        const auto step = map.advance(z);
        if (!step.alive) break;
        z = step.state;
        if (letter_from(step.letter).through_contact) break;
    }
    return z;
}

/// The orbit's own samples once it is on the cycle that the verdict names.
template <int D>
void take_cycle(const SceneMap<D>& map, const analysis::Classification& verdict, PostImpactState<double> z,
                Attractor& attractor) {
    auto point = map.state_at(analysis::Vector<D>(verdict.point.data()));
    const auto cycle = one_period(map, verdict.period, point);
    if (verdict.kind == analysis::Kind::landing) z = past_rebounds(map, z);
    attractor.distance = settle_on(map, cycle, z);
    const bool on_it = attractor.distance <= settled || verdict.kind == analysis::Kind::family;
    for (const auto& sample : on_it ? one_period(map, verdict.period, z) : cycle) attractor.states.emplace_back(sample);
}

/// What `classify` says of the start: from fewer impacts where they decide, from as many as it takes where they do not.
NamedMode verdict_of(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings,
                     OrbitSamples& samples) {
    const bool dissipative = is_dissipative_without_drive(scene);
    analysis::ClassifyOptions few, many;
    few.transient = settings.transient + (dissipative ? longest_death : 0);
    few.collisions = settings.collisions;
    few.exhaustive = many.exhaustive = settings.exhaustive;
    few.period.exact_multipliers = false;  // the same verdict, and nobody reads them
    const NamedMode named = name_mode(scene, start, few, settings.accuracy, is_interrupted, &samples);
    const bool decided = named.verdict.mode != analysis::Mode::undecided;
    if (!named.finished || decided || dissipative || named.outcome != Outcome::completed) return named;
    many.transient = std::max(many.transient, few.transient);
    many.collisions = std::max(many.collisions, few.collisions);
    many.period.exact_multipliers = false;
    OrbitSamples longer;
    const NamedMode again = name_mode(scene, start, many, settings.accuracy, is_interrupted, &longer);
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
    attractor.mean_spin_per_impact = named.verdict.mean_per_step;
    attractor.last = samples.last;
    if (named.outcome != Outcome::completed || is_dissipative_without_drive(scene)) return attractor;
    const bool decided = named.verdict.mode != analysis::Mode::undecided;
    if (decided && named.verdict.period > 0)
        with_scene_map(
            scene,
            [&](const auto& map) { take_cycle(map, named.verdict, post_impact_state(*samples.last), attractor); },
            contact_horizon, settings.accuracy);
    else
        attractor.states = std::move(samples.points);
    return attractor;
}

}  // namespace swirl::apps::bifurcate
