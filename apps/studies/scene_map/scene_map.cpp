#include "apps/studies/scene_map/scene_map.hpp"

#include "apps/studies/scene_map/effort.hpp"
#include "apps/studies/scene_map/scene_functions.hpp"

#include <stdexcept>
#include <type_traits>

namespace swirl::studies {

namespace {

template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& functions_in(Accuracy accuracy) {
    switch (accuracy) {
        case Accuracy::double_precision:
            break;
        case Accuracy::extended:
            return extended_functions<shape, rule>();
        case Accuracy::quad:
            return quad_functions<shape, rule>();
        case Accuracy::paper:
        case Accuracy::brent:
        case Accuracy::fixed_step:
            return baseline_functions<shape, rule>();
    }
    return double_functions<shape, rule>();
}

/// The choice of `with_collision_map`, made without a map.
const SceneFunctions<disk_dimension>& functions_for(const Scene<double>& scene, Accuracy accuracy,
                                                    std::integral_constant<int, disk_dimension>) {
    return scene.mu == 0 ? functions_in<Shape::disk, ImpactRule::frictionless>(accuracy)
                         : functions_in<Shape::disk, ImpactRule::poisson>(accuracy);
}

const SceneFunctions<polygon_dimension>& functions_for(const Scene<double>& scene, Accuracy accuracy,
                                                       std::integral_constant<int, polygon_dimension>) {
    if (scene.mu == 0) return functions_in<Shape::polygon, ImpactRule::frictionless>(accuracy);
    switch (scene.law) {
        case Law::newton:
            return functions_in<Shape::polygon, ImpactRule::newton>(accuracy);
        case Law::stronge:
            return functions_in<Shape::polygon, ImpactRule::stronge>(accuracy);
        case Law::poisson:
            break;
    }
    return functions_in<Shape::polygon, ImpactRule::poisson>(accuracy);
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
    : SceneMap(&functions_for(scene, accuracy, std::integral_constant<int, D>()), scene, horizon, accuracy, nullptr) {}

template <int D>
SceneMap<D>::SceneMap(const SceneFunctions<D>* functions, const Scene<double>& scene, double horizon, Accuracy accuracy,
                      const Body<double>* similar)
    : functions_(functions),
      map_(functions->make(scene, accuracy, similar)),
      body_(&functions->body(map_.get())),
      horizon_(horizon),
      accuracy_(accuracy) {
    if (scene.is_disk() != (D == disk_dimension)) throw std::logic_error("a map of the other shape's dimension");
}

template <int D>
const ContactScene<double>& SceneMap<D>::contact() const {
    return functions_->contact(map_.get());
}

template <int D>
auto SceneMap<D>::advance_by(const ReturnStep<double>& known) const -> analysis::Advance<D, State> {
    analysis::Advance<D, State> step;
    step.alive = goes_on(known);
    step.effort = effort_of(known);
    if (step.alive) fill(step, known);
    step.derivative_is_zero = has_rested(known);
    return step;
}

template <int D>
auto SceneMap<D>::linearise(const State& z) const -> analysis::Linearised<D, State> {
    const ReturnStep<double> known = return_step(z);
    analysis::Linearised<D, State> step;
    step.alive = goes_on(known);
    step.effort = 2 * effort_of(known);  // of a last contact too: 10⁵ series, where it is cut
    if (!step.alive) return step;
    fill(step, known);
    if (known.contacts.empty()) {
        step.derivative = through_flight(z, known);
        return step;
    }
    long series = 0;
    step.derivative = through_contact(section_point(z), known, series);
    step.effort += effort_per_series * static_cast<double>(series);
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
    step.integral = z.spin * known.duration;
    step.effort = 1;
    step.derivative =
        functions_->through_kept_flight(map_.get(), z, {known.duration, letter.vertex_step, letter.mode, known.state});
    return step;
}

template <int D>
std::int64_t SceneMap<D>::follow(State& z, std::int64_t steps, const analysis::Stop& stop,
                                 analysis::Effort& effort) const {
    return functions_->follow(map_.get(), z, steps, horizon_, stop, effort);
}

template <int D>
bool SceneMap<D>::goes_together_with(const SceneMap& other) const {
    return functions_ == other.functions_ && functions_->together != nullptr && horizon_ == contact_horizon &&
           other.horizon_ == contact_horizon;
}

template <int D>
void SceneMap<D>::follow_together(std::span<LaneOrbit> orbits) const {
    functions_->together(orbits);
}

template <int D>
ReturnStep<double> SceneMap<D>::return_step(const State& z, double horizon, const ContactSink& sink) const {
    ReturnStep<double> step;
    step.collision.after = z;
    step.outcome = functions_->advance(map_.get(), step, horizon, sink);
    return step;
}

template <int D>
ReturnStep<double> SceneMap<D>::first_impact(const LabStart<double>& start) const {
    return functions_->first_impact(map_.get(), start);
}

template <int D>
auto SceneMap<D>::through_flight(const State& z, const ReturnStep<double>& known) const -> Derivative {
    return functions_->through_flight(map_.get(), z, known);
}

template <int D>
auto SceneMap<D>::along(const State& z, const ReturnStep<double>& known, Parameter parameter) const
    -> analysis::Vector<D> {
    return functions_->along(map_.get(), z, known, parameter);
}

template <int D>
auto SceneMap<D>::through_contact(const SectionPoint<double>& z, const ReturnStep<double>& known, long& series) const
    -> Derivative {
    return functions_->through_contact(map_.get(), z, known, series);
}

template class SceneMap<disk_dimension>;
template class SceneMap<polygon_dimension>;
static_assert(analysis::SectionMap<SceneMap<disk_dimension>> && analysis::SectionMap<SceneMap<polygon_dimension>>);

}  // namespace swirl::studies
