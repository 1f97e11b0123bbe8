#include "apps/bifurcate/attractor.hpp"

#include "analysis/classification/period.hpp"
#include "analysis/classification/tangent_growth.hpp"
#include "apps/classify/classify_command.hpp"
#include "apps/scene_map/scene_map.hpp"
#include "apps/section_system.hpp"
#include "map/orbit.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::apps {

namespace {

constexpr std::int64_t growth_align = 50, growth_steps = 400;

/// The kept part of an orbit.
template <class System>
struct Kept {
    analysis::Tail<System::dimension> tail;
    double turned = 0, time = 0;
    Outcome outcome = Outcome::completed;
    bool any = false;
    typename System::State last;
};

template <class System>
Kept<System> follow(const System& system, const Start<double>& start, const SampleSettings& settings) {
    Kept<System> kept;
    std::visit(
        [&](const auto& s) {
            Orbit orbit(system.map(), s);
            while (orbit.impacts() < settings.transient + settings.collisions && orbit.advance()) {
                if (orbit.impacts() <= settings.transient) continue;
                kept.tail.states.push_back(system.state_of(section_point(orbit.launch())));
                if (orbit.impacts() == settings.transient + 1) continue;
                kept.tail.durations.push_back(orbit.collision().flight_time);
                kept.turned += orbit.passage().turned;
                kept.time += orbit.collision().flight_time;
            }
            kept.outcome = orbit.outcome();
            kept.any = orbit.impacts() > 0;
            if (kept.any) kept.last = system.state_of(section_point(orbit.launch()));
        },
        start);
    return kept;
}

/// The cycle as the orbit's samples: its k points and its mean.
template <class System>
void take_cycle(const System& system, const analysis::FoundCycle<System::dimension>& cycle, Attractor& attractor) {
    attractor.period = cycle.period;
    attractor.distance = cycle.distance;
    attractor.mode = cycle.period == 1 ? analysis::Mode::steady : analysis::Mode::quasi_steady;
    attractor.kind = cycle.period > 1 ? analysis::Kind::cycle
                                      : cycle.family ? analysis::Kind::family : analysis::Kind::fixed_point;
    double turned = 0, time = 0;
    auto z = cycle.point;
    for (std::int64_t i = 0; i < cycle.period; ++i) {
        const auto step = system.advance(z);
        attractor.states.push_back(z);
        turned += step.integral;
        time += step.duration;
        if (step.letter < 0) attractor.kind = analysis::Kind::landing;
        z = step.state;
    }
    if (attractor.kind == analysis::Kind::landing) attractor.mode = analysis::Mode::quasi_steady;
    attractor.mean_spin = turned / time;
}

template <class System>
void name(const System& system, const Kept<System>& kept, const SampleSettings& settings, Attractor& attractor) {
    analysis::PeriodOptions options;
    options.max_period = settings.max_period;
    const auto cycle = analysis::find_period(system, kept.tail, options);
    if (cycle.period > 0) {
        take_cycle(system, cycle, attractor);
        return;
    }
    attractor.mean_spin = kept.turned / kept.time;
    attractor.kind = analysis::Kind::transient;
    if (analysis::tangent_growth(system, kept.tail.states.front(), growth_align, growth_steps).is_positive(growth_steps)) {
        attractor.mode = analysis::Mode::chaotic;
        attractor.kind = analysis::Kind::chaotic;
    }
    for (const auto& z : kept.tail.states) attractor.states.push_back(z);
}

}  // namespace

Attractor settle(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings) {
    Attractor attractor;
    const bool landed = with_collision_map(scene, [&](const auto& map) {
        const SectionSystem system(map);
        const auto kept = follow(system, start, settings);
        attractor.outcome = kept.outcome;
        if (kept.any) attractor.last = kept.last;
        if (kept.outcome == Outcome::completed) name(system, kept, settings, attractor);
        return kept.outcome == Outcome::in_contact;
    });
    if (landed) {
        analysis::ClassifyOptions options;
        options.transient = settings.transient;
        options.collisions = std::max<std::int64_t>(settings.collisions, 64);
        const NamedMode named = name_mode(scene, start, options);
        attractor.mode = named.verdict.mode;
        attractor.kind = named.verdict.kind;
        attractor.mean_spin = named.verdict.mean;
    }
    return attractor;
}

}  // namespace swirl::apps
