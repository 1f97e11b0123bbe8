// SceneFunctions whose steps are computed by another map than double's own: in more digits, or with another search for
// the contact. The state before a step and its result are doubles: each step errs by their rounding, and by what the
// other map errs. So the scene's numbers are those of double, too. Contact is integrated in the other map's type; what
// is reported of it, for how long it is followed, and derivatives (those at that step) are double's.
#pragma once

#include "apps/studies/scene_map/in_digits.hpp"
#include "apps/studies/scene_map/scene_functions.hpp"
#include "map/baselines/baseline_map.hpp"
#include "map/derivative/parameter.hpp"

#include <stdexcept>
#include <type_traits>
#include <utility>

namespace swirl::studies {

namespace rounded_detail {

template <class Map>
Map make_map(const Scene<double>& scene, Accuracy accuracy) {
    if constexpr (std::is_same_v<typename Map::Number, double>)
        return Map(scene, baseline_of(accuracy).value());
    else
        return Map(scene_in<typename Map::Number>(scene));
}

}  // namespace rounded_detail

/// The functions by a map: CollisionMap over long double or Quad, or BaselineMap.
template <class Map>
struct RoundedScene {
    using T = typename Map::Number;
    using Functions = SceneFunctions<section_dimension<Map::shape>>;
    using State = typename Functions::State;
    using Step = typename Functions::Step;
    using Derivative = typename Functions::Derivative;

    RoundedScene(const Scene<double>& scene, Accuracy accuracy, const Body<double>* similar)
        : in_double(in_double_functions().make(scene, accuracy, similar)),
          map(rounded_detail::make_map<Map>(scene, accuracy)),
          return_map(map) {}
    RoundedScene(const RoundedScene&) = delete;
    RoundedScene& operator=(const RoundedScene&) = delete;

    std::shared_ptr<const void> in_double;  ///< what double_functions made
    Map map;
    ReturnMap<Map> return_map;  ///< refers to it

    static const RoundedScene& of(const void* scene) { return *static_cast<const RoundedScene*>(scene); }
    static const Functions& in_double_functions() { return double_functions<Map::shape, Map::rule>(); }

    static std::shared_ptr<const void> make(const Scene<double>& scene, Accuracy accuracy,
                                            const Body<double>* similar) {
        return std::make_shared<const RoundedScene>(scene, accuracy, similar);
    }
    static const Body<double>& body(const void* scene) { return in_double_functions().body(of(scene).in_double.get()); }
    static const ContactScene<double>& contact(const void* scene) {
        return in_double_functions().contact(of(scene).in_double.get());
    }
    static Step first_impact(const void* scene, const LabStart<double>& start) {
        const RoundedScene& here = of(scene);
        return rounded_from(here.return_map.advance(flight_in<T>(flight_from(body(scene), start))));
    }
    Outcome advance_rounded(Step& step, double horizon, const ContactSink& sink) const {
        ReturnStep<T> next;
        next.collision.after = begin_in<T>(map.body(), step.collision.after);
        const Outcome outcome = return_map.advance(next, horizon, sink);
        if (outcome == Outcome::completed)
            step = rounded_from(std::move(next));
        else
            step.contacts = std::move(next.contacts);
        return outcome;
    }
    static Outcome advance(const void* scene, Step& step, double horizon, const ContactSink& sink) {
        return of(scene).advance_rounded(step, horizon, sink);
    }
    static std::int64_t follow(const void* scene, State& z, std::int64_t steps, double horizon,
                               const analysis::Stop& stop, analysis::Effort& effort) {
        const RoundedScene& here = of(scene);
        return follow_steps(body(scene), z, steps, stop, effort,
                            [&](Step& step) { return here.advance_rounded(step, horizon, {}); });
    }
    static Derivative through_flight(const void* scene, const State& z, const Step& known) {
        return in_double_functions().through_flight(of(scene).in_double.get(), z, known);
    }
    static Derivative through_kept_flight(const void* scene, const State& z, const KeptFlight& kept) {
        return in_double_functions().through_kept_flight(of(scene).in_double.get(), z, kept);
    }
    static analysis::Vector<section_dimension<Map::shape>> along(const void* scene, const State& z, const Step& known,
                                                                 Parameter parameter) {
        return in_double_functions().along(of(scene).in_double.get(), z, known, parameter);
    }
    static Derivative through_contact(const void* scene, const SectionPoint<double>& z, const Step& known,
                                      long& series) {
        return in_double_functions().through_contact(of(scene).in_double.get(), z, known, series);
    }

    static constexpr Functions functions{&make,           &body,   &contact,        &first_impact,        &advance,
                                         &follow,         nullptr, &through_flight, &through_kept_flight, &along,
                                         &through_contact};
};

}  // namespace swirl::studies
