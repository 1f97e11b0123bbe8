#include "apps/modes/name_mode.hpp"

#include "apps/modes/contact_mode.hpp"
#include "apps/system/orbit_ending.hpp"
#include "apps/system/section_system.hpp"

#include <fmt/format.h>

namespace swirl::apps {

namespace {

/// What follows the last impact, followed on and judged.
template <class Map>
void judge_contact(const ReturnMap<Map>& map, const PostImpactState<double>& last, analysis::Classification& verdict) {
    // Friction may take longer than that to bring slip to an end: a tail that still changes is followed ten times on.
    for (const double time : {contact_horizon, 10 * contact_horizon}) {
        double reached = time;
        for (bool cut = true;
             cut;) {  // a body that swings very fast (most_contact_steps): once more, to where that was
            const double followed = reached;
            ContactTail tail(map.contact(), followed);
            const auto return_step = map.advance(last, followed, [&](const auto&... seen) { tail.add(seen...); });
            if (return_step.outcome != Outcome::in_contact) return;
            reached = return_step.contacts.back().end;
            cut = reached < followed;
            if (cut) continue;
            verdict.evidence.clear();
            if (tail.judge(verdict)) return;
        }
        if (reached < time) return;
    }
}

template <class System>
typename System::State state_of(const std::vector<double>& coordinates) {
    return Eigen::Map<const typename System::State>(coordinates.data());
}

/// Does a cycle lead through sustained contact? Then it is a landing.
template <class System>
void look_for_landings(const System& system, analysis::Classification& verdict) {
    using analysis::Kind;
    if (verdict.kind != Kind::cycle && verdict.kind != Kind::fixed_point) return;
    auto z = state_of<System>(verdict.point);
    for (std::int64_t k = 0; k < verdict.period; ++k) {
        const auto step = system.advance(z);
        if (step.letter < 0) {
            verdict.kind = Kind::landing;
            verdict.mode = analysis::Mode::quasi_steady;
            verdict.evidence.push_back({"impact that lands", static_cast<double>(k + 1),
                                        static_cast<double>(verdict.period),
                                        "the cycle leads through sustained contact", "none: a cycle of impacts alone"});
            return;
        }
        z = step.state;
    }
}

/// Impacts that only lose must fade, whatever they look like so far.
void name_dissipative_orbit(analysis::Classification& verdict) {
    verdict.mode = analysis::Mode::undecided;
    verdict.kind = analysis::Kind::transient;
    verdict.evidence = {
        {"loss by every impact", 1, 1,
         "with e < 1 every impact lowers J (without friction) or the energy (without swirl), so that no "
         "attractor has impacts: the orbit is on its way to contact",
         "0 (e = 1, or friction and swirl): period, exponent and rotation number would decide"}};
}

/// An orbit that ended with neither impacts nor contact to go on with.
void name_ending(Outcome outcome, long long impacts, analysis::Classification& verdict) {
    verdict.evidence.push_back({"impacts until the end", static_cast<double>(impacts), static_cast<double>(impacts),
                                fmt::format("the orbit has ended: {}", name_of(outcome)),
                                "more: named by the orbit of its impacts"});
}

}  // namespace

NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& options) {
    analysis::ClassifyOptions settings = options;
    settings.conserves = scene.mu == 0 && scene.restitution == 1;
    return with_collision_map(scene, [&](const auto& map) {
        NamedMode named;
        SectionPoint<double> first{};
        named.outcome = ending_of(map, start, 1, first, named.impacts);
        const SectionSystem system(map);
        if (named.outcome != Outcome::completed) {
            named.verdict.ended = true;
            if (named.outcome == Outcome::in_contact)
                judge_contact(system.return_map(), post_impact_state(std::get<SectionPoint<double>>(start)),
                              named.verdict);
            else
                name_ending(named.outcome, named.impacts, named.verdict);
            return named;
        }
        if (std::holds_alternative<SectionPoint<double>>(start)) named.impacts = 0;  // followed again from the point
        // Where the verdict is known beforehand, derivatives and periods would cost much and tell nothing.
        named.verdict = is_dissipative_without_drive(scene)
                            ? analysis::observe(system, system.state_of(first), system.integrated, settings)
                            : analysis::classify(system, system.state_of(first), system.integrated, settings);
        named.impacts += named.verdict.steps;
        if (named.verdict.ended) {
            const auto last = state_of<decltype(system)>(named.verdict.end);
            named.outcome = ending_at(system, last, named.impacts);
            if (named.outcome == Outcome::in_contact)
                judge_contact(system.return_map(), post_impact_state(system.point_of(last)), named.verdict);
            else
                name_ending(named.outcome, named.impacts, named.verdict);
        } else if (is_dissipative_without_drive(scene)) {
            name_dissipative_orbit(named.verdict);
        }
        look_for_landings(system, named.verdict);
        return named;
    });
}

}  // namespace swirl::apps
