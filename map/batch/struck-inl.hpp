// What lanes of disks and polygons share: states, the turn into the new contact's axes, and what is kept of an impact.
#if defined(SWIRL_MAP_BATCH_STRUCK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_STRUCK_INL
#undef SWIRL_MAP_BATCH_STRUCK_INL
#else
#define SWIRL_MAP_BATCH_STRUCK_INL
#endif

#include "map/batch/path-inl.hpp"
#include "map/model/scene.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

struct LaneState {
    Plane psi, chi;
    Lane vn, vt, spin;
};

struct LaneImpact {
    Lane normal, tangential, mode;
};

HWY_INLINE LaneState load_state(const LaneBlock& block, int i) {
    LaneState z;
    z.psi = {load(block.psi_x, i), load(block.psi_y, i)};
    z.chi = {load(block.chi_x, i), load(block.chi_y, i)};
    z.vn = load(block.vn, i);
    z.vt = load(block.vt, i);
    z.spin = load(block.spin, i);
    return z;
}

/// bounds.hpp, `rate_rounding`; speed = |V_x| + |V_y|.
HWY_INLINE Lane rate_rounding(Lane speed, Lane beta, Lane spin, Lane alpha) {
    return Lane(16 * unit_roundoff) * (speed + beta + magnitude(spin) * alpha);
}

/// The first condition of `may_chatter`, negated. `chatter` = tolerance (1 − e) × the bound of the acceleration.
HWY_INLINE Mask leaves_quickly(Lane un, Lane chatter, const LaneState& z, Lane alpha, Lane beta) {
    const Lane rounding =
        Lane(64 * unit_roundoff) * (magnitude(z.vn) + magnitude(z.vt) + beta + alpha * magnitude(z.spin));
    return all(un * un > chatter, magnitude(un) > rounding);
}

/// Neither `is_out_of_range` nor `has_diverged` nor `has_come_to_rest`, with room for rounding: the scalar code decides
/// beyond. (A sum is NaN where one of its terms is.)
HWY_INLINE Mask stays_in_range(const LaneState& z, Lane beta, Lane alpha) {
    const Lane speed = magnitude(z.vn) + magnitude(z.vt) + alpha * magnitude(z.spin);
    const Mask moves = either(beta > Lane(0), speed > Lane(4 * smallest_magnitude));
    return all(speed < Lane(largest_magnitude / 2), magnitude(z.spin) < Lane(largest_magnitude / 2), moves);
}

HWY_INLINE void keep_impact(Mask struck, const LaneState& after, Lane time, Lane looks, const LaneImpact& impact,
                            Lane vertex, LaneBlock& block, int i) {
    store_where(struck, after.psi.x, block.psi_x, i);
    store_where(struck, after.psi.y, block.psi_y, i);
    store_where(struck, after.chi.x, block.chi_x, i);
    store_where(struck, after.chi.y, block.chi_y, i);
    store_where(struck, after.vn, block.vn, i);
    store_where(struck, after.vt, block.vt, i);
    store_where(struck, after.spin, block.spin, i);
    store(time, block.flight_time, i);
    store(looks, block.steps, i);
    store(impact.normal, block.normal, i);
    store(impact.tangential, block.tangential, i);
    store(impact.mode, block.mode, i);
    store(vertex, block.vertex_step, i);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
