// Numbers, one in each lane of a vector, with the operations of double: each is rounded as IEEE says, so that a formula
// written with them has in each lane the bits of the same formula in double. No fused product and sum is here.
//
// Included by the files of kernels alone, once for each instruction set.
#if defined(SWIRL_MAP_BATCH_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_LANES_INL
#undef SWIRL_MAP_BATCH_LANES_INL
#else
#define SWIRL_MAP_BATCH_LANES_INL
#endif

#include "map/batch/lane_block.hpp"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, block_lanes>;
using Mask = hn::Mask<Tag>;
using Whole = hn::RebindToSigned<Tag>;
using Wholes = hn::Vec<Whole>;

/// A double in each lane.
struct Lane {
    hn::Vec<Tag> v;

    Lane() = default;                                    // with the bits that happen to be there
    HWY_INLINE Lane(double x) : v(hn::Set(Tag(), x)) {}  // NOLINT: as a double converts to a number of any type
    HWY_INLINE explicit Lane(hn::Vec<Tag> vector) : v(vector) {}
};

HWY_INLINE Lane operator+(Lane a, Lane b) {
    return Lane(hn::Add(a.v, b.v));
}
HWY_INLINE Lane operator-(Lane a, Lane b) {
    return Lane(hn::Sub(a.v, b.v));
}
HWY_INLINE Lane operator*(Lane a, Lane b) {
    return Lane(hn::Mul(a.v, b.v));
}
HWY_INLINE Lane operator/(Lane a, Lane b) {
    return Lane(hn::Div(a.v, b.v));
}
HWY_INLINE Lane operator-(Lane a) {
    return Lane(hn::Neg(a.v));
}
HWY_INLINE Lane sqrt(Lane a) {
    return Lane(hn::Sqrt(a.v));
}
HWY_INLINE Lane fabs(Lane a) {
    return Lane(hn::Abs(a.v));
}
HWY_INLINE Lane copysign(Lane a, Lane sign) {
    return Lane(hn::CopySign(a.v, sign.v));
}
HWY_INLINE Mask operator<(Lane a, Lane b) {
    return hn::Lt(a.v, b.v);
}
HWY_INLINE Mask operator<=(Lane a, Lane b) {
    return hn::Le(a.v, b.v);
}
HWY_INLINE Mask operator>(Lane a, Lane b) {
    return hn::Lt(b.v, a.v);
}
HWY_INLINE Mask operator>=(Lane a, Lane b) {
    return hn::Le(b.v, a.v);
}
HWY_INLINE Mask equal(Lane a, Lane b) {
    return hn::Eq(a.v, b.v);
}
HWY_INLINE Mask operator&&(Mask a, Mask b) {
    return hn::And(a, b);
}
HWY_INLINE Mask operator||(Mask a, Mask b) {
    return hn::Or(a, b);
}
HWY_INLINE Mask operator!(Mask a) {
    return hn::Not(a);
}
HWY_INLINE bool any(Mask a) {
    return !hn::AllFalse(Tag(), a);
}
HWY_INLINE std::uint32_t bits_of(Mask a) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Tag(), a, bits);
    return bits[0];
}
/// A bit for each lane: of one vector.
HWY_INLINE Mask mask_of(std::uint32_t bits) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits)};
    return hn::LoadMaskBits(Tag(), bytes);
}
HWY_INLINE Lane choose(Mask condition, Lane yes, Lane otherwise) {
    return Lane(hn::IfThenElse(condition, yes.v, otherwise.v));
}
/// std::max and std::min: the first where they are equal or one is NaN.
HWY_INLINE Lane max(Lane a, Lane b) {
    return choose(a < b, b, a);
}
HWY_INLINE Lane min(Lane a, Lane b) {
    return choose(b < a, b, a);
}

// What map/numbers/real.hpp and first_contact/ have for each type of number, for lanes.
template <class T>
using Truth = Mask;
template <class T>
HWY_INLINE T fraction(int p, int q) {  // rounded once
    return T(static_cast<double>(p) / static_cast<double>(q));
}
template <class T>
HWY_INLINE T epsilon() {
    return T(0x1p-52);
}
template <class T>
HWY_INLINE T fourth_root_of_epsilon() {
    return T(0x1p-13);
}
template <class T>
HWY_INLINE T cube_root_of_epsilon() {
    return T(0x1p-17);
}

#define SWIRL_INLINED HWY_INLINE
#include "map/numbers/vec2_formulas.hpp"

#include "map/numbers/turn_formulas.hpp"
#undef SWIRL_INLINED

using Plane = Vec2<Lane>;
using Factor = UnbiasedFactor<Lane>;

HWY_INLINE Lane load(const LaneNumbers& numbers, int first) {
    return Lane(hn::Load(Tag(), numbers.of + first));
}
HWY_INLINE void store(Lane value, LaneNumbers& numbers, int first) {
    hn::Store(value.v, Tag(), numbers.of + first);
}
HWY_INLINE void store_where(Mask condition, Lane value, LaneNumbers& numbers, int first) {
    store(choose(condition, value, load(numbers, first)), numbers, first);
}

HWY_INLINE Factor load(const LaneFactors& factors, int first) {
    return {load(factors.first, first), load(factors.second, first)};
}
HWY_INLINE Plane choose(Mask condition, Plane yes, Plane otherwise) {
    return {choose(condition, yes.x, otherwise.x), choose(condition, yes.y, otherwise.y)};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
