// One look at the flight of each lane's disk: map/first_contact/certain_disk.hpp (`direct_contact_disk`) and the impact
// of map/collision_map.hpp.
#if defined(SWIRL_MAP_BATCH_DISK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_DISK_INL
#undef SWIRL_MAP_BATCH_DISK_INL
#else
#define SWIRL_MAP_BATCH_DISK_INL
#endif

#include "map/batch/struck-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// What a flight and its bounds read. No more: GCC loads at the first call of `load_body` whatever later ones read, and
/// numbers that only the impact needs would lie in registers or on the stack until then (4 % of the time of AVX2).
HWY_INLINE Body<Lane> load_flying_disk(const LaneScenes& scenes, int i) {
    Body<Lane> body;
    body.alpha = load(scenes.alpha, i);
    body.beta = load(scenes.beta, i);
    body.outer = load(scenes.outer, i);
    body.unbiased_inner = load(scenes.unbiased_inner, i);
    return body;
}

template <ImpactRule rule>
HWY_INLINE LaneImpact impact_of_disk(const LaneScenes& scenes, int i, PostImpactState<Lane>& z) {
    const Lane alpha = load(scenes.alpha, i), beta = load(scenes.beta, i);
    const Lane restitution = load(scenes.restitution, i), mu = load(scenes.mu, i);
    const Lane normal = z.vn - beta * z.psi.y;
    const Lane un = choose(normal < Lane(0), Lane(0), normal);
    const Lane end = (Lane(1) + restitution) * un;
    if constexpr (rule == ImpactRule::frictionless) {
        z.vn = z.vn - end;
        return {end, Lane(0), Lane(static_cast<double>(ContactMode::frictionless))};
    } else {
        const Lane ut = (z.vt + alpha * z.spin) - beta * z.psi.x;
        const Lane stick = -load(scenes.disk_grip, i) * ut;
        const Mask slides = fabs(stick) > mu * end;
        const Lane q = choose(slides, choose(ut > Lane(0), -mu * end, mu * end), stick);
        const Mask early = fabs(stick) < mu * un;
        const Lane change = alpha * load(scenes.inverse_inertia, i) * q;
        z.vn = z.vn - end;
        z.vt = z.vt + q;
        z.spin = z.spin + change;
        return {end, q,
                choose(slides, Lane(static_cast<double>(ContactMode::sliding)),
                       choose(early, Lane(static_cast<double>(ContactMode::c_sticking)),
                              Lane(static_cast<double>(ContactMode::r_sticking))))};
    }
}

/// `touch_at_root` and `CollisionMap::strike`, `first` + `second` after a moment.
///   after  the state after the impact
template <ImpactRule rule>
HWY_INLINE LaneImpact strike_disk(const LaneScenes& scenes, int i, const Flight<Lane>& flight,
                                  const TurnedMoment<Lane>& near, Lane first, Lane second,
                                  PostImpactState<Lane>& after) {
    Instant<Lane> at = instant_at<Shape::disk>(flight, near.time + first, turn_after(near, first));
    advance_slightly(flight, at, second);
    const Plane x = load(scenes.unbiased_inverse_inner, i) * at.centre;
    turn_to_contact(x, missing_length(x), at.phase, flight, after);
    return impact_of_disk<rule>(scenes, i, after);
}

/// Lanes `i` … of a block, as many as a vector has.
template <ImpactRule rule>
HWY_INLINE RoundResult look_at_disks(bool sums_chatter, LaneBlock& block, int i) {
    const LaneScenes& scenes = block.scenes;
    const Body<Lane> body = load_flying_disk(scenes, i);
    const PostImpactState<Lane> z = load_state(block, i);
    // The bits of the sum of two products with χ = (1, 0): the two parts of α add up to it.
    const Flight<Lane> flight = flight_with(body.alpha * z.chi, body.beta, z);
    const CirclePath<Lane> path = circle_path_from_wall(body, flight, flight.beta * flight.phase);
    const CircleGap<Lane> start = gap_at_start(path);
    Mask usual = start.rate < -rate_rounding(body, flight);
    if (sums_chatter) usual = usual && leaves_the_wall<Shape::disk>(scenes, i, z);

    const Lane stored = load(block.guess, i);
    const Lane guess = choose(stored > Lane(0), stored, return_guess(start));
    const Lane looks = load(block.looks, i) + Lane(1);
    const TurnedMoment<Lane> near = moment_near(guess);
    const GapSeries<Lane> gap = series_along(path, near);
    const SeriesRoot<Lane> root = root_of(gap);
    const Lane time = near.time + (root.first + root.second);
    const Mask leads_on = root.rate > Lane(0) && fabs(root.first) + fabs(root.second) <= Lane(longest_correction);
    // The scalar code's search ends without success here …
    const Mask ended = usual && (!(guess > Lane(0) && guess <= Lane(longest_guess)) || looks > Lane(correction_limit));
    const Mask looked = usual && is_tabled_moment(guess) && looks <= Lane(correction_limit);
    const Mask converged = is_converged(root, time, derivative_bounds<11, Shape::disk>(body, flight).centre);
    const Mask clear =
        clear_between<Lane>(start, gap_at(gap, root), time, derivative_bounds<6, Shape::disk>(body, flight).centre);

    PostImpactState<Lane> after;
    const LaneImpact impact = strike_disk<rule>(scenes, i, flight, near, root.first, root.second, after);

    const Mask found = looked && leads_on && time > Lane(0);
    const Mask struck = found && converged && is_small(root.first) && clear && stays_in_range(after, body);
    const Mask again = found && !converged;
    // … and here, or what it finds is not proven.
    const Mask search_failed = ended || (looked && (!(leads_on && time > Lane(0)) || (converged && !clear)));
    keep_impact(struck, after, time, looks, impact, Lane(0), block, i);
    store(choose(again, time, Lane(0)), block.guess, i);
    store(choose(again, looks, Lane(0)), block.looks, i);
    return {bits_of(struck), bits_of(!(struck || again)), bits_of(search_failed)};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
