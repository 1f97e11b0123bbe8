// A disk's long or curved flights, of which the direct search finds no contact: `sampled_contact_disk` of
// map/first_contact/certain_disk.hpp, to its end.
#if defined(SWIRL_MAP_BATCH_SAMPLED_DISK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_SAMPLED_DISK_INL
#undef SWIRL_MAP_BATCH_SAMPLED_DISK_INL
#else
#define SWIRL_MAP_BATCH_SAMPLED_DISK_INL
#endif

#include "map/batch/disk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// DiskRoot, with the gap at the root.
struct LaneRoot {
    TurnedMoment<Lane> near;
    Gap<Lane> gap;
    Lane first, second, time, looks;
    Mask found;
};

HWY_INLINE Gap<Lane> choose(Mask condition, const Gap<Lane>& yes, const Gap<Lane>& otherwise) {
    return {choose(condition, yes.value, otherwise.value), choose(condition, yes.rate, otherwise.rate),
            choose(condition, yes.curvature, otherwise.curvature), choose(condition, yes.jerk, otherwise.jerk)};
}

/// seek_disk_root; not found, too, where a moment is not in the table.
HWY_INLINE LaneRoot seek_disk_root(const CirclePath<Lane>& path, Lane guess, Lane eleventh, Mask seeks) {
    LaneRoot root;
    root.looks = Lane(0);
    root.found = Lane(1) < Lane(0);
    root.time = guess;
    root.first = root.second = Lane(0);
    root.near = {Lane(1), {Lane(0), Lane(0)}, {Lane(0), Lane(0)}};
    root.gap = {Lane(0), Lane(0), Lane(0), Lane(0)};
    for (int looks = 0; looks < correction_limit; ++looks) {
        seeks = seeks && is_tabled_moment(root.time);
        if (!any(seeks)) break;
        root.looks = choose(seeks, root.looks + Lane(1), root.looks);
        const TurnedMoment<Lane> near = moment_near(root.time);
        const GapSeries<Lane> series = series_along(path, near);
        const SeriesRoot<Lane> next = root_of(series);
        seeks = seeks && next.rate > Lane(0) && fabs(next.first) + fabs(next.second) <= Lane(longest_correction);
        root.time = choose(seeks, near.time + (next.first + next.second), root.time);
        const Mask converged = seeks && is_converged(next, root.time, eleventh);
        root.near.time = choose(converged, near.time, root.near.time);
        root.near.turn = choose(converged, near.turn, root.near.turn);
        root.near.rest = choose(converged, near.rest, root.near.rest);
        root.gap = choose(converged, gap_at(series, next), root.gap);
        root.first = choose(converged, next.first, root.first);
        root.second = choose(converged, next.second, root.second);
        root.found = root.found || (converged && is_tabled_moment(root.time) && is_small(next.first));
        seeks = hn::AndNot(converged, seeks);
    }
    return root;
}

/// is_clear_in_pieces, in the lanes with a root.
HWY_INLINE Mask is_clear_in_pieces(const CirclePath<Lane>& path, const CircleGap<Lane>& start, const LaneRoot& root,
                                   Lane sixth) {
    Mask proving = root.found;
    Mask clear = Lane(1) < Lane(0);
    Gap<Lane> from = start;
    Lane begin(0);
    Lane piece = root.time;
    for (int looks = 0; looks < most_pieces; ++looks) {
        const Lane left = root.time - begin;
        const Mask last = proving && piece >= left;
        if (any(last)) {
            const Mask proven = last && clear_between(from, root.gap, left, sixth);
            clear = clear || proven;
            proving = hn::AndNot(proven, proving);
            if (!any(proving)) break;
            piece = choose(last, Lane(0.5) * left, piece);
        }
        const TurnedMoment<Lane> middle = moment_near(begin + piece);
        proving = proving && middle.time > begin && middle.time < root.time;
        const GapSeries<Lane> series = series_along(path, middle);
        const Gap<Lane> to{series.c[0], series.c[1], Lane(2) * series.c[2], Lane(6) * series.c[3]};
        const Mask proven = proving && clear_between(from, to, middle.time - begin, sixth);
        from = choose(proven, to, from);
        begin = choose(proven, middle.time, begin);
        piece = choose(proven, root.time, Lane(0.5) * piece);
    }
    return clear;
}

/// Lanes `i` … of a block, as many as a vector has: each is struck or left.
template <ImpactRule rule>
HWY_INLINE RoundResult look_at_sampled_disks(LaneBlock& block, int i) {
    const LaneScenes& scenes = block.scenes;
    const Body<Lane> body = load_flying_disk(scenes, i);
    const PostImpactState<Lane> z = load_state(block, i);
    const Flight<Lane> flight = flight_with(body.alpha * z.chi, body.beta, z);
    const CirclePath<Lane> path = circle_path_from_wall(body, flight, flight.beta * flight.phase);
    const CircleGap<Lane> start = gap_at_start(path);
    const Mask leaves = start.rate < -rate_rounding(body, flight);
    const LaneRoot root = seek_disk_root(path, sampled_guess(path, leaves),
                                         derivative_bounds<11, Shape::disk>(body, flight).centre, leaves);
    const Mask clear = is_clear_in_pieces(path, start, root, derivative_bounds<6, Shape::disk>(body, flight).centre);
    PostImpactState<Lane> after;
    const LaneImpact impact = strike_disk<rule>(scenes, i, flight, root.near, root.first, root.second, after);
    const Mask struck = clear && stays_in_range(after, body);
    keep_impact(struck, after, root.time, root.looks, impact, Lane(0), block, i);
    return {bits_of(struck), bits_of(!struck), 0};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
