// A moment of a polygon's flight and the vertex nearest to the wall then, in lanes: map/model/flight.hpp,
// map/first_contact/vertices.hpp, and the search of direct_polygon.hpp.
#if defined(SWIRL_MAP_BATCH_VERTICES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_VERTICES_INL
#undef SWIRL_MAP_BATCH_VERTICES_INL
#else
#define SWIRL_MAP_BATCH_VERTICES_INL
#endif

#include "map/batch/formulas-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// `advance`, where |step| and |S step| < 32.
HWY_INLINE Instant<Lane> advanced(const Flight<Lane>& flight, Instant<Lane> at, Lane step) {
    advance<Shape::polygon>(flight, at, step);
    return at;
}

HWY_INLINE Instant<Lane> choose(Mask condition, const Instant<Lane>& yes, const Instant<Lane>& otherwise) {
    return {choose(condition, yes.time, otherwise.time),
            choose(condition, yes.phase, otherwise.phase),
            choose(condition, yes.arm, otherwise.arm),
            choose(condition, yes.moved, otherwise.moved),
            choose(condition, yes.arm_moved, otherwise.arm_moved),
            choose(condition, yes.centre, otherwise.centre),
            choose(condition, yes.swirl, otherwise.swirl),
            choose(condition, yes.drift, otherwise.drift)};
}

/// The tabled rotations of a polygon's vertices, for its lanes.
struct VertexRows {
    const double* numbers;
    Wholes first;
    Lane sides, per_spacing;
    Mask short_sides;
    bool some_short;  ///< in a lane at least
};

HWY_INLINE VertexRows vertex_rows(const LaneBlock& block, int i) {
    const LaneScenes& scenes = block.scenes;
    const Mask short_sides = load(scenes.side, i) < Lane(swirl::Body<double>::longest_short_side);
    return {block.vertices,        hn::Load(Whole(), scenes.first_vertex + i),
            load(scenes.sides, i), load(scenes.per_spacing, i),
            short_sides,           any(short_sides)};
}

struct LaneVertex {
    Lane number;  ///< 0 … N − 1
    Rows row;     ///< its rotation
    Plane arm;
    Gap<Lane> gap;
    Mask known;  ///< there is a direction to it
};

HWY_INLINE LaneVertex choose(Mask condition, const LaneVertex& yes, const LaneVertex& otherwise) {
    const Gap<Lane>&a = yes.gap, &b = otherwise.gap;
    return {
        choose(condition, yes.number, otherwise.number),
        {choose(condition, yes.row.value, otherwise.row.value), choose(condition, yes.row.rest, otherwise.row.rest)},
        choose(condition, yes.arm, otherwise.arm),
        {choose(condition, a.value, b.value), choose(condition, a.rate, b.rate),
         choose(condition, a.curvature, b.curvature), choose(condition, a.jerk, b.jerk)},
        hn::And(condition, yes.known) || hn::AndNot(condition, otherwise.known)};
}

HWY_INLINE Plane turned_to(const Plane& v, Lane number, const Plane& rotation) {
    return choose(equal(number, Lane(0)), v, times(v, rotation));
}

HWY_INLINE Rows rows_of_vertex(const VertexRows& vertices, Lane number) {
    const Mask exists = number >= Lane(0) && number < vertices.sides;  // not in a lane without an orbit
    const Lane whole = choose(exists, number, Lane(0)) + Lane(0x1.8p52);
    const Wholes k = hn::And(bits_in(whole), hn::Set(Whole(), 2047));
    return rows_of(vertices.numbers, hn::Add(vertices.first, k));
}

/// The gap of the vertex `number`; the struck one's is 0.
HWY_INLINE Gap<Lane> gap_of(const VertexRows& vertices, const Flight<Lane>& flight, const Instant<Lane>& at,
                            Lane number, const Rows& row, const Plane& arm) {
    Gap<Lane> gap = vertex_gap(flight, at, arm);
    const Lane struck = struck_value(at);
    gap.value = gap.value + Lane(2) * dot(at.centre + arm, times(at.arm, row.rest));
    if (vertices.some_short)
        gap.value = choose(vertices.short_sides, short_side_value(at, minus_one(row.value, row.rest)), gap.value);
    gap.value = choose(equal(number, Lane(0)), struck, gap.value);
    return gap;
}

/// vertex_towards, and its arm.
HWY_INLINE void turn_towards(const VertexRows& vertices, const Instant<Lane>& at, LaneVertex& nearest) {
    const Plane between = seen_from(at.arm, at.centre);
    const Lane number = rough_angle(between.y, between.x) * vertices.per_spacing;
    nearest.known = fabs(number) < vertices.sides;
    const Lane k = (choose(nearest.known, number, Lane(0)) + Lane(0x1.8p52)) - Lane(0x1.8p52);
    nearest.number = choose(k < Lane(0), k + vertices.sides, k);
    nearest.row = rows_of_vertex(vertices, nearest.number);
    nearest.arm = turned_to(at.arm, nearest.number, nearest.row.value);
}

/// At another moment: the vertex of the look before where that is still nearest.
HWY_INLINE void stay_or_turn(const VertexRows& vertices, const Body<Lane>& body, const Instant<Lane>& at,
                             LaneVertex& nearest) {
    nearest.arm = turned_to(at.arm, nearest.number, nearest.row.value);
    const Mask stays = is_nearest(body, at.centre, nearest.arm);
    if (!any(!stays)) return;
    LaneVertex other;
    turn_towards(vertices, at, other);
    nearest.known = stays || other.known;
    nearest.number = choose(stays, nearest.number, other.number);
    nearest.row = {choose(stays, nearest.row.value, other.row.value), choose(stays, nearest.row.rest, other.row.rest)};
    nearest.arm = choose(stays, nearest.arm, other.arm);
}

/// Where a search has come to.
struct LaneSearch {
    Instant<Lane> at;
    LaneVertex nearest;
    Lane correction, looks;
    Lane latest;  ///< moment so far
    Mask found;
    Mask search_failed;  ///< the scalar search gives up, too …
    Mask recedes;        ///< … where the nearest vertex recedes, after `looks`
};

/// Lanes that need more looks than this leave: they are few, and all the others wait for them.
inline constexpr int most_looks = 4;

/// seek_vertex from `search.at`, in the lanes that are `open`.
HWY_INLINE void seek_vertex(const VertexRows& vertices, const Body<Lane>& body, const Flight<Lane>& flight, Lane fourth,
                            Mask open, LaneSearch& search) {
    search.found = Lane(1) < Lane(0);
    search.search_failed = search.recedes = search.found;
    search.looks = Lane(0);
    for (int look = 1;; ++look) {
        // Lanes that have found theirs see the same once more.
        LaneVertex& nearest = search.nearest;
        if (look == 1)
            turn_towards(vertices, search.at, nearest);
        else
            stay_or_turn(vertices, body, search.at, nearest);
        nearest.gap = gap_of(vertices, flight, search.at, nearest.number, nearest.row, nearest.arm);
        const Gap<Lane>& g = nearest.gap;
        search.correction = householder(g);
        open = open && nearest.known;
        const Mask leads_on = open && g.rate > Lane(0) && fabs(search.correction) <= Lane(longest_correction);
        const Mask fails = hn::AndNot(leads_on, open);
        search.search_failed = search.search_failed || fails;
        search.recedes = search.recedes || hn::And(fails, g.rate <= Lane(0));
        search.looks = choose(fails, Lane(look), search.looks);
        open = leads_on;
        const Mask now = open && is_converged(g, search.correction, search.at.time, fourth);
        search.looks = choose(now, Lane(look), search.looks);
        search.found = search.found || now;
        open = hn::AndNot(now, open);
        if (look == most_looks || !any(open)) return;
        open = open && fabs(flight.spin * search.correction) < Lane(32);
        search.at = choose(open, advanced(flight, search.at, search.correction), search.at);
        search.latest = max(search.latest, search.at.time);
    }
}

/// The search of strike_by_vertex in the lanes `asked` for: at the vertex behind `search.nearest`, from `search.at` on.
/// Where it is not found nothing changes.
///   unfinished  lanes in which the scalar search goes on
HWY_INLINE Mask seek_vertex_behind(const VertexRows& vertices, const Flight<Lane>& flight, Lane fourth, Mask asked,
                                   LaneSearch& search, Mask& unfinished) {
    Instant<Lane> at = search.at;
    Lane latest = search.latest;
    LaneVertex next = search.nearest;
    const Lane k = next.number + choose(flight.spin > Lane(0), Lane(-1), Lane(1));
    next.number = choose(k < Lane(0), k + vertices.sides, choose(equal(k, vertices.sides), Lane(0), k));
    next.row = rows_of_vertex(vertices, next.number);
    Mask all_found = Lane(1) < Lane(0);
    Mask open = asked;
    unfinished = all_found;
    for (int look = 1;; ++look) {
        next.arm = turned_to(at.arm, next.number, next.row.value);
        next.gap = gap_of(vertices, flight, at, next.number, next.row, next.arm);
        const Gap<Lane>& g = next.gap;
        const Lane correction = householder(g);
        open = open && g.rate > Lane(0) && fabs(correction) <= Lane(longest_correction);
        const Mask found = open && is_converged(g, correction, at.time, fourth);
        search.at = choose(found, at, search.at);
        search.latest = choose(found, latest, search.latest);
        search.nearest = choose(found, next, search.nearest);
        search.correction = choose(found, correction, search.correction);
        search.looks = choose(found, search.looks + Lane(look), search.looks);
        all_found = (all_found || found);
        const Mask left = hn::AndNot(found, open);
        open = left && fabs(flight.spin * correction) < Lane(32);
        unfinished = unfinished || (look == most_looks ? left : hn::AndNot(open, left));
        if (look == most_looks || !any(open)) return all_found;
        at = choose(open, advanced(flight, at, correction), at);
        latest = max(latest, at.time);
    }
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
