// The formulas of numbers/, model/ and first_contact/ in lanes, and the scene that they read.
#if defined(SWIRL_MAP_BATCH_FORMULAS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_FORMULAS_INL
#undef SWIRL_MAP_BATCH_FORMULAS_INL
#else
#define SWIRL_MAP_BATCH_FORMULAS_INL
#endif

#include "map/batch/turns-inl.hpp"
#include "map/first_contact/direct_polygon.hpp"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// The numbers of `Body` that are read here.
template <class T>
struct Body {
    T alpha, beta, inner, outer, spacing, half_slope, side;
    Vec2<T> next_turn;
    T inertia, inverse_inertia, inverse_inner, disk_grip;
    UnbiasedFactor<T> unbiased_alpha, unbiased_inverse_alpha, unbiased_inner, unbiased_inverse_inner;
};

/// To be called again where other numbers are read: those of before would wait for it in registers.
HWY_INLINE Body<Lane> load_body(const LaneScenes& s, int i) {
    Body<Lane> body;
    body.alpha = load(s.alpha, i);
    body.beta = load(s.beta, i);
    body.inner = load(s.inner, i);
    body.outer = load(s.outer, i);
    body.spacing = load(s.spacing, i);
    body.half_slope = load(s.half_slope, i);
    body.side = load(s.side, i);
    body.next_turn = {load(s.next_turn_x, i), load(s.next_turn_y, i)};
    body.inertia = Lane(0);  // not read
    body.inverse_inertia = load(s.inverse_inertia, i);
    body.inverse_inner = load(s.inverse_inner, i);
    body.disk_grip = load(s.disk_grip, i);
    body.unbiased_alpha = load(s.unbiased_alpha, i);
    body.unbiased_inverse_alpha = load(s.unbiased_inverse_alpha, i);
    body.unbiased_inner = load(s.unbiased_inner, i);
    body.unbiased_inverse_inner = load(s.unbiased_inverse_inner, i);
    return body;
}

#include "map/model/flight_formulas.hpp"

#include "map/model/impact_formulas.hpp"

#include "map/model/section_formulas.hpp"

#include "map/first_contact/certificate_formulas.hpp"

#include "map/first_contact/circle_path_formulas.hpp"

#include "map/first_contact/vertices_formulas.hpp"

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
