// One look at the flight of each lane's disk: map/first_contact/certain_disk.hpp (`direct_contact_disk`) and the impact
// of map/collision_map.hpp.
#if defined(SWIRL_MAP_BATCH_DISK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_DISK_INL
#undef SWIRL_MAP_BATCH_DISK_INL
#else
#define SWIRL_MAP_BATCH_DISK_INL
#endif

#include "map/batch/path-inl.hpp"
#include "map/batch/struck-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

struct LaneRoot {
    Lane first, second, value, rate, half_curvature;
};

HWY_INLINE LaneRoot root_of(const LaneSeries& g) {
    const Lane* c = g.c;
    LaneRoot root;
    root.first = householder(g);
    const Lane d = root.first;
    const Lane d2 = d * d;
    const Lane d4 = d2 * d2;
    root.value = ((c[0] + c[1] * d) + d2 * (c[2] + c[3] * d)) +
                 d4 * (((c[4] + c[5] * d) + d2 * (c[6] + c[7] * d)) + d4 * ((c[8] + c[9] * d) + d2 * c[10]));
    root.rate = ((c[1] + Lane(2) * c[2] * d) + d2 * (Lane(3) * c[3] + Lane(4) * c[4] * d)) +
                d4 * (((Lane(5) * c[5] + Lane(6) * c[6] * d) + d2 * (Lane(7) * c[7] + Lane(8) * c[8] * d)) +
                      d4 * (Lane(9) * c[9] + Lane(10) * c[10] * d));
    root.half_curvature = ((c[2] + Lane(3) * c[3] * d) + d2 * (Lane(6) * c[4] + Lane(10) * c[5] * d)) +
                          d4 * ((Lane(15) * c[6] + Lane(21) * c[7] * d) + d2 * (Lane(28) * c[8] + Lane(36) * c[9] * d));
    root.second = -(root.value * root.rate) / (root.rate * root.rate - root.value * root.half_curvature);
    return root;
}

HWY_INLINE LaneGap gap_at(const LaneSeries& g, const LaneRoot& root) {
    const Lane jerk = Lane(6) * (g.c[3] + Lane(4) * g.c[4] * root.first);
    return {Lane(0), root.rate + Lane(2) * root.second * root.half_curvature,
            Lane(2) * root.half_curvature + root.second * jerk, jerk};
}

HWY_INLINE Mask is_converged(const LaneRoot& root, Lane time, Lane eleventh) {
    const Lane small = Lane(0x1p-17 / 8);
    const Lane size = magnitude(root.second);
    const Lane d = magnitude(root.first);
    const Lane d2 = d * d;
    const Lane d4 = d2 * d2;
    return all(
        size <= small, size * magnitude(root.half_curvature) <= small * root.rate,
        magnitude(root.value) <= Lane(2) * root.rate * size,
        eleventh * (d4 * d4 * (d2 * d)) * fraction(1, 39916800) <= Lane(1.0 / 1024 * unit_roundoff) * root.rate * time);
}

/// Disks' `may_chatter`, negated. Bits of `contact_kinematics` with χ = 0.
HWY_INLINE Mask leaves_the_wall(const LaneScenes& scenes, int i, const LaneState& z) {
    const Lane alpha = load(scenes.alpha, i), beta = load(scenes.beta, i);
    const Lane un = z.vn - z.spin * (alpha * z.chi.y) - beta * z.psi.y;
    const Lane ut = z.vt + z.spin * (alpha * z.chi.x) - beta * z.psi.x;
    const Lane along = ut - alpha * z.spin;
    const Lane acceleration = beta + along * along * load(scenes.inverse_inner, i);
    return leaves_quickly(un, load(scenes.chatter, i) * acceleration, z, alpha, beta);
}

/// `CollisionMap::strike`: ψ and the velocity in the axes of the contact at x.
HWY_INLINE void meet_the_wall(Plane x, Plane phase, const LaneFlight& flight, LaneState& after) {
    const Lane longer = missing_length(x);
    const Plane velocity = seen_from(x, flight.velocity);
    after.psi = renormalised(seen_from(phase, x));
    after.chi = {Lane(1), Lane(0)};
    after.vn = velocity.x + longer * velocity.x;
    after.vt = velocity.y + longer * velocity.y;
    after.spin = flight.spin;
}

/// The disk at its contact: centre and the swirl's direction.
struct DiskAtWall {
    Lane time;
    Plane centre, phase;
};

/// instant_at<disk>, then advance_slightly.
HWY_INLINE DiskAtWall disk_at_wall(const LaneFlight& flight, const Moment& near, const LaneRoot& root, Lane time) {
    const Plane turn = turn_after(near, root.first);
    Plane moved = (near.time + root.first) * flight.velocity - flight.beta * times(flight.phase, turn);
    Plane phase = turned(flight.phase, turn);
    const Plane swirl = flight.beta * phase;
    const Plane drift = flight.velocity - quarter_turned(swirl);
    const Lane step = root.second;
    const Lane half = Lane(0.5) * step * step;
    moved = moved + (step * drift + half * swirl);
    phase = turned(phase, Plane{-half, step});
    return {time, flight.centre + moved, phase};
}

template <ImpactRule rule>
HWY_INLINE LaneImpact impact_of_disk(const LaneScenes& scenes, int i, LaneState& z) {
    const Lane beta = load(scenes.beta, i), alpha = load(scenes.alpha, i);
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
        const Mask slides = magnitude(stick) > mu * end;
        const Lane q = choose(slides, choose(ut > Lane(0), -mu * end, mu * end), stick);
        const Mask early = magnitude(stick) < mu * un;
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

/// Lanes `i` … of a block, as many as a vector has.
template <ImpactRule rule>
HWY_INLINE RoundResult look_at_disks(bool sums_chatter, LaneBlock& block, int i) {
    const LaneScenes& scenes = block.scenes;
    const LaneState z = load_state(block, i);
    const Lane alpha = load(scenes.alpha, i);
    LaneFlight flight;
    flight.arm = alpha * z.chi;
    flight.centre = {Lane(1) - flight.arm.x, -flight.arm.y};
    flight.velocity = {z.vn, z.vt};
    flight.phase = {z.psi.x, -z.psi.y};
    flight.beta = load(scenes.beta, i);
    flight.spin = z.spin;
    flight.swirl = flight.beta * flight.phase;

    const LanePath path = circle_path_from_wall(load(scenes.unbiased_inner, i), flight);
    const LaneStart start = gap_at_start(path);
    const Lane speed = magnitude(z.vn) + magnitude(z.vt);
    Mask usual = start.rate < -rate_rounding(speed, flight.beta, z.spin, alpha);
    if (sums_chatter) usual = all(usual, leaves_the_wall(scenes, i, z));

    const Lane stored = load(block.guess, i);
    const Lane guess = choose(stored > Lane(0), stored, return_guess(start));
    const Lane looks = load(block.looks, i) + Lane(1);
    const Moment near = moment_near(guess);
    const LaneSeries gap = series_along<11>(path, near);
    const LaneRoot root = root_of(gap);
    const Lane time = near.time + (root.first + root.second);
    const Mask leads_on =
        all(root.rate > Lane(0), magnitude(root.first) + magnitude(root.second) <= Lane(longest_correction));
    const Mask looked = all(usual, is_tabled_moment(guess), looks <= Lane(correction_limit));
    const Mask near_enough = all(leads_on, is_small(root.first));
    usual = all(looked, near_enough, time > Lane(0));
    const Lane outer = load(scenes.outer, i);
    const Mask converged = is_converged(root, time, centre_bound(11, flight.beta, outer, speed));
    const Mask clear = clear_between({Lane(0), start.rate, start.curvature, start.jerk}, gap_at(gap, root), time,
                                     centre_bound(6, flight.beta, outer, speed));

    const DiskAtWall at = disk_at_wall(flight, near, root, time);
    LaneState after;
    meet_the_wall(load(scenes.unbiased_inverse_inner, i) * at.centre, at.phase, flight, after);
    const LaneImpact impact = impact_of_disk<rule>(scenes, i, after);

    const Mask struck = all(usual, converged, clear, stays_in_range(after, flight.beta, alpha));
    const Mask again = all(usual, no(converged));
    const Mask search_failed =
        all(looked, either(no(leads_on), all(near_enough, converged, no(all(clear, time > Lane(0))))));
    keep_impact(struck, after, time, looks, impact, Lane(0), block, i);
    store(choose(again, time, Lane(0)), block.guess, i);
    store(choose(again, looks, Lane(0)), block.looks, i);
    return {bits_of(struck), bits_of(no(either(struck, again))), bits_of(search_failed)};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
