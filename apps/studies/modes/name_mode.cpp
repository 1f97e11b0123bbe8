#include "apps/studies/modes/name_mode.hpp"

#include "analysis/argument_error.hpp"
#include "apps/studies/modes/chord_mode.hpp"
#include "apps/studies/modes/contact_mode.hpp"
#include "apps/studies/modes/naming.hpp"
#include "apps/studies/modes/rolling_bounces.hpp"
#include "apps/studies/scene_map/chatter_once.hpp"
#include "map/dragged/riding.hpp"
#include "map/dry/riding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

namespace swirl::studies {

namespace {

/// What follows the last impact, followed on and judged.
template <int D>
void judge_contact(const SceneMap<D>& map, const Scene<double>& scene, const PostImpactState<double>& last,
                   analysis::Classification& verdict) {
    // Friction may take longer than that to bring slip to an end: a tail that still changes is followed ten times on.
    for (const double time : {contact_horizon, 10 * contact_horizon}) {
        double reached = time;
        for (bool cut = true;
             cut;) {  // a body that swings very fast (most_contact_steps): once more, to where that was
            const double followed = reached;
            ContactTail tail(scene, map.contact(), followed);
            const auto return_step = map.return_step(last, followed, [&](const auto&... seen) { tail.add(seen...); });
            if (!ends_in_contact(return_step.outcome)) return;
            reached = return_step.contacts.back().end;
            cut = reached < followed;
            if (cut) continue;
            verdict.evidence.clear();
            if (tail.judge(verdict)) return;
        }
        if (reached < time) return;
    }
}

/// What is said per impact of a cycle, its impacts being those with these S.
void count_chatter_once(const std::vector<double>& spins, const analysis::ClassifyOptions& settings,
                        analysis::Classification& verdict) {
    const auto impacts = static_cast<std::int64_t>(spins.size());
    const double fewer = static_cast<double>(verdict.period) / static_cast<double>(impacts);
    verdict.evidence.push_back(
        {rebounds_evidence, static_cast<double>(verdict.period - impacts), 0,
         "the cycle leads through sustained contact; rebounds that end there count as one impact",
         "a cycle without contact: it is one of impacts alone"});
    for (auto& evidence : verdict.evidence)
        if (evidence.name == "period") evidence.value = static_cast<double>(impacts);
    verdict.period = impacts;
    verdict.largest_exponent *= fewer;
    verdict.largest_exponent_error *= fewer;
    double sum = 0, pairs = 0;
    for (const double a : spins) {
        sum += a;
        for (const double b : spins) pairs += std::abs(a - b) <= settings.recurrence_threshold ? 1 : 0;
    }
    const auto n = static_cast<double>(impacts);
    verdict.mean_per_step = sum / n;
    verdict.recurrence_rate = pairs / (n * n);
    // Without its diagonal RC is of a series: that of as many impacts as were judged.
    const double judged = std::floor(static_cast<double>(settings.collisions) / fewer);
    verdict.recurrence_rate_without_diagonal = (verdict.recurrence_rate * judged - 1) / (judged - 1);
}

/// The cycle's state after its first landing; none where it leads through no contact.
template <int D>
std::optional<PostImpactState<double>> after_landing(const SceneMap<D>& map, const analysis::Classification& verdict) {
    auto z = map.state_at(analysis::Vector<D>(verdict.point.data()));
    for (std::int64_t k = 0; k < verdict.period; ++k) {
        const auto step = map.advance(z);
        if (!step.alive) return {};
        z = step.state;
        if (letter_from(step.letter).through_contact) return z;
    }
    return {};
}

/// A cycle that leads through sustained contact is a landing; its rebounds before that count as one impact
/// (chatter_once.hpp) in the period, and so in all that is said per impact.
template <int D>
void look_for_landings(const SceneMap<D>& map, const analysis::ClassifyOptions& settings,
                       analysis::Classification& verdict) {
    using analysis::Kind;
    if (verdict.kind != Kind::cycle && verdict.kind != Kind::fixed_point) return;
    const auto first = after_landing(map, verdict);
    if (!first) return;
    std::vector<double> spins;
    auto z = *first;
    for (std::int64_t done = 0; done < verdict.period;) {
        spins.push_back(map.coordinates(z)[map.integrated]);
        const auto steps = steps_as_one(map, z);
        done += static_cast<std::int64_t>(steps.size());
        const auto step = sum_of(map, steps);
        if (!step.alive) return;
        z = step.state;
    }
    verdict.kind = Kind::landing;
    verdict.mode = analysis::Mode::quasi_steady;
    const analysis::Vector<D> point = map.coordinates(*first);
    verdict.point.assign(point.begin(), point.end());
    count_chatter_once(spins, settings, verdict);
}

/// The largest less the smallest S of the flights; no number if there are none.
template <int D>
double range_of_spin(const analysis::Tail<SceneMap<D>>& tail) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (std::size_t i = 0; i < tail.durations.size(); ++i) {
        if (!(tail.durations[i] > 0)) continue;
        const double spin = tail.integrals[i] / tail.durations[i];
        least = std::min(least, spin);
        most = std::max(most, spin);
    }
    return most >= least ? most - least : std::numeric_limits<double>::quiet_NaN();
}

/// Without friction nothing turns a disk: where its impacts fade it slides along the wall in the end, with the S that
/// it has. @return false where S is seen to vary
bool name_fading_disk(double range, analysis::Classification& verdict) {
    if (!(range <= rest_of_spin)) return false;
    verdict.mode = analysis::Mode::steady;
    verdict.kind = analysis::Kind::sliding;
    verdict.evidence = {
        {"range of S", range, rest_of_spin,
         "without friction nothing changes S of a disk, and with e < 1 every impact lowers J, so that no "
         "attractor has impacts: in the end the disk slides along the wall",
         "e = 1, or friction: period, exponent and rotation number decide"}};
    return true;
}

/// Impacts that only lose must fade, whatever they look like so far.
void name_fading_orbit(analysis::Classification& verdict) {
    verdict.mode = analysis::Mode::undecided;
    verdict.kind = analysis::Kind::transient;
    verdict.evidence = {
        {"loss by every impact", 1, 1,
         "with e < 1 every impact lowers J (without friction) or the energy (without swirl), so that no "
         "attractor has impacts: the orbit is on its way to contact",
         "more impacts (--transient): the motion on the wall in which they end gives the mode"}};
}

/// An orbit that ended with neither impacts nor contact to go on with.
void name_ending(Outcome outcome, long long impacts, analysis::Classification& verdict) {
    verdict.evidence.push_back({"impacts until the end", static_cast<double>(impacts), static_cast<double>(impacts),
                                fmt::format("the orbit ended ({}) before its impacts showed a mode", name_of(outcome)),
                                outcome == Outcome::no_contact
                                    ? "a start from which the body reaches the wall: its impacts give the mode"
                                    : "a start whose orbit goes on: its impacts give the mode"});
}

/// A flight without contact over a floor that drags or has dry friction. False where nothing brings it to the floor's
/// velocity.
///   released  the wall has released the body there
bool name_riding(const Scene<double>& scene, const Flight<double>& flight, Outcome outcome,
                 analysis::Classification& verdict, bool released = false) {
    if (outcome != Outcome::riding && outcome != Outcome::no_contact) return false;
    const std::optional<Riding> riding =
        scene.has_dry_floor() ? riding_over_dry_floor(scene, flight, released) : riding_of(scene, flight);
    if (!riding) return false;
    verdict.mode = analysis::Mode::steady;
    verdict.kind = analysis::Kind::riding;
    verdict.mean = riding->spin;
    verdict.evidence = {
        {"room at the wall", riding->room, 0,
         "once the floor has taken what is left of its velocity the body goes along with the floor, and "
         "on the way there and after it nothing of it reaches the wall (proven; over dry friction with beta > M G "
         "in linear order of what is left)",
         "at most 0: it meets the wall again, and its impacts give the mode"}};
    return true;
}

/// The last flight of an orbit that has no next impact from `last` on.
struct Release {
    Flight<double> flight;
    bool is_from_contact = false;
};

template <int D>
Release last_release(const SceneMap<D>& map, const Scene<double>& scene, const PostImpactState<double>& last) {
    if (scene.has_dry_floor())
        if (const auto step = map.return_step(last); !step.contacts.empty()) {
            const PostImpactState<double> leaving = post_impact_state(map.contact(), step.contacts.back().to);
            return {flight_from(map.body(), leaving), true};
        }
    return {flight_from(map.body(), last), false};
}

/// An orbit that has no next impact from `last` on.
template <int D>
void name_end(const SceneMap<D>& map, const Scene<double>& scene, const PostImpactState<double>& last,
              NamedMode& named) {
    if (ends_in_contact(named.outcome)) return judge_contact(map, scene, last, named.verdict);
    const Release release = last_release(map, scene, last);
    if (!name_riding(scene, release.flight, named.outcome, named.verdict, release.is_from_contact))
        name_ending(named.outcome, named.impacts, named.verdict);
}

template <int D>
void keep_samples(const SceneMap<D>& map, const analysis::Tail<SceneMap<D>>& tail, OrbitSamples& samples) {
    samples.last = section_point(tail.ended ? tail.end : tail.last);
    if (tail.ended) return;
    for (const auto& point : tail.points) samples.points.emplace_back(point);
    for (const auto& state : tail.states) samples.points.emplace_back(map.coordinates(state));
}

template <int D>
NamedMode name_in(const SceneMap<D>& map, const SceneStart& from, const NamingOptions& options, OrbitSamples* samples) {
    const auto& [scene, start] = from;
    const analysis::ClassifyOptions settings = settings_for(scene, options.settings);
    const OrbitBegin begin = begin_orbit(map, start);
    if (begin.outcome != Outcome::completed) return named_without_orbit(map.body(), from, begin);
    if (options.look > 0) {
        if (is_for_limits_alone(scene, settings)) return {};
        const StepsToLook steps = steps_to(options.look);
        analysis::ClassifyOptions to_look = settings;
        to_look.collisions = steps.tail;
        auto orbit = followed(map, begin.state, steps.before, to_look, false, options.stop);
        return named_at_look(map, scene, begin, orbit, settings, samples);
    }
    auto orbit = followed(map, begin.state, steps_before(begin, settings), settings,
                          is_dissipative_without_drive(scene), options.stop);
    return name_from(map, scene, begin, orbit, settings, samples);
}

}  // namespace

analysis::ClassifyOptions settings_for(const Scene<double>& scene, analysis::ClassifyOptions settings) {
    settings.conserves = scene.mu == 0 && scene.restitution == 1 && !scene.acts_in_flight();
    return settings;
}

StepsToLook steps_to(std::int64_t wanted) {
    namespace detail = analysis::classification_detail;
    std::int64_t before = detail::first_look, look = detail::next_look(before);
    while (look < wanted) before = std::exchange(look, detail::next_look(look));
    if (look != wanted) analysis::refuse("look", static_cast<double>(wanted), "192, 288, 432, 648 …");
    return {before, look - before};
}

NamedMode named_without_orbit(const Body<double>& body, const SceneStart& from, const OrbitBegin& begin) {
    NamedMode named;
    named.outcome = begin.outcome;
    named.impacts = begin.impacts;
    named.verdict.ended = true;
    const auto* start = std::get_if<LabStart<double>>(&from.start);
    const bool flies = start != nullptr && begin.impacts == 0;
    if (!flies || !name_riding(from.scene, flight_from(body, *start), named.outcome, named.verdict))
        name_ending(named.outcome, named.impacts, named.verdict);
    else
        named.mean_errors = errors_of_means(named.verdict, {}, {}, {});
    return named;
}

template <int D>
NamedMode name_from(const SceneMap<D>& map, const Scene<double>& scene, const OrbitBegin& begin,
                    FollowedScene<D>& orbit, const analysis::ClassifyOptions& settings, OrbitSamples* samples) {
    const bool dissipative = is_dissipative_without_drive(scene);
    NamedMode named;
    named.impacts = begin.impacts;
    const auto& tail = orbit.tail;
    named.finished = !tail.stopped;
    if (tail.stopped) return named;
    if (samples) keep_samples(map, tail, *samples);
    named.verdict = judge(map, orbit, settings, dissipative);
    named.impacts += named.verdict.steps;
    if (tail.ended) {
        named.outcome = ending_at(map, tail.end, named.impacts);
        name_end(map, scene, tail.end, named);
    } else if (dissipative) {
        const bool keeps_spin = scene.is_disk() && scene.mu == 0;
        if (!keeps_spin || !name_fading_disk(range_of_spin<D>(tail), named.verdict)) name_fading_orbit(named.verdict);
    }
    look_for_landings(map, settings, named.verdict);
    if (named.outcome == Outcome::diverged) name_divergence(named);
    if constexpr (D == polygon_dimension) look_for_growth(map, scene, tail, named);
    if constexpr (D == disk_dimension) look_for_rolling(map, scene, tail, named);
    named.mean_errors = errors_of_means(map, tail, named.verdict);
    return named;
}

template NamedMode name_from(const SceneMap<disk_dimension>&, const Scene<double>&, const OrbitBegin&,
                             FollowedScene<disk_dimension>&, const analysis::ClassifyOptions&, OrbitSamples*);
template NamedMode name_from(const SceneMap<polygon_dimension>&, const Scene<double>&, const OrbitBegin&,
                             FollowedScene<polygon_dimension>&, const analysis::ClassifyOptions&, OrbitSamples*);

template <int D>
NamedMode named_at_look(const SceneMap<D>& map, const Scene<double>& scene, const OrbitBegin& begin,
                        FollowedScene<D>& orbit, const analysis::ClassifyOptions& settings, OrbitSamples* samples) {
    analysis::ClassifyOptions asked = settings;
    asked.chaos_alone = true;
    NamedMode named = name_from(map, scene, begin, orbit, asked, samples);
    if (!named.finished || orbit.cycle.period > 0 || orbit.tail.ended) return named;
    if (named.verdict.kind != analysis::Kind::chaotic || orbit.tail.cut) {
        named.verdict = {};
        return named;
    }
    named.verdict.evidence.push_back({"steps until chaos was called", static_cast<double>(named.verdict.steps),
                                      static_cast<double>(settings.transient + settings.collisions),
                                      "chaotic so far: called before the limits, at the risk allowed",
                                      "no risk: all steps up to the limits are judged"});
    return named;
}

template NamedMode named_at_look(const SceneMap<disk_dimension>&, const Scene<double>&, const OrbitBegin&,
                                 FollowedScene<disk_dimension>&, const analysis::ClassifyOptions&, OrbitSamples*);
template NamedMode named_at_look(const SceneMap<polygon_dimension>&, const Scene<double>&, const OrbitBegin&,
                                 FollowedScene<polygon_dimension>&, const analysis::ClassifyOptions&, OrbitSamples*);

NamedMode name_alone(const SceneStart& start, const NamingOptions& options, OrbitSamples* samples) {
    const auto name = [&](const auto& map) { return name_in(map, start, options, samples); };
    NamedMode named = with_scene_map(start.scene, name, contact_horizon, options.accuracy);
    named.accuracy = options.accuracy;
    return named;
}

NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& options,
                    Accuracy accuracy, const analysis::Stop& stop, OrbitSamples* samples) {
    return name_alone({scene, start}, {options, accuracy, stop}, samples);
}

}  // namespace swirl::studies
