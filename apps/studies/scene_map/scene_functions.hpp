// What SceneMap asks of one shape and impact rule, as plain functions over a map that they alone know the type of.
#pragma once

#include "apps/studies/scene_map/effort.hpp"
#include "apps/studies/scene_map/exact_return.hpp"
#include "apps/studies/scene_map/lanes.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "map/derivative/saltation.hpp"
#include "map/orbit/return_derivative.hpp"

namespace swirl::studies {

template <int D>
struct SceneFunctions {
    using State = PostImpactState<double>;
    using Step = ReturnStep<double>;
    using Derivative = analysis::Matrix<D>;

    std::shared_ptr<const void> (*make)(const Scene<double>&, Accuracy, const Body<double>* similar);
    const Body<double>& (*body)(const void* map);
    const ContactScene<double>& (*contact)(const void* map);
    Step (*first_impact)(const void* map, const LabStart<double>& start);
    Outcome (*advance)(const void* map, Step& step, double horizon, const ContactSink& sink);
    std::int64_t (*follow)(const void* map, State& z, std::int64_t steps, double horizon, const analysis::Stop& stop,
                           analysis::Effort& effort);
    void (*together)(std::span<LaneOrbit> orbits);  ///< in double only
    Derivative (*through_flight)(const void* map, const State& z, const Step& known);
    Derivative (*through_kept_flight)(const void* map, const State& z, const KeptFlight& kept);
    analysis::Vector<D> (*along)(const void* map, const State& z, const Step& known, Parameter parameter);
    Derivative (*through_contact)(const void* map, const SectionPoint<double>& z, const Step& known, long& series);
};

/// The functions of one map, in double; defined in scene_functions_in_double.hpp.
template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& double_functions();
/// The same with steps in another arithmetic, or with another search (rounded_scene.hpp); defined in
/// scene_functions_in_extended.cpp, scene_functions_in_quad.cpp and scene_functions_of_baselines.cpp.
template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& extended_functions();
template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& quad_functions();
template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& baseline_functions();

// For SWIRL_EVERY_MAP in those files.
#define SWIRL_COMPILE_DOUBLE_FUNCTIONS(T, SHAPE, RULE) \
    template const SceneFunctions<section_dimension<SHAPE>>& double_functions<SHAPE, RULE>();
#define SWIRL_COMPILE_EXTENDED_FUNCTIONS(T, SHAPE, RULE) \
    template const SceneFunctions<section_dimension<SHAPE>>& extended_functions<SHAPE, RULE>();
#define SWIRL_COMPILE_QUAD_FUNCTIONS(T, SHAPE, RULE) \
    template const SceneFunctions<section_dimension<SHAPE>>& quad_functions<SHAPE, RULE>();
#define SWIRL_COMPILE_BASELINE_FUNCTIONS(T, SHAPE, RULE) \
    template const SceneFunctions<section_dimension<SHAPE>>& baseline_functions<SHAPE, RULE>();

/// Follows a map; what repeats itself to the bit (ExactReturn) is not followed again.
///   advance  the step in place, ReturnMap's: ReturnStep → Outcome
template <class AdvanceStep>
std::int64_t follow_steps(const Body<double>& body, PostImpactState<double>& z, std::int64_t steps,
                          const analysis::Stop& stop, analysis::Effort& effort, const AdvanceStep& advance) {
    constexpr std::int64_t between = 1024;  // steps from one look at `stop` to the next
    ReturnStep<double> step;
    step.collision.after = z;
    ExactReturn exact;
    bool repeats = false;
    std::int64_t done = 0, look = 0;
    while (done < steps && !effort.is_spent()) {
        if (stop && done >= look) {
            if (stop()) break;
            look = done + between;
        }
        const Outcome outcome = advance(step);
        effort.spent += effort_of(step);
        if (outcome != Outcome::completed) break;
        const PostImpactState<double>& after = step.collision.after;
        if (has_come_to_rest(body, after) || has_diverged(body, after)) break;
        z = after;
        ++done;
        if (repeats) continue;
        const std::int64_t period = exact.after(z);
        if (period == 0) continue;
        repeats = true;
        done += (steps - done) / period * period;
    }
    return done;
}

/// The functions themselves, for the files of double.
template <Shape shape, ImpactRule rule>
struct ConcreteScene {
    static constexpr int dimension = section_dimension<shape>;
    using Map = CollisionMap<double, shape, rule>;
    using Functions = SceneFunctions<dimension>;
    using State = typename Functions::State;
    using Step = typename Functions::Step;
    using Derivative = typename Functions::Derivative;

    ConcreteScene(const Scene<double>& scene, const Body<double>* similar)
        : collision_map(scene, similar), return_map(collision_map) {}
    ConcreteScene(const ConcreteScene&) = delete;
    ConcreteScene& operator=(const ConcreteScene&) = delete;

    Map collision_map;
    ReturnMap<Map> return_map;  ///< refers to it

    static const ConcreteScene& of(const void* map) { return *static_cast<const ConcreteScene*>(map); }

    static std::shared_ptr<const void> make(const Scene<double>& scene, Accuracy, const Body<double>* similar) {
        return std::make_shared<const ConcreteScene>(scene, similar);
    }
    static const Body<double>& body(const void* map) { return of(map).collision_map.body(); }
    static const ContactScene<double>& contact(const void* map) { return of(map).return_map.contact(); }
    static Step first_impact(const void* map, const LabStart<double>& start) {
        const auto& return_map = of(map).return_map;
        return return_map.advance(flight_from(return_map.map().body(), start));
    }
    static Outcome advance(const void* map, Step& step, double horizon, const ContactSink& sink) {
        return of(map).return_map.advance(step, horizon, sink);
    }
    static std::int64_t follow(const void* map, State& z, std::int64_t steps, double horizon,
                               const analysis::Stop& stop, analysis::Effort& effort) {
        const auto& return_map = of(map).return_map;
        return follow_steps(return_map.map().body(), z, steps, stop, effort,
                            [&return_map, horizon](Step& step) { return return_map.advance(step, horizon); });
    }
    static Derivative through_flight(const void* map, const State& z, const Step& known) {
        return derivative_by_saltation(of(map).collision_map, z, known.collision);
    }
    static Derivative through_kept_flight(const void* map, const State& z, const KeptFlight& kept) {
        return derivative_by_saltation(of(map).collision_map, z, kept);
    }
    static analysis::Vector<dimension> along(const void* map, const State& z, const Step& known, Parameter parameter) {
        if (known.contacts.empty()) return derivative_along(of(map).collision_map, parameter, z, known.collision);
        return derivative_along_contact(of(map).return_map, parameter, section_point(z), known);
    }
    static Derivative through_contact(const void* map, const SectionPoint<double>& z, const Step& known, long& series) {
        return derivative_through_contact(of(map).return_map, z, known, &series);
    }

    static constexpr Functions functions{&make,
                                         &body,
                                         &contact,
                                         &first_impact,
                                         &advance,
                                         &follow,
                                         &follow_together<shape, rule>,
                                         &through_flight,
                                         &through_kept_flight,
                                         &along,
                                         &through_contact};
};

}  // namespace swirl::studies
