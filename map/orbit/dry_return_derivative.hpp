// The derivative of the return map over a floor with dry friction, through contact: return_derivative.hpp, with its
// motions.
#pragma once

#include "map/dry/dry_derivative.hpp"
#include "map/dry/wall_along.hpp"
#include "map/orbit/dry_return.hpp"
#include "map/orbit/return_derivative.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace swirl {

namespace detail {

/// F(z) in Jets.
///   along  of which differences are taken along a number of the scene; nothing along the state
template <class J, Shape shape, ImpactRule rule>
PostImpactState<J> return_over_dry_floor(const ReturnMap<DryMap<double, shape, rule>>& map, const Scene<J>& scene,
                                         const std::optional<DryWallsApart>& along, const PostImpactState<J>& near,
                                         const KnownContact& contact, const ReturnStep<double>& known) {
    using InTime = ContactJet<1>;
    const auto& plain = map.map();
    const DryMap<J, shape, rule> jets(scene, nullptr, plain.pressure());
    const DryMap<InTime, shape, rule> in_time(scene_in<InTime>(plain.scene()), nullptr, plain.pressure());
    const DryWallInJets<J> walls{plain.wall(), jets.wall(), in_time.wall(), along};
    const ContactScene<J> at_landing = scene_at(walls.wall, near);
    DryPieces<J> pieces{walls};
    contact_detail::SegmentFollower<J, DryPieces<J>> follower{walls.wall.contact, pieces,
                                                              contact.landing(at_landing, near), contact.vertex_step()};
    const ContactPhase<double>& phase = contact.phase;
    PostImpactState<J> leaving = follower.follow(phase);
    if (phase.finish != ContactEvent::release) return leaving;
    leaving.vn = leaving.vn - contact_kinematics(jets.body(), leaving).un;
    PostImpactState<double> from = phase.strike.after;  // as ReturnMap flies on
    from.psi = renormalised(from.psi);
    from.chi = renormalised(from.chi);
    from.vn = from.vn - contact_kinematics(plain.body(), from).un;
    int vertex = 0;
    if constexpr (shape == Shape::polygon)
        vertex = plain.body().vertex_number(static_cast<long long>(known.collision.vertex_step) - phase.vertex_step);
    return strike_along_course(plain, jets, from, leaving, known.collision.flight_time - phase.sums.time, vertex).after;
}

}  // namespace detail

/// DF(z), where `known` is F(z) and leads through contact, in closed form but for the flights and motions, which are
/// integrated in Jets by the same steps, and what begins at rest, of which differences are taken: 0 through a rest on
/// an edge or of a disk, NaN as of other maps.
///   series  is added how many steps it took, those in Jets by what they cost, if it is given
template <Shape shape, ImpactRule rule>
auto derivative_through_contact(const ReturnMap<DryMap<double, shape, rule>>& map, const SectionPoint<double>& z,
                                const ReturnStep<double>& known, long* series = nullptr) {
    constexpr int dimension = section_dimension<shape>;
    constexpr long cost_in_jets = 8;
    using J = ContactJet<dimension>;
    using Derivative = Eigen::Matrix<double, dimension, dimension>;
    if (series) *series += (1 + cost_in_jets) * contact_steps(known);
    // As in has_rested: what was before does not matter.
    const bool is_disk_at_rest =
        shape == Shape::disk && std::any_of(known.contacts.begin(), known.contacts.end(),
                                            [](const auto& piece) { return rests_in_dish(piece); });
    if (is_disk_at_rest || has_rested(known)) return Derivative(Derivative::Zero());
    const PostImpactState<double> base = post_impact_state(z);
    const detail::KnownContact contact(map, base, known);
    Derivative derivative = Derivative::Constant(std::numeric_limits<double>::quiet_NaN());
    if (!contact.is(known)) return derivative;
    const Scene<double>& scene = map.map().scene();
    const auto next = coordinates<shape>(section_point(
        detail::return_over_dry_floor(map, scene_in<J>(scene), std::nullopt, seeded<J, shape>(base), contact, known)));
    for (int i = 0; i < dimension; ++i) derivative.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    const double speed = scene.beta + speed_of(map.map().body(), z.vn, z.vt, z.spin);
    return Derivative(detail::without_rounding(derivative, speed));
}

/// ∂F/∂λ at z in the same way, λ a parameter of the scene.
template <Shape shape, ImpactRule rule>
auto derivative_along_contact(const ReturnMap<DryMap<double, shape, rule>>& map, Parameter parameter,
                              const SectionPoint<double>& z, const ReturnStep<double>& known) {
    constexpr int dimension = section_dimension<shape>;
    constexpr double apart = 1e-6;
    using J = ContactJet<1>;
    const PostImpactState<double> base = post_impact_state(z);
    const detail::KnownContact contact(map, base, known);
    Eigen::Matrix<double, dimension, 1> column;
    column.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (!contact.is(known)) return column;
    Scene<J> along = scene_in<J>(map.map().scene());
    number_of(along, parameter).v[0] = 1;
    const auto wall_at = [&](double change) {
        Scene<double> moved = map.map().scene();
        number_of(moved, parameter) += change;
        return DryMap<double, shape, rule>(moved, nullptr, map.map().pressure())
            .wall();  // refers to the map's pressure
    };
    const DryWallsApart walls{wall_at(apart), wall_at(-apart), apart};
    const auto next = coordinates<shape>(
        section_point(detail::return_over_dry_floor(map, along, walls, state_in_jets<J>(base), contact, known)));
    for (int i = 0; i < dimension; ++i) column[i] = next[static_cast<std::size_t>(i)].v[0];
    return column;
}

}  // namespace swirl
