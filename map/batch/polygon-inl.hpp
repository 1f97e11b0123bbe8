// The flight of each lane's polygon from wall to wall: map/first_contact/direct_polygon.hpp with its first proof,
// `clear_by_circumcircle`, and the impact.
#if defined(SWIRL_MAP_BATCH_POLYGON_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_POLYGON_INL
#undef SWIRL_MAP_BATCH_POLYGON_INL
#else
#define SWIRL_MAP_BATCH_POLYGON_INL
#endif

#include "map/batch/impact-inl.hpp"
#include "map/batch/vertices-inl.hpp"
#include "map/sustained/chatter_completion.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// The numbers of the scenes that the search and the proof read.
struct LaneBody {
    Lane alpha, beta, inner, outer, spacing, half_slope, side;
    Plane next_turn;
};

HWY_INLINE LaneBody load_body(const LaneScenes& s, int i) {
    return {load(s.alpha, i),   load(s.beta, i),       load(s.inner, i), load(s.outer, i),
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
    const Plane bend = flight.swirl - spin2 * flight.arm;
    return {Lane(0), Lane(2) * rate.x, Lane(2) * (dot(rate, rate) + bend.x), Lane(0)};
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
    bounds.third = centre_third +
                   Lane(2) * body.alpha *
                       (body.beta + s * (Lane(3) * body.beta + s * (Lane(3) * bounds.drift + s * body.outer)));
    bounds.centre_sixth = centre_bound(6, body.beta, body.outer, speed);
    return bounds;
}

/// One end of a flight, for `only_one_at_wall`.
struct LaneEnd {
    Plane centre, drift;
    Lane spin;
    Plane arm;
    Lane rate, bend, t, slack;
};

HWY_INLINE Mask only_one_at_wall(const LaneBody& body, const LaneBounds& bounds, const LaneEnd& end) {
    const Lane across = cross(end.arm, end.centre);
    const Lane along = dot(end.arm, end.centre);
    const Plane side = times(end.arm, {body.next_turn.x, Lane(hn::CopySign(body.next_turn.y.v, across.v))});
    const Lane behind = Lane(2) * dot(end.centre, side);
    const Lane slope = Lane(2) * (dot(end.drift, side) - end.spin * cross(end.centre, side));
    return all(magnitude(across) <= body.half_slope * along, end.rate > Lane(0),
               end.t * (end.bend + fraction(1, 3) * bounds.third * end.t) <= Lane(2) * end.rate,
               end.rate * behind + end.slack <= Lane(0),
               end.rate * (behind + end.t * (slope + end.t * bounds.apart)) + end.slack <= Lane(0));
}

/// clear_by_circumcircle.
HWY_INLINE Mask clear_by_circumcircle(const LaneBody& body, const LaneFlight& flight, const LaneStart& start,
                                      const LaneGap& struck, const LaneSearch& search, Lane speed) {
    const LaneBounds bounds = vertex_bounds(body, flight, speed);
    const LaneInstant& at = search.at;
    const LaneGap& g = search.nearest.gap;
    const Lane inner2 = body.inner * body.inner;
    const LaneGap leaving{dot(flight.centre, flight.centre) - inner2, start.rate, start.bend, start.jerk};
    const LaneGap arriving{dot(at.centre, at.centre) - inner2, Lane(2) * dot(at.centre, at.drift),
                           Lane(2) * (dot(at.drift, at.drift) + dot(at.centre, at.swirl)), Lane(0)};
    const InnerLanes c = inner_coefficients(leaving, arriving, at.time, bounds.centre_sixth);
    const Lane c0 = larger(leaving.value, Lane(0)) + Lane(4 * unit_roundoff);
    const Lane c5 = larger(arriving.value, Lane(0)) + Lane(4 * unit_roundoff);
    const Lane out = at.time * c0 / (c0 - Lane(5) * c.first);
    const Lane shift = magnitude(search.correction);
    const Lane in = at.time * c5 / (c5 - Lane(5) * c.fourth) + shift;
    const Lane rate = g.rate - shift * (magnitude(g.bend) + bounds.third * shift);
    const Lane bend = g.bend + bounds.third * shift;
    const Lane s = magnitude(flight.spin);
    const Lane fastest = Lane(2) * (bounds.drift + body.alpha * s);
    const Lane slack = Lane(32 * unit_roundoff) * (Lane(1) + fastest) * (Lane(1) + fastest * at.time) +
                       rate * shift * Lane(2) * body.side * (bounds.drift + body.outer * s);
    const Lane t = larger(out, in);
    const Lane distance = body.inner - bounds.drift * shift;
    const LaneEnd first{flight.centre, flight.velocity - quarter_turned(flight.swirl), flight.spin, flight.arm,
                        -struck.rate,  struck.bend,                                    out,         Lane(0)};
    const LaneEnd last{at.centre, Plane{-at.drift.x, -at.drift.y}, -flight.spin, search.nearest.arm, rate, bend, in, slack};
    const Mask ring = all(c.first < Lane(0), c.fourth < Lane(0), c.second <= Lane(0), c.third <= Lane(0));
    return all(ring, t * (s * distance + Lane(2) * bounds.drift) <= Lane(0.5) * body.spacing * distance,
               Lane(2) * t * bounds.drift <= distance, only_one_at_wall(body, bounds, first),
               only_one_at_wall(body, bounds, last));
}

/// Polygons' `may_chatter`, negated.
HWY_INLINE Mask leaves_the_wall(const LaneScenes& scenes, int i, const LaneBody& body, const LaneState& z) {
    const LaneContact u = contact_kinematics(body.alpha, body.beta, z);
    const Lane acceleration = body.beta + u.ut * u.ut;
    const Lane from_edge = magnitude(magnitude(z.chi.y) - load(scenes.widest_sine, i));
    return all(leaves_quickly(u.un, load(scenes.chatter, i) * acceleration, z, body.alpha, body.beta),
               from_edge > Lane(2 * neighbour_tolerance));
}

HWY_INLINE LaneFlight flight_from(const LaneBody& body, const LaneState& z) {
    LaneFlight flight;
    flight.arm = body.alpha * z.chi;
    flight.centre = {Lane(1) - flight.arm.x, -flight.arm.y};
    flight.velocity = {z.vn, z.vt};
    flight.phase = {z.psi.x, -z.psi.y};
    flight.beta = body.beta;
    flight.spin = z.spin;
    flight.swirl = flight.beta * flight.phase;
    return flight;
}

/// instant_of_return. @return the lanes in which the usual guess does
HWY_INLINE Mask instant_of_return(const LaneFlight& flight, const LanePath& path, const LaneStart& start,
                                  LaneInstant& at) {
    const Lane guess = return_guess(start);
    const Moment near = moment_near(guess);
    const Lane closer = householder(series_along<5>(path, near));
    const Lane spun = flight.spin * near.time;
    at = instant_after(flight, near, turn_minus_one(spun), closer);
    return all(is_tabled_moment(guess), magnitude(closer) <= Lane(longest_step), near.time + closer > Lane(0),
               magnitude(spun) < Lane(32), magnitude(flight.spin * closer) < Lane(32));
}

/// Lanes `i` … of a block, as many as a vector has.
template <ImpactRule rule, bool sums_chatter>
HWY_INLINE RoundResult look_at_polygons(LaneBlock& block, int i) {
    const LaneScenes& scenes = block.scenes;
    const LaneState z = load_state(block, i);
    const LaneBody body = load_body(scenes, i);
    const LaneFlight flight = flight_from(body, z);
    const Lane speed = magnitude(z.vn) + magnitude(z.vt);
    const LanePath path = circle_path(flight);
    const LaneStart start = gap_at_start(path);
    const LaneGap struck = struck_gap_at_start(flight);
    LaneSearch search;
    Mask usual = instant_of_return(flight, path, start, search.at);
    usual = all(usual, struck.rate < -rate_rounding(speed, body.beta, z.spin, body.alpha));
    if constexpr (sums_chatter) usual = all(usual, leaves_the_wall(scenes, i, body, z));
    const VertexRows vertices{block.vertices, hn::Load(Whole(), scenes.first_vertex + i), load(scenes.sides, i),
                              load(scenes.per_spacing, i)};
    seek_vertex(vertices, flight, fourth_bound(body, flight, speed), usual, search);
    usual = all(search.found, search.at.time + search.correction > Lane(0),
                magnitude(flight.spin * search.correction) < Lane(32),
                clear_by_circumcircle(body, flight, start, struck, search, speed));

    const LaneInstant at = advanced(flight, search.at, search.correction);
    const Plane arm = turned_to(at.arm, search.nearest.number, rows_of_vertex(vertices, search.nearest.number).value);
    const Plane x = at.centre + arm;
    LaneState after;
    after.chi = renormalised(load(scenes.per_alpha, i) * seen_from(x, arm));
    meet_the_wall(x, at.phase, flight, after);
    const LaneImpact impact = impact_of_polygon<rule>(scenes, i, after);

    const Mask done = all(usual, stays_in_range(after, body.beta, body.alpha));
    keep_impact(done, after, at.time, search.looks, impact, search.nearest.number, block, i);
    return {bits_of(done), bits_of(no(done))};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
