// Contact from landing to the next flight or impact: pieces of one kind of motion, joined by events.
#pragma once

#include "map/sustained/chatter_completion.hpp"
#include "map/sustained/contact_run.hpp"
#include "map/sustained/strike.hpp"

#include <vector>

namespace swirl {

/// One piece of sustained contact. Times and vertices count from the impact before it.
struct ContactSegment {
    double start = 0, end = 0;
    int vertex_step = 0;  ///< the vertex it stands on; an edge's clockwise one
    Support support = Support::vertex;
    ContactMotion motion = ContactMotion::sticking;
    ContactEvent begin = ContactEvent::landing;
    ContactEvent finish = ContactEvent::horizon;
    ContactState from, to;
    double turned = 0;          ///< ∫ S dt
    double work = 0;            ///< ∫ f (u_t − 1) dt: what friction added to J
    double landing_jacobi = 0;  ///< what the end of chatter before it (a landing's, a neighbour's) added to J
    double error = 0;           ///< of a landing: what ending chatter there does to place and velocities (an estimate)
    long steps = 0;             ///< power series that it took
};

struct ContactPhase {
    ContactEvent finish = ContactEvent::horizon;  ///< horizon, release, strike or jam
    bool resolved = true;                         ///< false: no motion is consistent with the wall and friction
    Strike strike;  ///< `after` is the post-impact state at the end: leaving, or just after the impact (strike, jam)
    int vertex_step = 0;  ///< the vertex of that post-impact state, from the one that had struck
    ContactSums sums;
    std::vector<ContactSegment> segments;
};

/// Follows contact until the body leaves the wall, another vertex strikes, or `horizon` is over.
ContactPhase follow_contact(const ContactScene& scene, const ChatterCompletion& completion, double horizon,
                            const ContactSink& sink = {});

/// Where two vertices strike in turn and flights shrink to rounding (`ChatterCompletion::struck`): the neighbour
/// strikes before the body has left the wall, after no time.
ContactPhase struck_at_once(const ContactScene& scene, const PostImpactState<double>& post_impact);

}  // namespace swirl
