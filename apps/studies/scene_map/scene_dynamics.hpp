// What SceneMap asks of a scene, whatever its shape, impact rule and arithmetic.
#pragma once

#include "apps/studies/scene_map/accuracy.hpp"
#include "apps/studies/scene_map/lanes.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/step_cost.hpp"
#include "map/derivative/saltation.hpp"
#include "map/map_list.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace swirl::studies {

/// A scene's return map of dimension D. All members are pure functions of the scene and their arguments.
template <int D>
class SceneDynamics {
public:
    using State = PostImpactState<double>;
    using Step = ReturnStep<double>;
    using Derivative = analysis::Matrix<D>;

    SceneDynamics() = default;
    SceneDynamics(const SceneDynamics&) = delete;
    SceneDynamics& operator=(const SceneDynamics&) = delete;
    virtual ~SceneDynamics() = default;

    /// A scene of this shape, impact rule and arithmetic with other numbers.
    virtual std::shared_ptr<const SceneDynamics> with(const Scene<double>& scene) const = 0;
    virtual const Body<double>& body() const = 0;
    virtual const ContactScene<double>& contact() const = 0;

    virtual Step first_impact(const LabStart<double>& start) const = 0;
    /// ReturnMap's step, in place.
    virtual Outcome advance(Step& step, double horizon, const ContactSink& sink) const = 0;
    /// See analysis::follow.
    virtual std::int64_t follow(State& z, std::int64_t steps, double horizon, const analysis::Stop& stop,
                                analysis::StepBudget& budget) const = 0;

    /// What a step of contact costs (step_cost.hpp).
    virtual double cost_per_contact_step() const { return cost_per_series; }

    /// Orbits that take their steps together, lane by lane; only where the rule and the arithmetic have lanes.
    virtual bool goes_together_with(const SceneDynamics&) const { return false; }
    virtual void follow_together(std::span<LaneOrbit<D>>) const {}

    /// ∫ S dt of the flight after z.
    virtual double turned(const State& z, double duration) const { return z.spin * duration; }

    virtual Derivative through_flight(const State& z, const Step& known) const = 0;
    virtual Derivative through_kept_flight(const State& z, const KeptFlight& kept) const = 0;
    virtual analysis::Vector<D> along(const State& z, const Step& known, Parameter parameter) const = 0;
    /// `series` is added the power series that it took.
    virtual Derivative through_contact(const SectionPoint<double>& z, const Step& known, long& series) const = 0;
};

/// Dynamics in double (dynamics_in_double.hpp): CollisionMap's, compiled in scenes_in_double.cpp, DraggedMap's, over a
/// floor that drags, in dragged_scenes.cpp, and CornerMap's, of rounded corners, in corner_scenes.cpp.
template <class Map>
std::shared_ptr<const SceneDynamics<section_dimension<Map::shape>>> make_dynamics_in_double(const Scene<double>& scene);
/// The dynamics by another map (rounded_dynamics.hpp): CollisionMap over long double or Quad, compiled in
/// scenes_in_extended.cpp and scenes_in_quad.cpp, or BaselineMap, in scenes_of_baselines.cpp.
template <class Map>
std::shared_ptr<const SceneDynamics<section_dimension<Map::shape>>> make_rounded_dynamics(const Scene<double>& scene,
                                                                                          Accuracy accuracy);

// For SWIRL_EVERY_MAP in those files.
#define SWIRL_COMPILE_DYNAMICS_IN_DOUBLE(T, SHAPE, RULE)                    \
    template std::shared_ptr<const SceneDynamics<section_dimension<SHAPE>>> \
    make_dynamics_in_double<CollisionMap<T, SHAPE, RULE>>(const Scene<double>&);
#define SWIRL_COMPILE_DRAGGED_DYNAMICS(T, SHAPE, RULE)                      \
    template std::shared_ptr<const SceneDynamics<section_dimension<SHAPE>>> \
    make_dynamics_in_double<DraggedMap<T, SHAPE, RULE>>(const Scene<double>&);
#define SWIRL_COMPILE_CORNER_DYNAMICS(T, SHAPE, RULE)                       \
    template std::shared_ptr<const SceneDynamics<section_dimension<SHAPE>>> \
    make_dynamics_in_double<CornerMap<T, SHAPE, RULE>>(const Scene<double>&);
#define SWIRL_COMPILE_DRY_DYNAMICS(T, SHAPE, RULE)                          \
    template std::shared_ptr<const SceneDynamics<section_dimension<SHAPE>>> \
    make_dynamics_in_double<DryMap<T, SHAPE, RULE>>(const Scene<double>&);
#define SWIRL_COMPILE_ROUNDED_DYNAMICS(T, SHAPE, RULE)                      \
    template std::shared_ptr<const SceneDynamics<section_dimension<SHAPE>>> \
    make_rounded_dynamics<CollisionMap<T, SHAPE, RULE>>(const Scene<double>&, Accuracy);
#define SWIRL_COMPILE_BASELINE_DYNAMICS(T, SHAPE, RULE)                     \
    template std::shared_ptr<const SceneDynamics<section_dimension<SHAPE>>> \
    make_rounded_dynamics<BaselineMap<SHAPE, RULE>>(const Scene<double>&, Accuracy);

}  // namespace swirl::studies
