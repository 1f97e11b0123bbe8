#include "apps/studies/diagrams/attractor.hpp"

#include "analysis/classification/tail.hpp"
#include "apps/studies/modes/early_chaos.hpp"
#include "apps/studies/scene_map/chatter_once.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace swirl::studies::diagrams {

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

/// A matrix whose columns are these points; all have one size.
template <class Points>
Eigen::MatrixXd in_columns(const Points& points) {
    if (points.empty()) return {};
    Eigen::MatrixXd columns(points.front().size(), static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];
    return columns;
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
    attractor.states = in_columns(on_it ? one_period(map, verdict.period, z) : cycle);
}

/// As many impacts as the diagram wants. One that can only die away is waited for.
analysis::ClassifyOptions first_settings(const SampleSettings& wanted, bool dissipative) {
    analysis::ClassifyOptions settings;
    settings.transient = wanted.transient + (dissipative ? longest_death : 0);
    settings.collisions = wanted.collisions;
    settings.exhaustive = wanted.exhaustive;
    settings.period.exact_multipliers = false;  // the same verdict, and nobody reads them
    return settings;
}

/// As many as `classify` follows, at least.
analysis::ClassifyOptions further_settings(const SampleSettings& wanted) {
    analysis::ClassifyOptions settings = first_settings(wanted, false);
    const analysis::ClassifyOptions usual;
    settings.transient = std::max(settings.transient, usual.transient);
    settings.collisions = std::max(settings.collisions, usual.collisions);
    return settings;
}

bool is_decided(const NamedMode& named) {
    return named.verdict.mode != analysis::Mode::undecided;
}

/// What is kept of a verdict and what it saw.
Attractor attractor_from(const Scene<double>& scene, const NamedMode& named, OrbitSamples& samples, Accuracy accuracy) {
    Attractor attractor;
    attractor.finished = true;
    attractor.outcome = named.outcome;
    attractor.mode = named.verdict.mode;
    attractor.kind = named.verdict.kind;
    attractor.impacts = named.impacts;
    attractor.period = named.verdict.period;
    attractor.largest_exponent = named.verdict.largest_exponent;
    attractor.mean_spin = named.verdict.mean;
    attractor.mean_spin_per_impact = named.verdict.mean_per_step;
    attractor.mean_errors = named.mean_errors;
    attractor.growth = named.growth;
    attractor.limit_spin = named.limit_spin;
    attractor.last = samples.last;
    if (named.outcome != Outcome::completed || is_dissipative_without_drive(scene)) return attractor;
    if (is_decided(named) && named.verdict.period > 0)
        with_scene_map(
            scene,
            [&](const auto& map) { take_cycle(map, named.verdict, post_impact_state(*samples.last), attractor); },
            contact_horizon, accuracy);
    else
        attractor.states = in_columns(std::exchange(samples.points, {}));  // a diagram has many
    return attractor;
}

/// Those that the diagram's counts leave undecided are followed on; the samples are those of the diagram.
struct FollowedOn {
    std::vector<std::size_t> places;
    std::vector<SceneStart> starts;
    std::vector<OrbitSamples> samples;
};

}  // namespace

analysis::ClassifyOptions limits_of(const SampleSettings& wanted) {
    return first_settings(wanted, false);
}

void settle_all(std::span<const SceneStart> starts, const SampleSettings& settings, const analysis::Stop& stop,
                const TakeAttractor& take, std::int64_t look) {
    std::vector<std::size_t> places;
    std::vector<SceneStart> driven;
    FollowedOn further;
    const auto options = [&](const analysis::ClassifyOptions& counts, std::int64_t to_look = 0) {
        return NamingOptions{counts, settings.accuracy, stop, true, to_look};
    };
    for (std::size_t i = 0; i < starts.size(); ++i) {
        if (look > 0 && has_attracting_steady_mode(starts[i].scene)) {
            Attractor nothing_known;
            nothing_known.finished = true;
            take(i, nothing_known);
            continue;
        }
        if (!is_dissipative_without_drive(starts[i].scene)) {
            places.push_back(i);
            driven.push_back(starts[i]);
            continue;
        }
        name_modes(starts.subspan(i, 1), options(first_settings(settings, true)),
                   [&](std::size_t, const NamedMode& named, OrbitSamples& samples) {
                       take(i, attractor_from(starts[i].scene, named, samples, settings.accuracy));
                   });
    }
    name_modes(driven, options(first_settings(settings, false), look),
               [&](std::size_t k, const NamedMode& named, OrbitSamples& samples) {
                   if (is_decided(named) || named.outcome != Outcome::completed || look > 0)
                       return take(places[k], attractor_from(driven[k].scene, named, samples, settings.accuracy));
                   further.places.push_back(places[k]);
                   further.starts.push_back(driven[k]);
                   further.samples.push_back(std::move(samples));
               });
    name_modes(further.starts, options(further_settings(settings)),
               [&](std::size_t k, const NamedMode& named, OrbitSamples& longer) {
                   OrbitSamples& samples = further.samples[k];
                   samples.last = longer.last;
                   take(further.places[k], attractor_from(further.starts[k].scene, named, samples, settings.accuracy));
               });
}

Attractor settle(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings,
                 const analysis::Stop& stop) {
    const SceneStart one{scene, start};
    Attractor attractor;
    settle_all({&one, 1}, settings, stop, [&](std::size_t, const Attractor& found) { attractor = found; });
    return attractor;
}

analysis::CyclePoints points_of(const Attractor& attractor) {
    analysis::CyclePoints points;
    for (const auto& state : attractor.states.colwise()) points.emplace_back(state);
    return points;
}

}  // namespace swirl::studies::diagrams
