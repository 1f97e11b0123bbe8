#include "apps/studies/modes/escape.hpp"

#include "analysis/classification/tail.hpp"
#include "analysis/special_values.hpp"
#include "apps/studies/parallel/pieces.hpp"
#include "apps/studies/scene_map/chatter_once.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace swirl::studies {

namespace {

using analysis::Kind;

constexpr double beside = 0.01;     // of a cycle: chaos may pass so near to it, but not for ever
constexpr double came_apart = 1e4;  // neighbours: some ten over the exponent of chaos; tori take 10⁴ impacts for that

bool is_on_cycle(Kind kind) {
    return kind == Kind::fixed_point || kind == Kind::cycle || kind == Kind::landing;
}
bool is_on_cycle(const RunVerdict& run) {
    return is_on_cycle(run.kind);
}

bool is_chaotic(const RunVerdict& run) {
    return run.kind == Kind::chaotic;
}

/// No more impacts: at rest, rolling or sliding on the wall.
bool is_on_wall(const RunVerdict& run) {
    return run.outcome == Outcome::in_contact;
}

/// The last impact at which the orbit was farther than `beside` from the cycle that it settles on.
template <int D>
std::int64_t last_impact_away(const SceneMap<D>& map, const Start<double>& start, const RunVerdict& run,
                              const RunControl& control) {
    std::vector<analysis::Vector<D>> cycle;
    auto z = map.state_at(analysis::Vector<D>(run.point.data()));
    for (std::int64_t i = 0; i < run.period; ++i) {
        cycle.push_back(map.coordinates(z));
        z = advance_as_one(map, z).state;
    }
    const OrbitBegin begin = begin_orbit(map, start);
    z = begin.state;
    std::int64_t last = 0;
    for (std::int64_t n = begin.impacts; n < run.impacts && !control.is_stopped();) {
        const analysis::Vector<D> here = map.coordinates(z);
        const bool is_near = std::any_of(cycle.begin(), cycle.end(), [&](const auto& point) {
            return analysis::distance(map, point, here) <= beside;
        });
        if (!is_near) last = n;
        const auto steps = steps_as_one(map, z);
        const auto step = sum_of(map, steps);
        if (!step.alive) break;
        n += static_cast<std::int64_t>(steps.size());
        z = step.state;
    }
    return last;
}

/// How long a run was in chaos; nothing of one whose date of leaving is not known.
analysis::ChaoticStay stay_of(const Scene<double>& scene, Accuracy accuracy, double speed, const RunVerdict& run,
                              const RunControl& control) {
    if (is_chaotic(run) || is_on_wall(run)) return {run.impacts, !is_chaotic(run)};
    if (!is_on_cycle(run)) return {};
    const Start<double> start = random_start(scene.beta, speed, run.seed, 0);
    const auto last_away = [&](const auto& map) { return last_impact_away(map, start, run, control); };
    return {with_scene_map(scene, last_away, contact_horizon, accuracy), true};
}

/// ln of how much the difference of two neighbouring orbits has grown by an impact; where a rest makes it zero another
/// begins, and the largest counts.
template <int D>
double ln_growth(const SceneMap<D>& map, const Start<double>& start, std::int64_t impact, const RunControl& control) {
    const OrbitBegin begin = begin_orbit(map, start);
    auto z = begin.state;
    const analysis::Vector<D> apart = analysis::Vector<D>::Ones().normalized();
    analysis::Vector<D> difference = apart;
    double grown = 0, before = -analysis::infinity;
    for (std::int64_t n = begin.impacts; n < impact && !control.is_stopped(); ++n) {
        const auto step = map.linearise(z);
        if (!step.alive) break;
        z = step.state;
        const analysis::Vector<D> next = step.derivative * difference;
        const double size = next.norm();
        if (!std::isfinite(size)) continue;  // at a border of the map there is no derivative
        if (size == 0) {
            before = std::max(before, std::exchange(grown, 0));
            difference = apart;
            continue;
        }
        grown += std::log(size);
        difference = next / size;
    }
    return std::max(before, grown);
}

/// How long a run was in chaos; nothing of one that left without having been there.
analysis::ChaoticStay chaotic_stay_of(const Scene<double>& scene, Accuracy accuracy, double speed,
                                      const RunVerdict& run, std::int64_t settling, const RunControl& control) {
    const analysis::ChaoticStay stay = stay_of(scene, accuracy, speed, run, control);
    if (!stay.left || stay.steps <= settling) return stay;
    const Start<double> start = random_start(scene.beta, speed, run.seed, 0);
    const auto grown = [&](const auto& map) { return ln_growth(map, start, stay.steps, control); };
    const bool was_chaotic = with_scene_map(scene, grown, contact_horizon, accuracy) > std::log(came_apart);
    return was_chaotic ? stay : analysis::ChaoticStay{};
}

/// The rate of escape from the stays of all runs; none if it was stopped before.
///   within  what each run heeds
template <class StayOf>
std::optional<analysis::EscapeRate> rate_over(const std::vector<RunVerdict>& runs, std::int64_t settling,
                                              const RunControl& control, const RunControl& within,
                                              const StayOf& stay_in_chaos) {
    std::vector<analysis::ChaoticStay> stays(runs.size());
    const bool whole = run_pieces(runs.size(), "escapes from chaos", control,
                                  [runs, within, stay_in_chaos, &stays](std::size_t r) -> KeepResult {
                                      if (within.is_stopped()) return {};
                                      const analysis::ChaoticStay stay = stay_in_chaos(runs[r]);
                                      if (within.is_stopped()) return {};  // it was followed no further
                                      return [&stays, r, stay] { stays[r] = stay; };
                                  });
    if (!whole) return std::nullopt;
    return analysis::escape_rate(stays, settling);
}

}  // namespace

std::optional<analysis::EscapeRate> escape_of(const Scene<double>& scene, double speed,
                                              const std::vector<RunVerdict>& runs, Accuracy accuracy,
                                              const RunControl& control) {
    const auto has_left = [](const RunVerdict& run) { return is_on_cycle(run) || is_on_wall(run); };
    if (std::none_of(runs.begin(), runs.end(), is_chaotic) || std::none_of(runs.begin(), runs.end(), has_left))
        return std::nullopt;
    return rate_over(runs, chaos_begins, control, control, [scene, accuracy, speed, control](const RunVerdict& run) {
        return stay_of(scene, accuracy, speed, run, control);
    });
}

std::optional<analysis::EscapeRate> escape_of_any(const Scene<double>& scene, double speed,
                                                  const std::vector<RunVerdict>& runs, std::int64_t settling,
                                                  Accuracy accuracy, const RunControl& control,
                                                  const analysis::Stop& over) {
    RunControl within = control;
    within.stop = [stop = control.stop, over] { return (stop && stop()) || (over && over()); };
    const auto rate =
        rate_over(runs, settling, control, within, [scene, accuracy, speed, settling, within](const RunVerdict& run) {
            return chaotic_stay_of(scene, accuracy, speed, run, settling, within);
        });
    return rate && rate->steps > 0 ? rate : std::nullopt;
}

analysis::ChaoticStay stay_as_judged(Kind kind, Outcome outcome, std::int64_t impacts) {
    if (kind == Kind::chaotic) return {impacts, false};
    if (is_on_cycle(kind) || outcome == Outcome::in_contact) return {impacts, true};
    return {};
}

void name_remaining(const analysis::EscapeRate& escape, std::vector<RunVerdict>& runs) {
    if (!escape.others_will_leave) return;
    for (RunVerdict& run : runs) {
        if (run.kind != Kind::chaotic) continue;
        run.kind = Kind::transient;
        run.mode = analysis::Mode::undecided;
    }
}

void name_remaining(const analysis::EscapeRate& escape, NamedMode& named) {
    if (!escape.others_will_leave || named.verdict.kind != Kind::chaotic) return;
    named.verdict.kind = Kind::transient;
    named.verdict.mode = analysis::Mode::undecided;
    named.verdict.evidence.push_back(
        {"rate of escape from chaos", escape.rate, escape.least_rate,
         fmt::format("{} of {} runs have left chaos: half of those that remain will within {:.3g} impacts", escape.left,
                     escape.left + escape.remaining, escape.half_life),
         "fewer than 3 runs leave, or none of them late: chaotic"});
}

}  // namespace swirl::studies
