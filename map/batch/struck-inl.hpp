// What lanes of disks and polygons share: states, a guess from samples, and what is kept of an impact.
#if defined(SWIRL_MAP_BATCH_STRUCK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_STRUCK_INL
#undef SWIRL_MAP_BATCH_STRUCK_INL
#else
#define SWIRL_MAP_BATCH_STRUCK_INL
#endif

#include "map/batch/formulas-inl.hpp"
#include "map/contact/chatter_completion.hpp"
#include "map/model/scene.hpp"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

struct LaneImpact {
    Lane normal, tangential, mode;
};

HWY_INLINE PostImpactState<Lane> load_state(const LaneBlock& block, int i) {
    PostImpactState<Lane> z;
    z.psi = {load(block.psi_x, i), load(block.psi_y, i)};
    z.chi = {load(block.chi_x, i), load(block.chi_y, i)};
    z.vn = load(block.vn, i);
    z.vt = load(block.vt, i);
    z.spin = load(block.spin, i);
    return z;
}

/// sampled_guess, in the lanes that want it; −1 if the gap stays negative.
HWY_INLINE Lane sampled_guess(const CirclePath<Lane>& path, Mask wanted) {
    Lane guess(-1), before(0);
    std::size_t step = 2;
    for (std::size_t k = step; k < sixty_fourths && any(wanted); k += step) {
        const Lane time(static_cast<double>(k) / 64);
        const TabledVector& turn = turns_of_sixty_fourths[k];
        const Lane gap = gap_along(path, time, Plane{Lane(turn.value.x), Lane(turn.value.y)});
        const Mask crossed = hn::And(wanted, gap > Lane(0));
        guess = choose(crossed, time - Lane(static_cast<double>(step) / 64) * gap / (gap - before), guess);
        wanted = hn::AndNot(crossed, wanted);
        before = gap;
        if (step < 16) step = k;
    }
    return guess;
}

/// `may_chatter`, negated.
template <Shape shape>
HWY_INLINE Mask leaves_the_wall(const LaneScenes& scenes, int i, const PostImpactState<Lane>& z) {
    const Body<Lane> body = load_body(scenes, i);
    constexpr bool disk = shape == Shape::disk;
    const ContactKinematics<Lane> u = contact_kinematics(body, z);
    const Lane along = disk ? u.ut - body.alpha * z.spin : u.ut;
    const Lane acceleration = body.beta + along * along * (disk ? body.inverse_inner : Lane(1));
    const Lane rounding =
        Lane(64) * epsilon<Lane>() * (fabs(z.vn) + fabs(z.vt) + body.beta + body.alpha * fabs(z.spin));
    const Mask quickly = u.un * u.un > load(scenes.chatter, i) * acceleration && fabs(u.un) > rounding;
    if (disk) return quickly;
    const Lane from_edge = fabs(fabs(z.chi.y) - load(scenes.widest_sine, i));
    return quickly && from_edge > Lane(2 * neighbour_tolerance<double>());
}

/// Neither `is_out_of_range` nor `has_diverged` nor `has_come_to_rest`, with room for rounding: the scalar code decides
/// beyond. (A sum is NaN where one of its terms is.)
HWY_INLINE Mask stays_in_range(const PostImpactState<Lane>& z, const Body<Lane>& body) {
    const Lane speed = fabs(z.vn) + fabs(z.vt) + body.alpha * fabs(z.spin);
    const Mask moves = body.beta > Lane(0) || speed > Lane(4 * smallest_magnitude);
    return speed < Lane(largest_magnitude / 2) && fabs(z.spin) < Lane(largest_magnitude / 2) && moves;
}

HWY_INLINE void keep_impact(Mask struck, const PostImpactState<Lane>& after, Lane time, Lane looks,
                            const LaneImpact& impact, Lane vertex, LaneBlock& block, int i) {
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
