#include "apps/studies/scene_map/scene_map.hpp"

#include "apps/studies/scene_map/scene_dynamics.hpp"
#include "apps/studies/scene_map/step_cost.hpp"
#include "map/baselines/baseline_map.hpp"
#include "map/corners/corner_map.hpp"
#include "map/dragged/dragged_map.hpp"
#include "map/dry/dry_map.hpp"
#include "map/numbers/quad.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace swirl::studies {

namespace {

/// Dynamics of dimension D, whose scenes go on with `with`.
template <int D>
using Dynamics = std::shared_ptr<const SceneDynamics<D>>;

template <Shape shape, ImpactRule rule>
Dynamics<section_dimension<shape>> dynamics_in(Accuracy accuracy, const Scene<double>& scene) {
    if (scene.has_drag()) {
        if (accuracy != Accuracy::double_precision)
            throw std::invalid_argument("accuracy = " + std::string(name_of(accuracy)) +
                                        " is not extended to a floor that drags; double is wanted");
        return make_dynamics_in_double<DraggedMap<double, shape, rule>>(scene);
    }
    if (scene.has_dry_floor()) {
        if (accuracy != Accuracy::double_precision)
            throw std::invalid_argument("accuracy = " + std::string(name_of(accuracy)) +
                                        " is not extended to a floor with dry friction; double is wanted");
        return make_dynamics_in_double<DryMap<double, shape, rule>>(scene);
    }
    if (scene.is_rounded()) {
        if (accuracy != Accuracy::double_precision)
            throw std::invalid_argument("accuracy = " + std::string(name_of(accuracy)) +
                                        " is not extended to rounded corners; double is wanted");
        if constexpr (shape == Shape::polygon)
            return make_dynamics_in_double<CornerMap<double, shape, rule>>(scene);
        else
            throw std::logic_error("a disk has no corners");
    }
    switch (accuracy) {
        case Accuracy::double_precision:
            break;
        case Accuracy::extended:
            return make_rounded_dynamics<CollisionMap<long double, shape, rule>>(scene, accuracy);
        case Accuracy::quad:
            return make_rounded_dynamics<CollisionMap<Quad, shape, rule>>(scene, accuracy);
        case Accuracy::paper:
        case Accuracy::brent:
        case Accuracy::fixed_step:
            return make_rounded_dynamics<BaselineMap<shape, rule>>(scene, accuracy);
    }
    return make_dynamics_in_double<CollisionMap<double, shape, rule>>(scene);
}

template <int D>
Dynamics<D> dynamics_for(const Scene<double>& scene, Accuracy accuracy) {
    constexpr Shape shape = D == disk_dimension ? Shape::disk : Shape::polygon;
    return with_rule<shape>(scene, [&](auto rule) { return dynamics_in<shape, rule()>(accuracy, scene); });
}

/// What a step says of a return step from which an orbit goes on.
template <class Step>
void fill(Step& step, const ReturnStep<double>& return_step) {
    step.state = return_step.collision.after;
    step.duration = return_step.collision.flight_time;
    step.integral = return_step.turned;
    step.letter = number_of(letter_of(return_step));
}

}  // namespace

template <int D>
SceneMap<D>::SceneMap(const Scene<double>& scene, double horizon, Accuracy accuracy)
    : SceneMap(dynamics_for<D>(scene, accuracy), horizon) {
    if (scene.is_disk() != (D == disk_dimension)) throw std::logic_error("a map of the other shape's dimension");
}

template <int D>
SceneMap<D>::SceneMap(std::shared_ptr<const SceneDynamics<D>> dynamics, double horizon)
    : dynamics_(std::move(dynamics)), body_(&dynamics_->body()), horizon_(horizon) {}

template <int D>
auto SceneMap<D>::with(const Scene<double>& scene) const -> SceneMap {
    if (scene.is_disk() != (D == disk_dimension)) throw std::logic_error("a map of the other shape's dimension");
    return SceneMap(dynamics_->with(scene), horizon_);
}

template <int D>
const ContactScene<double>& SceneMap<D>::contact() const {
    return dynamics_->contact();
}

template <int D>
auto SceneMap<D>::advance_by(const ReturnStep<double>& known) const -> analysis::Advance<D, State> {
    analysis::Advance<D, State> step;
    step.alive = goes_on(known);
    step.cost = cost_of(known, dynamics_->cost_per_contact_step());
    if (step.alive) fill(step, known);
    step.derivative_is_zero = has_rested(known);
    return step;
}

template <int D>
auto SceneMap<D>::linearise(const State& z) const -> analysis::Linearised<D, State> {
    const ReturnStep<double> known = return_step(z);
    analysis::Linearised<D, State> step;
    step.alive = goes_on(known);
    step.cost =
        2 * cost_of(known, dynamics_->cost_per_contact_step());  // of a last contact too: 10⁵ series, where it is cut
    if (!step.alive) return step;
    fill(step, known);
    if (known.contacts.empty()) {
        step.derivative = through_flight(z, known);
        return step;
    }
    long series = 0;
    step.derivative = through_contact(section_point(z), known, series);
    step.cost += dynamics_->cost_per_contact_step() * static_cast<double>(series);
    return step;
}

template <int D>
auto SceneMap<D>::linearise(const State& z, const analysis::KnownStep<State>& known) const
    -> analysis::Linearised<D, State> {
    const Letter letter = letter_from(known.letter);
    if (letter.through_contact) return linearise(z);
    analysis::Linearised<D, State> step;
    step.state = known.state;
    step.duration = known.duration;
    step.letter = known.letter;
    step.integral = dynamics_->turned(z, known.duration);
    step.cost = 1;
    step.derivative = dynamics_->through_kept_flight(z, {known.duration, letter.vertex_step, letter.mode, known.state});
    return step;
}

template <int D>
std::int64_t SceneMap<D>::follow(State& z, std::int64_t steps, const analysis::Stop& stop,
                                 analysis::StepBudget& budget) const {
    return dynamics_->follow(z, steps, horizon_, stop, budget);
}

template <int D>
bool SceneMap<D>::goes_together_with(const SceneMap& other) const {
    return dynamics_->goes_together_with(*other.dynamics_) && horizon_ == contact_horizon &&
           other.horizon_ == contact_horizon;
}

template <int D>
void SceneMap<D>::follow_together(std::span<LaneOrbit<D>> orbits) const {
    dynamics_->follow_together(orbits);
}

template <int D>
ReturnStep<double> SceneMap<D>::return_step(const State& z, double horizon, const ContactSink& sink) const {
    ReturnStep<double> step;
    step.collision.after = z;
    step.outcome = dynamics_->advance(step, horizon, sink);
    return step;
}

template <int D>
ReturnStep<double> SceneMap<D>::first_impact(const LabStart<double>& start) const {
    return dynamics_->first_impact(start);
}

template <int D>
auto SceneMap<D>::through_flight(const State& z, const ReturnStep<double>& known) const -> Derivative {
    return dynamics_->through_flight(z, known);
}

template <int D>
auto SceneMap<D>::along(const State& z, const ReturnStep<double>& known, Parameter parameter) const
    -> analysis::Vector<D> {
    return dynamics_->along(z, known, parameter);
}

template <int D>
auto SceneMap<D>::through_contact(const SectionPoint<double>& z, const ReturnStep<double>& known, long& series) const
    -> Derivative {
    return dynamics_->through_contact(z, known, series);
}

template class SceneMap<disk_dimension>;
template class SceneMap<polygon_dimension>;
static_assert(analysis::SectionMap<SceneMap<disk_dimension>> && analysis::SectionMap<SceneMap<polygon_dimension>>);

}  // namespace swirl::studies
