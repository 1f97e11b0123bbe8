// The first proof that nothing was passed, in lanes: `clear_by_circumcircle` of map/first_contact/vertex_proofs.hpp,
// and the bounds of all proofs.
#if defined(SWIRL_MAP_BATCH_CIRCLE_PROOF_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_CIRCLE_PROOF_INL
#undef SWIRL_MAP_BATCH_CIRCLE_PROOF_INL
#else
#define SWIRL_MAP_BATCH_CIRCLE_PROOF_INL
#endif

#include "map/batch/vertices-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// The numbers of the scenes that the search and the proof read.
struct LaneBody {
    Lane alpha, beta, inner, outer, spacing, half_slope, side;
    Plane next_turn;
};

HWY_INLINE LaneBody load_body(const LaneScenes& s, int i) {
    return {
        load(s.alpha, i),   load(s.beta, i),       load(s.inner, i), load(s.outer, i),
        load(s.spacing, i), load(s.half_slope, i), load(s.side, i),  {load(s.next_turn_x, i), load(s.next_turn_y, i)}};
}

/// derivative_bounds<4, polygon>.vertex.
HWY_INLINE Lane fourth_bound(const LaneBody& body, const LaneFlight& flight, Lane speed) {
    const Lane place = body.outer + body.beta;
    const Lane s = magnitude(flight.spin);
    const Lane relative = magnitude(flight.spin - Lane(1));
    const Lane relative2 = relative * relative;
    return centre_bound(4, body.beta, body.outer, speed) +
           Lane(2) * body.alpha * (s * s * s * (s * place + Lane(4) * speed) + body.beta * (relative2 * relative2));
}

/// struck_gap_at_start.
HWY_INLINE LaneGap struck_gap_at_start(const LaneFlight& flight) {
    const Plane rate = flight.velocity + quarter_turned(flight.spin * flight.arm - flight.swirl);
    const Lane spin2 = flight.spin * flight.spin;
    const Plane curvature = flight.swirl - spin2 * flight.arm;
    return {Lane(0), Lane(2) * rate.x, Lane(2) * (dot(rate, rate) + curvature.x), Lane(0)};
}

/// VertexBounds.
struct LaneBounds {
    Lane drift, apart, third, centre_sixth;
};

HWY_INLINE LaneBounds vertex_bounds(const LaneBody& body, const LaneFlight& flight, Lane speed) {
    LaneBounds bounds;
    bounds.drift = speed + body.beta;
    const Lane s = magnitude(flight.spin);
    bounds.apart = body.side * (body.beta + s * (Lane(2) * bounds.drift + s * body.outer));
    const Lane centre_third = Lane(2) * body.beta * (Lane(3) * bounds.drift + body.outer);
    bounds.third =
        centre_third +
        Lane(2) * body.alpha * (body.beta + s * (Lane(3) * body.beta + s * (Lane(3) * bounds.drift + s * body.outer)));
    bounds.centre_sixth = centre_bound(6, body.beta, body.outer, speed);
    return bounds;
}

/// One end of a flight, for `only_one_at_wall`.
struct LaneEnd {
    Plane centre, drift;
    Lane spin;
    Plane arm;
    Lane rate, curvature, t, slack;
};

HWY_INLINE Mask only_one_at_wall(const LaneBody& body, const LaneBounds& bounds, const LaneEnd& end) {
    const Lane across = cross(end.arm, end.centre);
    const Lane along = dot(end.arm, end.centre);
    const Plane side = times(end.arm, {body.next_turn.x, Lane(hn::CopySign(body.next_turn.y.v, across.v))});
    const Lane behind = Lane(2) * dot(end.centre, side);
    const Lane slope = Lane(2) * (dot(end.drift, side) - end.spin * cross(end.centre, side));
    return all(magnitude(across) <= body.half_slope * along, end.rate > Lane(0),
               end.t * (end.curvature + fraction(1, 3) * bounds.third * end.t) <= Lane(2) * end.rate,
               end.rate * behind + end.slack <= Lane(0),
               end.rate * (behind + end.t * (slope + end.t * bounds.apart)) + end.slack <= Lane(0));
}

/// What the proofs read.
struct ProofTask {
    LaneBody body;
    LaneFlight flight;
    VertexRows vertices;
    LaneStart start;
    LaneGap struck;
    Lane speed;  ///< |V_x| + |V_y|
    LaneSearch search;
};

/// The circumscribed circle's gap at the start, and at another moment (without its jerk).
HWY_INLINE LaneGap leaving_gap(const ProofTask& task) {
    return {dot(task.flight.centre, task.flight.centre) - task.body.inner * task.body.inner, task.start.rate,
            task.start.curvature, task.start.jerk};
}
HWY_INLINE LaneGap centre_gap(const LaneBody& body, const LaneInstant& at) {
    return {dot(at.centre, at.centre) - body.inner * body.inner, Lane(2) * dot(at.centre, at.drift),
            Lane(2) * (dot(at.drift, at.drift) + dot(at.centre, at.swirl)), Lane(0)};
}

/// ClosedBetween.
struct LaneRing {
    Mask proven;
    Lane out, in;
};

HWY_INLINE LaneRing closed_between(const LaneGap& from, const LaneGap& to, Lane h, Lane sixth) {
    const Lane c0 = larger(from.value, Lane(0)) + Lane(4 * unit_roundoff);
    const Lane c5 = larger(to.value, Lane(0)) + Lane(4 * unit_roundoff);
    const InnerLanes c = inner_coefficients(from, to, h, sixth);
    return {all(c.first < Lane(0), c.fourth < Lane(0), c.second <= Lane(0), c.third <= Lane(0)),
            h * c0 / (c0 - Lane(5) * c.first), h * c5 / (c5 - Lane(5) * c.fourth)};
}

HWY_INLINE Mask two_suffice(const LaneBody& body, const LaneFlight& flight, Lane drift, Lane t, Lane distance) {
    return all(t * (magnitude(flight.spin) * distance + Lane(2) * drift) <= Lane(0.5) * body.spacing * distance,
               Lane(2) * t * drift <= distance);
}

HWY_INLINE Mask clear_by_circumcircle(const ProofTask& task) {
    const LaneBody& body = task.body;
    const LaneFlight& flight = task.flight;
    const LaneBounds bounds = vertex_bounds(body, flight, task.speed);
    const LaneInstant& at = task.search.at;
    const LaneGap& g = task.search.nearest.gap;
    const LaneRing ring = closed_between(leaving_gap(task), centre_gap(body, at), at.time, bounds.centre_sixth);
    const Lane shift = magnitude(task.search.correction);
    const Lane in = ring.in + shift;
    const Lane rate = g.rate - shift * (magnitude(g.curvature) + bounds.third * shift);
    const Lane curvature = g.curvature + bounds.third * shift;
    const Lane s = magnitude(flight.spin);
    const Lane fastest = Lane(2) * (bounds.drift + body.alpha * s);
    const Lane slack = Lane(32 * unit_roundoff) * (Lane(1) + fastest) * (Lane(1) + fastest * at.time) +
                       rate * shift * Lane(2) * body.side * (bounds.drift + body.outer * s);
    const Plane start_drift = flight.velocity - quarter_turned(flight.swirl);
    const LaneEnd first{flight.centre,     start_drift,           flight.spin, flight.arm,
                        -task.struck.rate, task.struck.curvature, ring.out,    Lane(0)};
    const LaneEnd last{
        at.centre, {-at.drift.x, -at.drift.y}, -flight.spin, task.search.nearest.arm, rate, curvature, in, slack};
    return all(ring.proven,
               two_suffice(body, flight, bounds.drift, larger(ring.out, in), body.inner - bounds.drift * shift),
               only_one_at_wall(body, bounds, first), only_one_at_wall(body, bounds, last));
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
