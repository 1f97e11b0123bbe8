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
    const Plane turn = turn_minus_one(time);
    at.time = time;
    at.moved = time * flight.velocity - flight.beta * times(flight.phase, turn);
    at.phase = turned(flight.phase, turn);
    at.arm_moved = times(flight.arm, turn_minus_one(flight.spin * time));
    at.arm = flight.arm + at.arm_moved;
    complete(flight, at);
    return at;
}

HWY_INLINE LaneGap gap_after(const LaneGap& gap, Lane d) {
    const Lane bend = gap.bend + d * gap.jerk;
    return {gap.value + d * (gap.rate + Lane(0.5) * d * (gap.bend + fraction(1, 3) * d * gap.jerk)),
            gap.rate + Lane(0.5) * d * (gap.bend + bend), bend, gap.jerk};
}

HWY_INLINE Mask nonpositive_until(Lane value, Lane rate, Lane bend, Lane t, Lane third) {
    const Lane b = larger(bend + fraction(1, 3) * third * t, Lane(0));
    return all(value <= Lane(0), value + t * (rate + Lane(0.5) * b * t) <= Lane(0));
}

HWY_INLINE Mask touch_together(const LaneGap& first, const LaneGap& second, Lane time) {
    const Lane apart = magnitude(first.value * second.rate - second.value * first.rate);
    return all(first.rate > Lane(0), second.rate > Lane(0),
               apart <= Lane(16 * unit_roundoff) * (larger(first.rate, second.rate) + first.rate * second.rate * time));
}

/// The gap of the vertex `number`, whichever that is.
HWY_INLINE LaneGap gap_of_vertex(const Rows& row, Lane spin, const LaneInstant& at, Lane number) {
    return gap_of(spin, at, turned_to(at.arm, number, row.value), times(at.arm, row.rest), equal(number, Lane(0)));
}

/// neighbour_of.
HWY_INLINE LaneGap gap_of_neighbour(const VertexRows& vertices, Lane spin, const LaneInstant& at, Lane number,
                                    const Plane& arm) {
    const Lane k = number + choose(cross(arm, at.centre) >= Lane(0), Lane(1), Lane(-1));
    const Lane around = choose(k < Lane(0), k + vertices.sides, choose(equal(k, vertices.sides), Lane(0), k));
    return gap_of_vertex(rows_of_vertex(vertices, around), spin, at, around);
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
        nonpositive_until(struck.value, struck.rate, struck.bend, ring.out, bounds.third),
        nonpositive_until(other.value, other.rate, other.bend, ring.out, bounds.third),
        nonpositive_until(striking.value, -striking.rate, striking.bend, ring.in, bounds.third),
        nonpositive_until(neighbour.value, -neighbour.rate, neighbour.bend, ring.in, bounds.third));
}

/// One lane's flight in all lanes, so that its vertices can stand in them.
class OneFlight {
public:
    HWY_INLINE OneFlight(const ProofTask& task, int lane)
        : lane_(hn::IndicesFromVec(Tag(), hn::Set(Whole(), lane))),
          spin_(of(task.flight.spin)),
          sixth_(of(sixth_bound(task.body, task.flight, task.speed))),
          striking_(of(task.search.nearest.number)),
          vertices_(task.vertices) {
        vertices_.first = bits_in(of(Lane(hn::BitCast(Tag(), task.vertices.first))));
        vertices_.sides = of(task.vertices.sides);
    }

    /// every_vertex_clear without halves, of this flight.
    ///   strikes  the vertex that strikes does so at `to`
    HWY_INLINE bool is_clear(const LaneInstant& from, const LaneInstant& to, bool strikes) const {
        const LaneInstant first = of(from), last = of(to);
        const Lane striking = strikes ? striking_ : Lane(-1);
        const int sides = static_cast<int>(hn::GetLane(vertices_.sides.v));
        for (int k = 0; k < sides; k += static_cast<int>(hn::Lanes(Tag()))) {
            const Lane number(hn::Iota(Tag(), k));
            const Mask beyond = number >= vertices_.sides;
            const Lane vertex = choose(beyond, Lane(0), number);
            const Rows row = rows_of_vertex(vertices_, vertex);
            const LaneGap before = gap_of_vertex(row, spin_, first, vertex);
            LaneGap after = gap_of_vertex(row, spin_, last, vertex);
            after.value = choose(equal(number, striking), smaller(after.value, Lane(0)), after.value);
            if (any(no(either(beyond, clear_between(before, after, last.time - first.time, sixth_))))) return false;
        }
        return true;
    }

private:
    HWY_INLINE Lane of(Lane a) const { return Lane(hn::TableLookupLanes(a.v, lane_)); }
    HWY_INLINE Plane of(const Plane& a) const { return {of(a.x), of(a.y)}; }
    HWY_INLINE LaneInstant of(const LaneInstant& at) const {
        return {of(at.time),      of(at.phase),  of(at.arm),   of(at.moved),
                of(at.arm_moved), of(at.centre), of(at.swirl), of(at.drift)};
    }

    decltype(hn::IndicesFromVec(Tag(), Wholes())) lane_;
    Lane spin_, sixth_, striking_;
    VertexRows vertices_;
};

/// The lanes, of those that are asked for, whose flights are clear: in one piece, or in two, before and after
/// `half_way`.
HWY_INLINE std::uint32_t clear_flights(const ProofTask& task, std::uint32_t asked, const LaneInstant& start,
                                       const LaneInstant* half_way, const LaneInstant& end) {
    std::uint32_t clear = 0;
    for (; asked != 0; asked &= asked - 1) {
        const int lane = std::countr_zero(asked);
        const OneFlight flight(task, lane);
        const bool is_clear = half_way == nullptr
                                  ? flight.is_clear(start, end, true)
                                  : flight.is_clear(start, *half_way, false) && flight.is_clear(*half_way, end, true);
        if (is_clear) clear |= 1u << lane;
    }
    return clear;
}

/// every_vertex_clear with one halving. Few vertices only.
HWY_INLINE Mask clear_in_halves(const ProofTask& task, const LaneInstant& end, Mask asked) {
    asked = hn::And(asked, task.vertices.sides <= Lane(few_sides));
    if (!any(asked)) return asked;
    const LaneInstant start = instant_at_start(task.flight);
    const std::uint32_t whole = clear_flights(task, bits_of(asked), start, nullptr, end);
    const Lane half_time = Lane(0.5) * (start.time + end.time);
    const Mask known = all(half_time < Lane(32), magnitude(task.flight.spin * half_time) < Lane(32));
    const std::uint32_t left = bits_of(hn::And(asked, known)) & ~whole;
    if (left == 0) return mask_of(whole);
    const LaneInstant half_way = instant_at(task.flight, half_time);
    return mask_of(whole | clear_flights(task, left, start, &half_way, end));
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
    if (any(left)) clear = either(clear, clear_in_halves(task, end, left));
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
