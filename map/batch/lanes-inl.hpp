// Numbers, one in each lane of a vector, with the operations of double: each is rounded as IEEE says, so that a formula
// written with them has in each lane the bits of the same formula in double. No fused product and sum is here.
//
// Included by the files of kernels alone, once for each instruction set. Functions of map/ that are templates on the
// number can't be used: they are compiled without the set's instructions.
#if defined(SWIRL_MAP_BATCH_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_LANES_INL
#undef SWIRL_MAP_BATCH_LANES_INL
#else
#define SWIRL_MAP_BATCH_LANES_INL
#endif

#include "map/batch/lane_block.hpp"

#include <hwy/highway.h>

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
HWY_INLINE Lane root_of_square(Lane a) {
    return Lane(hn::Sqrt(a.v));
}
HWY_INLINE Lane magnitude(Lane a) {
    return Lane(hn::Abs(a.v));
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
template <class... More>
HWY_INLINE Mask all(Mask a, Mask b, More... more) {
    if constexpr (sizeof...(more) == 0)
        return hn::And(a, b);
    else
        return all(hn::And(a, b), more...);
}
HWY_INLINE Mask either(Mask a, Mask b) {
    return hn::Or(a, b);
}
HWY_INLINE Mask no(Mask a) {
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
HWY_INLINE Lane larger(Lane a, Lane b) {
    return choose(a < b, b, a);
}
HWY_INLINE Lane smaller(Lane a, Lane b) {
    return choose(b < a, b, a);
}
/// p/q, rounded once.
HWY_INLINE Lane fraction(int p, int q) {
    return Lane(static_cast<double>(p) / static_cast<double>(q));
}

HWY_INLINE Lane load(const LaneNumbers& numbers, int first) {
    return Lane(hn::Load(Tag(), numbers.of + first));
}
HWY_INLINE void store(Lane value, LaneNumbers& numbers, int first) {
    hn::Store(value.v, Tag(), numbers.of + first);
}
HWY_INLINE void store_where(Mask condition, Lane value, LaneNumbers& numbers, int first) {
    store(choose(condition, value, load(numbers, first)), numbers, first);
}

/// Vectors of the plane, as Vec2 and its functions.
struct Plane {
    Lane x, y;
};

HWY_INLINE Plane operator+(Plane a, Plane b) {
    return {a.x + b.x, a.y + b.y};
}
HWY_INLINE Plane operator-(Plane a, Plane b) {
    return {a.x - b.x, a.y - b.y};
}
HWY_INLINE Plane operator*(Lane s, Plane a) {
    return {s * a.x, s * a.y};
}
HWY_INLINE Lane dot(Plane a, Plane b) {
    return a.x * b.x + a.y * b.y;
}
HWY_INLINE Lane cross(Plane a, Plane b) {
    return a.x * b.y - a.y * b.x;
}
HWY_INLINE Plane quarter_turned(Plane a) {
    return {-a.y, a.x};
}
HWY_INLINE Plane times(Plane a, Plane b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
HWY_INLINE Plane seen_from(Plane a, Plane b) {
    return {a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x};
}
HWY_INLINE Lane missing_length(Plane a) {
    return Lane(0.5) * ((Lane(0.5) - a.x * a.x) + (Lane(0.5) - a.y * a.y));
}
HWY_INLINE Plane renormalised(Plane a) {
    const Lane missing = missing_length(a);
    return a + missing * a;
}
HWY_INLINE Plane renormalised(Plane a, Lane angle) {
    return a + times(Plane{missing_length(a), angle}, a);
}

/// UnbiasedFactor.
struct LaneFactor {
    Lane first, second;
};
HWY_INLINE LaneFactor load(const LaneFactors& factors, int first) {
    return {load(factors.first, first), load(factors.second, first)};
}
HWY_INLINE Lane operator*(LaneFactor c, Lane x) {
    return c.first * x + c.second * x;
}
HWY_INLINE Plane operator*(LaneFactor c, Plane v) {
    return {c * v.x, c * v.y};
}
HWY_INLINE Plane turned(Plane v, Plane turn) {
    return v + times(v, turn);
}
HWY_INLINE Plane compose(Plane a, Plane b) {
    return a + (b + times(a, b));
}
HWY_INLINE Plane choose(Mask condition, Plane yes, Plane otherwise) {
    return {choose(condition, yes.x, otherwise.x), choose(condition, yes.y, otherwise.y)};
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
