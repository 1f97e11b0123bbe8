#include "apps/studies/tradeoff/arithmetic_orbit.hpp"

#include "analysis/classification/classify.hpp"
#include "analysis/means/mean_error.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/tradeoff/arithmetic_in.hpp"
#include "map/numbers/quad.hpp"

#include <cstdint>
#include <numeric>

namespace swirl::studies::tradeoff {

namespace {

/// An arithmetic as analysis/ wants a map. It ends where the budget does, too.
template <int D>
class ArithmeticSectionMap {
public:
    static constexpr int dimension = D;
    static constexpr int integrated = D - 1;
    using State = PostImpactState<Quad>;

    ArithmeticSectionMap(const ArithmeticMap& map, const SceneMap<D>& exact, const Budget& budget)
        : map_(map), exact_(exact), budget_(budget) {}

    analysis::Advance<D, State> advance(const State& z) const {
        analysis::Advance<D, State> step;
        fill(step, map_.advance(z));
        return step;
    }
    analysis::Linearised<D, State> linearise(const State& z) const {
        analysis::Linearised<D, State> step;
        const ArithmeticStep found = map_.advance(z);
        fill(step, found);
        if (!step.alive) return step;
        const auto rounded = state_in<double>(z);
        step.derivative = found.rounded.contacts.empty()
                              ? exact_.through_flight(rounded, found.rounded)
                              : exact_.through_contact(section_point(rounded), found.rounded);
        return step;
    }

    static analysis::Vector<D> coordinates(const State& z) { return SceneMap<D>::coordinates(state_in<double>(z)); }
    static State state_at(const analysis::Vector<D>& point) {
        State z = state_in<Quad>(SceneMap<D>::state_at(point));
        z.psi = renormalised(z.psi);
        z.chi = renormalised(z.chi);
        return z;
    }
    static double angle_period(int coordinate) { return SceneMap<D>::angle_period(coordinate); }

private:
    template <class Step>
    void fill(Step& step, const ArithmeticStep& found) const {
        step.alive = found.outcome == Outcome::completed && !budget_.is_spent(orbits_share);
        step.state = found.after;
        step.duration = found.rounded.collision.flight_time;
        step.integral = found.rounded.turned;
        step.letter = number_of(letter_of(found.rounded));
    }

    const ArithmeticMap& map_;
    const SceneMap<D>& exact_;
    const Budget& budget_;
};

/// Follows the orbit, and keeps of it what a verdict asks for.
template <int D>
analysis::Tail<ArithmeticSectionMap<D>> follow(const ArithmeticMap& map, PostImpactState<Quad> z, std::int64_t count,
                                               const Budget& budget, ArithmeticOrbit& orbit) {
    analysis::Tail<ArithmeticSectionMap<D>> tail;
    tail.first = z;
    double drift = 0;
    while (tail.steps < count && !budget.is_spent(orbits_share)) {
        const ArithmeticStep step = map.advance(z);
        orbit.outcome = step.outcome;
        if (step.outcome != Outcome::completed) {
            tail.ended = true;
            tail.end = z;
            break;
        }
        ++tail.steps;
        tail.points.push_back(ArithmeticSectionMap<D>::coordinates(z));
        tail.durations.push_back(step.rounded.collision.flight_time);
        orbit.duration += tail.durations.back();
        tail.integrals.push_back(step.rounded.turned);
        tail.last = z;
        drift += step.jacobi_drift;
        z = step.after;
    }
    orbit.impacts = tail.steps;
    if (tail.steps > 0) orbit.jacobi_drift = std::abs(drift) / static_cast<double>(tail.steps);
    return tail;
}

analysis::ClassifyOptions settings_for(const Scene<double>& scene) {
    analysis::ClassifyOptions settings;
    settings.conserves = scene.mu == 0 && scene.restitution == 1;
    settings.period.max_period = 256;
    settings.period.exact_multipliers = false;
    return settings;
}

template <int D>
std::optional<ArithmeticOrbit> orbit_in(const SceneMap<D>& exact, const Arithmetic& arithmetic,
                                        const Scene<double>& scene, const PostImpactState<double>& begin,
                                        std::int64_t count, const Budget& budget) {
    ArithmeticOrbit orbit;
    const ArithmeticMap arithmetic_map = arithmetic.make(scene, {});
    const ArithmeticSectionMap<D> map(arithmetic_map, exact, budget);
    const auto tail = follow<D>(arithmetic_map, arithmetic.begin(scene, begin), count, budget, orbit);
    if (tail.steps > 0) {
        const double turned = std::accumulate(tail.integrals.begin(), tail.integrals.end(), 0.0);
        orbit.mean_spin = turned / std::accumulate(tail.durations.begin(), tail.durations.end(), 0.0);
        if (!tail.ended)  // of an orbit that goes on as it was
            orbit.mean_spin_error = analysis::error_of_ratio(tail.integrals, tail.durations).standard_error;
    }
    if (!tail.ended && is_dissipative_without_drive(scene)) {
        orbit.kind = analysis::Kind::transient;
    } else if (!tail.ended && tail.steps == count) {
        const auto verdict = analysis::classify_tail(map, tail, D - 1, settings_for(scene));
        orbit.mode = verdict.mode;
        orbit.kind = verdict.kind;
        orbit.period = verdict.period;
        orbit.largest_exponent = verdict.largest_exponent;
        orbit.largest_exponent_error = verdict.largest_exponent_error;
    }
    if (budget.is_spent(orbits_share)) return std::nullopt;  // a verdict on what was cut is none
    return orbit;
}

}  // namespace

std::optional<ArithmeticOrbit> orbit_by(const Arithmetic& arithmetic, const Scene<double>& scene,
                                        const PostImpactState<double>& begin, std::int64_t count,
                                        const Budget& budget) {
    return with_scene_map(scene,
                          [&](const auto& map) { return orbit_in(map, arithmetic, scene, begin, count, budget); });
}

}  // namespace swirl::studies::tradeoff
