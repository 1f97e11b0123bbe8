// A polygon's impact in lanes: `impulse` of map/model/impact.hpp, with both sides of
// each branch where lanes part. A division of which only one side is wanted is made once, of what is chosen.
#if defined(SWIRL_MAP_BATCH_IMPACT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_IMPACT_INL
#undef SWIRL_MAP_BATCH_IMPACT_INL
#else
#define SWIRL_MAP_BATCH_IMPACT_INL
#endif

#include "map/batch/struck-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// NormalVelocityPath.
struct LanePieces {
    Lane start, first, second, kink, at_kink;
    Mask has_kink, in_compression;
};

HWY_INLINE Lane compression_end(const LanePieces& path) {
    const Lane quotient =
        choose(path.in_compression, path.at_kink, -path.start) / choose(path.in_compression, path.second, path.first);
    return choose(path.in_compression, path.kink - quotient, quotient);
}

HWY_INLINE Lane end_at_velocity(const LanePieces& path, Lane compressed, Lane level) {
    const Mask on_first = hn::AndNot(path.in_compression, !path.has_kink || level <= path.at_kink);
    const Mask beyond = !(path.in_compression || on_first);
    const Lane quotient = choose(beyond, level - path.at_kink, level) / choose(on_first, path.first, path.second);
    return choose(beyond, path.kink, compressed) + quotient;
}

HWY_INLINE Lane end_at_work(const LanePieces& path, Lane compressed, Lane restitution) {
    const Lane at_kink = choose(path.has_kink, path.at_kink, Lane(0));
    const Lane straight = compressed + restitution * compressed;
    const Mask on_first = !path.has_kink || straight <= path.kink;
    const Lane compression = Lane(-0.5) * ((path.start + at_kink) * path.kink + at_kink * (compressed - path.kink));
    const Lane level = restitution * path.start;
    const Lane left = (level * level - at_kink * at_kink) * (path.second / path.first);
    const Lane root = sqrt(choose(path.in_compression, Lane(2) * compression / path.second, at_kink * at_kink + left));
    const Lane beyond = path.kink + left / (path.second * (at_kink + root));
    return choose(path.in_compression, compressed + restitution * root, choose(on_first, straight, beyond));
}

template <ImpactRule rule>
HWY_INLINE Lane impulse_end(const LanePieces& path, Lane restitution) {
    const Lane compressed = compression_end(path);
    if constexpr (rule == ImpactRule::newton)
        return end_at_velocity(path, compressed, -restitution * path.start);
    else if constexpr (rule == ImpactRule::stronge)
        return end_at_work(path, compressed, restitution);
    else
        return compressed + restitution * compressed;
}

HWY_INLINE Lane number_of(ContactMode mode) {
    return Lane(static_cast<double>(mode));
}

template <ImpactRule rule>
HWY_INLINE LaneImpact impulse(const ContactKinematics<Lane>& approach, Lane mu, Lane restitution) {
    const Lane b2 = approach.b2();
    const Lane un = choose(approach.un < Lane(0), Lane(0), approach.un);
    if constexpr (rule == ImpactRule::frictionless) {
        return {(Lane(1) + restitution) * un / b2, Lane(0), number_of(ContactMode::frictionless)};
    } else {
        const Lane b1 = approach.b1();
        const Lane b3 = approach.b3();
        const Lane stick = mu * b1;
        const Mask sticks = fabs(b3) <= stick;
        const Mask at_rest = equal(approach.ut, Lane(0));
        const Mask positive = choose(at_rest, b3, approach.ut) > Lane(0);
        const Lane signed_b3 = choose(positive, b3, -b3);
        const Lane slowing = stick - signed_b3;
        LanePieces path;
        path.has_kink = hn::And(at_rest, sticks) || hn::AndNot(at_rest, slowing > Lane(0));
        path.start = -un;
        path.first = b2 - mu * signed_b3;
        const Lane kink = choose(slowing > Lane(0), choose(positive, approach.ut, -approach.ut) / slowing, Lane(0));
        path.kink = choose(path.has_kink, kink, Lane(0));
        path.second = choose(sticks, approach.sticking(), b2 + mu * signed_b3);
        path.at_kink = path.start + path.first * path.kink;
        path.in_compression = hn::And(path.has_kink, path.at_kink < Lane(0));
        const Lane end = impulse_end<rule>(path, restitution);
        const Lane friction = choose(positive, -mu, mu);
        const Mask slides = !path.has_kink || end < path.kink;
        const Lane after = choose(sticks, -b3 / b1, -friction);
        const Lane tangential = choose(slides, friction * end, friction * path.kink + after * (end - path.kink));
        const Lane stuck =
            choose(path.in_compression, number_of(ContactMode::c_sticking), number_of(ContactMode::r_sticking));
        const Lane reversed =
            choose(path.in_compression, number_of(ContactMode::c_reversed), number_of(ContactMode::r_reversed));
        return {end, tangential, choose(slides, number_of(ContactMode::sliding), choose(sticks, stuck, reversed))};
    }
}

/// `z` is the state before the impact and then the one after it.
template <ImpactRule rule>
HWY_INLINE LaneImpact impact_of_polygon(const LaneScenes& scenes, int i, PostImpactState<Lane>& z) {
    const ContactKinematics<Lane> before = contact_kinematics(load_body(scenes, i), z);
    const LaneImpact j = impulse<rule>(before, load(scenes.mu, i), load(scenes.restitution, i));
    apply_impulse(before, j.normal, j.tangential, z);
    return j;
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
