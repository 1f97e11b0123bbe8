// The further proofs that nothing was passed, in lanes: `clear_by_derivatives` of map/first_contact/vertex_proofs.hpp.
// Taken where a lane's flight is not proven clear by the circumscribed circle; compiled once for all impact rules.
#if defined(SWIRL_MAP_BATCH_PROOFS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_PROOFS_INL
#undef SWIRL_MAP_BATCH_PROOFS_INL
#else
#define SWIRL_MAP_BATCH_PROOFS_INL
#endif

#include "map/batch/circle_proof-inl.hpp"

#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

HWY_INLINE LaneInstant instant_at_start(const LaneFlight& flight) {
    const Plane nothing{Lane(0), Lane(0)};
    return {Lane(0), flight.phase,  flight.arm,   nothing,
            nothing, flight.centre, flight.swirl, flight.velocity - quarter_turned(flight.swirl)};
}

/// instant_at<polygon>, where τ and |Sτ| < 32.
HWY_INLINE LaneInstant instant_at(const LaneFlight& flight, Lane time) {
    LaneInstant at;
    const Plane turn = cis_minus_one(time);
    at.time = time;
    at.moved = time * flight.velocity - flight.beta * times(flight.phase, turn);
    at.phase = turned(flight.phase, turn);
    at.arm_moved = times(flight.arm, cis_minus_one(flight.spin * time));
    at.arm = flight.arm + at.arm_moved;
    complete(flight, at);
    return at;
}

HWY_INLINE LaneGap gap_after(const LaneGap& gap, Lane d) {
    const Lane curvature = gap.curvature + d * gap.jerk;
    return {gap.value + d * (gap.rate + Lane(0.5) * d * (gap.curvature + fraction(1, 3) * d * gap.jerk)),
            gap.rate + Lane(0.5) * d * (gap.curvature + curvature), curvature, gap.jerk};
}

HWY_INLINE Mask nonpositive_until(Lane value, Lane rate, Lane curvature, Lane t, Lane third) {
    const Lane b = larger(curvature + fraction(1, 3) * third * t, Lane(0));
    return all(value <= Lane(0), value + t * (rate + Lane(0.5) * b * t) <= Lane(0));
}

HWY_INLINE Mask touch_together(const LaneGap& first, const LaneGap& second, Lane time) {
    const Lane apart = magnitude(first.value * second.rate - second.value * first.rate);
    return all(first.rate > Lane(0), second.rate > Lane(0),
               apart <= Lane(16 * unit_roundoff) * (larger(first.rate, second.rate) + first.rate * second.rate * time));
}

/// The gap of the vertex `number`, whichever that is.
HWY_INLINE LaneGap gap_of_vertex(const VertexRows& vertices, const Rows& row, Lane spin, const LaneInstant& at,
                                 Lane number) {
    return gap_of(vertices, spin, at, number, row, turned_to(at.arm, number, row.value));
}

/// neighbour_of.
HWY_INLINE LaneGap gap_of_neighbour(const VertexRows& vertices, Lane spin, const LaneInstant& at, Lane number,
                                    const Plane& arm) {
    const Lane k = number + choose(cross(arm, at.centre) >= Lane(0), Lane(1), Lane(-1));
    const Lane around = choose(k < Lane(0), k + vertices.sides, choose(equal(k, vertices.sides), Lane(0), k));
    return gap_of_vertex(vertices, rows_of_vertex(vertices, around), spin, at, around);
}

/// derivative_bounds<6, polygon>.vertex.
HWY_INLINE Lane sixth_bound(const LaneBody& body, const LaneFlight& flight, Lane speed) {
    const Lane place = body.outer + body.beta;
    const Lane s = magnitude(flight.spin);
    const Lane s2 = s * s;
    const Lane relative = magnitude(flight.spin - Lane(1));
    const Lane relative2 = relative * relative;
    return centre_bound(6, body.beta, body.outer, speed) +
           Lane(2) * body.alpha *
               (s2 * s2 * s * (s * place + Lane(6) * speed) + body.beta * (relative2 * relative2 * relative2));
}

/// clear_by_pairs.
HWY_INLINE Mask clear_by_pairs(const ProofTask& task, const LaneGap& arriving, const LaneGap& striking,
                               const LaneGap& neighbour, Lane time) {
    const LaneBody& body = task.body;
    const LaneFlight& flight = task.flight;
    const LaneBounds bounds = vertex_bounds(body, flight, task.speed);
    const LaneRing ring = closed_between(leaving_gap(task), arriving, time, bounds.centre_sixth);
    const Lane shift = magnitude(task.search.correction);
    const LaneInstant start = instant_at_start(flight);
    const LaneGap other = gap_of_neighbour(task.vertices, flight.spin, start, Lane(0), flight.arm);
    const LaneGap& struck = task.struck;
    return all(
        ring.proven,
        two_suffice(body, flight, bounds.drift, larger(ring.out, ring.in + shift), body.inner - bounds.drift * shift),
        nonpositive_until(struck.value, struck.rate, struck.curvature, ring.out, bounds.third),
        nonpositive_until(other.value, other.rate, other.curvature, ring.out, bounds.third),
        nonpositive_until(striking.value, -striking.rate, striking.curvature, ring.in, bounds.third),
        nonpositive_until(neighbour.value, -neighbour.rate, neighbour.curvature, ring.in, bounds.third));
}

/// One lane's flight in all lanes, so that its vertices can stand in them.
class OneFlight {
public:
    HWY_INLINE OneFlight(const ProofTask& task, int lane)
        : lane_(hn::IndicesFromVec(Tag(), hn::Set(Whole(), lane))),
          flight_(of(task.flight)),
          sixth_(of(sixth_bound(task.body, task.flight, task.speed))),
          striking_(of(task.search.nearest.number)),
          vertices_(task.vertices) {
        vertices_.first = bits_in(of(Lane(hn::BitCast(Tag(), task.vertices.first))));
        vertices_.sides = of(task.vertices.sides);
        const Lane is_short = of(choose(task.vertices.short_sides, Lane(1), Lane(0)));
        vertices_.short_sides = equal(is_short, Lane(1));
        vertices_.some_short = any(vertices_.short_sides);
        const int sides = static_cast<int>(hn::GetLane(vertices_.sides.v));
        for (; count_ * lanes < sides; ++count_) {
            VertexGroup& group = groups_[count_];
            const Lane number(hn::Iota(Tag(), count_ * lanes));
            group.beyond = number >= vertices_.sides;
            group.number = choose(group.beyond, Lane(0), number);
            group.row = rows_of_vertex(vertices_, group.number);
            group.striking = hn::AndNot(group.beyond, equal(group.number, striking_));
        }
    }

    /// every_vertex_clear from the start to the contact.
    HWY_INLINE bool is_clear(const LaneInstant& contact) const {
        const LaneInstant to = of(contact);
        Gaps before, after;
        fill(instant_at_start(flight_), before);
        fill(to, after);
        for (int g = 0; g < count_; ++g)
            after.group[g].value =
                choose(groups_[g].striking, smaller(after.group[g].value, Lane(0)), after.group[g].value);
        const Lane from(0);
        return is_clear_whole(before, after, to.time - from) ||
               is_clear_in_halves(before, after, from, to.time, most_halvings);
    }

private:
    static constexpr int lanes = static_cast<int>(hn::MaxLanes(Tag()));
    static constexpr int most_groups = (few_sides + lanes - 1) / lanes;

    /// As many vertices as a vector has lanes.
    struct VertexGroup {
        Lane number;
        Rows row;
        Mask beyond;    ///< there is none with this number
        Mask striking;  ///< the one that strikes
    };
    /// Every vertex's at a moment.
    struct Gaps {
        LaneGap group[most_groups];
    };

    HWY_INLINE void fill(const LaneInstant& at, Gaps& gaps) const {
        for (int g = 0; g < count_; ++g)
            gaps.group[g] = gap_of_vertex(vertices_, groups_[g].row, flight_.spin, at, groups_[g].number);
    }

    /// Every vertex between two moments that are `h` apart.
    HWY_INLINE bool is_clear_whole(const Gaps& before, const Gaps& after, Lane h) const {
        for (int g = 0; g < count_; ++g)
            if (any(no(either(groups_[g].beyond, clear_between(before.group[g], after.group[g], h, sixth_)))))
                return false;
        return true;
    }

    /// On either half of the way, each in its own halves where that is not enough. Moments that the tables do not reach
    /// leave it unproven, as the caller knows.
    HWY_NOINLINE bool is_clear_in_halves(const Gaps& before, const Gaps& after, const Lane& from, const Lane& to,
                                         int halvings) const {
        const Lane time = Lane(0.5) * (from + to);
        if (any(no(all(time < Lane(32), magnitude(flight_.spin * time) < Lane(32))))) return false;
        Gaps half_way;
        fill(instant_at(flight_, time), half_way);
        return (is_clear_whole(before, half_way, time - from) ||
                (halvings > 1 && is_clear_in_halves(before, half_way, from, time, halvings - 1))) &&
               (is_clear_whole(half_way, after, to - time) ||
                (halvings > 1 && is_clear_in_halves(half_way, after, time, to, halvings - 1)));
    }

    HWY_INLINE Lane of(Lane a) const { return Lane(hn::TableLookupLanes(a.v, lane_)); }
    HWY_INLINE Plane of(const Plane& a) const { return {of(a.x), of(a.y)}; }
    HWY_INLINE LaneInstant of(const LaneInstant& at) const {
        return {of(at.time),      of(at.phase),  of(at.arm),   of(at.moved),
                of(at.arm_moved), of(at.centre), of(at.swirl), of(at.drift)};
    }
    HWY_INLINE LaneFlight of(const LaneFlight& flight) const {
        return {of(flight.centre), of(flight.velocity), of(flight.phase), of(flight.arm),
                of(flight.swirl),  of(flight.spin),     of(flight.beta)};
    }

    decltype(hn::IndicesFromVec(Tag(), Wholes())) lane_;
    LaneFlight flight_;
    Lane sixth_, striking_;
    VertexRows vertices_;
    int count_ = 0;  ///< of groups
    VertexGroup groups_[most_groups];
};

/// every_vertex_clear from the start on, flight by flight. Few vertices only.
HWY_INLINE Mask every_vertex_clear(const ProofTask& task, const LaneInstant& end, Mask asked) {
    asked = hn::And(asked, task.vertices.sides <= Lane(few_sides));
    if (!any(asked)) return asked;
    std::uint32_t clear = 0;
    for (std::uint32_t lanes = bits_of(asked); lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        if (OneFlight(task, lane).is_clear(end)) clear |= 1u << lane;
    }
    return mask_of(clear);
}

/// clear_by_derivatives for the lanes `asked` for; `end` is the contact.
inline HWY_NOINLINE void clear_by_derivatives(const ProofTask& task, const LaneInstant& end, const Mask& asked,
                                              Mask& clear) {
    const LaneSearch& search = task.search;
    const LaneInstant& at = search.at;
    const LaneGap& g = search.nearest.gap;
    const Plane& arm = search.nearest.arm;
    const Lane d = search.correction;
    LaneGap circle = centre_gap(task.body, at);
    circle.jerk = Lane(2) * (Lane(3) * dot(at.drift, at.swirl) - cross(at.centre, at.swirl));
    LaneGap striking = gap_after(g, d);
    striking.value = Lane(0);
    const LaneGap neighbour =
        gap_after(gap_of_neighbour(task.vertices, task.flight.spin, at, search.nearest.number, arm), d);
    const Lane time = at.time + d;
    const Mask alone =
        all(asked, is_nearest(task.body.half_slope, at, arm), no(touch_together(striking, neighbour, time)));
    const Mask by_pairs = hn::And(alone, clear_by_pairs(task, gap_after(circle, d), striking, neighbour, time));
    const Mask left = hn::AndNot(by_pairs, alone);
    clear = by_pairs;
    if (any(left)) clear = either(clear, every_vertex_clear(task, end, left));
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
