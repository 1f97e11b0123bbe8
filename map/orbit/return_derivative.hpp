// The derivative of the return map where a return step leads through sustained contact: exact, by Jets.
//
// DF is differentiated along the orbit's own events (map/sustained/contact_along.hpp): the state in contact, where the
// removal of u_n with its friction is smooth for either sign of u_n (`landed_like`); the motion to the end of contact;
// and what follows, a flight to its first contact or the impulse that ends the contact. On the border between two ways
// it is the one-sided derivative on the orbit's side. A singular value of DF within rounding belongs to a direction
// that contact removes, and is set to zero.
#pragma once

#include "map/derivative/strike_along.hpp"
#include "map/orbit/return_map.hpp"
#include "map/sustained/contact_along.hpp"

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
                       : follow_contact(map.contact(), completion, contact_horizon)) {}

    /// The state where contact begins, with its derivatives by the section's coordinates.
    template <class J, Shape shape>
    ContactState<J> landing(const ContactScene<J>& scene) const {
        const PostImpactState<J> near = seeded<J, shape>(base);
        if (struck) return contact_state(scene, near);
        return landed_like(scene, slipping<J>(), completion_in_jets<J>(completion), near);
    }

    /// False on a border within the rounding of the state.
    bool is(const ReturnStep<double>& known) const {
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

/// The impact after a release: `leaving` with u_n = 0, which it has in every neighbour too.
template <class Map, class J>
PostImpactState<J> impact_after_release(const CollisionMap<J, Map::shape, Map::rule>& map, PostImpactState<J> leaving,
                                        const ReturnStep<double>& known, const ContactPhase<double>& phase) {
    leaving.vn = leaving.vn - contact_kinematics(map.body(), leaving).un;
    const double flown = known.collision.flight_time - phase.sums.time;
    int vertex = 0;
    if constexpr (Map::shape == Shape::polygon)
        vertex = map.body().vertex_number(static_cast<long long>(known.collision.vertex_step) - phase.vertex_step);
    return strike_along(map, flight_from(map.body(), leaving), flown, vertex).after;
}

}  // namespace detail

/// DF(z), where `known` is F(z) and leads through contact; NaN if z, as it is rounded here, ends it by another event.
///   series  is added how many power series it took, those in Jets by what they cost, if it is given
template <class Map>
auto derivative_through_contact(const ReturnMap<Map>& map, const SectionPoint<double>& z,
                                const ReturnStep<double>& known, long* series = nullptr) {
    constexpr int dimension = section_dimension<Map::shape>;
    constexpr long cost_in_jets = 8;
    using J = ContactJet<dimension>;
    using Derivative = Eigen::Matrix<double, dimension, dimension>;
    const detail::KnownContact contact(map, post_impact_state(z), known);
    const ContactPhase<double>& phase = contact.phase;
    Derivative derivative = Derivative::Constant(std::numeric_limits<double>::quiet_NaN());
    if (!phase.resolved || phase.finish == ContactEvent::horizon || !contact.is(known)) return derivative;
    const Scene<double>& s = map.map().scene();
    const CollisionMap<J, Map::shape, Map::rule> jets(
        {s.sides, J(s.alpha), J(s.beta), J(s.mu), J(s.restitution), s.law, J(s.inertia_factor)});
    const ContactScene<J> scene = contact_scene(jets.body(), jets.scene().mu, jets.scene().restitution, Map::rule);
    const ContactState<J> landing = contact.template landing<J, Map::shape>(scene);
    long steps = 0;
    PostImpactState<J> end = contact_along(map.contact(), scene, phase, landing, &steps);
    if (phase.finish == ContactEvent::release) end = detail::impact_after_release<Map>(jets, end, known, phase);
    if (series) *series += cost_in_jets * steps + contact_steps(known);
    const auto next = coordinates<Map::shape>(section_point(end));
    for (int i = 0; i < dimension; ++i) derivative.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    const double speed = s.beta + speed_of(map.map().body(), z.vn, z.vt, z.spin);
    return Derivative(detail::without_rounding(derivative, speed));
}

}  // namespace swirl
