// Dynamics whose steps are computed by another map than double's own: in more digits, or with another search for the
// contact. The state before a step and its result are doubles: each step errs by their rounding, and by what the other
// map errs. So the scene's numbers are those of double, too. Contact is integrated in the other map's type; what is
// reported of it, for how long it is followed, and derivatives (those at that step) are double's.
#pragma once

#include "apps/studies/scene_map/dynamics_in_double.hpp"
#include "apps/studies/scene_map/in_digits.hpp"
#include "map/baselines/baseline_map.hpp"
#include "map/model/parameter.hpp"

#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

namespace swirl::studies {

/// The dynamics by a map: CollisionMap over long double or Quad, or BaselineMap.
template <class Map>
class RoundedDynamics final : public SceneDynamics<section_dimension<Map::shape>> {
public:
    using T = typename Map::Number;
    using Base = SceneDynamics<section_dimension<Map::shape>>;
    using State = typename Base::State;
    using Step = typename Base::Step;
    using Derivative = typename Base::Derivative;

    ///   in_double  the same scene's
    RoundedDynamics(const Scene<double>& scene, Accuracy accuracy, std::shared_ptr<const Base> in_double)
        : accuracy_(accuracy), in_double_(std::move(in_double)), map_(make_map(scene, accuracy)), return_map_(map_) {}

    std::shared_ptr<const Base> with(const Scene<double>& scene) const override {
        return std::make_shared<const RoundedDynamics>(scene, accuracy_, in_double_->with(scene));
    }
    const Body<double>& body() const override { return in_double_->body(); }
    const ContactScene<double>& contact() const override { return in_double_->contact(); }

    Step first_impact(const LabStart<double>& start) const override {
        return rounded_from(return_map_.advance(flight_in<T>(flight_from(body(), start))));
    }
    Outcome advance(Step& step, double horizon, const ContactSink& sink) const override {
        ReturnStep<T> next;
        next.collision.after = begin_in<T>(map_.body(), step.collision.after);
        const Outcome outcome = return_map_.advance(next, horizon, sink);
        if (outcome == Outcome::completed)
            step = rounded_from(std::move(next));
        else
            step.contacts = std::move(next.contacts);
        return outcome;
    }
    std::int64_t follow(State& z, std::int64_t steps, double horizon, const analysis::Stop& stop,
                        analysis::StepBudget& budget) const override {
        return follow_steps(body(), z, steps, stop, budget, this->cost_per_contact_step(),
                            [this, horizon](Step& step) { return advance(step, horizon, {}); });
    }

    Derivative through_flight(const State& z, const Step& known) const override {
        return in_double_->through_flight(z, known);
    }
    Derivative through_kept_flight(const State& z, const KeptFlight& kept) const override {
        return in_double_->through_kept_flight(z, kept);
    }
    analysis::Vector<section_dimension<Map::shape>> along(const State& z, const Step& known,
                                                          Parameter parameter) const override {
        return in_double_->along(z, known, parameter);
    }
    Derivative through_contact(const SectionPoint<double>& z, const Step& known, long& series) const override {
        return in_double_->through_contact(z, known, series);
    }

private:
    static Map make_map(const Scene<double>& scene, Accuracy accuracy) {
        if constexpr (std::is_same_v<T, double>)
            return Map(scene, baseline_of(accuracy).value());
        else
            return Map(scene_in<T>(scene));
    }

    Accuracy accuracy_;
    std::shared_ptr<const Base> in_double_;
    Map map_;
    ReturnMap<Map> return_map_;  ///< refers to it
};

template <class Map>
std::shared_ptr<const SceneDynamics<section_dimension<Map::shape>>> make_rounded_dynamics(const Scene<double>& scene,
                                                                                          Accuracy accuracy) {
    return std::make_shared<const RoundedDynamics<Map>>(
        scene, accuracy, make_dynamics_in_double<CollisionMap<double, Map::shape, Map::rule>>(scene));
}

}  // namespace swirl::studies
