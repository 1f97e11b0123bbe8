// A moment of a polygon's flight and the vertex nearest to the wall then, in lanes: map/model/flight.hpp,
// map/first_contact/vertices.hpp, and the search of direct_polygon.hpp.
#if defined(SWIRL_MAP_BATCH_VERTICES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_VERTICES_INL
#undef SWIRL_MAP_BATCH_VERTICES_INL
#else
#define SWIRL_MAP_BATCH_VERTICES_INL
#endif

#include "map/batch/path-inl.hpp"
#include "map/first_contact/direct_polygon.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// Instant; `moved` and `arm_moved` from the start.
struct LaneInstant {
    Lane time;
    Plane phase, arm, moved, arm_moved;
    Plane centre, swirl, drift;  ///< follow from the others
};

HWY_INLINE void complete(const LaneFlight& flight, LaneInstant& at) {
    at.centre = flight.centre + at.moved;
    at.swirl = flight.beta * at.phase;
    at.drift = flight.velocity - quarter_turned(at.swirl);
}

/// cis_minus_one for |δ| < 32; nearly always all lanes are within ¼.
HWY_INLINE Plane turn_of(Lane angle) {
    if (any(no(is_small(angle)))) return cis_minus_one(angle);
    return turn_within_quarter(angle);
}

HWY_INLINE LaneInstant instant_after(const LaneFlight& flight, const Moment& near, Plane spun, Lane later) {
    LaneInstant at;
    const Plane turn = turn_after(near, later);
    at.time = near.time + later;
    at.moved = (near.time * flight.velocity + later * flight.velocity) - flight.beta * times(flight.phase, turn);
    at.phase = turned(flight.phase, turn);
    at.arm_moved = times(flight.arm, compose(spun, turn_of(flight.spin * later)));
    at.arm = flight.arm + at.arm_moved;
    complete(flight, at);
    return at;
}

/// advance<polygon>, where |step| and |S step| < 32.
HWY_INLINE LaneInstant advanced(const LaneFlight& flight, const LaneInstant& from, Lane step) {
    LaneInstant at;
    const Plane turn = turn_of(step);
    at.time = from.time + step;
    at.moved = from.moved + (step * flight.velocity - times(from.swirl, turn));
    at.phase = turned(from.phase, turn);
    const Plane arm_step = times(from.arm, turn_of(flight.spin * step));
    at.arm = from.arm + arm_step;
    at.arm_moved = from.arm_moved + arm_step;
    complete(flight, at);
    return at;
}

HWY_INLINE LaneInstant choose(Mask condition, const LaneInstant& yes, const LaneInstant& otherwise) {
    return {choose(condition, yes.time, otherwise.time),
            choose(condition, yes.phase, otherwise.phase),
            choose(condition, yes.arm, otherwise.arm),
            choose(condition, yes.moved, otherwise.moved),
            choose(condition, yes.arm_moved, otherwise.arm_moved),
            choose(condition, yes.centre, otherwise.centre),
            choose(condition, yes.swirl, otherwise.swirl),
            choose(condition, yes.drift, otherwise.drift)};
}

HWY_INLINE Lane rough_angle(Lane y, Lane x) {
    const Lane a = magnitude(x), b = magnitude(y);
    const Lane t = smaller(a, b) / larger(a, b);
    const Lane s = t * t, s2 = s * s;
    Lane angle =
        t * ((Lane(0.99997726) - Lane(0.33262347) * s) +
             s2 * ((Lane(0.19354346) - Lane(0.11643287) * s) + s2 * (Lane(0.05265332) - Lane(0.01172120) * s)));
    angle = choose(b > a, Lane(M_PI / 2) - angle, angle);
    angle = choose(x < Lane(0), Lane(M_PI) - angle, angle);
    return choose(y < Lane(0), -angle, angle);
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
    const Mask short_sides = load(scenes.side, i) < Lane(Body<double>::longest_short_side);
    return {block.vertices,        hn::Load(Whole(), scenes.first_vertex + i),
            load(scenes.sides, i), load(scenes.per_spacing, i),
            short_sides,           any(short_sides)};
}

struct LaneVertex {
    Lane number;  ///< 0 … N − 1
    Rows row;     ///< its rotation
    Plane arm;
    LaneGap gap;
    Mask known;  ///< there is a direction to it
};

HWY_INLINE LaneVertex choose(Mask condition, const LaneVertex& yes, const LaneVertex& otherwise) {
    const LaneGap &a = yes.gap, &b = otherwise.gap;
    return {
        choose(condition, yes.number, otherwise.number),
        {choose(condition, yes.row.value, otherwise.row.value), choose(condition, yes.row.rest, otherwise.row.rest)},
        choose(condition, yes.arm, otherwise.arm),
        {choose(condition, a.value, b.value), choose(condition, a.rate, b.rate),
         choose(condition, a.curvature, b.curvature), choose(condition, a.jerk, b.jerk)},
        either(hn::And(condition, yes.known), hn::AndNot(condition, otherwise.known))};
}

HWY_INLINE Plane turned_to(const Plane& v, Lane number, const Plane& rotation) {
    return choose(equal(number, Lane(0)), v, times(v, rotation));
}

HWY_INLINE Rows rows_of_vertex(const VertexRows& vertices, Lane number) {
    const Mask exists = all(number >= Lane(0), number < vertices.sides);  // not in a lane without an orbit
    const Lane whole = choose(exists, number, Lane(0)) + Lane(0x1.8p52);
    const Wholes k = hn::And(bits_in(whole), hn::Set(Whole(), 2047));
    return rows_of(vertices.numbers, hn::Add(vertices.first, k));
}

/// short_side_gap of the vertex `row`, from that of the one that has struck.
HWY_INLINE Lane short_side_gap(const LaneInstant& at, const Plane& moved, Lane struck, const Rows& row) {
    const Plane turn{(row.value.x - Lane(1)) + row.rest.x, row.value.y + row.rest.y};
    const Plane apart = times(at.arm, turn);
    return struck + (Lane(2) * apart.x + dot(apart, apart) + Lane(2) * dot(moved, apart));
}

/// vertex_gap, of the struck vertex (number 0) with `struck_gap`'s value.
HWY_INLINE LaneGap gap_of(const VertexRows& vertices, Lane spin, const LaneInstant& at, Lane number, const Rows& row,
                          const Plane& arm) {
    const Lane spin2 = spin * spin;
    const Plane x = at.centre + arm;
    const Plane rate = at.drift + spin * quarter_turned(arm);
    const Plane curvature = at.swirl - spin2 * arm;
    const Plane jerk = quarter_turned(at.swirl - (spin2 * spin) * arm);
    const Plane moved = at.moved + at.arm_moved;
    const Lane struck = Lane(2) * moved.x + dot(moved, moved);
    Lane value = (dot(x, x) - Lane(1)) + Lane(2) * dot(x, times(at.arm, row.rest));
    if (vertices.some_short) value = choose(vertices.short_sides, short_side_gap(at, moved, struck, row), value);
    return {choose(equal(number, Lane(0)), struck, value), Lane(2) * dot(x, rate),
            Lane(2) * (dot(rate, rate) + dot(x, curvature)), Lane(2) * (Lane(3) * dot(rate, curvature) + dot(x, jerk))};
}

/// vertex_towards, and its arm.
HWY_INLINE void turn_towards(const VertexRows& vertices, const LaneInstant& at, LaneVertex& nearest) {
    const Plane between = seen_from(at.arm, at.centre);
    const Lane number = rough_angle(between.y, between.x) * vertices.per_spacing;
    nearest.known = magnitude(number) < vertices.sides;
    const Lane k = (choose(nearest.known, number, Lane(0)) + Lane(0x1.8p52)) - Lane(0x1.8p52);
    nearest.number = choose(k < Lane(0), k + vertices.sides, k);
    nearest.row = rows_of_vertex(vertices, nearest.number);
    nearest.arm = turned_to(at.arm, nearest.number, nearest.row.value);
}

/// is_nearest.
HWY_INLINE Mask is_nearest(Lane half_slope, const LaneInstant& at, const Plane& arm) {
    return magnitude(cross(arm, at.centre)) <= half_slope * dot(arm, at.centre);
}

/// The same at another moment: the vertex of the look before where that is still nearest.
HWY_INLINE void stay_or_turn(const VertexRows& vertices, Lane half_slope, const LaneInstant& at, LaneVertex& nearest) {
    nearest.arm = turned_to(at.arm, nearest.number, nearest.row.value);
    const Mask stays = is_nearest(half_slope, at, nearest.arm);
    if (!any(no(stays))) return;
    LaneVertex other;
    turn_towards(vertices, at, other);
    nearest.known = either(stays, other.known);
    nearest.number = choose(stays, nearest.number, other.number);
    nearest.row = {choose(stays, nearest.row.value, other.row.value), choose(stays, nearest.row.rest, other.row.rest)};
    nearest.arm = choose(stays, nearest.arm, other.arm);
}

HWY_INLINE Lane correction_of(const LaneGap& g) {
    const Lane half_curvature = Lane(0.5) * g.curvature;
    const Lane sixth_jerk = fraction(1, 6) * g.jerk;
    const Lane square = g.rate * g.rate;
    const Lane curvature = half_curvature + half_curvature;
    return -(g.value * (square - g.value * half_curvature)) /
           (g.rate * (square - g.value * curvature) + g.value * (g.value * sixth_jerk));
}

HWY_INLINE Mask is_converged(const LaneGap& gap, Lane correction, Lane time, Lane fourth) {
    const Lane small(0x1p-13 / 4);
    const Lane size = magnitude(correction);
    const Lane square = size * size;
    return all(size <= small, size * magnitude(gap.curvature) <= small * gap.rate,
               square * magnitude(gap.jerk) <= small * small * gap.rate,
               fourth * (square * square) <= Lane(unit_roundoff) * gap.rate * time,
               magnitude(gap.value) <= Lane(2) * gap.rate * size);
}

/// Where a search has come to.
struct LaneSearch {
    LaneInstant at;
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
HWY_INLINE void seek_vertex(const VertexRows& vertices, Lane half_slope, const LaneFlight& flight, Lane fourth,
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
            stay_or_turn(vertices, half_slope, search.at, nearest);
        nearest.gap = gap_of(vertices, flight.spin, search.at, nearest.number, nearest.row, nearest.arm);
        const LaneGap& g = nearest.gap;
        search.correction = correction_of(g);
        open = all(open, nearest.known);
        const Mask leads_on = all(open, g.rate > Lane(0), magnitude(search.correction) <= Lane(longest_correction));
        const Mask fails = hn::AndNot(leads_on, open);
        search.search_failed = either(search.search_failed, fails);
        search.recedes = either(search.recedes, hn::And(fails, g.rate <= Lane(0)));
        search.looks = choose(fails, Lane(look), search.looks);
        open = leads_on;
        const Mask now = all(open, is_converged(g, search.correction, search.at.time, fourth));
        search.looks = choose(now, Lane(look), search.looks);
        search.found = either(search.found, now);
        open = hn::AndNot(now, open);
        if (look == most_looks || !any(open)) return;
        open = all(open, magnitude(flight.spin * search.correction) < Lane(32));
        search.at = choose(open, advanced(flight, search.at, search.correction), search.at);
        search.latest = larger(search.latest, search.at.time);
    }
}

/// The search of strike_by_vertex in the lanes `asked` for: at the vertex behind `search.nearest`, from `search.at` on.
/// Where it is not found nothing changes.
///   unfinished  lanes in which the scalar search goes on
HWY_INLINE Mask seek_vertex_behind(const VertexRows& vertices, const LaneFlight& flight, Lane fourth, Mask asked,
                                   LaneSearch& search, Mask& unfinished) {
    LaneInstant at = search.at;
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
        next.gap = gap_of(vertices, flight.spin, at, next.number, next.row, next.arm);
        const LaneGap& g = next.gap;
        const Lane correction = correction_of(g);
        open = all(open, g.rate > Lane(0), magnitude(correction) <= Lane(longest_correction));
        const Mask found = all(open, is_converged(g, correction, at.time, fourth));
        search.at = choose(found, at, search.at);
        search.latest = choose(found, latest, search.latest);
        search.nearest = choose(found, next, search.nearest);
        search.correction = choose(found, correction, search.correction);
        search.looks = choose(found, search.looks + Lane(look), search.looks);
        all_found = either(all_found, found);
        const Mask left = hn::AndNot(found, open);
        open = all(left, magnitude(flight.spin * correction) < Lane(32));
        unfinished = either(unfinished, look == most_looks ? left : hn::AndNot(open, left));
        if (look == most_looks || !any(open)) return all_found;
        at = choose(open, advanced(flight, at, correction), at);
        latest = larger(latest, at.time);
    }
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
