// Tables of rotations in lanes: `cis_minus_one` and `moment_near` of map/numbers/, with both sides of each branch where
// lanes part.
#if defined(SWIRL_MAP_BATCH_TURNS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_TURNS_INL
#undef SWIRL_MAP_BATCH_TURNS_INL
#else
#define SWIRL_MAP_BATCH_TURNS_INL
#endif

#include "map/batch/lanes-inl.hpp"
#include "map/numbers/turn_table.hpp"

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// A row of four numbers from a table for each lane: value and rest of a tabled rotation.
struct Rows {
    Plane value, rest;
};

#if HWY_TARGET != HWY_SCALAR  // which has no vectors to turn
/// Two rows, one in each half of a vector.
HWY_INLINE hn::Vec<Tag> two_rows(const double* first, const double* second) {
    const hn::Half<Tag> half;
    return hn::Combine(Tag(), hn::LoadU(half, second), hn::LoadU(half, first));
}
/// The even and the odd pairs of lanes of two vectors, in turn from each.
HWY_INLINE Lane even_blocks(hn::Vec<Tag> a, hn::Vec<Tag> b) {
    return Lane(hn::OddEvenBlocks(hn::SwapAdjacentBlocks(b), a));
}
HWY_INLINE Lane odd_blocks(hn::Vec<Tag> a, hn::Vec<Tag> b) {
    return Lane(hn::OddEvenBlocks(b, hn::SwapAdjacentBlocks(a)));
}
#endif

/// Whole rows are loaded and turned: quicker than gathering their numbers.
HWY_INLINE Rows rows_of(const double* table, Wholes row) {
    const Tag tag;
    const Wholes at = hn::ShiftLeft<2>(row);
    constexpr std::size_t lanes = hn::MaxLanes(Tag());
    Rows rows;
#if HWY_TARGET != HWY_SCALAR
    if constexpr (lanes == 8) {
        alignas(64) std::int64_t from[8];
        hn::Store(at, Whole(), from);
        const auto a = two_rows(table + from[0], table + from[4]), b = two_rows(table + from[1], table + from[5]);
        const auto c = two_rows(table + from[2], table + from[6]), d = two_rows(table + from[3], table + from[7]);
        const auto even = hn::InterleaveLower(tag, a, b), odd = hn::InterleaveUpper(tag, a, b);
        const auto more_even = hn::InterleaveLower(tag, c, d), more_odd = hn::InterleaveUpper(tag, c, d);
        rows.value = {even_blocks(even, more_even), even_blocks(odd, more_odd)};
        rows.rest = {odd_blocks(even, more_even), odd_blocks(odd, more_odd)};
    } else if constexpr (lanes == 4) {
        alignas(32) std::int64_t from[4];
        hn::Store(at, Whole(), from);
        const auto a = hn::LoadU(tag, table + from[0]), b = hn::LoadU(tag, table + from[1]);
        const auto c = hn::LoadU(tag, table + from[2]), d = hn::LoadU(tag, table + from[3]);
        const auto even = hn::InterleaveLower(tag, a, b), odd = hn::InterleaveUpper(tag, a, b);
        const auto more_even = hn::InterleaveLower(tag, c, d), more_odd = hn::InterleaveUpper(tag, c, d);
        rows.value = {Lane(hn::ConcatLowerLower(tag, more_even, even)), Lane(hn::ConcatLowerLower(tag, more_odd, odd))};
        rows.rest = {Lane(hn::ConcatUpperUpper(tag, more_even, even)), Lane(hn::ConcatUpperUpper(tag, more_odd, odd))};
    } else if constexpr (lanes == 2) {
        alignas(16) std::int64_t from[2];
        hn::Store(at, Whole(), from);
        const auto a = hn::LoadU(tag, table + from[0]), b = hn::LoadU(tag, table + from[1]);
        const auto c = hn::LoadU(tag, table + from[0] + 2), d = hn::LoadU(tag, table + from[1] + 2);
        rows.value = {Lane(hn::InterleaveLower(tag, a, b)), Lane(hn::InterleaveUpper(tag, a, b))};
        rows.rest = {Lane(hn::InterleaveLower(tag, c, d)), Lane(hn::InterleaveUpper(tag, c, d))};
    }
#endif
    if constexpr (lanes == 1) {
        rows.value = {Lane(hn::GatherIndex(tag, table, at)), Lane(hn::GatherIndex(tag, table + 1, at))};
        rows.rest = {Lane(hn::GatherIndex(tag, table + 2, at)), Lane(hn::GatherIndex(tag, table + 3, at))};
    }
    return rows;
}

/// The bits of a double as a whole number.
HWY_INLINE Wholes bits_in(Lane a) {
    return hn::BitCast(Whole(), a.v);
}

HWY_INLINE Mask is_tiny(Lane angle) {
    return fabs(angle) <= Lane(0x1p-13);
}
HWY_INLINE Mask is_small(Lane angle) {
    return fabs(angle) <= Lane(0.25);
}

/// cis_minus_one for |δ| ≤ ¼.
HWY_INLINE Plane turn_within_quarter(Lane angle) {
    return choose(is_tiny(angle), tiny_turn_minus_one(angle), small_turn_minus_one(angle));
}

/// cis_minus_one for |δ| < 32, which is the caller's to see to.
HWY_INLINE Plane turn_by_table(Lane angle) {
    const Lane doubled = angle + angle;
    const Lane shifted = doubled + Lane(0x1.8p52);
    const Lane nearest = shifted - Lane(0x1.8p52);
    const Mask beyond = fabs(angle) < Lane(32);  // where not, or NaN, the row is one that exists
    const Lane k = choose(beyond, fabs(nearest), Lane(0));
    const Wholes row = hn::And(bits_in(k + Lane(0x1.8p52)), hn::Set(Whole(), 127));
    static_assert(sizeof(TabledVector) == 4 * sizeof(double));
    const Rows entry = rows_of(&half_radians[0].value.x, row);
    const Mask backwards = nearest < Lane(0);
    const Lane side = choose(backwards, Lane(-1), Lane(1));
    const Plane coarse{entry.value.x, side * entry.value.y};
    const Plane rest{entry.rest.x, side * entry.rest.y};
    const Mask in_table = !is_small(angle);
    // One polynomial for both: of the angle itself, or of what the table leaves.
    const Plane fine = small_turn_minus_one(choose(in_table, angle - Lane(0.5) * nearest, angle));
    const Plane far = compose(coarse, rest, fine);
    return choose(is_tiny(angle), tiny_turn_minus_one(angle), choose(in_table, far, fine));
}

/// cis_minus_one for |δ| < 32; nearly always all lanes are within ¼.
HWY_INLINE Plane cis_minus_one(Lane angle) {
    if (any(!is_small(angle))) return turn_by_table(angle);
    return turn_within_quarter(angle);
}

/// Moments that `moment_near` finds in its table.
HWY_INLINE Mask is_tabled_moment(Lane time) {
    return time > Lane(0) && time < Lane(7.99);
}

HWY_INLINE TurnedMoment<Lane> moment_near(Lane time) {
    const Lane shifted = time + Lane(0x1.8p46);
    const Wholes row = hn::And(bits_in(shifted), hn::Set(Whole(), static_cast<std::int64_t>(sixty_fourths) - 1));
    const Rows entry = rows_of(&turns_of_sixty_fourths[0].value.x, row);
    TurnedMoment<Lane> moment{shifted - Lane(0x1.8p46), entry.value, entry.rest};
    const Mask tabled = time >= Lane(1.0 / 32);
    if (any(!tabled)) {
        moment.time = choose(tabled, moment.time, time);
        moment.turn = choose(tabled, moment.turn, turn_within_quarter(time));
        moment.rest = choose(tabled, moment.rest, Plane{Lane(0), Lane(0)});
    }
    return moment;
}

/// E(τ + d) for |d| ≤ ¼.
HWY_INLINE Plane turn_after(const TurnedMoment<Lane>& moment, Lane d) {
    return compose(moment.turn, moment.rest, turn_within_quarter(d));
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
