// The flight of each lane's polygon from wall to wall: map/first_contact/direct_polygon.hpp, and the impact.
#if defined(SWIRL_MAP_BATCH_POLYGON_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_POLYGON_INL
#undef SWIRL_MAP_BATCH_POLYGON_INL
#else
#define SWIRL_MAP_BATCH_POLYGON_INL
#endif

#include "map/batch/impact-inl.hpp"
#include "map/batch/proofs-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// A moment near a guess, and the way from it to the place where the centre is back at its first distance.
struct LaneReturn {
    TurnedMoment<Lane> near;
    Lane closer;
    Mask close;
};

HWY_INLINE LaneReturn return_near(const CirclePath<Lane>& path, Lane guess) {
    LaneReturn back;
    back.near = moment_near(guess);
    back.closer = householder(series_along(path, back.near));
    back.close =
        is_tabled_moment(guess) && fabs(back.closer) <= Lane(longest_step) && back.near.time + back.closer > Lane(0);
    return back;
}

/// Lanes in which something is found, and those in which the scalar code does not find it either.
struct Found {
    Mask found, search_failed;
};

/// instant_of_return; guesses between 7.99 and 16 leave.
HWY_INLINE Found instant_of_return(const Flight<Lane>& flight, const CirclePath<Lane>& path,
                                   const CircleGap<Lane>& start, Instant<Lane>& at, Lane& latest) {
    const Lane guess = return_guess(start);
    LaneReturn back = return_near(path, guess);
    const Mask sampled =
        hn::AndNot(back.close || (guess >= Lane(7.99) && guess <= Lane(longest_guess)), Lane(0) < Lane(1));
    Mask search_failed = Lane(1) < Lane(0);
    if (any(sampled)) {
        const Lane other_guess = sampled_guess(path, sampled);
        const LaneReturn other = return_near(path, other_guess);
        const Mask far = is_tabled_moment(other_guess) && !(fabs(other.closer) <= Lane(longest_step));
        search_failed = hn::And(sampled, other_guess <= Lane(0) || far);
        back.near = {choose(sampled, other.near.time, back.near.time), choose(sampled, other.near.turn, back.near.turn),
                     choose(sampled, other.near.rest, back.near.rest)};
        back.closer = choose(sampled, other.closer, back.closer);
        back.close = back.close || hn::And(sampled, other.close);
    }
    const Lane spun = flight.spin * back.near.time;
    at = instant_after(flight, back.near, turn_by_table(spun), back.closer);
    latest = max(back.near.time, at.time);
    return {back.close && fabs(spun) < Lane(32) && fabs(flight.spin * back.closer) < Lane(32), search_failed};
}

/// `CollisionMap::strike`: the state in the axes of the contact, before the impact.
HWY_INLINE PostImpactState<Lane> state_at_wall(const Body<Lane>& body, const Flight<Lane>& flight,
                                               const Instant<Lane>& at, Lane vertex, const VertexRows& vertices) {
    const Rows row = rows_of_vertex(vertices, vertex);
    const Plane arm = turned_to(at.arm, vertex, row.value);
    const Plane x = at.centre + arm;
    PostImpactState<Lane> after;
    turn_to_contact(x, missing_length(x), cross(x, times(at.arm, row.rest)), cross(row.value, row.rest), at.phase, arm,
                    body, flight, after);
    return after;
}

/// Without the proof: contact_of_next_vertex in the lanes in which the circle does not return, contact_of_vertex_behind
/// in those in which the nearest vertex recedes there. Those where it is found.
///   unfinished  lanes in which contact_of_vertex_behind goes on
HWY_INLINE Mask find_behind(const VertexRows& vertices, const Flight<Lane>& flight, Lane fourth, Mask no_return,
                            Mask recedes, LaneSearch& search, Mask& unfinished) {
    const Mask asked = (no_return || recedes);
    unfinished = Lane(1) < Lane(0);
    if (!any(asked)) return asked;
    search.at = choose(no_return, instant_at_start(flight), search.at);
    search.nearest.number = choose(no_return, Lane(0), search.nearest.number);
    search.looks = choose(no_return, Lane(0), search.looks);
    search.latest = choose(no_return, Lane(0), search.latest);
    const Mask found = seek_vertex_behind(vertices, flight, fourth, asked, search, unfinished);
    unfinished = hn::And(unfinished, recedes);
    return found;
}

/// Lanes `i` … of a block, as many as a vector has.
template <ImpactRule rule>
HWY_INLINE RoundResult look_at_polygons(bool sums_chatter, LaneBlock& block, int i) {
    const LaneScenes& scenes = block.scenes;
    const PostImpactState<Lane> z = load_state(block, i);
    const Body<Lane> body = load_body(scenes, i);
    const Flight<Lane> flight = flight_from(body, z);
    const VertexRows vertices = vertex_rows(block, i);
    LaneSearch search;
    const CirclePath<Lane> path = circle_path(flight, flight.beta * flight.phase);
    const CircleGap<Lane> start = gap_at_start(path);
    const Gap<Lane> struck = struck_gap_at_start(flight);
    const Found back = instant_of_return(flight, path, start, search.at, search.latest);
    Mask leaves = struck.rate < -rate_rounding(body, flight);
    if (sums_chatter) leaves = leaves && leaves_the_wall<Shape::polygon>(scenes, i, z);
    const Lane fourth = derivative_bounds<4, Shape::polygon>(body, flight).vertex;
    seek_vertex(vertices, body, flight, fourth, leaves && back.found, search);
    Mask unfinished;
    const Mask behind = find_behind(vertices, flight, fourth, leaves && back.search_failed, leaves && search.recedes,
                                    search, unfinished);
    const Mask found = search.found || behind;
    const Mask late_enough = search.at.time + search.correction > Lane(nearest_share) * search.latest;
    // The scalar code's searches from the circle's return find nothing either; more of these below.
    Mask search_failed =
        hn::AndNot(behind, back.search_failed || search.search_failed) || hn::AndNot(late_enough, found);
    const Mask usual = found && late_enough && fabs(flight.spin * search.correction) < Lane(32);
    const Instant<Lane> at = advanced(flight, search.at, search.correction);
    const Gap<Lane> leaving = leaving_gap(body, flight, start);
    const Mask by_circle = clear_by_circumcircle(body, flight, leaving, centre_gap(body, search.at), struck, search.at,
                                                 search.nearest.gap, search.nearest.arm, search.correction);
    Mask clear = hn::AndNot(behind, hn::And(usual, by_circle));
    const Mask unproven = hn::AndNot(clear, usual);
    if (any(unproven)) {
        Mask by_others;
        clear_by_derivatives({scenes, i, flight, vertices, leaving, struck, search}, at, unproven, by_others);
        clear = (clear || by_others);
        // Where the body has turned by less, every moment between is one that the proofs here can look at, too.
        search_failed = search_failed || (unproven && !by_others && fabs(flight.spin * at.time) < Lane(32));
    }

    PostImpactState<Lane> after = state_at_wall(load_body(scenes, i), flight, at, search.nearest.number, vertices);
    const LaneImpact impact = impact_of_polygon<rule>(scenes, i, after);

    const Mask done = clear && stays_in_range(after, body);
    keep_impact(done, after, at.time, search.looks, impact, search.nearest.number, block, i);
    return {bits_of(done), bits_of(!done), bits_of(leaves && hn::AndNot(unfinished, search_failed))};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
