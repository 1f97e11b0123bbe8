// The flight of each lane's polygon from wall to wall: map/first_contact/direct_polygon.hpp with its first proof,
// `clear_by_circumcircle`, and the impact.
#if defined(SWIRL_MAP_BATCH_POLYGON_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_POLYGON_INL
#undef SWIRL_MAP_BATCH_POLYGON_INL
#else
#define SWIRL_MAP_BATCH_POLYGON_INL
#endif

#include "map/batch/impact-inl.hpp"
#include "map/batch/proofs-inl.hpp"
#include "map/sustained/chatter_completion.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// Polygons' `may_chatter`, negated.
HWY_INLINE Mask leaves_the_wall(const LaneScenes& scenes, int i, const LaneBody& body, const LaneState& z) {
    const LaneContact u = contact_kinematics(body.alpha, body.beta, z);
    const Lane acceleration = body.beta + u.ut * u.ut;
    const Lane from_edge = magnitude(magnitude(z.chi.y) - load(scenes.widest_sine, i));
    return all(leaves_quickly(u.un, load(scenes.chatter, i) * acceleration, z, body.alpha, body.beta),
               from_edge > Lane(2 * neighbour_tolerance<double>()));
}

HWY_INLINE LaneFlight flight_from(const LaneBody& body, LaneFactor alpha, const LaneState& z) {
    LaneFlight flight;
    flight.arm = alpha * z.chi;
    flight.centre = {Lane(1) - flight.arm.x, -flight.arm.y};
    flight.velocity = {z.vn, z.vt};
    flight.phase = {z.psi.x, -z.psi.y};
    flight.beta = body.beta;
    flight.spin = z.spin;
    flight.swirl = flight.beta * flight.phase;
    return flight;
}

/// sampled_guess, in the lanes that want it; −1 if the gap stays negative.
HWY_INLINE Lane sampled_guess(const LanePath& path, Mask wanted) {
    Lane guess(-1), before(0);
    std::size_t step = 2;
    for (std::size_t k = step; k < sixty_fourths && any(wanted); k += step) {
        const Lane time(static_cast<double>(k) / 64);
        const TabledVector& turn = turns_of_sixty_fourths[k];
        const Lane gap =
            time * (path.slope + path.speed2 * time) - Lane(2) * ((path.a0 + path.a1 * time) * Lane(turn.value.x) +
                                                                  (path.b0 + path.b1 * time) * Lane(turn.value.y));
        const Mask crossed = hn::And(wanted, gap > Lane(0));
        guess = choose(crossed, time - Lane(static_cast<double>(step) / 64) * gap / (gap - before), guess);
        wanted = hn::AndNot(crossed, wanted);
        before = gap;
        if (step < 16) step = k;
    }
    return guess;
}

/// A moment near a guess, and the way from it to the place where the centre is back at its first distance.
struct LaneReturn {
    Moment near;
    Lane closer;
    Mask close;
};

HWY_INLINE LaneReturn return_near(const LanePath& path, Lane guess) {
    LaneReturn back;
    back.near = moment_near(guess);
    back.closer = householder(series_along<5>(path, back.near));
    back.close = all(is_tabled_moment(guess), magnitude(back.closer) <= Lane(longest_step),
                     back.near.time + back.closer > Lane(0));
    return back;
}

/// Lanes in which something is found, and those in which the scalar code does not find it either.
struct Found {
    Mask found, search_failed;
};

/// instant_of_return; guesses between 7.99 and 16 leave.
HWY_INLINE Found instant_of_return(const LaneFlight& flight, const LanePath& path, const LaneStart& start,
                                   LaneInstant& at, Lane& latest) {
    const Lane guess = return_guess(start);
    LaneReturn back = return_near(path, guess);
    const Mask sampled =
        hn::AndNot(either(back.close, all(guess >= Lane(7.99), guess <= Lane(longest_guess))), Lane(0) < Lane(1));
    Mask search_failed = Lane(1) < Lane(0);
    if (any(sampled)) {
        const Lane other_guess = sampled_guess(path, sampled);
        const LaneReturn other = return_near(path, other_guess);
        const Mask far = all(is_tabled_moment(other_guess), no(magnitude(other.closer) <= Lane(longest_step)));
        search_failed = hn::And(sampled, either(other_guess <= Lane(0), far));
        back.near = {choose(sampled, other.near.time, back.near.time), choose(sampled, other.near.turn, back.near.turn),
                     choose(sampled, other.near.rest, back.near.rest)};
        back.closer = choose(sampled, other.closer, back.closer);
        back.close = either(back.close, hn::And(sampled, other.close));
    }
    const Lane spun = flight.spin * back.near.time;
    at = instant_after(flight, back.near, cis_minus_one(spun), back.closer);
    latest = larger(back.near.time, at.time);
    return {all(back.close, magnitude(spun) < Lane(32), magnitude(flight.spin * back.closer) < Lane(32)),
            search_failed};
}

/// `CollisionMap::strike`: the state in the axes of the contact, before the impact.
HWY_INLINE LaneState state_at_wall(LaneFactor inverse_alpha, const LaneFlight& flight, const LaneInstant& at,
                                   Lane vertex, const VertexRows& vertices) {
    const Rows row = rows_of_vertex(vertices, vertex);
    const Plane arm = turned_to(at.arm, vertex, row.value);
    const Plane x = at.centre + arm;
    const Plane seen = seen_from(x, flight.velocity);
    const Lane turn = cross(x, times(at.arm, row.rest));
    const Plane velocity = seen + seen_from(Plane{missing_length(x), turn}, seen);
    LaneState after;
    after.psi = renormalised(seen_from(at.phase, x), turn);
    after.chi = renormalised(inverse_alpha * seen_from(x, arm), cross(row.value, row.rest) - turn);
    after.vn = velocity.x;
    after.vt = velocity.y;
    after.spin = flight.spin;
    return after;
}

/// Without the proof: contact_of_next_vertex in the lanes in which the circle does not return, contact_of_vertex_behind
/// in those in which the nearest vertex recedes there. Those where it is found.
///   unfinished  lanes in which contact_of_vertex_behind goes on
HWY_INLINE Mask find_behind(ProofTask& task, Lane fourth, Mask no_return, Mask recedes, Mask& unfinished) {
    const Mask asked = either(no_return, recedes);
    unfinished = Lane(1) < Lane(0);
    if (!any(asked)) return asked;
    LaneSearch& search = task.search;
    search.at = choose(no_return, instant_at_start(task.flight), search.at);
    search.nearest.number = choose(no_return, Lane(0), search.nearest.number);
    search.looks = choose(no_return, Lane(0), search.looks);
    search.latest = choose(no_return, Lane(0), search.latest);
    const Mask found = seek_vertex_behind(task.vertices, task.flight, fourth, asked, search, unfinished);
    unfinished = hn::And(unfinished, recedes);
    return found;
}

/// Lanes `i` … of a block, as many as a vector has.
template <ImpactRule rule>
HWY_INLINE RoundResult look_at_polygons(bool sums_chatter, LaneBlock& block, int i) {
    const LaneScenes& scenes = block.scenes;
    const LaneState z = load_state(block, i);
    ProofTask task;
    task.body = load_body(scenes, i);
    task.flight = flight_from(task.body, load(scenes.unbiased_alpha, i), z);
    task.vertices = vertex_rows(block, i);
    task.speed = magnitude(z.vn) + magnitude(z.vt);
    const LaneBody& body = task.body;
    const LaneFlight& flight = task.flight;
    LaneSearch& search = task.search;
    const LanePath path = circle_path(flight);
    task.start = gap_at_start(path);
    task.struck = struck_gap_at_start(flight);
    const Found back = instant_of_return(flight, path, task.start, search.at, search.latest);
    Mask leaves = task.struck.rate < -rate_rounding(task.speed, body.beta, z.spin, body.alpha);
    if (sums_chatter) leaves = all(leaves, leaves_the_wall(scenes, i, body, z));
    const Lane fourth = fourth_bound(body, flight, task.speed);
    seek_vertex(task.vertices, body.half_slope, flight, fourth, all(leaves, back.found), search);
    Mask unfinished;
    const Mask behind =
        find_behind(task, fourth, all(leaves, back.search_failed), all(leaves, search.recedes), unfinished);
    const Mask found = either(search.found, behind);
    const Mask late_enough = search.at.time + search.correction > Lane(nearest_share) * search.latest;
    // The scalar code's searches from the circle's return find nothing either; more of these below.
    Mask search_failed =
        either(hn::AndNot(behind, either(back.search_failed, search.search_failed)), hn::AndNot(late_enough, found));
    const Mask usual = all(found, late_enough, magnitude(flight.spin * search.correction) < Lane(32));
    const LaneInstant at = advanced(flight, search.at, search.correction);
    Mask clear = hn::AndNot(behind, hn::And(usual, clear_by_circumcircle(task)));
    const Mask unproven = hn::AndNot(clear, usual);
    if (any(unproven)) {
        Mask by_others;
        clear_by_derivatives(task, at, unproven, by_others);
        clear = either(clear, by_others);
        // Where the body has turned by less, every moment between is one that the proofs here can look at, too.
        search_failed =
            either(search_failed, all(unproven, no(by_others), magnitude(flight.spin * at.time) < Lane(32)));
    }

    LaneState after =
        state_at_wall(load(scenes.unbiased_inverse_alpha, i), flight, at, search.nearest.number, task.vertices);
    const LaneImpact impact = impact_of_polygon<rule>(scenes, i, after);

    const Mask done = all(clear, stays_in_range(after, body.beta, body.alpha));
    keep_impact(done, after, at.time, search.looks, impact, search.nearest.number, block, i);
    return {bits_of(done), bits_of(no(done)), bits_of(all(leaves, hn::AndNot(unfinished, search_failed)))};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
