// A scene's dynamics in double: those of its map itself.
#pragma once

#include "apps/studies/scene_map/exact_return.hpp"
#include "apps/studies/scene_map/lanes.hpp"
#include "apps/studies/scene_map/scene_dynamics.hpp"
#include "apps/studies/scene_map/step_cost.hpp"
#include "map/corners/corner_derivative.hpp"
#include "map/derivative/parameter.hpp"
#include "map/orbit/dragged_return_derivative.hpp"
#include "map/orbit/dry_return_derivative.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>

namespace swirl::studies {

/// Follows a map; what repeats itself to the bit (ExactReturn) is not followed again.
///   advance  the step in place, ReturnMap's: ReturnStep → Outcome
template <class AdvanceStep>
std::int64_t follow_steps(const Body<double>& body, PostImpactState<double>& z, std::int64_t steps,
                          const analysis::Stop& stop, analysis::StepBudget& budget, double per_contact_step,
                          const AdvanceStep& advance) {
    constexpr std::int64_t between = 1024;  // steps from one look at `stop` to the next
    ReturnStep<double> step;
    step.collision.after = z;
    ExactReturn exact;
    bool repeats = false;
    std::int64_t done = 0, look = 0;
    while (done < steps && !budget.is_spent()) {
        if (stop && done >= look) {
            if (stop()) break;
            look = done + between;
        }
        const Outcome outcome = advance(step);
        budget.spent += cost_of(step, per_contact_step);
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

/// The dynamics of CollisionMap, of DraggedMap, of DryMap or of CornerMap: CollisionMap alone has lanes.
template <class Map_>
class DynamicsInDouble final : public SceneDynamics<section_dimension<Map_::shape>> {
public:
    using Map = Map_;
    static constexpr bool drags = requires(const Map& map) { map.floor(); };
    static constexpr bool is_rounded = has_round_corners<Map>;
    static constexpr bool is_dry = has_dry_floor<Map>;
    static constexpr bool has_lanes_of_its_own = !drags && !is_rounded && !is_dry;
    using Base = SceneDynamics<section_dimension<Map::shape>>;
    using State = typename Base::State;
    using Step = typename Base::Step;
    using Derivative = typename Base::Derivative;

    explicit DynamicsInDouble(const Scene<double>& scene, const Body<double>* similar = nullptr)
        : map_(scene, similar), return_map_(map_) {}

    const ReturnMap<Map>& return_map() const { return return_map_; }

    std::shared_ptr<const Base> with(const Scene<double>& scene) const override {
        return std::make_shared<const DynamicsInDouble>(scene, &body());
    }
    const Body<double>& body() const override { return map_.body(); }
    const ContactScene<double>& contact() const override { return return_map_.contact(); }

    Step first_impact(const LabStart<double>& start) const override {
        return return_map_.advance(flight_from(body(), start));
    }
    Outcome advance(Step& step, double horizon, const ContactSink& sink) const override {
        return return_map_.advance(step, horizon, sink);
    }
    std::int64_t follow(State& z, std::int64_t steps, double horizon, const analysis::Stop& stop,
                        analysis::StepBudget& budget) const override {
        return follow_steps(body(), z, steps, stop, budget, cost_per_contact_step(),
                            [this, horizon](Step& step) { return return_map_.advance(step, horizon); });
    }

    double cost_per_contact_step() const override { return is_dry ? cost_per_dry_step : cost_per_series; }

    bool goes_together_with(const Base& other) const override {
        return has_lanes_of_its_own && dynamic_cast<const DynamicsInDouble*>(&other) != nullptr;
    }
    void follow_together(std::span<LaneOrbit<section_dimension<Map::shape>>> orbits) const override {
        if constexpr (has_lanes_of_its_own) studies::follow_together<Map::shape, Map::rule>(orbits);
    }

    double turned(const State& z, double duration) const override {
        if constexpr (drags)
            return map_.turned(z.spin, duration);
        else if constexpr (is_dry)
            return map_.turned(flight_from(body(), z), duration);
        else
            return Base::turned(z, duration);
    }

    Derivative through_flight(const State& z, const Step& known) const override {
        return derivative_by_saltation(map_, z, known.collision);
    }
    Derivative through_kept_flight(const State& z, const KeptFlight& kept) const override {
        return derivative_by_saltation(map_, z, kept);
    }
    analysis::Vector<section_dimension<Map::shape>> along(const State& z, const Step& known,
                                                          Parameter parameter) const override {
        if (!drags && parameter == Parameter::drag)
            throw std::logic_error("along drag the map is that over a floor that drags");
        if (!is_rounded && parameter == Parameter::corner)
            throw std::logic_error("along the radius of corners the map is that of rounded corners");
        if (known.contacts.empty()) return derivative_along(map_, parameter, z, known.collision);
        if constexpr (is_rounded)
            throw std::logic_error(not_in_contact);
        else
            return derivative_along_contact(return_map_, parameter, section_point(z), known);
    }
    Derivative through_contact(const SectionPoint<double>& z, const Step& known, long& series) const override {
        if constexpr (is_rounded)
            throw std::logic_error(not_in_contact);
        else
            return derivative_through_contact(return_map_, z, known, &series);
    }

private:
    static constexpr const char* not_in_contact = "rounded corners are not followed in contact";

    Map map_;
    ReturnMap<Map> return_map_;  ///< refers to it
};

template <class Map>
std::shared_ptr<const SceneDynamics<section_dimension<Map::shape>>> make_dynamics_in_double(
    const Scene<double>& scene) {
    return std::make_shared<const DynamicsInDouble<Map>>(scene);
}

}  // namespace swirl::studies
