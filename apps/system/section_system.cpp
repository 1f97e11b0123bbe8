#include "apps/system/section_system.hpp"

#include "map/orbit/return_derivative.hpp"

namespace swirl::apps {

template <Shape shape, ImpactRule rule>
auto SectionSystem<shape, rule>::advance(const State& z) const -> analysis::Advance<dimension> {
    const ReturnStep<double> return_step = return_.advance(post_impact_state(point_of(z)), horizon_);
    analysis::Advance<dimension> step;
    fill(step, return_step);
    return step;
}

template <Shape shape, ImpactRule rule>
auto SectionSystem<shape, rule>::linearise(const State& z) const -> analysis::Linearised<dimension> {
    const SectionPoint<double> point = point_of(z);
    const ReturnStep<double> return_step = return_.advance(post_impact_state(point), horizon_);
    analysis::Linearised<dimension> step;
    fill(step, return_step);
    if (!step.alive) return step;
    step.derivative = derivative_of(point, return_step);
    return step;
}

template <Shape shape, ImpactRule rule>
auto SectionSystem<shape, rule>::derivative_of(const SectionPoint<double>& z,
                                               const ReturnStep<double>& return_step) const
    -> Eigen::Matrix<double, dimension, dimension> {
    if (return_step.contacts.empty()) return map_.derivative_of(z, return_step.collision);
    return derivative_through_contact(return_, z, return_step);
}

template class SectionSystem<Shape::disk, ImpactRule::frictionless>;
template class SectionSystem<Shape::disk, ImpactRule::poisson>;
template class SectionSystem<Shape::polygon, ImpactRule::frictionless>;
template class SectionSystem<Shape::polygon, ImpactRule::poisson>;
template class SectionSystem<Shape::polygon, ImpactRule::newton>;
template class SectionSystem<Shape::polygon, ImpactRule::stronge>;

}  // namespace swirl::apps
