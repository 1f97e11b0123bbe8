#include "apps/bifurcate/attractor.hpp"

#include "analysis/classification/period.hpp"
#include "analysis/classification/tangent_growth.hpp"
#include "apps/bifurcate/exact_return.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/modes/name_mode.hpp"
#include "apps/system/scene_map.hpp"
#include "apps/system/section_system.hpp"
#include "map/orbit/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::apps::bifurcate {

namespace {

constexpr std::int64_t longest_death = 100'000;  // impacts for which an orbit's end is waited for
constexpr std::int64_t growth_align = 50;
constexpr std::int64_t growth_steps[] = {200, 400};  // the second only where the first does not decide

/// The kept part of an orbit.
template <class System>
struct Kept {
    analysis::Tail<System::dimension> tail;
    double turned = 0, time = 0;
    Outcome outcome = Outcome::completed;
    bool any = false;
    bool interrupted = false;  ///< before all impacts were followed
    typename System::State last;
};

template <class System>
Kept<System> follow(const System& system, const Start<double>& start, const SampleSettings& settings) {
    Kept<System> kept;
    std::visit(
        [&](const auto& s) {
            ReducedOrbit orbit(system.map(), s);
            ExactReturn exact;
            std::int64_t left_out = 0;  // whole periods of an orbit that repeats itself to the bit
            const auto impacts = [&] { return orbit.impacts() + left_out; };
            const auto goes_on = [&] { return impacts() < settings.transient + settings.collisions; };
            while (goes_on() && !(kept.interrupted = is_interrupted()) && orbit.advance()) {
                if (impacts() <= settings.transient) {
                    if (left_out > 0) continue;
                    if (const auto period = exact.after(orbit.post_impact()); period > 0)
                        left_out = (settings.transient - impacts()) / period * period;
                    continue;
                }
                kept.tail.states.push_back(system.state_of(section_point(orbit.post_impact())));
                if (impacts() == settings.transient + 1) continue;
                kept.tail.durations.push_back(orbit.collision().flight_time);
                kept.turned += orbit.return_step().turned;
                kept.time += orbit.collision().flight_time;
            }
            kept.outcome = orbit.outcome();
            kept.any = orbit.impacts() > 0;
            if (kept.any) kept.last = system.state_of(section_point(orbit.post_impact()));
        },
        start);
    return kept;
}

constexpr std::int64_t most_settling = 20'000;  // impacts
constexpr double settled = 1e-13;               // some 10² ε: an orbit dithers by its rounding over 1 − |m|

/// Follows the orbit on until it is on the cycle but for rounding. Returns the distance that is left.
template <class System>
double settle_on(const System& system, const std::vector<typename System::State>& points, typename System::State& z) {
    const auto away = [&] {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& point : points) nearest = std::min(nearest, analysis::distance(system, point, z));
        return nearest;
    };
    double left = away();
    for (std::int64_t n = 0; left > settled && n < most_settling; n += static_cast<std::int64_t>(points.size())) {
        for (std::size_t i = 0; i < points.size(); ++i) z = system.advance(z).state;
        left = away();
    }
    return left;
}

/// The orbit's own samples once it is on the cycle, and their mean. A family's member is where the orbit is already.
template <class System>
void take_cycle(const System& system, const analysis::FoundCycle<System::dimension>& cycle, const Kept<System>& kept,
                Attractor& attractor) {
    attractor.period = cycle.period;
    attractor.mode = cycle.period == 1 ? analysis::Mode::steady : analysis::Mode::quasi_steady;
    attractor.kind = cycle.period > 1 ? analysis::Kind::cycle
                     : cycle.family   ? analysis::Kind::family
                                      : analysis::Kind::fixed_point;
    std::vector<typename System::State> points{cycle.point};
    while (static_cast<std::int64_t>(points.size()) < cycle.period)
        points.push_back(system.advance(points.back()).state);
    auto z = kept.last;
    attractor.distance = settle_on(system, points, z);
    double turned = 0, time = 0;
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
    options.exact_multipliers = false;
    const auto cycle = analysis::find_period(system, kept.tail, options);
    if (cycle.period > 0 && cycle.rounding <= options.rounding) {
        take_cycle(system, cycle, kept, attractor);
        return;
    }
    attractor.mean_spin = kept.turned / kept.time;
    attractor.kind = analysis::Kind::transient;
    for (const std::int64_t steps : growth_steps) {
        if (!analysis::tangent_growth(system, kept.tail.states.front(), growth_align, steps).is_positive(steps))
            continue;
        attractor.mode = analysis::Mode::chaotic;
        attractor.kind = analysis::Kind::chaotic;
        break;
    }
    for (const auto& z : kept.tail.states) attractor.states.push_back(z);
}

}  // namespace

Attractor settle(const Scene<double>& scene, const Start<double>& start, const SampleSettings& settings) {
    Attractor attractor;
    const bool ends_in_contact = with_collision_map(scene, [&](const auto& map) {
        const SectionSystem system(map);
        const auto kept = follow(system, start, settings);
        attractor.outcome = kept.outcome;
        if (kept.any) attractor.last = kept.last;
        attractor.finished = !kept.interrupted;
        if (is_dissipative_without_drive(scene))
            return attractor.finished;  // what looks irregular there is on its way to rest
        if (attractor.finished && kept.outcome == Outcome::completed) name(system, kept, settings, attractor);
        return kept.outcome == Outcome::in_contact;
    });
    if (ends_in_contact) {
        analysis::ClassifyOptions options;
        options.transient = settings.transient + (is_dissipative_without_drive(scene) ? longest_death : 0);
        options.collisions = std::max<std::int64_t>(settings.collisions, 64);
        const NamedMode named = name_mode(scene, start, options);
        attractor.mode = named.verdict.mode;
        attractor.kind = named.verdict.kind;
        attractor.mean_spin = named.verdict.mean;
        attractor.outcome = named.outcome;
    }
    return attractor;
}

}  // namespace swirl::apps::bifurcate
