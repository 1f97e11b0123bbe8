#include "apps/classify/classify_command.hpp"
#include "apps/classify/contact_mode.hpp"
#include "apps/orbit_ending.hpp"
#include "apps/section_system.hpp"

namespace swirl::apps {

namespace {

/// The last launch of an orbit that ends in contact, followed on and judged.
template <class Map>
void judge_contact(const Map& map, const Start<double>& start, NamedMode& named) {
    const ReturnMap<Map> return_map(map);
    const Launch<double> last = std::visit(
        [&](const auto& s) {
            Orbit orbit(map, s);
            for (long long i = 0; i < named.impacts; ++i) orbit.advance();
            return orbit.launch();
        },
        start);
    // Friction may take longer than that to bring slip to an end: a tail that is irregular is followed ten times on.
    for (const double time : {contact_horizon, 10 * contact_horizon}) {
        ContactTail tail(return_map.contact(), time);
        const auto passage = return_map.advance(last, time, [&](const auto&... seen) { tail.add(seen...); });
        if (passage.outcome != Outcome::in_contact) return;
        analysis::Classification verdict;
        tail.judge(verdict);
        named.verdict.mode = verdict.mode;
        named.verdict.kind = verdict.kind;
        named.verdict.mean = verdict.mean;
        named.verdict.evidence = verdict.evidence;
        if (verdict.mode != analysis::Mode::undecided) return;
    }
}

/// Does a cycle lead through sustained contact? Then it is a landing.
template <class System>
void look_for_landings(const System& system, analysis::Classification& verdict) {
    using analysis::Kind;
    if (verdict.kind != Kind::cycle && verdict.kind != Kind::fixed_point) return;
    typename System::State z;
    for (int i = 0; i < System::dimension; ++i) z[i] = verdict.point[static_cast<std::size_t>(i)];
    for (std::int64_t k = 0; k < verdict.period; ++k) {
        const auto step = system.advance(z);
        if (step.letter < 0) {
            verdict.kind = Kind::landing;
            verdict.mode = analysis::Mode::quasi_steady;
            verdict.evidence.push_back({"impact that lands", static_cast<double>(k + 1), static_cast<double>(verdict.period),
                                        "the cycle leads through sustained contact"});
            return;
        }
        z = step.state;
    }
}

}  // namespace

NamedMode name_mode(const Scene<double>& scene, const Start<double>& start, const analysis::ClassifyOptions& settings) {
    return with_collision_map(scene, [&](const auto& map) {
        NamedMode named;
        SectionPoint<double> first{};
        named.outcome = ending_of(map, start, 1, first, named.impacts);
        if (named.impacts == 0) {
            named.verdict.ended = true;
            if (named.outcome == Outcome::in_contact) judge_contact(map, start, named);
            return named;
        }
        const SectionSystem system(map);
        named.verdict = analysis::classify(system, system.state_of(first), system.dimension - 1, settings);
        named.impacts += named.verdict.steps;
        if (named.verdict.ended) named.outcome = ending_of(map, start, named.impacts + 1, first, named.impacts);
        if (named.outcome == Outcome::in_contact) judge_contact(map, start, named);
        look_for_landings(system, named.verdict);
        return named;
    });
}

}  // namespace swirl::apps
