#include "apps/classify/classify_command.hpp"
#include "apps/classify/contact_mode.hpp"
#include "apps/orbit_ending.hpp"
#include "apps/section_system.hpp"

namespace swirl::apps {

namespace {

/// What follows the last impact, followed on and judged.
template <class Map>
void judge_contact(const ReturnMap<Map>& map, const Launch<double>& last, analysis::Classification& verdict) {
    // Friction may take longer than that to bring slip to an end: a tail that still changes is followed ten times on.
    for (const double time : {contact_horizon, 10 * contact_horizon}) {
        ContactTail tail(map.contact(), time);
        const auto passage = map.advance(last, time, [&](const auto&... seen) { tail.add(seen...); });
        if (passage.outcome != Outcome::in_contact) return;
        verdict.evidence.clear();
        if (tail.judge(verdict)) return;
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

/// Impacts that only lose J must fade, whatever they look like so far.
void name_what_fades(analysis::Classification& verdict) {
    verdict.mode = analysis::Mode::undecided;
    verdict.kind = analysis::Kind::transient;
    verdict.evidence.push_back({"loss of J by every impact", 1, 1,
                                "with e < 1, without friction or swirl, no attractor has impacts: the orbit is on its way "
                                "to contact",
                                "0 (e = 1, or friction and swirl): the evidence above would decide"});
}

}  // namespace

NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& settings) {
    return with_collision_map(scene, [&](const auto& map) {
        NamedMode named;
        SectionPoint<double> first{};
        named.outcome = ending_of(map, start, 1, first, named.impacts);
        const SectionSystem system(map);
        if (named.outcome != Outcome::completed) {
            named.verdict.ended = true;
            if (named.outcome == Outcome::in_contact)
                judge_contact(system.return_map(), launch_from(std::get<SectionPoint<double>>(start)), named.verdict);
            return named;
        }
        if (std::holds_alternative<SectionPoint<double>>(start)) named.impacts = 0;  // followed again from the point
        named.verdict = analysis::classify(system, system.state_of(first), system.dimension - 1, settings);
        named.impacts += named.verdict.steps;
        if (named.verdict.ended) {
            const auto last = state_of<decltype(system)>(named.verdict.end);
            named.outcome = ending_at(system, last, named.impacts);
            if (named.outcome == Outcome::in_contact)
                judge_contact(system.return_map(), launch_from(system.point_of(last)), named.verdict);
        }
        look_for_landings(system, named.verdict);
        if (!named.verdict.ended && only_loses(scene)) name_what_fades(named.verdict);
        return named;
    });
}

}  // namespace swirl::apps
