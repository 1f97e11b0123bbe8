// The derivative of the return map where a return step leads through sustained contact: exact, by Jets.
//
// DF is differentiated along the orbit's own events (map/contact/contact_along.hpp): the state in contact, where the
// removal of u_n with its friction is smooth for either sign of u_n (`landed_like`); the motion to the end of contact;
// and what follows, a flight to its first contact or the impulse that ends the contact. On the border between two ways
// it is the one-sided derivative on the orbit's side. A singular value of DF within rounding belongs to a direction
// that contact removes, and is set to zero.
#pragma once

#include "map/contact/contact_along.hpp"
#include "map/derivative/parameter.hpp"
#include "map/derivative/strike_along.hpp"
#include "map/orbit/return_map.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace swirl {

namespace detail {

/// A landing on a vertex whose neighbour comes to rest at once counts as one on their edge: the rocking between ends
/// within rounding.
inline ChatterCompletion<double> lasting_completion(ChatterCompletion<double> completion,
                                                    const std::vector<ContactSegment>& contacts) {
    if (contacts.size() < 2 || completion.support != Support::vertex) return completion;
    const ContactSegment& first = contacts[0];
    const ContactSegment& second = contacts[1];
    if (first.end > first.start || second.support != Support::edge) return completion;
    return {true, Support::edge, second.from, second.vertex_step, completion.error, completion.jacobi};
}

template <class J>
ChatterCompletion<J> completion_in_jets(const ChatterCompletion<double>& c) {
    return {c.in_contact,  c.support,  {J(c.state.psi), J(c.state.chi), J(c.state.ut), J(c.state.spin)},
            c.vertex_step, J(c.error), J(c.jacobi)};
}

/// A return step's contact, once more from its landing.
struct KnownContact {
    PostImpactState<double> base;
    bool struck = false;  ///< two vertices struck in turn, in flights that shrank to nothing: no contact in between
    ChatterCompletion<double> completion;
    ContactPhase<double> phase;

    template <class Map>
    KnownContact(const ReturnMap<Map>& map, const PostImpactState<double>& post_impact, const ReturnStep<double>& known)
        : base(post_impact),
          struck(known.contacts.front().steps == 0 && known.contacts.front().finish == ContactEvent::strike),
          completion(lasting_completion(map.completion(base), known.contacts)),
          phase(struck ? struck_at_once(map.contact(), base)
                       : phase_from(map.map(), map.contact(), completion, contact_horizon)) {}

    /// The state where contact begins, with the derivatives that the scene and a state `near` carry.
    template <class J>
    ContactState<J> landing(const ContactScene<J>& scene, const PostImpactState<J>& near) const {
        if (struck) return contact_state(scene, near);
        return landed_like(scene, slipping<J>(), completion_in_jets<J>(completion), near);
    }

    /// Of the vertex that the landing belongs to.
    int vertex_step() const { return struck ? 0 : completion.vertex_step; }

    /// False on a border within the rounding of the state, and where contact was not followed to its end.
    bool is(const ReturnStep<double>& known) const {
        if (!phase.resolved || phase.finish == ContactEvent::horizon) return false;
        return phase.segments.empty() || phase.segments.back().finish == known.contacts.back().finish;
    }

private:
    /// Where the impact before stopped the slip and friction does not hold, u_n is removed with the friction of the
    /// slip that begins: the state before it, as if it slipped that way already.
    template <class J>
    PostImpactState<J> slipping() const {
        PostImpactState<J> state = state_in_jets<J>(base);
        for (const ContactSegment& piece : phase.segments) {
            if (!(piece.end > piece.start)) continue;
            if (completion.state.ut == 0 && piece.motion == ContactMotion::sliding_forward) state.vt += J(1);
            if (completion.state.ut == 0 && piece.motion == ContactMotion::sliding_backward) state.vt -= J(1);
            break;
        }
        return state;
    }
};

/// Without the singular values that are no more than rounding made of zero: 64 ε of the largest, where velocities (the
/// last three coordinates) are measured in units of `speed`, so that the rank does not depend on how slow a body is.
Eigen::MatrixXd without_rounding(const Eigen::MatrixXd& derivative, double speed);

/// A map over Jets, and whether it is one over a floor that drags (dragged_return_derivative.hpp).
template <class Map, class J>
struct InJets {
    using Collisions = CollisionMap<J, Map::shape, Map::rule>;
    static constexpr bool over_floor = false;
};

/// The impact after a release: `leaving` with u_n = 0, which it has in every neighbour too.
template <class Map, class JetMap, class J>
PostImpactState<J> impact_after_release(const JetMap& map, PostImpactState<J> leaving, const ReturnStep<double>& known,
                                        const ContactPhase<double>& phase) {
    leaving.vn = leaving.vn - contact_kinematics(map.body(), leaving).un;
    const double flown = known.collision.flight_time - phase.sums.time;
    int vertex = 0;
    if constexpr (Map::shape == Shape::polygon)
        vertex = map.body().vertex_number(static_cast<long long>(known.collision.vertex_step) - phase.vertex_step);
    return strike_along(map, flight_from(map.body(), leaving), flown, vertex).after;
}

/// F(z) in Jets: `scene` is the map's and `near` the state z, with what they carry of derivatives.
///   steps  is added the number of power series
template <class Map, class J>
auto return_in_jets(const ReturnMap<Map>& map, const Scene<J>& scene, const PostImpactState<J>& near,
                    const KnownContact& contact, const ReturnStep<double>& known, long& steps) {
    const typename InJets<Map, J>::Collisions jets(scene);
    const ContactScene<J> in_contact = contact_scene(jets.body(), scene, Map::rule, InJets<Map, J>::over_floor);
    const ContactPhase<double>& phase = contact.phase;
    PostImpactState<J> end = contact_along(map.contact(), in_contact, phase, contact.landing(in_contact, near),
                                           contact.vertex_step(), &steps);
    if (phase.finish == ContactEvent::release) end = impact_after_release<Map>(jets, end, known, phase);
    return coordinates<Map::shape>(section_point(end));
}

}  // namespace detail

/// DF(z), where `known` is F(z) and leads through contact: 0 through a rest (`has_rested`), else NaN if z, as it is
/// rounded here, ends it by another event.
///   series  is added how many power series it took, those in Jets by what they cost, if it is given
template <class Map>
auto derivative_through_contact(const ReturnMap<Map>& map, const SectionPoint<double>& z,
                                const ReturnStep<double>& known, long* series = nullptr) {
    constexpr int dimension = section_dimension<Map::shape>;
    constexpr long cost_in_jets = 8;
    using J = ContactJet<dimension>;
    using Derivative = Eigen::Matrix<double, dimension, dimension>;
    if (has_rested(known)) return Derivative(Derivative::Zero());
    const detail::KnownContact contact(map, post_impact_state(z), known);
    Derivative derivative = Derivative::Constant(std::numeric_limits<double>::quiet_NaN());
    if (!contact.is(known)) return derivative;
    const Scene<double>& scene = map.map().scene();
    long steps = 0;
    const auto next =
        detail::return_in_jets(map, scene_in<J>(scene), seeded<J, Map::shape>(contact.base), contact, known, steps);
    if (series) *series += cost_in_jets * steps + contact_steps(known);
    for (int i = 0; i < dimension; ++i) derivative.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    const double speed = scene.beta + speed_of(map.map().body(), z.vn, z.vt, z.spin);
    return Derivative(detail::without_rounding(derivative, speed));
}

/// ∂F/∂λ at z in the same way, λ a parameter of the scene.
template <class Map>
auto derivative_along_contact(const ReturnMap<Map>& map, Parameter parameter, const SectionPoint<double>& z,
                              const ReturnStep<double>& known) {
    constexpr int dimension = section_dimension<Map::shape>;
    using J = ContactJet<1>;
    using Column = Eigen::Matrix<double, dimension, 1>;
    const detail::KnownContact contact(map, post_impact_state(z), known);
    Column column = Column::Constant(std::numeric_limits<double>::quiet_NaN());
    if (!contact.is(known)) return column;
    Scene<J> along = scene_in<J>(map.map().scene());
    number_of(along, parameter).v[0] = 1;
    long steps = 0;
    const auto next = detail::return_in_jets(map, along, state_in_jets<J>(contact.base), contact, known, steps);
    for (int i = 0; i < dimension; ++i) column[i] = next[static_cast<std::size_t>(i)].v[0];
    return column;
}

}  // namespace swirl
