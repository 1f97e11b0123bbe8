// Contact from landing to the next flight or impact: pieces of one kind of motion, joined by events.
#pragma once

#include "map/contact/chatter_completion.hpp"
#include "map/contact/contact_run.hpp"
#include "map/contact/strike.hpp"

#include <vector>

namespace swirl {

/// One piece of sustained contact, for records and figures: in double whatever the number of the motion. Times and
/// vertices count from the impact before it.
struct ContactSegment {
    double start = 0, end = 0;
    int vertex_step = 0;  ///< the vertex in contact; an edge's clockwise one
    Support support = Support::vertex;
    ContactMotion motion = ContactMotion::sticking;
    ContactEvent begin = ContactEvent::landing;
    ContactEvent finish = ContactEvent::horizon;
    ContactState<double> from, to;
    double turned = 0;          ///< ∫ S dt
    double work = 0;            ///< ∫ f (u_t − 1) dt: change of J by friction
    double landing_jacobi = 0;  ///< change of J by the end of chatter before it (a landing's, a neighbour's)
    double error = 0;  ///< of a landing: estimated error of position and velocities by replacing the rest of chatter
    long steps = 0;    ///< number of power series, or of steps of the integration
};

/// A body at rest against a dish with dry friction (map/dry), on its rim or a vertex: neither slips nor turns (from
/// rest to rest it turns one way). (On an edge `sticking` is rest, whatever the floor.)
inline bool rests_in_dish(const ContactSegment& piece) {
    return piece.support != Support::edge && piece.motion == ContactMotion::sticking && piece.from.spin == 0 &&
           piece.to.spin == 0 && piece.turned == 0 && piece.end > piece.start;
}

template <class T>
struct ContactPhase {
    ContactEvent finish = ContactEvent::horizon;  ///< horizon, release, strike or jam
    bool cut = false;      ///< finish is horizon, but the horizon was not reached: too many steps or pieces
    bool resolved = true;  ///< false: no motion is consistent with the wall and friction
    Strike<T> strike;  ///< `after` is the post-impact state at the end: leaving, or just after the impact (strike, jam)
    int vertex_step = 0;  ///< the vertex of that post-impact state, counted from the one that struck before
    ContactSums<T> sums;
    std::vector<ContactSegment> segments;
};

/// Follows contact until the body leaves the wall, another vertex strikes, `horizon` is over, or so many power series
/// were made.
template <class T>
ContactPhase<T> follow_contact(const ContactScene<T>& scene, const ChatterCompletion<T>& completion, double horizon,
                               const ContactSink& sink = {}, long most_steps = most_contact_steps);

/// Where two vertices strike in turn and flights shrink to rounding (`ChatterCompletion::struck`): the strike of the
/// neighbour, at the same time.
template <class T>
ContactPhase<T> struck_at_once(const ContactScene<T>& scene, const PostImpactState<T>& post_impact);

}  // namespace swirl
