// The derivative of the return map over a floor with dry friction, through a disk's contact: return_derivative.hpp,
// with its motions.
#pragma once

#include "map/dry/dry_derivative.hpp"
#include "map/dry/rim_along.hpp"
#include "map/orbit/dry_return.hpp"
#include "map/orbit/return_derivative.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace swirl {

namespace detail {

template <class J, ImpactRule rule>
PostImpactState<J> return_over_dry_floor(const ReturnMap<DryMap<double, Shape::disk, rule>>& map, const Scene<J>& scene,
                                         const PostImpactState<J>& near, const ReturnStep<double>& known) {
    using InTime = ContactJet<1>;
    const auto& plain = map.map();
    const DryMap<J, Shape::disk, rule> jets(scene, nullptr, plain.pressure());
    const DryMap<InTime, Shape::disk, rule> in_time(scene_in<InTime>(plain.scene()), nullptr, plain.pressure());
    const RimScene<double> rim = plain.rim();
    const RimScene<J> rim_in_jets = jets.rim();
    const RimScene<InTime> rim_in_time = in_time.rim();
    const ContactState<J> end =
        rim_along<J>({rim, rim_in_jets, rim_in_time}, known.contacts, landing_on_rim(rim_in_jets, near));
    const ContactSegment& last = known.contacts.back();
    return strike_along_course(plain, jets, leaving_rim(rim, last.to), leaving_rim(rim_in_jets, end),
                               known.collision.flight_time - last.end, 0)
        .after;
}

}  // namespace detail

/// DF(z), where `known` is F(z) and leads through contact, in closed form but for the flights and motions, which are
/// integrated in Jets by the same steps: 0 through a rest.
///   series  is added how many steps it took, those in Jets by what they cost, if it is given
template <ImpactRule rule>
auto derivative_through_contact(const ReturnMap<DryMap<double, Shape::disk, rule>>& map, const SectionPoint<double>& z,
                                const ReturnStep<double>& known, long* series = nullptr) {
    constexpr int dimension = section_dimension<Shape::disk>;
    constexpr long cost_in_jets = 8;
    using J = ContactJet<dimension>;
    using Derivative = Eigen::Matrix<double, dimension, dimension>;
    if (series) *series += (1 + cost_in_jets) * contact_steps(known);
    // As in has_rested: what was before does not matter.
    if (std::any_of(known.contacts.begin(), known.contacts.end(), rests_on_rim)) return Derivative(Derivative::Zero());
    const PostImpactState<double> base = post_impact_state(z);
    const auto next = coordinates<Shape::disk>(section_point(
        detail::return_over_dry_floor(map, scene_in<J>(map.map().scene()), seeded<J, Shape::disk>(base), known)));
    Derivative derivative;
    for (int i = 0; i < dimension; ++i) derivative.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    const double speed = map.map().scene().beta + speed_of(map.map().body(), z.vn, z.vt, z.spin);
    return Derivative(detail::without_rounding(derivative, speed));
}

/// ∂F/∂λ at z in the same way, λ a parameter of the scene.
template <ImpactRule rule>
auto derivative_along_contact(const ReturnMap<DryMap<double, Shape::disk, rule>>& map, Parameter parameter,
                              const SectionPoint<double>& z, const ReturnStep<double>& known) {
    constexpr int dimension = section_dimension<Shape::disk>;
    using J = ContactJet<1>;
    const PostImpactState<double> base = post_impact_state(z);
    Scene<J> along = scene_in<J>(map.map().scene());
    number_of(along, parameter).v[0] = 1;
    const auto next = coordinates<Shape::disk>(
        section_point(detail::return_over_dry_floor(map, along, state_in_jets<J>(base), known)));
    Eigen::Matrix<double, dimension, 1> column;
    for (int i = 0; i < dimension; ++i) column[i] = next[static_cast<std::size_t>(i)].v[0];
    return column;
}

}  // namespace swirl
