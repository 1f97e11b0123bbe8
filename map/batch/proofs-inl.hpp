// Proofs that nothing was passed, in lanes: map/first_contact/vertex_proofs.hpp. `clear_by_derivatives` is taken where
// a lane's flight is not proven clear by the circumscribed circle; compiled once for all impact rules.
#if defined(SWIRL_MAP_BATCH_PROOFS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_PROOFS_INL
#undef SWIRL_MAP_BATCH_PROOFS_INL
#else
#define SWIRL_MAP_BATCH_PROOFS_INL
#endif

#include "map/batch/vertices-inl.hpp"

#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// What the proofs read. Filled in where they are asked for: it is stored, since they are no part of the round's code.
struct ProofTask {
    const LaneScenes& scenes;
    int first;  ///< lane of them
    Flight<Lane> flight;
    VertexRows vertices;
    Gap<Lane> leaving, struck;  ///< at the start: of the circumscribed circle, of the vertex that has struck
    LaneSearch search;
};

/// The circumscribed circle's gap.
HWY_INLINE Gap<Lane> centre_gap(const Body<Lane>& body, const Instant<Lane>& at) {
    return centre_gap_of(circle_gap(body, at.centre), at);
}

/// The gap of the vertex `number`, whichever that is.
HWY_INLINE Gap<Lane> gap_of_vertex(const VertexRows& vertices, const Rows& row, const Flight<Lane>& flight,
                                   const Instant<Lane>& at, Lane number) {
    return gap_of(vertices, flight, at, number, row, turned_to(at.arm, number, row.value));
}

/// neighbour_of.
HWY_INLINE Gap<Lane> gap_of_neighbour(const VertexRows& vertices, const Flight<Lane>& flight, const Instant<Lane>& at,
                                      Lane number, const Plane& arm) {
    const Lane k = number + choose(cross(arm, at.centre) >= Lane(0), Lane(1), Lane(-1));
    const Lane around = choose(k < Lane(0), k + vertices.sides, choose(equal(k, vertices.sides), Lane(0), k));
    return gap_of_vertex(vertices, rows_of_vertex(vertices, around), flight, at, around);
}

HWY_INLINE Mask clear_by_pairs(const ProofTask& task, const Gap<Lane>& arriving, const Gap<Lane>& striking,
                               const Gap<Lane>& neighbour, Lane time) {
    const Body<Lane> body = load_body(task.scenes, task.first);
    const Flight<Lane>& flight = task.flight;
    const VertexBounds<Lane> bounds = vertex_bounds(body, flight);
    const ClosedBetween<Lane> ring = closed_between(task.leaving, arriving, time, bounds.centre_sixth);
    const Lane shift = fabs(task.search.correction);
    const Gap<Lane> other = gap_of_neighbour(task.vertices, flight, instant_at_start(flight), Lane(0), flight.arm);
    return ring.proven &&
           two_suffice(body, flight, bounds.drift, max(ring.out, ring.in + shift), body.inner - bounds.drift * shift) &&
           pairs_keep_inside(ring, task.struck, other, striking, neighbour, bounds.third);
}

/// One lane's flight in all lanes, so that its vertices can stand in them.
class OneFlight {
public:
    HWY_INLINE OneFlight(const ProofTask& task, int lane)
        : lane_(hn::IndicesFromVec(Tag(), hn::Set(Whole(), lane))),
          flight_(of(task.flight)),
          sixth_(of(derivative_bounds<6, Shape::polygon>(load_body(task.scenes, task.first), task.flight).vertex)),
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
    HWY_INLINE bool is_clear(const Instant<Lane>& contact) const {
        const Instant<Lane> to = of(contact);
        Gaps before, after;
        fill(instant_at_start(flight_), before);
        fill(to, after);
        for (int g = 0; g < count_; ++g)
            after.group[g].value =
                choose(groups_[g].striking, min(after.group[g].value, Lane(0)), after.group[g].value);
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
        Gap<Lane> group[most_groups];
    };

    HWY_INLINE void fill(const Instant<Lane>& at, Gaps& gaps) const {
        for (int g = 0; g < count_; ++g)
            gaps.group[g] = gap_of_vertex(vertices_, groups_[g].row, flight_, at, groups_[g].number);
    }

    /// Every vertex between two moments that are `h` apart.
    HWY_INLINE bool is_clear_whole(const Gaps& before, const Gaps& after, Lane h) const {
        for (int g = 0; g < count_; ++g)
            if (any(!(groups_[g].beyond || clear_between(before.group[g], after.group[g], h, sixth_)))) return false;
        return true;
    }

    /// On either half of the way, each in its own halves where that is not enough. Moments that the tables do not reach
    /// leave it unproven, as the caller knows.
    HWY_NOINLINE bool is_clear_in_halves(const Gaps& before, const Gaps& after, const Lane& from, const Lane& to,
                                         int halvings) const {
        const Lane time = Lane(0.5) * (from + to);
        if (any(!(time < Lane(32) && fabs(flight_.spin * time) < Lane(32)))) return false;
        Gaps half_way;
        fill(instant_at<Shape::polygon>(flight_, time), half_way);
        return (is_clear_whole(before, half_way, time - from) ||
                (halvings > 1 && is_clear_in_halves(before, half_way, from, time, halvings - 1))) &&
               (is_clear_whole(half_way, after, to - time) ||
                (halvings > 1 && is_clear_in_halves(half_way, after, time, to, halvings - 1)));
    }

    HWY_INLINE Lane of(Lane a) const { return Lane(hn::TableLookupLanes(a.v, lane_)); }
    HWY_INLINE Plane of(const Plane& a) const { return {of(a.x), of(a.y)}; }
    HWY_INLINE Instant<Lane> of(const Instant<Lane>& at) const {
        return {of(at.time),      of(at.phase),  of(at.arm),   of(at.moved),
                of(at.arm_moved), of(at.centre), of(at.swirl), of(at.drift)};
    }
    HWY_INLINE Flight<Lane> of(const Flight<Lane>& flight) const {
        return {of(flight.centre),
                of(flight.velocity),
                of(flight.phase),
                of(flight.arm),
                of(flight.spin),
                of(flight.beta),
                true};
    }

    decltype(hn::IndicesFromVec(Tag(), Wholes())) lane_;
    Flight<Lane> flight_;
    Lane sixth_, striking_;
    VertexRows vertices_;
    int count_ = 0;  ///< of groups
    VertexGroup groups_[most_groups];
};

/// every_vertex_clear from the start on, flight by flight. Few vertices only.
HWY_INLINE Mask every_vertex_clear(const ProofTask& task, const Instant<Lane>& end, Mask asked) {
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
inline HWY_NOINLINE void clear_by_derivatives(const ProofTask& task, const Instant<Lane>& end, const Mask& asked,
                                              Mask& clear) {
    const LaneSearch& search = task.search;
    const Instant<Lane>& at = search.at;
    const Gap<Lane>& g = search.nearest.gap;
    const Plane& arm = search.nearest.arm;
    const Lane d = search.correction;
    const Body<Lane> body = load_body(task.scenes, task.first);
    Gap<Lane> striking = gap_after(g, d);
    striking.value = Lane(0);
    const Gap<Lane> neighbour =
        gap_after(gap_of_neighbour(task.vertices, task.flight, at, search.nearest.number, arm), d);
    const Lane time = at.time + d;
    const Mask alone = asked && is_nearest(body, at.centre, arm) && !touch_together(striking, neighbour, time);
    const Mask by_pairs =
        hn::And(alone, clear_by_pairs(task, gap_after(centre_gap(body, at), d), striking, neighbour, time));
    const Mask left = hn::AndNot(by_pairs, alone);
    clear = by_pairs;
    if (any(left)) clear = clear || every_vertex_clear(task, end, left);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
