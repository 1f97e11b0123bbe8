#include "apps/section_system.hpp"

#include "map/sustained/contact_derivative.hpp"

namespace swirl::apps {

template <Shape shape, ImpactRule rule>
auto SectionSystem<shape, rule>::advance(const State& z) const -> analysis::Advance<dimension> {
    const Passage<double> passage = return_.advance(launch_from(point_of(z)), horizon_);
    analysis::Advance<dimension> step;
    fill(step, passage);
    return step;
}

template <Shape shape, ImpactRule rule>
auto SectionSystem<shape, rule>::linearise(const State& z) const -> analysis::Linearised<dimension> {
    const SectionPoint<double> point = point_of(z);
    const Passage<double> passage = return_.advance(launch_from(point), horizon_);
    analysis::Linearised<dimension> step;
    fill(step, passage);
    if (!step.alive) return step;
    step.derivative = derivative_of(point, passage);
    return step;
}

template <Shape shape, ImpactRule rule>
auto SectionSystem<shape, rule>::derivative_of(const SectionPoint<double>& z, const Passage<double>& passage) const
    -> Eigen::Matrix<double, dimension, dimension> {
    if (passage.contacts.empty()) return map_.derivative_of(z, passage.collision);
    return derivative_through_contact(return_, z, passage);
}

template class SectionSystem<Shape::disk, ImpactRule::frictionless>;
template class SectionSystem<Shape::disk, ImpactRule::poisson>;
template class SectionSystem<Shape::polygon, ImpactRule::frictionless>;
template class SectionSystem<Shape::polygon, ImpactRule::poisson>;
template class SectionSystem<Shape::polygon, ImpactRule::newton>;
template class SectionSystem<Shape::polygon, ImpactRule::stronge>;

}  // namespace swirl::apps
