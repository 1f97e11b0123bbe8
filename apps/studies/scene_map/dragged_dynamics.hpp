// A scene's dynamics over a floor that drags, in double (map/dragged).
#pragma once

#include "apps/studies/scene_map/dynamics_in_double.hpp"
#include "map/dragged/dragged_derivative.hpp"
#include "map/orbit/dragged_return.hpp"

#include <cstdint>
#include <memory>
#include <stdexcept>

namespace swirl::studies {

/// No lanes, and no sustained contact: an orbit ends where it begins (`Outcome::contact_with_drag`).
template <Shape shape, ImpactRule rule>
class DraggedDynamics final : public SceneDynamics<section_dimension<shape>> {
public:
    using Base = SceneDynamics<section_dimension<shape>>;
    using State = typename Base::State;
    using Step = typename Base::Step;
    using Derivative = typename Base::Derivative;
    using Map = DraggedMap<double, shape, rule>;

    explicit DraggedDynamics(const Scene<double>& scene, const Body<double>* similar = nullptr)
        : map_(scene, similar), return_map_(map_) {}

    std::shared_ptr<const Base> with(const Scene<double>& scene) const override {
        return std::make_shared<const DraggedDynamics>(scene, &body());
    }
    const Body<double>& body() const override { return map_.body(); }
    const ContactScene<double>& contact() const override { no_contact(); }

    Step first_impact(const LabStart<double>& start) const override {
        return return_map_.advance(flight_from(body(), start));
    }
    Outcome advance(Step& step, double, const ContactSink&) const override { return return_map_.advance(step); }
    std::int64_t follow(State& z, std::int64_t steps, double, const analysis::Stop& stop,
                        analysis::StepBudget& budget) const override {
        return follow_steps(body(), z, steps, stop, budget, [this](Step& step) { return return_map_.advance(step); });
    }
    double turned(const State& z, double duration) const override { return map_.turned(z.spin, duration); }

    Derivative through_flight(const State& z, const Step& known) const override {
        return derivative_by_saltation(map_, z, known.collision);
    }
    Derivative through_kept_flight(const State& z, const KeptFlight& kept) const override {
        return derivative_by_saltation(map_, z, kept);
    }
    analysis::Vector<section_dimension<shape>> along(const State& z, const Step& known,
                                                     Parameter parameter) const override {
        return derivative_along(map_, parameter, z, known.collision);
    }
    Derivative through_contact(const SectionPoint<double>&, const Step&, long&) const override { no_contact(); }

private:
    [[noreturn]] static void no_contact() { throw std::logic_error("contact is not followed over a floor that drags"); }

    Map map_;
    ReturnMap<Map> return_map_;  ///< refers to it
};

}  // namespace swirl::studies
