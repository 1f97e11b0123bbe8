// What SceneMap asks of one shape and impact rule, as plain functions over a map that they alone know the type of.
#pragma once

#include "apps/system/effort.hpp"
#include "apps/system/exact_return.hpp"
#include "apps/system/scene_map.hpp"
#include "map/derivative/derivative.hpp"
#include "map/orbit/return_derivative.hpp"

namespace swirl::apps {

template <int D>
struct SceneFunctions {
    using State = PostImpactState<double>;
    using Step = ReturnStep<double>;
    using Derivative = analysis::Matrix<D>;

    std::shared_ptr<const void> (*make)(const Scene<double>&);
    const ContactScene& (*contact)(const void* map);
    Step (*first_impact)(const void* map, const LabStart<double>& start);
    Outcome (*advance)(const void* map, Step& step, double horizon, const ContactSink& sink);
    std::int64_t (*follow)(const void* map, State& z, std::int64_t steps, double horizon, const analysis::Stop& stop,
                           analysis::Effort& effort);
    Derivative (*through_flight)(const void* map, const State& z, const Step& known);
    std::pair<Derivative, analysis::Vector<D>> (*along)(const void* map, const State& z, const Step& known,
                                                        Parameter parameter);
    Derivative (*through_contact)(const void* map, const SectionPoint<double>& z, const Step& known, long& series);
};

/// The functions of the map that `with_collision_map` chooses; defined in scene_functions_of_disks.cpp and
/// scene_functions_of_polygons.cpp.
template <ImpactRule rule>
const SceneFunctions<disk_dimension>& disk_functions();
template <ImpactRule rule>
const SceneFunctions<polygon_dimension>& polygon_functions();

/// The functions themselves, for those two files.
template <Shape shape, ImpactRule rule>
struct ConcreteScene {
    static constexpr int dimension = section_dimension<shape>;
    using Map = CollisionMap<double, shape, rule>;
    using Functions = SceneFunctions<dimension>;
    using State = typename Functions::State;
    using Step = typename Functions::Step;
    using Derivative = typename Functions::Derivative;

    explicit ConcreteScene(const Scene<double>& scene)
        : differentiated(CollisionMap<double, shape, rule>(scene)), return_map(differentiated.map()) {}
    ConcreteScene(const ConcreteScene&) = delete;
    ConcreteScene& operator=(const ConcreteScene&) = delete;

    DifferentiatedMap<double, shape, rule> differentiated;
    ReturnMap<Map> return_map;  ///< refers to the map within the other

    static const ConcreteScene& of(const void* map) { return *static_cast<const ConcreteScene*>(map); }

    static std::shared_ptr<const void> make(const Scene<double>& scene) {
        return std::make_shared<const ConcreteScene>(scene);
    }
    static const ContactScene& contact(const void* map) { return of(map).return_map.contact(); }
    static Step first_impact(const void* map, const LabStart<double>& start) {
        const auto& return_map = of(map).return_map;
        return return_map.advance(flight_from(return_map.map().body(), start));
    }
    static Outcome advance(const void* map, Step& step, double horizon, const ContactSink& sink) {
        return of(map).return_map.advance(step, horizon, sink);
    }
    static std::int64_t follow(const void* map, State& z, std::int64_t steps, double horizon,
                               const analysis::Stop& stop, analysis::Effort& effort) {
        constexpr std::int64_t between = 1024;  // steps from one look at `stop` to the next
        const auto& return_map = of(map).return_map;
        const auto& body = return_map.map().body();
        Step step;
        step.collision.after = z;
        ExactReturn exact;
        bool repeats = false;
        std::int64_t done = 0, look = 0;
        while (done < steps && !effort.is_spent()) {
            if (stop && done >= look) {
                if (stop()) break;
                look = done + between;
            }
            const Outcome outcome = return_map.advance(step, horizon);
            effort.spent += effort_of(step);
            if (outcome != Outcome::completed) break;
            const State& after = step.collision.after;
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
    static Derivative through_flight(const void* map, const State& z, const Step& known) {
        return of(map).differentiated.derivative_of(z, known.collision);
    }
    static std::pair<Derivative, analysis::Vector<dimension>> along(const void* map, const State& z, const Step& known,
                                                                    Parameter parameter) {
        return derivative_with_parameter<double, shape, rule>(of(map).return_map.map().scene(), parameter, z,
                                                              known.collision);
    }
    static Derivative through_contact(const void* map, const SectionPoint<double>& z, const Step& known, long& series) {
        return derivative_through_contact(of(map).return_map, z, known, &series);
    }

    static constexpr Functions functions{&make,   &contact,        &first_impact, &advance,
                                         &follow, &through_flight, &along,        &through_contact};
};

}  // namespace swirl::apps
