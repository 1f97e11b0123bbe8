// SceneFunctions whose steps are computed by another map than double's own: in more digits, or with another search for
// the contact. The state before a step and its result are doubles: each step errs by their rounding, and by what the
// other map errs. So the scene's numbers are those of double, too. Derivatives are those of double at that step, and
// so is contact (ReturnMap).
#pragma once

#include "apps/system/scene_functions.hpp"
#include "map/baselines/baseline_map.hpp"

#include <stdexcept>
#include <type_traits>
#include <utility>

namespace swirl::apps {

namespace rounded_detail {

template <class To, class From>
Vec2<To> as(const Vec2<From>& v) {
    return {static_cast<To>(v.x), static_cast<To>(v.y)};
}

/// The directions are brought to unit length in T, so that the body touches to T's rounding.
template <class T>
PostImpactState<T> in_more_digits(const PostImpactState<double>& z) {
    if constexpr (std::is_same_v<T, double>)
        return z;
    else
        return {renormalised(as<T>(z.psi)), renormalised(as<T>(z.chi)), T(z.vn), T(z.vt), T(z.spin)};
}

template <class T>
Flight<T> in_more_digits(const Flight<double>& f) {
    return {as<T>(f.centre), as<T>(f.velocity), as<T>(f.phase), as<T>(f.arm), T(f.spin), T(f.beta), f.struck};
}

template <class T>
Scene<T> in_more_digits(const Scene<double>& s) {
    return {s.sides, T(s.alpha), T(s.beta), T(s.mu), T(s.restitution), s.law, T(s.inertia_factor)};
}

template <class T>
Collision<double> rounded(const Collision<T>& c) {
    const auto number = [](const T& x) { return static_cast<double>(x); };
    Collision<double> result;
    result.outcome = c.outcome;
    result.after = {as<double>(c.after.psi), as<double>(c.after.chi), number(c.after.vn), number(c.after.vt),
                    number(c.after.spin)};
    result.flight_time = number(c.flight_time);
    result.normal = as<double>(c.normal);
    result.vertex_step = c.vertex_step;
    result.impulse = {number(c.impulse.normal), number(c.impulse.tangential), c.impulse.mode};
    result.jacobi_restitution = number(c.jacobi_restitution);
    result.jacobi_friction = number(c.jacobi_friction);
    result.simultaneous = c.simultaneous;
    result.steps = c.steps;
    return result;
}

template <class T>
ReturnStep<double> rounded(ReturnStep<T>&& step) {
    return {step.outcome, rounded(step.collision), static_cast<double>(step.turned),
            static_cast<double>(step.contact_work), std::move(step.contacts)};
}

template <class Map>
Map make_map(const Scene<double>& scene, Accuracy accuracy) {
    if constexpr (std::is_same_v<typename Map::Number, double>)
        return Map(scene, baseline_of(accuracy).value());
    else
        return Map(in_more_digits<typename Map::Number>(scene));
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
    using WithParameter = std::pair<Derivative, analysis::Vector<section_dimension<Map::shape>>>;

    RoundedScene(const Scene<double>& scene, Accuracy accuracy)
        : in_double(in_double_functions().make(scene, accuracy)),
          body(make_body(scene)),
          map(rounded_detail::make_map<Map>(scene, accuracy)),
          return_map(map) {}
    RoundedScene(const RoundedScene&) = delete;
    RoundedScene& operator=(const RoundedScene&) = delete;

    std::shared_ptr<const void> in_double;  ///< what double_functions made
    Body<double> body;
    Map map;
    ReturnMap<Map> return_map;  ///< refers to it

    static const RoundedScene& of(const void* scene) { return *static_cast<const RoundedScene*>(scene); }
    static const Functions& in_double_functions() { return double_functions<Map::shape, Map::rule>(); }

    static std::shared_ptr<const void> make(const Scene<double>& scene, Accuracy accuracy) {
        return std::make_shared<const RoundedScene>(scene, accuracy);
    }
    static const ContactScene& contact(const void* scene) {
        return in_double_functions().contact(of(scene).in_double.get());
    }
    static Step first_impact(const void* scene, const LabStart<double>& start) {
        const RoundedScene& here = of(scene);
        return rounded_detail::rounded(
            here.return_map.advance(rounded_detail::in_more_digits<T>(flight_from(here.body, start))));
    }
    Outcome advance_rounded(Step& step, double horizon, const ContactSink& sink) const {
        ReturnStep<T> next;
        next.collision.after = rounded_detail::in_more_digits<T>(step.collision.after);
        const Outcome outcome = return_map.advance(next, horizon, sink);
        if (outcome == Outcome::completed)
            step = rounded_detail::rounded(std::move(next));
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
        return follow_steps(here.body, z, steps, stop, effort,
                            [&](Step& step) { return here.advance_rounded(step, horizon, {}); });
    }
    static Derivative through_flight(const void* scene, const State& z, const Step& known) {
        return in_double_functions().through_flight(of(scene).in_double.get(), z, known);
    }
    static WithParameter along(const void* scene, const State& z, const Step& known, Parameter parameter) {
        return in_double_functions().along(of(scene).in_double.get(), z, known, parameter);
    }
    static Derivative through_contact(const void* scene, const SectionPoint<double>& z, const Step& known,
                                      long& series) {
        return in_double_functions().through_contact(of(scene).in_double.get(), z, known, series);
    }

    static constexpr Functions functions{&make,   &contact,        &first_impact, &advance,
                                         &follow, &through_flight, &along,        &through_contact};
};

}  // namespace swirl::apps
